// A line: in each column, or row, the pixel nearest to it.
#include "line.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "mv/formatted.h"
#include "sheet.h"
#include "trials.h"

namespace mv::rasterizer {

// A smooth line is thin.
static int thicknessOf(const Line& line) { return line.method == LineMethod::smooth ? 1 : line.thickness; }

static std::vector<PixelStep> pixelsOf(const Line& line, const Grid& grid) {
    const auto [from, to] = line.ends;
    return thickLine(line.method, line.thicken, thicknessOf(line), grid.whole(from.x), grid.whole(from.y),
                     grid.whole(to.x), grid.whole(to.y));
}

std::size_t countLine(const Line& line, const Grid& grid) { return pixelsOf(line, grid).size(); }

static MeshData meshOf(const Line& line, const Grid& grid);

void drawLine(Gpu& gpu, const Settings& s, const Grid& grid, const Frame& frame) {
    const Line& line = s.line;
    const std::vector<PixelStep> pixels = pixelsOf(line, grid);
    const Picture mine = inked(grid, pixels), glPicture = byOpenGl(gpu, meshOf(line, grid), grid, frame);

    showPictures(gpu, frame, grid, mine, glPicture, {{{line.ends[0] + 0.5, line.ends[1] + 0.5}}});
    if (thicknessOf(line) == 1) {
        showErrors(gpu, pixels, grid, frame);
        showDecision(gpu, line, pixels, grid, frame);
    }
    const auto different = differing(grid.allSet(), pixels, glPicture);
    const bool areFew = different.size() <= 6;
    if (areFew) showDifferent(gpu, different, grid, frame);
    showWords(gpu, frame, grid, std::string(nameOf(line.method)) + ": " + countOf(grid, pixels.size()),
              formatted(areFew ? "OpenGL: pixels set otherwise, ringed: %.0f" : "OpenGL: pixels set otherwise: %.0f",
                        double(countDifferent(inked(grid.allSet(), pixels), glPicture))));
}

// The mesh for OpenGL: a line if thin, a strip of two triangles if thick.
static MeshData meshOf(const Line& line, const Grid& grid) {
    MeshData data{.primitive = thicknessOf(line) == 1 ? Primitive::lines : Primitive::triangles};
    const auto add = [&](const vec2& at) {
        data.positions.emplace_back(at.x, at.y, 1);
        data.colors.emplace_back(fvec3(colorOf(first)), 1);
    };
    const auto [from, to] = line.ends;
    if (thicknessOf(line) == 1) {
        for (const vec2& end : {from, to}) add({grid.whole(end.x) + 0.5, grid.whole(end.y) + 0.5});
        return data;
    }
    const auto corners =
        stripOf(thicknessOf(line), grid.whole(from.x), grid.whole(from.y), grid.whole(to.x), grid.whole(to.y));
    for (const int i : {0, 1, 2, 0, 2, 3}) add(corners.at(static_cast<std::size_t>(i)));
    return data;
}

void readLine(const Gpu& gpu, const Line& line, const Grid& grid, Numbers& numbers) {
    const std::vector<PixelStep> pixels = pixelsOf(line, grid);
    numbers.set("set", double(pixels.size()));
    numbers.set("differs", double(countDifferent(inked(grid.allSet(), pixels), gpu.glPicture)));
    const vec2 from(grid.whole(line.ends[0].x), grid.whole(line.ends[0].y)),
        to(grid.whole(line.ends[1].x), grid.whole(line.ends[1].y));
    if (from != to) numbers.set("as-thick", double(pixels.size()) / glm::distance(from, to));
}

}  // namespace mv::rasterizer

namespace mv {
namespace {

std::vector<PixelStep> naive(int x1, int y1, int x2, int y2) {
    std::vector<PixelStep> set;
    const float m = static_cast<float>(y2 - y1) / static_cast<float>(x2 - x1);
    auto y = static_cast<float>(y1);
    for (int x = x1; x <= x2; ++x, y += m) {
        // A vertical line has no slope, and only its first pixel is drawn
        if (!(std::abs(y) < 1e9F)) break;
        set.push_back({x, static_cast<int>(std::lround(y)), static_cast<double>(y)});
    }
    return set;
}

// Count in floats, by e, how far the line is above the pixel's middle. e begins at `start`; y steps where e reaches `limit`.
std::vector<PixelStep> withError(int x1, int y1, int x2, int y2, float start, float limit) {
    std::vector<PixelStep> set;
    const float m = static_cast<float>(y2 - y1) / static_cast<float>(x2 - x1);
    float e = start;
    for (int x = x1, y = y1; x <= x2; ++x) {
        set.push_back({x, y, static_cast<double>(e)});
        e += m;
        if (e >= limit) {
            ++y;
            e -= 1;
        }
    }
    return set;
}

// The same with e in units of 1/(x2 - x1), and halves of them.
std::vector<PixelStep> scaled(int x1, int y1, int x2, int y2) {
    std::vector<PixelStep> set;
    double e = -0.5 * (x2 - x1);
    for (int x = x1, y = y1; x <= x2; ++x) {
        set.push_back({x, y, e});
        e += y2 - y1;
        if (e >= 0) {
            ++y;
            e -= x2 - x1;
        }
    }
    return set;
}

std::vector<PixelStep> bresenham(int x1, int y1, int x2, int y2) {
    std::vector<PixelStep> set;
    int e = -(x2 - x1);
    for (int x = x1, y = y1; x <= x2; ++x) {
        set.push_back({x, y, double(e)});
        e += 2 * (y2 - y1);
        if (e >= 0) {
            ++y;
            e -= 2 * (x2 - x1);
        }
    }
    return set;
}

// A line whose x and y are swapped where it is steep, so that it goes along x by no less than along y.
struct Turned {
    bool steep;
    int x1, y1, x2, y2;
    Turned(int ax, int ay, int bx, int by)
        : steep(std::abs(by - ay) > std::abs(bx - ax)), x1(ax), y1(ay), x2(bx), y2(by) {
        if (!steep) return;
        std::swap(x1, y1);
        std::swap(x2, y2);
    }
    int step() const { return x1 <= x2 ? 1 : -1; }
    PixelStep back(PixelStep step) const {
        if (steep) std::swap(step.x, step.y);
        return step;
    }
};

std::vector<PixelStep> octants(int ax, int ay, int bx, int by) {
    std::vector<PixelStep> set;
    const Turned line(ax, ay, bx, by);
    const int rise = std::abs(line.y2 - line.y1), up = line.y1 < line.y2 ? 1 : -1, run = std::abs(line.x2 - line.x1);
    // Break a tie between two pixels by the direction, so that a line sets the same pixels there and back
    const int least = line.step() > 0 ? 0 : 1;
    int e = -run;
    for (int i = 0, x = line.x1, y = line.y1; i <= run; ++i, x += line.step()) {
        set.push_back(line.back({x, y, double(e)}));
        e += 2 * rise;
        if (e >= least) {
            y += up;
            e -= 2 * run;
        }
    }
    return set;
}

std::vector<PixelStep> smooth(int ax, int ay, int bx, int by) {
    std::vector<PixelStep> set;
    const Turned line(ax, ay, bx, by);
    const int run = std::abs(line.x2 - line.x1);
    for (int i = 0, x = line.x1; i <= run; ++i, x += line.step()) {
        // Compute y at x as whole + part, with no rounding in `whole`
        const long rise = long(line.y2 - line.y1) * i;
        const long whole = run == 0 ? 0 : (rise >= 0 ? rise / run : -((-rise + run - 1) / run));
        const double part = run == 0 ? 0 : double(rise - whole * run) / run;
        const int y = line.y1 + static_cast<int>(whole);
        set.push_back(line.back({x, y, part, 1 - part}));
        if (part > 0) set.push_back(line.back({x, y + 1, part, part}));
    }
    return set;
}

}  // namespace

std::vector<PixelStep> linePixels(LineMethod method, int x1, int y1, int x2, int y2) {
    switch (method) {
        case LineMethod::naive:
            return naive(x1, y1, x2, y2);
        case LineMethod::error:
            return withError(x1, y1, x2, y2, 0, 0.5F);
        case LineMethod::shifted:
            return withError(x1, y1, x2, y2, -0.5F, 0);
        case LineMethod::scaled:
            return scaled(x1, y1, x2, y2);
        case LineMethod::bresenham:
            return bresenham(x1, y1, x2, y2);
        case LineMethod::octants:
            return octants(x1, y1, x2, y2);
        case LineMethod::smooth:
            return smooth(x1, y1, x2, y2);
    }
    return {};
}

}  // namespace mv
