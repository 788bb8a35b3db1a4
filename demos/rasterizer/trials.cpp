#include "trials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "samples.h"

namespace mv {
namespace {

// The same numbers on every machine. Source: Steele, Lea, Flood, SplitMix (2014).
class Scattered {
  public:
    explicit Scattered(std::uint64_t seed) : state_(seed) {}
    int below(int end) {
        auto z = state_ += 0x9E3779B97F4A7C15U;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
        return static_cast<int>((z ^ (z >> 31)) % static_cast<std::uint64_t>(end));
    }

  private:
    std::uint64_t state_;
};

constexpr int lines = 64, triangles = 16, circles = 32;

struct TestLine {
    int x1, y1, x2, y2;
};
std::vector<TestLine> testLines(int columns) {
    Scattered random(26);
    std::vector<TestLine> made;
    for (int i = 0; i < lines; ++i) {
        const int length = columns / 2 + random.below(columns / 2), rise = random.below(length + 1);
        const int x = random.below(columns - length);
        made.push_back({x, random.below(columns), x + length, 0});
        made.back().y2 = made.back().y1 + rise;
    }
    return made;
}

std::vector<std::array<vec2, 3>> testTriangles(int columns, int rows) {
    Scattered random(23);
    std::vector<std::array<vec2, 3>> made(triangles);
    for (auto& corners : made) {
        for (vec2& corner : corners) {
            const double x = random.below(columns * subPixels) / double(subPixels);
            corner = {x, random.below(rows * subPixels) / double(subPixels)};
        }
    }
    return made;
}

std::vector<int> testRadii(int columns) {
    Scattered random(41);
    std::vector<int> radii;
    for (int i = 0; i < circles; ++i) radii.push_back(columns / 8 + random.below(columns * 3 / 8));
    return radii;
}
// The columns of an eighth, without that of the middle: as many as x <= y has.
int columnsOfEighth(int radius) {
    int columns = 0;
    while (2 * (columns + 1) * (columns + 1) <= radius * radius) ++columns;
    return columns;
}

std::int64_t roundedDown(std::int64_t above, std::int64_t below) {
    return above >= 0 ? above / below : -((-above + below - 1) / below);
}
std::int64_t roundedUp(std::int64_t above, std::int64_t below) { return -roundedDown(-above, below); }

}  // namespace

std::vector<double> lineTest(LineMethod method, int columns) {
    std::vector<double> heights;
    for (const TestLine& line : testLines(columns)) {
        const auto pixels = linePixels(method, line.x1, line.y1, line.x2, line.y2);
        const std::size_t begin = heights.size();
        heights.resize(begin + static_cast<std::size_t>(line.x2 - line.x1 + 1), 0);
        for (const PixelStep& pixel : pixels)
            heights[begin + static_cast<std::size_t>(pixel.x - line.x1)] += pixel.coverage * pixel.y;
    }
    return heights;
}

std::vector<double> lineTruth(int columns) {
    std::vector<double> heights;
    for (const TestLine& line : testLines(columns)) {
        for (int x = line.x1; x <= line.x2; ++x)
            heights.push_back(line.y1 + double(line.y2 - line.y1) * (x - line.x1) / double(line.x2 - line.x1));
    }
    return heights;
}

std::vector<double> triangleTest(FillMethod method, int columns, int rows) {
    const auto area = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    std::vector<double> covered(triangles * area, 0);
    std::size_t begin = 0;
    for (const auto& corners : testTriangles(columns, rows)) {
        for (const PixelStep& pixel : coveredPixels(corners, columns, rows, method).pixels)
            ++covered[begin + pixelIndex(pixel.x, pixel.y, columns)];
        begin += area;
    }
    return covered;
}

double triangleTestPixels(FillMethod method, int columns, int rows) {
    const auto covered = triangleTest(method, columns, rows);
    return static_cast<double>(std::count_if(covered.begin(), covered.end(), [](double one) { return one > 0; }));
}

std::vector<double> triangleTruth(int columns, int rows) {
    const auto area = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    std::vector<double> covered(triangles * area, 0);
    std::size_t begin = 0;
    for (const auto& corners : testTriangles(columns, rows)) {
        std::array<std::array<std::int64_t, 2>, 3> p{};
        for (std::size_t i = 0; i < 3; ++i)
            p.at(i) = {std::llround(corners.at(i).x * subPixels), std::llround(corners.at(i).y * subPixels)};
        for (int row = 0; row < rows; ++row) {
            // A row's middle lies in an edge that begins at or below it and ends above it: two of them cross it, or none. The
            // pixels from the left crossing, it included, to the right one, without it, are covered.
            const std::int64_t y = std::int64_t(row) * subPixels + subPixels / 2;
            std::vector<std::int64_t> from;  // the first pixel whose middle is at the crossing or right of it
            for (std::size_t i = 0; i < 3; ++i) {
                auto a = p.at(i), b = p.at((i + 1) % 3);
                if (a[1] > b[1]) std::swap(a, b);
                if (a[1] > y || b[1] <= y) continue;
                const std::int64_t below = b[1] - a[1], x = a[0] * below + (y - a[1]) * (b[0] - a[0]);
                from.push_back(roundedUp(x - below * (subPixels / 2), below * subPixels));
            }
            if (from.size() != 2) continue;
            const auto [first, end] = std::minmax(from[0], from[1]);
            for (std::int64_t column = std::max<std::int64_t>(first, 0); column < std::min<std::int64_t>(end, columns);
                 ++column)
                covered[begin + pixelIndex(static_cast<int>(column), row, columns)] = 1;
        }
        begin += area;
    }
    return covered;
}

std::vector<double> shareTest(int places, int columns, int rows) {
    std::vector<double> all;
    for (const auto& corners : testTriangles(columns, rows)) {
        const std::vector<double> one = sharesByPlaces(corners, places, columns, rows);
        all.insert(all.end(), one.begin(), one.end());
    }
    return all;
}

std::vector<double> shareTruth(int columns, int rows) {
    std::vector<double> all;
    for (const auto& corners : testTriangles(columns, rows)) {
        const std::vector<double> one = exactShares(corners, columns, rows);
        all.insert(all.end(), one.begin(), one.end());
    }
    return all;
}

std::vector<double> circleTest(CircleMethod method, int columns) {
    std::vector<double> reached;
    for (const int radius : testRadii(columns)) {
        const int eighth = columnsOfEighth(radius);
        const std::size_t begin = reached.size(), side = begin + static_cast<std::size_t>(eighth) + 1;
        reached.resize(begin + 2 * (static_cast<std::size_t>(eighth) + 1), 0);
        for (const PixelStep& pixel : circlePixels(method, 0, 0, radius)) {
            const auto note = [&](std::size_t from, int along, int out) {
                if (along < 0 || along > eighth) return;
                double& most = reached[from + static_cast<std::size_t>(along)];
                most = std::max(most, double(out));
            };
            note(begin, pixel.x, pixel.y);
            note(side, pixel.y, pixel.x);
        }
    }
    return reached;
}

double circleTestPixels(CircleMethod method, int columns) {
    double count = 0;
    for (const int radius : testRadii(columns)) count += double(circlePixels(method, 0, 0, radius).size());
    return count;
}

std::vector<double> circleTruth(int columns) {
    std::vector<double> out;
    for (const int radius : testRadii(columns)) {
        for (int eighth = 0; eighth < 2; ++eighth) {
            for (int x = 0; x <= columnsOfEighth(radius); ++x)
                out.push_back(std::sqrt(double(radius * radius - x * x)));
        }
    }
    return out;
}

long countDifferent(const Picture& a, const Picture& b) {
    const auto isWhite = [](const Picture& picture, std::size_t at) {
        return picture.rgba[at] == 255 && picture.rgba[at + 1] == 255 && picture.rgba[at + 2] == 255;
    };
    long count = 0;
    for (std::size_t at = 0; at < std::min(a.rgba.size(), b.rgba.size()); at += 4)
        count += isWhite(a, at) != isWhite(b, at);
    return count;
}

}  // namespace mv
