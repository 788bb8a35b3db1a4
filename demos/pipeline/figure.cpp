// The numbers of pipeline: the products as the GPU makes them, and by how much they differ from doubles all the way.
#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <string>

#include "gpu_product.h"
#include "mv/formatted.h"
#include "mv/geometry/plot.h"
#include "mv/gl/functions.h"
#include "mv/gl/text_column.h"
#include "pipeline.h"

namespace mv::pipeline {

static const vec4 red(0.8, 0.1, 0.1, 1), green(0, 0.45, 0.1, 1), grey(0.5, 0.5, 0.5, 1);

static void heading(TextColumn& text, const std::string& formula) {
    text.next(6);
    text.left(0, formula, vec4(0.1, 0.25, 0.7, 1));
    text.right(574, "float - double", grey);
    text.next(21);
}
static void result(TextColumn& text, const std::string& from, double value, double exact, bool first) {
    text.right(392, from);
    text.right(500, (first ? "=  " : "") + tableNumber(value));
    text.right(574, value == exact ? "0" : formatted("%.2g", value - exact), grey);
    text.next();
}

// Write each product, a row of the matrix in a line.
static void writeProducts(TextColumn& text, const Settings& s, double aspect) {
    fvec4 value(corner(s.vertex), 1);
    vec4 exact(value);
    for (const Step& step : steps(s, aspect)) {
        const fvec4 next = gpuProduct(fmat4(step.uploaded), value);
        const vec4 exactNext = step.exact * exact;
        heading(text, step.to + " = " + matrixName(step) + " * " + step.from);
        for (int row = 0; row < 4; ++row) {
            for (int column = 0; column < 4; ++column)
                text.right(column < 3 ? 62 * (column + 1) : 292, tableNumber(step.uploaded[column][row]));
            result(text, (row == 0 ? "*  " : "") + tableNumber(value[row]), next[row], exactNext[row], row == 0);
        }
        value = next;
        exact = exactNext;
    }
}

// Magnify the pixels about the one that is marked: a dot where float puts the vertex, a cross where double does.
static void magnify(Drawing& drawing, const Pane& pane, const vec2& pixel, const vec2& exact) {
    const int across = std::min(pane.width, pane.height) / 5;
    const vec2 low = glm::floor(pixel), size(across);
    const vec2 corner(8, pane.height - size.y - 8);
    const Plot magnified{{corner, corner + size}, {low.x - 3, low.x + 4}, {low.y - 3, low.y + 4}};
    drawing.fill(magnified.box, vec4(1));
    drawing.fill({magnified.pixel(low), magnified.pixel(low + 1.0)}, vec4(1, 0.85, 0.5, 1));
    drawing.pixelGrid(magnified, {.color = vec4(0.6, 0.6, 0.6, 1), .width = 1});
    for (const vec2& arm : {vec2(1, 0), vec2(0, 1)})
        drawing.curve(magnified, std::array{exact - arm, exact + arm}, {.color = green});
    drawing.curve(magnified, std::array{pixel, exact}, {.color = green});
    drawing.point(magnified.pixel(pixel), 7, vec4(0.1, 0.1, 0.1, 1));
}

// Write the way from clip space to the pixel, and name the vertex where it is, or where it would be without clipping.
static void writePixel(Drawing& drawing, TextColumn& text, const Settings& s, const Frame& frame) {
    const Pane pane = viewIn(frame.inPixels());  // of whose pixels the numbers tell
    const auto [clip, exact] = clipOf(s, pane.aspect());
    const bool inside = isInView(clip);
    text.left(0,
              inside       ? "-w <= x, y, z <= w: in view"
              : clip.w < 0 ? "w < 0: clipped"
                           : "beyond -w .. w: clipped",
              inside ? green : red);
    text.next();
    if (clip.w == 0 || exact.w == 0) return;

    const vec3 device = deviceFromClip(clip), exactDevice = deviceFromClip(exact);
    heading(text, "device = clip / w");
    for (int row = 0; row < 3; ++row)
        result(text, tableNumber(clip[row]) + " / " + tableNumber(clip.w), device[row], exactDevice[row], row == 0);
    const vec3 size(pane.width, pane.height, 1), pixel = pixelFromDevice(device, pane),
                                                 exactPixel = pixelFromDevice(exactDevice, pane);
    heading(text, "pixel, depth = (device + 1) / 2 * size");
    for (int row = 0; row < 3; ++row)
        result(text, "(" + tableNumber(device[row]) + " + 1) / 2 * " + tableNumber(size[row]), pixel[row],
               exactPixel[row], row == 0);

    const bool inPane = pixel.x >= 0 && pixel.x < pane.width && pixel.y >= 0 && pixel.y < pane.height;
    const vec2 at = vec2(glm::floor(pixel)) / frame.scale();
    const int x = int(at.x), y = frame.height() - int(at.y);
    if (inside)
        drawText(frame, x + 8, y, "vertex " + std::to_string(s.vertex));
    else if (clip.w < 0 && inPane)
        drawText(frame, x - 7, y - 11, "× divided by w < 0", {.color = red});
    if (clip.w < 0) frame.say("The vertex has w < 0, and is clipped.");
    if (inside) magnify(drawing, viewIn(frame), vec2(pixel), vec2(exactPixel));
}

static std::vector<TextLine> scaled(std::vector<TextLine> lines, double scale) {
    if (scale == 1) return lines;
    if (scale == 0) return {};
    for (TextLine& line : lines) {
        line.x = int(line.x * scale);
        line.y = int(line.y * scale);
        line.style.height = int(line.style.height * scale);
    }
    return lines;
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    const FrameInfo inPixels = frame.inPixels();
    glViewport(0, 0, inPixels.width(), inPixels.height());
    const Pane pane = viewIn(frame);
    gpu.drawing.begin(frame);
    gpu.drawing.in(pane);
    const double scale = numbersScale(frame);
    TextColumn text(numbersBeside(frame) && scale > 0 ? int(pane.width / scale) + 14 : 14, 6, 15);
    writeProducts(text, s, pane.aspect());
    writePixel(gpu.drawing, text, s, frame);
    drawText(frame, scaled(text.lines, scale));
    gpu.drawing.draw(frame);
}

}  // namespace mv::pipeline
