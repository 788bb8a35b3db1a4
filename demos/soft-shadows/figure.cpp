// Beside soft-shadows: the method, and a section through lamp and caster, in which one sees how wide the soft edge is.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "soft-shadows.h"

namespace mv::soft_shadows {
namespace {

// In the section: x is the distance from under the lamp's middle towards the caster, y the height.
struct Section {
    double lampHalf, lampHeight;  // the lamp lies level
    double near, far, low, high;  // the caster's sides, its underside and its top
};

Section sectionOf(const Settings& s, const Scene& scene) {
    const SceneLight& lamp = scene.lights[0];
    const bool isCube = s.scene == Which::cube;
    const double away = isCube ? std::hypot(lamp.position.x, lamp.position.z) : 0, half = isCube ? 0.5 : 0.75,
                 low = s.casterHeight + (isCube ? 0 : 0.68), high = s.casterHeight + (isCube ? 1 : 0.72);
    return {s.lampSize / 2, lamp.position.y, away - half, away + half, low, high};
}

// Where the ray from the lamp's point at `from` past (x, y) meets the floor.
double onFloor(const Section& section, double from, double x, double y) {
    return from + (x - from) * section.lampHeight / (section.lampHeight - y);
}

}  // namespace

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    if (!s.section) return;
    constexpr std::array names{"a shadow matrix for each point", "a shadow map for each point",
                               "one map, blurred by a fixed width", "one map, blurred as wide as it asks for",
                               "blurred in the picture"};
    const Section section = sectionOf(s, sceneOf(s, frame));
    const int size = std::clamp(frame.height() / 34, 7, 18);
    const vec4 ink(0.15, 0.15, 0.15, 1), paper(1, 1, 1, 0.88), lampColor(0.85, 0.50, 0, 1), dark(0.25, 0.25, 0.3, 1),
        soft(0.15, 0.40, 0.75, 1);

    // The edge of the shadow that is farther away: past the top, from the lamp's nearer end and from its farther one
    const double begin = onFloor(section, section.lampHalf, section.far, section.high),
                 end = onFloor(section, -section.lampHalf, section.far, section.high);
    const double left = std::min(-section.lampHalf, section.near), wide = std::max(end, section.far) - left,
                 unit = std::min(0.26 * frame.width() / wide, 0.20 * frame.height() / section.lampHeight);
    const vec2 corner(14, frame.height() - unit * section.lampHeight - 2.6 * size);
    const auto place = [&](double x, double y) { return corner + unit * vec2(x - left, y); };

    gpu.drawing.begin(frame);
    gpu.drawing.fill({corner - vec2(10, 2.2 * size), place(left + wide, section.lampHeight) + vec2(14, 2.4 * size)},
                     paper);
    gpu.drawing.line(place(left, 0), place(left + wide, 0), {ink, 1.5});
    gpu.drawing.line(place(-section.lampHalf, section.lampHeight), place(section.lampHalf, section.lampHeight),
                     {lampColor, 4});
    gpu.drawing.fill({place(section.near, section.low), place(section.far, section.high)}, {0.72, 0.30, 0.22, 1});
    for (const auto& [from, to] : {std::pair(section.lampHalf, begin), std::pair(-section.lampHalf, end)})
        gpu.drawing.line(place(from, section.lampHeight), place(to, 0), {lampColor, 1});
    gpu.drawing.line(place(std::max(section.near, left), 0), place(begin, 0), {dark, 4});
    gpu.drawing.line(place(begin, 0), place(end, 0), {soft, 6});
    gpu.drawing.textAround(place(0.0, section.lampHeight) + vec2(1.5 * size, 1.0 * size), "lamp",
                           {size, lampColor, vec4(0)});
    gpu.drawing.textAround(place(end, 0) - vec2(2.4 * size, 1.1 * size), "soft edge", {size, soft, vec4(0)});
    const bool isByMany = s.method == Method::matrix || s.method == Method::maps;
    gpu.drawing.text({10, 1.9 * size},
                     std::string(names.at(std::size_t(s.method))) +
                         (isByMany ? " of the lamp, " + std::to_string(s.lights) + " points" : ""),
                     {size, ink, paper});
    gpu.drawing.draw(frame);
}

}  // namespace mv::soft_shadows
