// Beside the scene of shadow-polygons: the sphere round the light with what is on it, or the table of all pairs.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mv/demo/handle.h"
#include "mv/geometry/closest.h"
#include "mv/gl/text.h"
#include "shadow-polygons.h"

namespace mv::shadow_polygons {

static const vec4 ink(0.1, 0.1, 0.1, 1), grey(0.6, 0.6, 0.6, 1), inVain(0.93, 0.55, 0.15, 1), dark(0.10, 0.35, 0.75, 1);

static Pane besidePane(const Settings& s, const FrameInfo& frame) {
    const Pane scene = scenePane(s, frame);
    if (frame.isUpright()) return {0, 0, frame.width(), std::max(1, scene.y)};
    return {scene.width, 0, std::max(1, frame.width() - scene.width), frame.height()};
}

// The sphere laid flat, equal areas to equal areas: straight down from the light in the middle, straight up along the rim.
// (Lambert's azimuthal projection.)
static vec2 flat(const vec3& direction) {
    const double across = std::hypot(direction.x, direction.z);
    if (across == 0) return vec2(0, direction.y > 0 ? 1 : 0);
    return std::sqrt((1 + direction.y) / 2) / across * vec2(direction.x, -direction.z);
}

// The largest square of the pane that leaves room for words above it.
static Box squareIn(const Pane& pane, int words) {
    const vec2 room(pane.width, std::max(1, pane.height - words));
    const double side = 0.94 * std::min(room.x, room.y);
    const vec2 low = (room - side) / 2.0;
    return {low, low + side};
}

namespace {

// The flat sphere in its square.
class Sphere {
  public:
    Sphere(Drawing& drawing, const Box& box)
        : drawing_(drawing), middle_((box.low + box.high) / 2.0), radius_(box.size().x / 2) {}

    vec2 pixel(const vec3& direction) const { return middle_ + radius_ * flat(direction); }
    void rim() {
        std::vector<vec2> round = circle(middle_, radius_);
        round.push_back(round.front());
        drawing_.line(round, {grey, 1});
    }
    // The points of a curve, which is broken where it runs through straight up, which is all of the rim.
    void curve(const std::vector<vec3>& directions, const Stroke& stroke) {
        std::vector<vec2> part;
        for (const vec3& direction : directions) {
            const vec2 next = pixel(direction);
            if (!part.empty() && glm::distance(part.back(), next) > radius_ / 2) {
                if (part.size() > 1) drawing_.line(part, stroke);
                part.clear();
            }
            part.push_back(next);
        }
        if (part.size() > 1) drawing_.line(part, stroke);
    }

  private:
    Drawing& drawing_;
    vec2 middle_;
    double radius_;
};

}  // namespace

static void drawOutline(Sphere& sphere, const FlatPolygon& polygon, const vec3& light) {
    std::vector<vec3> directions;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const vec3 &a = polygon.corners[i], &b = polygon.corners[(i + 1) % polygon.corners.size()];
        const double nearest = glm::distance(light, closestOnSegment(light, a, b));
        // A step of at most some 6 degrees of the great circle
        const int steps = int(std::ceil(std::min(64.0, 10 * glm::distance(a, b) / std::max(nearest, 1e-6))));
        for (int k = 0; k <= steps; ++k) {
            const vec3 there = a + double(k) / steps * (b - a) - light;
            if (there != vec3(0)) directions.push_back(glm::normalize(there));
        }
    }
    sphere.curve(directions, {vec4(0.75 * polygon.color, 1), 2});
}

static void drawCap(Sphere& sphere, const Cap& cap) {
    if (cap.chord >= 2) return;
    const vec3 other = std::abs(cap.axis.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0);
    const vec3 u = glm::normalize(glm::cross(cap.axis, other)), v = glm::cross(cap.axis, u);
    const double cosine = 1 - cap.chord * cap.chord / 2, sine = std::sqrt(1 - cosine * cosine);
    std::vector<vec3> round;
    for (int i = 0; i <= 48; ++i) {
        const double angle = 2 * pi * i / 48;
        round.push_back(cosine * cap.axis + sine * (std::cos(angle) * u + std::sin(angle) * v));
    }
    sphere.curve(round, {grey, 1});
}

static std::set<CasterOn> darkPairs(const Shadows& shadows) {
    std::set<CasterOn> pairs;
    for (const Shadow& shadow : shadows.dark) pairs.insert(shadow.of);
    return pairs;
}

// Draw the outlines and caps, and a line for each pair that is projected: those without a shadow first.
static void drawSphere(Gpu& gpu, const Settings& s, const Box& box) {
    Sphere sphere(gpu.drawing, box);
    sphere.rim();
    for (const Cap& cap : gpu.caps) drawCap(sphere, cap);
    for (const FlatPolygon& polygon : gpu.polygons) drawOutline(sphere, polygon, s.light);
    const std::set<CasterOn> withShadow = darkPairs(gpu.shadows);
    for (const bool shows : {false, true}) {
        for (const CasterOn& pair : gpu.shadows.pairs.kept) {
            if (withShadow.contains(pair) != shows) continue;
            const Stroke stroke{shows ? dark : vec4(vec3(inVain), 0.6), 1};
            gpu.drawing.line(sphere.pixel(gpu.caps[pair.caster].axis), sphere.pixel(gpu.caps[pair.receiver].axis),
                             stroke);
        }
    }
    for (const Cap& cap : gpu.caps) gpu.drawing.point(sphere.pixel(cap.axis), 5, ink);
}

// Show a cell for each pair: a row for each receiver, a column for each caster.
static void drawPairs(const Gpu& gpu, const FrameInfo& frame, const Pane& pane, const Box& box) {
    const double pixels = frame.scale().x;
    const int count = int(gpu.polygons.size()), cell = std::max(1, int(box.size().x * pixels) / count),
              side = cell * count;
    Picture picture(side, side);
    const auto fill = [&](std::size_t row, std::size_t column, const vec3& color) {
        const int gap = cell > 4 ? std::max(1, int(std::lround(pixels))) : 0;
        for (int y = int(row) * cell; y < (int(row) + 1) * cell - gap; ++y) {
            for (int x = int(column) * cell; x < (int(column) + 1) * cell - gap; ++x)
                picture.set(x, y,
                            {std::uint8_t(255 * color.x), std::uint8_t(255 * color.y), std::uint8_t(255 * color.z)});
        }
    };
    const auto number = std::size_t(count);
    for (std::size_t row = 0; row < number; ++row) {
        for (std::size_t column = 0; column < number; ++column) fill(row, column, vec3(row == column ? 1.0 : 0.92));
    }
    for (const CasterOn& pair : gpu.shadows.pairs.kept) fill(pair.receiver, pair.caster, vec3(inVain));
    for (const Shadow& shadow : gpu.shadows.dark) fill(shadow.of.receiver, shadow.of.caster, vec3(dark));
    showImage(frame, pane.x + int(box.low.x), frame.height() - int(box.high.y), picture);
}

static std::vector<std::pair<std::string, vec4>> wordsOf(const Gpu& gpu, Show show) {
    const auto ofAll = [](long part, std::size_t all) { return std::to_string(part) + " of " + std::to_string(all); };
    const std::size_t count = gpu.polygons.size();
    const Pairs& pairs = gpu.shadows.pairs;
    return {{std::to_string(count) + " polygons; pairs compared: " + ofAll(pairs.tested, count * (count - 1) / 2), ink},
            {"projected: " + ofAll(long(pairs.kept.size()), count * (count - 1)), inVain},
            {"of these with a shadow: " + std::to_string(gpu.shadows.dark.size()), dark},
            {show == Show::pairs ? "a row for each receiver, a column for each caster"
                                 : "middle: straight down from the light; rim: straight up",
             vec4(0.4, 0.4, 0.4, 1)}};
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    gpu.drawing.begin(frame);
    const Pane scene = scenePane(s, frame);
    const FrameInfo inPane(frame.index(), scene.width, scene.height);
    gpu.drawing.in(scene);
    gpu.drawing.point(sceneOf(s, inPane).clipFromWorld(), s.light, 11, {0.95, 0.75, 0.1, 1});
    gpu.drawing.text(sceneOf(s, inPane).clipFromWorld(), s.light, {8, 20}, "light");
    if (s.show != Show::scene) {
        const Pane pane = besidePane(s, frame);
        const int height = std::clamp(frame.height() / 34, 8, 16), words = 4 * (height + 5);
        const Box box = squareIn(pane, words);
        gpu.drawing.in(pane);
        gpu.drawing.fill({vec2(0), vec2(pane.width, pane.height)}, vec4(1));
        if (s.show == Show::sphere) drawSphere(gpu, s, box);
        vec2 at(box.low.x, pane.height - 6);
        for (const auto& [line, color] : wordsOf(gpu, s.show)) {
            gpu.drawing.text(at, line, {height, color, vec4(0)});
            at.y -= height + 5;
        }
    }
    gpu.drawing.draw(frame);
    if (s.show == Show::pairs) {
        const Pane pane = besidePane(s, frame);
        drawPairs(gpu, frame, pane, squareIn(pane, 4 * (std::clamp(frame.height() / 34, 8, 16) + 5)));
    }
}

void readOut(Gpu& gpu, const Settings&, const Frame&, Numbers& numbers) {
    numbers.set("pairs-compared", double(gpu.shadows.pairs.tested));
    numbers.set("projections", double(gpu.shadows.pairs.kept.size()));
    numbers.set("shadows", double(gpu.shadows.dark.size()));
}

}  // namespace mv::shadow_polygons
