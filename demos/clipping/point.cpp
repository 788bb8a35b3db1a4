// A point is inside a window where none of its signed distances from four half planes is negative.
#include "clipping.h"
#include "mv/formatted.h"
#include "mv/gl/text.h"

namespace mv::clipping {

using namespace clip;

void drawPoint(ClipFigure& figure, const Settings& s, const Frame&) {
    const vec2 point = s.plane.ends[0];
    const Box window = windowOf(s.plane);
    figure.window(window);
    figure.say("inside where no signed distance is negative:");
    bool inside = true;
    static const std::array<const char*, 4> names{"x - x_min", "x_max - x", "y - y_min", "y_max - y"};
    const auto planes = halfPlanes(window);
    for (std::size_t i = 0; i < 4; ++i) {
        const vec2 normal = planes.at(i).normal;
        const double distance = planes.at(i).of(point);
        inside = inside && distance >= 0;
        const vec4& color = distance < 0 ? red : green;
        figure.say(names.at(i) + formatted(" = %.2f", distance), color);
        const vec2 aside = (i % 2 == 0 ? 4.0 : -4.0) * vec2(normal.y, normal.x);
        figure.drawing.arrow(figure.px(point - distance * normal) + aside, figure.px(point) + aside, {color, 2});
    }
    figure.say(inside ? "It is kept." : "It is not kept.", inside ? green : red);
    figure.point(point, 10, inside ? green : red);
    figure.name(point, "p: " + codeText(regionCode(window, point)));
}

}  // namespace mv::clipping
