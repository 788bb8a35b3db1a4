// A fill: from a seed, all pixels of its colour that are joined to it.
#include "fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "mv/error.h"
#include "sheet.h"

namespace mv::rasterizer {

// The outline that is filled, of lines.
static PixelMap outlineOf(const Corners& corners, const Grid& grid) {
    PixelMap map(grid.columns, grid.rows);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const vec2 a = corners.at(i), b = corners.at((i + 1) % corners.size());
        for (const PixelStep& pixel :
             linePixels(LineMethod::octants, grid.whole(a.x), grid.whole(a.y), grid.whole(b.x), grid.whole(b.y))) {
            if (map.holds(pixel.x, pixel.y)) map.at(pixel.x, pixel.y) = 1;
        }
    }
    return map;
}

static Flooded flooded(const Fill& fill, PixelMap map, const Grid& grid) {
    const int x = grid.whole(fill.seed.x), y = grid.whole(fill.seed.y);
    return fill.flood == Flood::spans ? floodBySpans(map, x, y, 2, fill.neighbours)
                                      : floodByRecursion(map, x, y, 2, fill.neighbours);
}

std::size_t countFill(const Fill& fill, const Corners& corners, const Grid& grid) {
    return flooded(fill, outlineOf(corners, grid), grid).pixels.size();
}

void drawFill(Gpu& gpu, const Settings& s, const Grid& grid, const Frame& frame) {
    const Fill& fill = s.fill;
    const Corners& corners = s.corners;
    const PixelMap outline = outlineOf(corners, grid);
    const std::vector<PixelStep> pixels = flooded(fill, outline, grid).pixels;
    Shape shape{{{corners.begin(), corners.end()}}, fill.seed + 0.5};
    shape.lines.front().push_back(corners.front());
    showPictures(gpu, frame, grid, inked(grid, pixels, &outline), orderOf(grid, pixels, &outline), shape);
    showWords(gpu, frame, grid,
              std::string(nameOf(fill.flood)) + ", " + std::to_string(fill.neighbours) +
                  " neighbours: " + countOf(grid, pixels.size()),
              "the order: from blue to yellow");
}

void readFill(const Fill& fill, const Corners& corners, const Grid& grid, Numbers& numbers) {
    const Flooded all = flooded(fill, outlineOf(corners, grid), grid);
    numbers.set("set", double(all.pixels.size()));
    numbers.set("deepest", double(all.deepest));
}

}  // namespace mv::rasterizer

namespace mv {
namespace {

constexpr std::array<std::pair<int, int>, 8> around{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

class Recursion {
  public:
    Recursion(PixelMap& map, int from, int to, int neighbors, long deepest)
        : map_(map), from_(from), to_(to), neighbors_(static_cast<std::size_t>(neighbors)), most_(deepest) {}
    void fill(int x, int y, long depth) {
        if (!take(x, y, depth)) return;
        for (std::size_t i = 0; i < neighbors_; ++i) fill(x + around.at(i).first, y + around.at(i).second, depth + 1);
    }
    Flooded flooded;

  private:
    // Apart, so that what it needs does not lie on the stack a thousand times
    bool take(int x, int y, long depth) {
        ++flooded.calls;
        if (!map_.holds(x, y) || map_.at(x, y) != from_) return false;
        if (depth > most_) {
            throw Error("floodByRecursion", "must not go deeper than " + std::to_string(most_) +
                                                " calls, or the stack ends: fill by spans");
        }
        flooded.deepest = std::max(flooded.deepest, depth);
        map_.at(x, y) = to_;
        flooded.pixels.push_back({x, y, double(depth)});
        return true;
    }

    PixelMap& map_;
    int from_, to_;
    std::size_t neighbors_;
    long most_;
};

}  // namespace

Flooded floodByRecursion(PixelMap& map, int x, int y, int color, int neighbors, long deepest) {
    if (!map.holds(x, y) || map.at(x, y) == color) return {};
    Recursion recursion(map, map.at(x, y), color, neighbors, deepest);
    recursion.fill(x, y, 1);
    return std::move(recursion.flooded);
}

Flooded floodBySpans(PixelMap& map, int x, int y, int color, int neighbors) {
    Flooded flooded;
    if (!map.holds(x, y) || map.at(x, y) == color) return flooded;
    const int from = map.at(x, y), reach = neighbors == 8 ? 1 : 0;
    std::vector<std::pair<int, int>> waiting{{x, y}};
    while (!waiting.empty()) {
        flooded.deepest = std::max(flooded.deepest, static_cast<long>(waiting.size()));
        const auto [seedX, row] = waiting.back();
        waiting.pop_back();
        ++flooded.calls;
        if (map.at(seedX, row) != from) continue;
        // The run of the row that the seed lies in
        int left = seedX, right = seedX;
        while (left > 0 && map.at(left - 1, row) == from) --left;
        while (right + 1 < map.width && map.at(right + 1, row) == from) ++right;
        flooded.calls += right - left + 2;
        for (int i = left; i <= right; ++i) {
            map.at(i, row) = color;
            flooded.pixels.push_back({i, row, double(waiting.size())});
        }
        // One seed for each run above and below it that touches it
        for (const int other : {row - 1, row + 1}) {
            if (other < 0 || other >= map.height) continue;
            bool inRun = false;
            for (int i = std::max(left - reach, 0); i <= std::min(right + reach, map.width - 1); ++i) {
                ++flooded.calls;
                const bool isFree = map.at(i, other) == from;
                if (isFree && !inRun) waiting.emplace_back(i, other);
                inRun = isFree;
            }
        }
    }
    return flooded;
}

}  // namespace mv
