// Drawn over the picture and beside it: the chosen pixel, its ray from the side, and the objects that the ray meets.
#include <algorithm>
#include <string>

#include "mv/formatted.h"
#include "mv/geometry/plot.h"
#include "mv/gl/text.h"
#include "mv/gl/word_size.h"
#include "ray-cast.h"

namespace mv::ray_cast {

int column(const Settings& s) { return std::min(static_cast<int>(s.pixelX * s.rows), s.rows - 1); }
int row(const Settings& s) { return std::min(static_cast<int>((1 - s.pixelY) * s.rows), s.rows - 1); }
std::vector<CastCandidate> chosen(const Settings& s) { return candidates(s, shownBy(s), rayOf(s, column(s), row(s))); }

Pane picturePane(const FrameInfo& frame) {
    const int side = std::max(1, std::min(frame.width() / 2, frame.height() * 8 / 9));
    return {0, 0, side, side};
}
Pane sidePane(const FrameInfo& frame) {
    const int left = picturePane(frame).width + 4, low = frame.height() * 2 / 5;
    return {left, low, std::max(1, frame.width() - left), std::max(1, frame.height() - low)};
}
CastSide fromSide(const Settings& s, const FrameInfo& frame) { return {sidePane(frame), eyeOf(s), s.distance, s.size}; }

static std::string title(const Settings& s) {
    if (s.by == Maker::gl) return "triangles, by OpenGL";
    const std::string cells = std::to_string(s.rows) + " x " + std::to_string(s.rows);
    if (s.by == Maker::raster) return "triangles filled into " + cells + " pixels";
    if (isThere(s, CastKind::teapot)) return cells + " rays, " + std::to_string(s.triangles) + " triangles";
    return cells + " rays, " + (hasForms(s) ? nameOf(s.form) : "stable") + ", in " + nameOf(s.precision);
}

// Draw the pixels' grid, and a red frame round the chosen one.
static void drawPixels(Drawing& drawing, const Settings& s, const Pane& pane) {
    drawing.in(pane);
    const double cell = double(pane.width) / s.rows;
    const Plot plot{{vec2(0), vec2(pane.width)}, {0, double(s.rows)}, {0, double(s.rows)}};
    if (cell >= 6) drawing.pixelGrid(plot, {vec4(0.1, 0.1, 0.1, 0.25), 1});
    const vec2 low = plot.pixel({column(s), s.rows - 1 - row(s)}), high = low + vec2(cell);
    const std::vector<vec2> marked{low, {high.x, low.y}, high, {low.x, high.y}, low};
    drawing.line(marked, {vec4(1), 4});  // under the red, which a red object would hide
    drawing.line(marked, {castRed, 2});
    if (cell < 6) drawing.line(low + vec2(5 + cell, 5 + cell), low + vec2(24, 24), {castRed, 2});
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    Drawing& drawing = gpu.drawing;
    drawing.begin(frame);
    const int height = std::clamp(frame.height() / 34, leastWords, 24);
    const TextStyle words{height, castInk, vec4(0)};
    drawing.text({6, frame.height() - 2}, title(s), words);
    drawing.text({6, frame.height() - 2 - 1.2 * height},
                 formatted("pixel (%.0f, ", column(s)) + formatted("%.0f), the ray through its middle", row(s)),
                 {height, castRed, vec4(0)});
    drawPixels(drawing, s, picturePane(frame));

    const Pane side = sidePane(frame), table{side.x, 0, side.width, std::max(1, side.y)};
    const std::vector<CastCandidate> met = chosen(s);
    fromSide(s, frame).draw(drawing, rayOf(s, column(s), row(s)), met, words);
    drawCandidates(drawing, table, met, kindsOf(s), words);
    drawing.draw(frame);
}

}  // namespace mv::ray_cast
