// A polygon that crosses itself: its outline says what is inside, row by row.
#include <algorithm>
#include <cmath>

#include "mv/geometry/clip_segment.h"
#include "sheet.h"

namespace mv::rasterizer {

static std::vector<PixelStep> pixelsOf(const Star& star, const Grid& grid) {
    std::vector<vec2> corners = star.corners;
    for (vec2& corner : corners) corner *= grid.scale;
    return polygonPixels(corners, grid.columns, grid.rows, star.winding);
}

std::size_t countStar(const Star& star, const Grid& grid) { return pixelsOf(star, grid).size(); }

void drawStar(Gpu& gpu, const Settings& s, const Grid& grid, const Frame& frame) {
    const Star& star = s.star;
    const std::vector<PixelStep> pixels = pixelsOf(star, grid);
    Shape shape{{star.corners}};
    shape.lines.front().push_back(star.corners.front());
    showPictures(gpu, frame, grid, inked(grid, pixels), orderOf(grid, pixels), shape);
    showWords(gpu, frame, grid, std::string(nameOf(star.winding)) + ": " + countOf(grid, pixels.size()),
              "the order: from blue to yellow");
}

void readStar(const Star& star, const Grid& grid, Numbers& numbers) {
    numbers.set("set", double(pixelsOf(star, grid).size()));
}

}  // namespace mv::rasterizer

namespace mv {

std::vector<PixelStep> polygonPixels(const std::vector<vec2>& corners, int width, int height, Winding winding) {
    std::vector<PixelStep> set;
    struct Crossing {
        int column;  // the first whose middle is not left of the edge
        int turn;
    };
    for (int j = 0; j < height; ++j) {
        const double y = j + 0.5;
        std::vector<Crossing> crossings;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
            if ((a.y > y) == (b.y > y)) continue;
            const vec2 &low = a.y < b.y ? a : b, &high = a.y < b.y ? b : a;
            const double x = low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x);
            // By x alone a middle on the edge falls on either side, by rounding, and two polygons with this edge set it both
            // or neither. orientation() decides exactly
            int column = static_cast<int>(std::ceil(x - 0.5)) - 1;
            while (orientation(low, high, {column + 0.5, y}) > 0) ++column;
            crossings.push_back({column, a.y < b.y ? 1 : -1});
        }
        std::ranges::sort(crossings, [](const Crossing& a, const Crossing& b) { return a.column < b.column; });
        int turns = 0;
        for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
            turns += winding == Winding::evenOdd ? 1 : crossings[i].turn;
            if (winding == Winding::evenOdd ? turns % 2 == 0 : turns == 0) continue;
            for (int x = std::max(0, crossings[i].column); x < std::min(width, crossings[i + 1].column); ++x)
                set.push_back({x, j, double(turns)});
        }
    }
    return set;
}

}  // namespace mv
