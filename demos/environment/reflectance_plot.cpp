#include "reflectance_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace mv {

void drawReflectance(Drawing& drawing, const Box& box, const Coating& coating) {
    const Plot plot{box, {0, 90, "angle from the normal, degrees"}, {0, 1, "part reflected"}};
    drawing.axes(plot);
    const bool isColored = coating.kind == Coating::Kind::metal;
    const std::array<vec4, 3> colors{vec4(0.8, 0.15, 0.1, 1), vec4(0.1, 0.55, 0.15, 1), vec4(0.1, 0.3, 0.8, 1)};
    for (int color = 0; color < (isColored ? 3 : 1); ++color) {
        std::vector<vec2> exact, thin;
        for (int i = 0; i <= 180; ++i) {
            const double angle = 0.5 * i, cosine = std::clamp(std::cos(radians(angle)), 0.0, 1.0);
            exact.emplace_back(angle, coating.reflected(cosine)[color]);
            thin.emplace_back(angle, coating.reflected(cosine, true)[color]);
        }
        const vec4 ink = isColored ? colors.at(static_cast<std::size_t>(color)) : vec4(0.1, 0.1, 0.1, 1);
        drawing.curve(plot, exact, {ink, 2});
        drawing.curve(plot, thin, {ink, 1});
    }
}

}  // namespace mv
