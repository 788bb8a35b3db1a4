// The surroundings of shiny bodies: a room with balls, as rays see it, and a sky. The room is also in
// shaders/include/surroundings.glsl, in float.
#pragma once
#include <array>
#include <vector>

#include "mv/geometry/cube_faces.h"
#include "mv/geometry/ray.h"
#include "mv/image/picture.h"
#include "mv/math/types.h"

namespace mv {

// A room about the origin with tiled walls, each in a colour of its own, and a lamp in the ceiling. All in it sends out light by
// itself, the same to all sides, so that who looks from where does not matter. The room grows as a whole: seen from its
// middle a larger room looks the same.
struct Room {
    static constexpr std::size_t ballCount = 4;
    double size;   // half of its width and depth
    double round;  // where the first ball is on its way round the middle, in degrees; the others rest

    vec3 halfSize() const { return size * vec3(1, 0.6, 1); }
    double ballRadius() const { return 0.13 * size; }
    std::array<vec3, ballCount> ballPlaces() const;
    static std::array<vec3, ballCount> ballColors();

    // Whether a part of that ball may be in the view volume; false where it lies beyond one of the six planes.
    bool isBallInView(std::size_t ball, const mat4& clipFromWorld) const;
    // Whether that ball is wholly behind the sphere of radius 1 in the middle, for an eye outside of both.
    bool isBallHidden(std::size_t ball, const vec3& eye) const;

    // Where a ray that starts inside meets a wall.
    vec3 wallAlong(const Ray& ray) const;
    // The light that comes along a ray from inside the room, outside the balls, 0..1 in linear light.
    vec3 seenAlong(const Ray& ray) const;
};

// A sky with clouds and a sun over hills, at infinity: the light from a direction of any length but 0, 0..1.
vec3 skyAlong(const vec3& direction);
// The same as a cube of size x size texels a face, for CubeMap: each texel is asked at its middle.
std::array<FloatPicture, cubeFaces> skyCube(int size);

}  // namespace mv
