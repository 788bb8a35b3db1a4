// A picture round a ball, for rays that meet it.
#pragma once
#include <memory>
#include <vector>

#include "mv/image/picture.h"
#include "mv/math/types.h"

namespace mv {

// The picture's mipmaps, the finest first, each row a latitude, from the south pole up; and how the ball is turned: a rotation.
struct BallTexture {
    std::shared_ptr<const std::vector<FloatPicture>> levels;
    mat3 modelFromWorld{1};
};

// From the model to its texture, of a unit vector from the ball's middle: u eastwards, 0 at -x and 0.25 at +z, v from the south pole
// (0) to the north pole (1), y. At the poles any u would do; 0.5 is taken.
vec2 onTexture(const vec3& normalInModel);

// The colour at a place of the ball, by its unit normal in world space: one texel; or the mean over about `width`, in radii of the ball,
// of the surface: between four texels of the two levels whose texels are about as large. East and west it is averaged as
// far as towards the poles.
vec3 textureAround(const BallTexture& texture, const vec3& normal, double width);

// Squares of 15 degrees, dark ones of a hue that goes round with the longitude, an equator and a meridian of 0; tilted like the earth
// and turned about its axis. Linear light.
BallTexture globeTexture(double turn);

}  // namespace mv
