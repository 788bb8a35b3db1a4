#include "pixel_grid.h"

#include <algorithm>
#include <cmath>

namespace mv {

Plot gridPlot(const Pane& pane, int columns, int rows, int margin) {
    const int side = std::max(1, std::min((pane.width - 2 * margin) / columns, (pane.height - 2 * margin) / rows));
    const vec2 upperLeft(margin, pane.height - margin);
    return {{{upperLeft.x, upperLeft.y - side * rows}, {upperLeft.x + side * columns, upperLeft.y}},
            {0, double(columns)},
            {0, double(rows)}};
}

void magnify(const Picture& small, const Plot& plot, const Pane& pane, Picture& sheet) {
    const int side = static_cast<int>(std::lround(plot.box.size().x / small.width));
    const int left = pane.x + static_cast<int>(plot.box.low.x);
    const int top = sheet.height - pane.y - static_cast<int>(plot.box.high.y);
    for (int y = std::max(0, top); y < std::min(sheet.height, top + side * small.height); ++y) {
        for (int x = std::max(0, left); x < std::min(sheet.width, left + side * small.width); ++x)
            sheet.set(x, y, small.at((x - left) / side, (y - top) / side));
    }
}

void drawGrid(Drawing& drawing, const Plot& plot) {
    const double side = plot.box.size().x / plot.x.high;
    if (side >= 6) drawing.pixelGrid(plot, {vec4(0.8, 0.82, 0.86, 1), 1});
    const vec2 low = plot.box.low, high = plot.box.high;
    const vec2 frame[] = {low, {high.x, low.y}, high, {low.x, high.y}, low};
    drawing.line(frame, {vec4(0.3, 0.3, 0.3, 1), 1});
}

}  // namespace mv
