// Which pixels a triangle covers: those whose middles lie on the inner side of all three edges, as graphics cards find it,
// in whole numbers. y goes up; pixel (i, j) has its middle at (i + 1/2, j + 1/2).
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "mv/math/types.h"
#include "shared/pixel_step.h"

namespace mv {

// Corners are snapped to so many parts of a pixel, as llvmpipe and most graphics cards do.
inline constexpr int subPixels = 256;

enum class FillMethod {
    brute,        // every pixel of the grid is asked
    box,          // those of the box around the triangle
    incremental,  // the same, each function by adding A to the right and B upwards
    tiles,        // of tiles of 8 x 8 those that no edge leaves wholly outside; whole ones without asking their pixels
    floats,       // as box, but A x + B y + C in floats
};
// The rule for a middle that lies on an edge.
enum class EdgeRule { bottomLeft, inside, outside };

// A x + B y + C, positive on the inner side, in units of 1/256 pixel and their products.
struct EdgeFunction {
    std::int64_t a, b, c;
    bool keeps;  // a middle that lies on it
    std::int64_t at(std::int64_t x, std::int64_t y) const { return a * x + b * y + c; }
};
// None for a triangle without area after snapping. Corners that go round clockwise are taken the other way.
// Refused: a coordinate beyond 2^22 pixels in size, from which on the products leave 64 bits.
std::vector<EdgeFunction> edgeFunctions(const std::array<vec2, 3>& corners, EdgeRule rule);

struct Covered {
    std::vector<PixelStep> pixels;  // in the order in which they are set
    std::int64_t asked = 0;         // edge functions evaluated, or added up
};
// The pixels of a grid of width x height.
Covered coveredPixels(const std::array<vec2, 3>& corners, int width, int height, FillMethod method,
                      EdgeRule rule = EdgeRule::bottomLeft);

// The weights of the corners at a pixel's middle; with w they are those of the surface before the division: each over its
// corner's w, and divided by their sum.
vec3 cornerWeights(const std::array<vec2, 3>& corners, const vec2& at);
vec3 perspectiveWeights(const vec3& weights, const vec3& w);

}  // namespace mv
