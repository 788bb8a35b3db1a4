// A thick line: the thin one's pixels repeated across it, or the strip of its width filled.
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "fill.h"
#include "line.h"

namespace mv {

std::vector<PixelStep> thickLine(LineMethod method, Thicken thicken, int thickness, int x1, int y1, int x2, int y2) {
    const std::vector<PixelStep> thin = linePixels(method, x1, y1, x2, y2);
    if (thickness == 1) return thin;
    std::vector<PixelStep> set;
    if (thicken == Thicken::across) {
        const auto corners = stripOf(thickness, x1, y1, x2, y2);
        vec2 low = corners[0], high = corners[0];
        for (const vec2& corner : corners) {
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
        // Move the strip to (0, 0), where the picture of polygonPixels() begins
        const auto left = static_cast<int>(std::floor(low.x)), bottom = static_cast<int>(std::floor(low.y));
        std::vector<vec2> moved;
        for (const vec2& corner : corners) moved.emplace_back(corner.x - left, corner.y - bottom);
        set = polygonPixels(moved, static_cast<int>(std::ceil(high.x)) - left,
                            static_cast<int>(std::ceil(high.y)) - bottom, Winding::nonZero);
        for (PixelStep& pixel : set) {
            pixel.x += left;
            pixel.y += bottom;
        }
        return set;
    }
    const bool steep = std::abs(y2 - y1) > std::abs(x2 - x1);
    for (const PixelStep& pixel : thin) {
        for (int i = 0; i < thickness; ++i) {
            set.push_back(pixel);
            (steep ? set.back().x : set.back().y) += i - (thickness - 1) / 2;
        }
    }
    return set;
}

std::array<vec2, 4> stripOf(double thickness, int x1, int y1, int x2, int y2) {
    const vec2 from(x1 + 0.5, y1 + 0.5), to(x2 + 0.5, y2 + 0.5);
    const double length = glm::distance(from, to);
    if (length == 0) return {from, from, from, from};
    const vec2 half = thickness / 2 / length * vec2(from.y - to.y, to.x - from.x);
    return {from - half, to - half, to + half, from + half};
}

}  // namespace mv
