// The picture that rays make of a square and its shadow on the plane y = 0: the same picture by another method, in double.
#pragma once
#include <array>
#include <optional>

#include "mv/image/picture.h"
#include "mv/math/types.h"

namespace mv::test {

struct ShadowScene {
    mat4 clipFromWorld;
    mat4 worldFromSquare;     // of the unit square -0.5..0.5 in its own plane y = 0
    vec3 light;               // a point
    double floorHalf = 0;     // half the side of a floor that is drawn at y = 0 and seen from both sides; 0: none
    bool beyondFloor = true;  // the shadow also falls where there is no floor
};

enum class Seen { background, square, floor, shadow };

// The thing that the ray through this point of the picture (normalised device coordinates) meets first. The shadow lies on the
// upper side of the plane where the way to the light, above the plane, meets the square. Where there is no floor it is
// seen from below too.
Seen castRay(const ShadowScene& scene, const vec2& ndc);

// The colours of what is seen, in the order of Seen.
using SeenColors = std::array<Pixel, 4>;

// The pixels that are not as the rays say. Those within a pixel of an edge are passed over: whether GL covers them is
// a matter of rounding; as are those within 20 pixels of `except`, where something stands that the rays do not know.
struct RayComparison {
    long wrong = 0;
    long shadow = 0;  // pixels compared that are shadow, by the rays
    long compared = 0;
};
RayComparison compareWithRays(const Picture& picture, const ShadowScene& scene, const SeenColors& colors,
                              std::optional<vec2> except = {});

}  // namespace mv::test
