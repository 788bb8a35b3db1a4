// Over the picture of texture-map: where the lines of the texture belong. Beside it: how the slip falls, or the formula.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <vector>

#include "mv/formatted.h"
#include "mv/gl/gl.h"
#include "mv/gl/word_size.h"
#include "perspective_quad.h"
#include "texture-map.h"

namespace mv::texture_map {
namespace {

const vec4 red(0.85, 0.1, 0.1, 1), blue(0.1, 0.3, 0.75, 1), grey(0.45, 0.45, 0.45, 1), ink(0.1, 0.1, 0.1, 1);

void drawQuad(Drawing& drawing, const Settings& s, const Frame& frame, const TextStyle& words) {
    const Pane left = leftPane(frame);
    const double ratio = s.surface.ratio;
    const mat3 pixels = pixelFromQuad(ratio, left);
    // Eighths of the texture; where u and v reach beyond 0..1, its edges
    const bool isBeyond = s.reach > 1;
    for (int i = 0; i <= 8; i += isBeyond ? 8 : 1) {
        const double at = isBeyond ? 0.5 + (i / 8.0 - 0.5) / s.reach : i / 8.0;
        drawing.line(projected(pixels, {at, 0}), projected(pixels, {at, 1}), {ink, 1});
        drawing.line(projected(pixels, {0, at}), projected(pixels, {1, at}), {ink, 1});
    }
    drawing.text({8, 1.5 * words.height + 4},
                 isBeyond            ? "black lines: where u and v are 0 and 1"
                 : s.picture.isSet() ? "black lines: where eighths of the picture belong"
                                     : "black lines: where the squares belong",
                 words);
    const Slip most = largestSlip(ratio, s.surface.divisions, left);
    if (s.surface.method == Method::affine && most.pixels > 2) drawing.arrow(most.shown, most.right, {red, 3});
    if (isForward(s)) return;

    // Draw the slip over the divisions
    drawing.in({0, 0, frame.width(), frame.height()});
    const vec2 size(frame.width(), frame.height());
    const Box box = frame.isUpright() ? Box{vec2(0.16, 0.71) * size, vec2(0.96, 0.90) * size}
                                      : Box{vec2(0.72, 0.2) * size, vec2(0.97, 0.86) * size};
    const Plot plot{box, {1, 64, "divisions a side", true}, {0.01, 1000, "largest slip, px", true}};
    drawing.axes(plot);
    std::vector<vec2> curve, square;
    for (int n = 1; n <= 64; ++n) {
        const double pixelsOff = largestSlip(ratio, n, left).pixels;
        if (pixelsOff > 0) curve.emplace_back(n, pixelsOff);
        if (pixelsOff > 0) square.emplace_back(n, largestSlip(ratio, 64, left).pixels * std::pow(64.0 / n, 2));
    }
    drawing.curve(plot, square, {grey, 1});
    drawing.curve(plot, curve, {blue, 2});
    if (most.pixels >= 0.01) drawing.point(plot.pixel({s.surface.divisions, most.pixels}), 9, red);
    drawing.text({plot.box.low.x, plot.box.high.y + 3.2 * words.height},
                 formatted("affine, W = %.3g:", ratio) + formatted(" %.3g px", most.pixels),
                 {words.height, blue, vec4(0)});
    drawing.text(plot.pixel({8, 600}), curve.empty() ? "nothing slips" : "grey: as 1/n²", {words.height, ink, vec4(0)});
}

void drawBody(Drawing& drawing, const Settings& s, const Pane& left, const TextStyle& words) {
    const mat4 clip = clipFromSurface(s.shape, s.surface, left);
    const auto point = [&](double u, double v) { return surfacePoint(s.shape, s.surface.formula, u, v); };
    if (isCircle(s)) {
        for (int i = 0; i < 64; ++i) drawing.edge(clip, point(i / 64.0, 1), point((i + 1) / 64.0, 1), {blue, 2});
        return;
    }
    std::vector<vec3> line;
    for (int i = 0; i <= 32; ++i) line.push_back(1.004 * point(0, i / 32.0));
    for (std::size_t i = 1; i < line.size(); ++i) drawing.edge(clip, line[i - 1], line[i], {red, 2});
    drawing.text(clip, point(0, 0.6), {5 * words.height, 0}, "seam: u = 0 and 1", words);
    if (s.shape != Shape::sphere) return;
    drawing.point(clip, point(0, 1), 8, red);
    drawing.text(clip, point(0, 1), {10, 30}, "pole: every u", words);
}

std::vector<std::string> formulaOf(const Settings& s) {
    const bool isLecture = s.surface.formula == Formula::lecture;
    switch (s.shape) {
        case Shape::quad:
            return {"Each texel is drawn", "where it belongs:", "holes where texels are", "larger than pixels"};
        case Shape::cylinder:
            return {"F(u, v) =", isLecture ? "(cos 2πu, h, sin 2πu)" : "(cos 2πu, h v, sin 2πu)",
                    isLecture ? "v is not in it: a circle" : ""};
        case Shape::sphere:
            return {"F(u, v) =", "(cos a cos 2πu, sin a, cos a sin 2πu)", "a = π (v - 1/2)"};
        case Shape::triangle:
            break;
    }
    const TexturedTriangle corners = cornersOf(s.triangle);
    return {s.triangle.map == Map::matrix ? "(u, v, 1) = P⁻¹ p" : "(u, v) = G (p - p₁) + t₁",
            formatted("plane %.3g from the origin", s.triangle.distance),
            formatted("det P = %.3g", glm::determinant(pointFromTexture(corners))),
            formatted("corners off by %.2g", errorInFloats(planeMap(s.triangle), corners))};
}

void drawFormula(Drawing& drawing, const Settings& s, const FrameInfo& frame, const TextStyle& words) {
    vec2 at(frame.isUpright() ? 8 : 0.64 * frame.width(), (frame.isUpright() ? 0.95 : 0.8) * frame.height());
    for (const std::string& line : formulaOf(s)) {
        if (!line.empty()) drawing.text(at, line, words);
        at.y -= 2.0 * words.height;
    }
}

}  // namespace

// The left part of the picture, and of one that is higher than wide the lower part.
Pane leftPane(const FrameInfo& frame) {
    if (frame.isUpright()) return {0, 0, frame.width(), std::max(1, frame.height() * 5 / 8)};
    return {0, 0, std::max(1, frame.width() * 5 / 8), frame.height()};
}
Pane paneOf(const Frame& frame) {
    return frame.measuring() ? Pane{0, 0, frame.width(), frame.height()} : leftPane(frame);
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    Drawing& drawing = gpu.drawing;
    drawing.begin(frame);
    const Pane left = leftPane(frame);
    drawing.in(left);
    const TextStyle words{.height = std::clamp(frame.height() / 30, leastWords, 18)};
    const bool isQuad = s.shape == Shape::quad;
    if (isQuad) drawQuad(drawing, s, frame, words);
    if (!isQuad && !isTriangle(s)) drawBody(drawing, s, left, words);
    drawing.in(left);
    drawing.text({8, left.height - 8},
                 isTriangle(s) ? std::string("triangle: texture coordinates by ") + nameOf(s.triangle.map)
                               : nameOf(s.shape) + std::string(": ") + nameOf(s.surface.method),
                 words);
    drawing.in({0, 0, frame.width(), frame.height()});
    if (!isQuad || isForward(s)) drawFormula(drawing, s, frame, words);
    const FrameInfo inPixels = frame.inPixels();
    glViewport(0, 0, inPixels.width(), inPixels.height());
    drawing.draw(frame);
}

// Eight by eight squares, blue at u = 0 and red at u = 1, dark at v = 0.
Picture chart(int side) {
    Picture picture(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double u = (x + 0.5) / side, v = 1 - (y + 0.5) / side;
            const bool isLight = (static_cast<int>(8 * u) + static_cast<int>(8 * v)) % 2 != 0;
            const vec3 hue = glm::mix(vec3(0.15, 0.35, 0.75), vec3(0.85, 0.3, 0.15), u);
            const vec3 color = 255.0 * (isLight ? glm::mix(hue, vec3(1), 0.92) : (0.45 + 0.55 * v) * hue);
            const auto byte = [](double value) { return static_cast<std::uint8_t>(std::lround(value)); };
            picture.set(x, y, {byte(color.x), byte(color.y), byte(color.z)});
        }
    }
    return picture;
}

}  // namespace mv::texture_map
