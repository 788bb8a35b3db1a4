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

void magnify(const Picture& small, const Plot& plot, const Pane& pane, const vec2& scale, Picture& sheet) {
    const vec2 low = scale * (vec2(pane.x, pane.y) + plot.box.low),
               each = scale * plot.box.size() / vec2(small.width, small.height);
    const double top = sheet.height - low.y - each.y * small.height;
    for (int y = 0; y < sheet.height; ++y) {
        const int row = static_cast<int>(std::floor((y + 0.5 - top) / each.y));
        if (row < 0 || row >= small.height) continue;
        for (int x = 0; x < sheet.width; ++x) {
            const int column = static_cast<int>(std::floor((x + 0.5 - low.x) / each.x));
            if (column >= 0 && column < small.width) sheet.set(x, y, small.at(column, row));
        }
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
