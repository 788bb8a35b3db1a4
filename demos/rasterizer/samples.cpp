#include "samples.h"

#include <algorithm>
#include <cmath>

#include "mv/error.h"
#include "mv/math/clip.h"
#include "shared/raster_triangle.h"

namespace mv {

std::vector<vec2> samplePlaces(int count) {
    if (count == 1) return {{0.5, 0.5}};
    if (count != 4) throw Error("samplePlaces", "must be 1 or 4 points of a pixel", std::to_string(count));
    return {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
}

std::array<vec2, 3> movedToMiddle(std::array<vec2, 3> corners, const vec2& place) {
    for (vec2& corner : corners) corner += 0.5 - place;
    return corners;
}

double exactShare(const std::array<vec2, 3>& corners, int x, int y) {
    const std::array<vec4, 4> pixel{vec4(1, 0, 0, -x), vec4(-1, 0, 0, x + 1), vec4(0, 1, 0, -y), vec4(0, -1, 0, y + 1)};
    std::vector<vec4> polygon;
    for (const vec2& corner : corners) polygon.emplace_back(corner, 0, 1);
    std::vector<vec3> left;
    for (const vec4& corner : clipPolygon(polygon, pixel))
        left.emplace_back(corner.x / corner.w, corner.y / corner.w, 0);
    return polygonArea(left);
}

std::vector<double> sharesByPlaces(const std::array<vec2, 3>& corners, int places, int columns, int rows) {
    std::vector<double> shares(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
    for (const vec2& place : samplePlaces(places)) {
        for (const PixelStep& pixel :
             coveredPixels(movedToMiddle(corners, place), columns, rows, FillMethod::box).pixels)
            shares.at(static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(pixel.x)) += 1.0 / places;
    }
    return shares;
}

std::vector<double> exactShares(const std::array<vec2, 3>& corners, int columns, int rows) {
    vec2 low = corners[0], high = corners[0];
    for (const vec2& corner : corners) {
        low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
        high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
    }
    std::vector<double> shares;
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            const bool isNear = x + 1 > low.x && x < high.x && y + 1 > low.y && y < high.y;
            shares.push_back(isNear ? exactShare(corners, x, y) : 0);
        }
    }
    return shares;
}

}  // namespace mv
