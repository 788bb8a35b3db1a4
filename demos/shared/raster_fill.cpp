#include "shared/raster_fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "mv/error.h"
#include "mv/geometry/clip_segment.h"

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
            // Where a middle is on the edge x is a rounding off it, to either side: so the neighbour across the edge would differ.
            int column = static_cast<int>(std::ceil(x - 0.5)) - 1;
            while (orientation(low, high, {column + 0.5, y}) > 0) ++column;
            crossings.push_back({column, a.y < b.y ? 1 : -1});
        }
        std::ranges::sort(crossings, {}, &Crossing::column);
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
