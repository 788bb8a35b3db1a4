// A circle: in an eighth of it the pixel of each column that is nearest, and its seven mirror images.
#include "circle.h"

#include <cmath>
#include <numbers>
#include <string>

#include "mv/error.h"
#include "sheet.h"
#include "trials.h"

namespace mv::rasterizer {

// OpenGL has no circles. Here it draws this many chords instead.
static constexpr int chords = 48;

static int radiusOf(const Circle& circle, const Grid& grid) { return static_cast<int>(circle.radius * grid.scale); }

static std::vector<PixelStep> pixelsOf(const Circle& circle, const Grid& grid) {
    return circlePixels(circle.method, grid.whole(circle.middle.x), grid.whole(circle.middle.y),
                        radiusOf(circle, grid));
}

std::size_t countCircle(const Circle& circle, const Grid& grid) { return pixelsOf(circle, grid).size(); }

// The ring of chords, in pixels.
static std::vector<vec2> ringOf(const Circle& circle, const Grid& grid) {
    const vec2 middle(grid.whole(circle.middle.x) + 0.5, grid.whole(circle.middle.y) + 0.5);
    std::vector<vec2> ring;
    for (int i = 0; i <= chords; ++i) {
        const double turn = 2 * std::numbers::pi * (i % chords) / chords;
        ring.push_back(middle + double(radiusOf(circle, grid)) * vec2(std::cos(turn), std::sin(turn)));
    }
    return ring;
}

void drawCircle(Gpu& gpu, const Settings& s, const Grid& grid, const Frame& frame) {
    const Circle& circle = s.circle;
    const std::vector<PixelStep> pixels = pixelsOf(circle, grid);
    std::vector<vec2> ring = ringOf(circle, grid);
    MeshData data{.primitive = Primitive::lines};
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        for (const vec2& end : {ring[i], ring[i + 1]}) {
            data.positions.emplace_back(end.x, end.y, 1);
            data.colors.emplace_back(fvec3(colorOf(first)), 1);
        }
    }
    const Picture mine = inked(grid, pixels), glPicture = byOpenGl(gpu, std::move(data), grid, frame);

    for (vec2& point : ring) point /= grid.scale;
    showPictures(gpu, frame, grid, mine, glPicture, {{std::move(ring)}});
    if (circle.method != CircleMethod::turned)
        showErrors(gpu, pixels, grid, frame);  // turned points have roundings instead
    showWords(gpu, frame, grid, std::string(nameOf(circle.method)) + ": " + countOf(grid, pixels.size()),
              std::to_string(chords) + " chords by OpenGL: pixels set otherwise: " +
                  std::to_string(countDifferent(inked(grid.allSet(), pixels), glPicture)));
}

void readCircle(const Gpu& gpu, const Circle& circle, const Grid& grid, Numbers& numbers) {
    const std::vector<PixelStep> pixels = pixelsOf(circle, grid);
    numbers.set("set", double(pixels.size()));
    numbers.set("differs", double(countDifferent(inked(grid.allSet(), pixels), gpu.glPicture)));
}

}  // namespace mv::rasterizer

namespace mv {
namespace {

// The pixels of a circle round (0, 0), moved to the middle (x, y).
struct Round {
    int x, y;
    std::vector<PixelStep> set = {};

    void add(int dx, int dy, double error) { set.push_back({x + dx, y + dy, error}); }
    // On an axis or a diagonal two of the mirror images are one pixel.
    void addUpAndDown(int dx, int dy, double error) {
        add(dx, dy, error);
        if (dy != 0) add(dx, -dy, error);
    }
    void addEight(int dx, int dy, double error) {
        addUpAndDown(dx, dy, error);
        if (dx != 0) addUpAndDown(-dx, dy, error);
        if (dx == dy) return;
        addUpAndDown(dy, dx, error);
        if (dy != 0) addUpAndDown(-dy, dx, error);
    }
};

float heightAt(int dx, int radius) {
    const auto x = static_cast<float>(dx), r = static_cast<float>(radius);
    return std::sqrt(r * r - x * x);
}

void columns(Round& round, int radius) {
    for (int dx = -radius; dx <= radius; ++dx) {
        const float height = heightAt(dx, radius);
        const auto dy = static_cast<int>(std::lround(height));
        round.addUpAndDown(dx, dy, double(height));
    }
}

void mirrored(Round& round, int radius) {
    for (int dx = 0; dx <= radius; ++dx) {
        const float height = heightAt(dx, radius);
        const auto dy = static_cast<int>(std::lround(height));
        if (dx > dy) return;
        round.addEight(dx, dy, double(height));
    }
}

void turned(Round& round, int radius) {
    if (radius == 0) return round.add(0, 0, 0);
    const float step = 1 / static_cast<float>(radius), cosine = std::cos(step), sine = std::sin(step);
    const auto steps = static_cast<int>(std::ceil(2 * std::numbers::pi * radius));
    auto px = static_cast<float>(radius), py = 0.0F;
    for (int i = 0; i < steps; ++i) {
        const auto dx = static_cast<int>(std::lround(px)), dy = static_cast<int>(std::lround(py));
        const bool isNew =
            round.set.empty() || round.set.back().x != round.x + dx || round.set.back().y != round.y + dy;
        if (isNew) round.add(dx, dy, std::hypot(double(px), double(py)) - radius);
        const float turnedX = cosine * px - sine * py;
        py = sine * px + cosine * py;
        px = turnedX;
    }
}

// d is (dx + 1)^2 + (dy - 1/2)^2 - r^2 less 1/4, which changes no decision. The point midway between the next pixel and
// the pixel below it is inside the circle if d is below 0.
void midpoint(Round& round, int radius) {
    int d = 1 - radius;
    for (int dx = 0, dy = radius; dx <= dy; ++dx) {
        round.addEight(dx, dy, d);
        if (d < 0) {
            d += 2 * dx + 3;
        } else {
            d += 2 * (dx - dy) + 5;
            --dy;
        }
    }
}

}  // namespace

std::vector<PixelStep> circlePixels(CircleMethod method, int x, int y, int radius) {
    constexpr int largest = 1 << 20, farthest = 1 << 30;
    if (radius < 0 || radius > largest)
        throw Error("circlePixels", "radius must be 0 .. " + std::to_string(largest), std::to_string(radius));
    for (const int part : {x, y}) {
        if (part < -farthest || part > farthest)
            throw Error("circlePixels", "the middle must be within 2^30 pixels of the first", std::to_string(part));
    }
    Round round{x, y};
    switch (method) {
        case CircleMethod::columns:
            columns(round, radius);
            break;
        case CircleMethod::mirrored:
            mirrored(round, radius);
            break;
        case CircleMethod::turned:
            turned(round, radius);
            break;
        case CircleMethod::midpoint:
            midpoint(round, radius);
            break;
    }
    return std::move(round.set);
}

}  // namespace mv
