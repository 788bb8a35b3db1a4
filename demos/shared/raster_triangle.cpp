#include "shared/raster_triangle.h"

#include <algorithm>
#include <cmath>

#include "mv/error.h"

namespace mv {
namespace {

struct Snapped {
    std::int64_t x, y;
};

Snapped snapped(const vec2& corner) {
    constexpr double most = 1 << 22;
    if (!(std::abs(corner.x) <= most && std::abs(corner.y) <= most)) {
        throw Error("edgeFunctions", "each corner must lie within 2^22 pixels, a guard band: cut the triangle before",
                    numberText(corner.x) + ", " + numberText(corner.y));
    }
    return {std::llround(corner.x * subPixels), std::llround(corner.y * subPixels)};
}

EdgeFunction edge(const Snapped& from, const Snapped& to, EdgeRule rule) {
    const std::int64_t dx = to.x - from.x, dy = to.y - from.y;
    // Counter-clockwise, left edges go down, and bottom ones to the right.
    const bool isBottomLeft = dy < 0 || (dy == 0 && dx > 0);
    return {-dy, dx, dy * from.x - dx * from.y,
            rule == EdgeRule::inside || (rule == EdgeRule::bottomLeft && isBottomLeft)};
}

bool isInside(std::int64_t value, const EdgeFunction& edge) { return value > 0 || (value == 0 && edge.keeps); }

std::int64_t middle(int pixel) { return std::int64_t(pixel) * subPixels + subPixels / 2; }

struct PixelBox {
    int left, right, bottom, top;  // up to, but without right and top
};

PixelBox boxOf(const std::array<vec2, 3>& corners, int width, int height) {
    PixelBox box{width, 0, height, 0};
    for (const vec2& corner : corners) {
        // Wider by half a pixel than the corner, which snapping moves by 1/512
        const auto least = [](double x, int most) {
            return static_cast<int>(std::clamp(std::floor(x - 0.51), 0.0, double(most)));
        };
        const auto end = [](double x, int most) {
            return static_cast<int>(std::clamp(std::ceil(x + 0.51), 0.0, double(most)));
        };
        box.left = std::min(box.left, least(corner.x, width));
        box.right = std::max(box.right, end(corner.x, width));
        box.bottom = std::min(box.bottom, least(corner.y, height));
        box.top = std::max(box.top, end(corner.y, height));
    }
    return box;
}

void askEach(const std::vector<EdgeFunction>& edges, const PixelBox& box, Covered& covered) {
    for (int j = box.bottom; j < box.top; ++j) {
        for (int i = box.left; i < box.right; ++i) {
            bool inside = true;
            for (const EdgeFunction& edge : edges) inside = isInside(edge.at(middle(i), middle(j)), edge) && inside;
            covered.asked += 3;
            if (inside) covered.pixels.push_back({i, j});
        }
    }
}

void addUp(const std::vector<EdgeFunction>& edges, const PixelBox& box, Covered& covered) {
    std::array<std::int64_t, 3> row{}, now{};
    for (std::size_t k = 0; k < 3; ++k) row.at(k) = edges[k].at(middle(box.left), middle(box.bottom));
    for (int j = box.bottom; j < box.top; ++j) {
        now = row;
        for (int i = box.left; i < box.right; ++i) {
            const bool inside = isInside(now[0], edges[0]) && isInside(now[1], edges[1]) && isInside(now[2], edges[2]);
            if (inside) covered.pixels.push_back({i, j});
            for (std::size_t k = 0; k < 3; ++k) now.at(k) += edges[k].a * subPixels;  // one pixel to the right
        }
        covered.asked += 3 * std::int64_t(box.right - box.left);
        for (std::size_t k = 0; k < 3; ++k) row.at(k) += edges[k].b * subPixels;  // one pixel up
    }
}

void byTiles(const std::vector<EdgeFunction>& edges, const PixelBox& box, Covered& covered) {
    constexpr int side = 8;
    for (int bottom = box.bottom; bottom < box.top; bottom += side) {
        for (int left = box.left; left < box.right; left += side) {
            const PixelBox tile{left, std::min(left + side, box.right), bottom, std::min(bottom + side, box.top)};
            bool isOutside = false, isWhole = true;
            for (const EdgeFunction& edge : edges) {
                // The function is largest at one corner of the tile and smallest at the opposite one.
                const std::int64_t x1 = middle(tile.left), x2 = middle(tile.right - 1), y1 = middle(tile.bottom),
                                   y2 = middle(tile.top - 1);
                const std::int64_t largest = edge.at(edge.a > 0 ? x2 : x1, edge.b > 0 ? y2 : y1);
                const std::int64_t smallest = edge.at(edge.a > 0 ? x1 : x2, edge.b > 0 ? y1 : y2);
                isOutside |= !isInside(largest, edge);
                isWhole &= isInside(smallest, edge);
                covered.asked += 2;
            }
            if (isOutside) continue;
            if (!isWhole) {
                addUp(edges, tile, covered);
                continue;
            }
            for (int j = tile.bottom; j < tile.top; ++j) {
                for (int i = tile.left; i < tile.right; ++i) covered.pixels.push_back({i, j});
            }
        }
    }
}

void inFloats(const std::vector<EdgeFunction>& edges, const PixelBox& box, Covered& covered) {
    for (int j = box.bottom; j < box.top; ++j) {
        for (int i = box.left; i < box.right; ++i) {
            bool inside = true;
            for (const EdgeFunction& edge : edges) {
                const float value = static_cast<float>(edge.a) * static_cast<float>(middle(i)) +
                                    static_cast<float>(edge.b) * static_cast<float>(middle(j)) +
                                    static_cast<float>(edge.c);
                inside = (value > 0 || (value == 0 && edge.keeps)) && inside;
            }
            covered.asked += 3;
            if (inside) covered.pixels.push_back({i, j});
        }
    }
}

}  // namespace

std::vector<EdgeFunction> edgeFunctions(const std::array<vec2, 3>& corners, EdgeRule rule) {
    std::array<Snapped, 3> p{snapped(corners[0]), snapped(corners[1]), snapped(corners[2])};
    const std::int64_t area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    if (area == 0) return {};
    if (area < 0) std::swap(p[1], p[2]);
    return {edge(p[0], p[1], rule), edge(p[1], p[2], rule), edge(p[2], p[0], rule)};
}

Covered coveredPixels(const std::array<vec2, 3>& corners, int width, int height, FillMethod method, EdgeRule rule) {
    const std::vector<EdgeFunction> edges = edgeFunctions(corners, rule);
    Covered covered;
    if (edges.empty()) return covered;
    const PixelBox box = boxOf(corners, width, height);
    switch (method) {
        case FillMethod::brute:
            askEach(edges, {0, width, 0, height}, covered);
            break;
        case FillMethod::box:
            askEach(edges, box, covered);
            break;
        case FillMethod::incremental:
            addUp(edges, box, covered);
            break;
        case FillMethod::tiles:
            byTiles(edges, box, covered);
            break;
        case FillMethod::floats:
            inFloats(edges, box, covered);
            break;
    }
    return covered;
}

vec3 cornerWeights(const std::array<vec2, 3>& corners, const vec2& at) {
    const auto twice = [](const vec2& a, const vec2& b, const vec2& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    const vec3 areas(twice(at, corners[1], corners[2]), twice(at, corners[2], corners[0]),
                     twice(at, corners[0], corners[1]));
    return areas / (areas.x + areas.y + areas.z);
}

vec3 perspectiveWeights(const vec3& weights, const vec3& w) {
    const vec3 over = weights / w;
    return over / (over.x + over.y + over.z);
}

}  // namespace mv
