#include "shared/relief_figures.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "mv/formatted.h"
#include "mv/gl/text.h"
#include "mv/math/color.h"

namespace mv {
namespace {

const vec4 ink(0.1, 0.1, 0.1, 1), grey(0.55, 0.55, 0.55, 1), lampColor(0.85, 0.6, 0.0, 1), lampInk(0.6, 0.42, 0.0, 1),
    blue(0.1, 0.3, 0.75, 1);

vec2 way(double degrees) { return {std::sin(radians(degrees)), std::cos(radians(degrees))}; }

}  // namespace

vec2 SightFigure::tip(double degrees) const { return foot + size * way(degrees); }

void SightFigure::draw(Drawing& drawing, double degrees, int wordHeight) const {
    drawing.line(foot - vec2(0.2 * size, 0), foot + vec2(size, 0), {ink, 2});
    drawing.line(foot, tip(0), {grey, 1});
    drawing.arrow(foot, tip(degrees), {blue, 2});
    std::vector<vec2> arc;
    for (int i = 0; i <= 20; ++i) arc.push_back(foot + 0.35 * size * way(degrees * i / 20));
    drawing.line(arc, {blue, 1});
    if (wordHeight > 0)
        drawing.text(foot + vec2(-0.2 * size, size + 1.5 * wordHeight), formatted("eye at %.0f°", degrees),
                     {wordHeight, blue, vec4(0)});
}

void LampDial::draw(Drawing& drawing, const vec3& towardsLamp, int wordHeight) const {
    std::vector<vec2> ring;
    for (int i = 0; i <= 48; ++i) ring.push_back(middle + radius * way(7.5 * i));
    drawing.line(ring, {grey, 1.5});
    drawing.line(middle, at(towardsLamp), {lampColor, 1.5});
    drawing.point(at(towardsLamp), 12, lampColor);
    if (wordHeight > 0)
        drawing.text(middle + vec2(1.2 * radius, 0.6 * wordHeight), "lamp", {wordHeight, lampInk, vec4(0)});
}

const std::vector<vec3>& levelColors() {
    static const std::vector<vec3> colors{{0.03, 0.05, 0.32}, {0.03, 0.17, 0.52}, {0.03, 0.38, 0.38},
                                          {0.13, 0.45, 0.10}, {0.70, 0.52, 0.05}, {0.79, 0.21, 0.03},
                                          {0.60, 0.03, 0.03}};
    return colors;
}

void drawLevelColors(Drawing& drawing, const FrameInfo& frame, int wordHeight) {
    const double side = 1.6 * wordHeight;
    for (std::size_t i = 0; i < levelColors().size(); ++i) {
        const vec2 low(frame.width() - 3.6 * wordHeight, 0.5 * wordHeight + side * double(i));
        drawing.fill({low, low + vec2(3.2 * wordHeight, side)}, vec4(1, 1, 1, 0.8));
        const vec4 color(srgbFromLinear(levelColors()[i]), 1);
        drawing.fill({low + side * vec2(0.2, 0.15), low + side * vec2(0.9, 0.85)}, color);
        drawing.text(low + vec2(side, 1.3 * wordHeight), std::to_string(1U << i), {wordHeight, ink, vec4(0)});
    }
}

}  // namespace mv
