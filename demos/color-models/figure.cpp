// Drawn over the solids and below them: outlines, the way of the mixture, strips, marks and words.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <string>

#include "color-models.h"
#include "mv/demo/handle.h"
#include "mv/formatted.h"
#include "mv/geometry/plot.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/word_size.h"
#include "mv/math/color.h"
#include "mv/math/color_difference.h"

namespace mv::color_models {
namespace {

const vec4 ink(0.1, 0.1, 0.1, 1), faint(0.35, 0.35, 0.35, 1), white(1, 1, 1, 1);
const std::array<std::string, 4> wayNames{"sRGB", "linear", "HSL", "OKLab"};

double unit(const FrameInfo& frame) {
    return frame.isUpright() ? std::min(frame.width() / 660.0, frame.height() / 900.0)
                             : std::min(frame.width() / 960.0, frame.height() / 640.0);
}

// How high the strips and their curves are, below the solids. In an upright picture the curves stand below the strips.
int stripsHeight(const FrameInfo& frame) { return std::max(1, frame.height() * (frame.isUpright() ? 3 : 2) / 5); }

int wordSize(const FrameInfo& frame, double size) { return std::max(leastWords, static_cast<int>(size * unit(frame))); }

// Write words. Places are in units, of which the picture has 640 in its height or 960 in its width, from the lower left corner.
void words(Drawing& drawing, const FrameInfo& frame, const vec2& at, const std::string& text, const vec4& color,
           double size) {
    drawing.text(at * unit(frame), text, {wordSize(frame, size), color, vec4(0)});
}

// The edges of the whole solid, and the greys.
void drawOutline(Drawing& drawing, Space solid, const mat4& clip) {
    const Stroke stroke{vec4(0.3, 0.3, 0.3, 0.6), 1};
    drawing.edge(clip, vec3(0), vec3(0, 1, 0), stroke);
    if (solid == cube) {
        const MeshData edges = wireCube();
        for (std::size_t i = 0; i < edges.positions.size(); i += 2) {
            drawing.edge(clip, modelFromRgb() * (vec3(edges.positions[i]) + 0.5),
                         modelFromRgb() * (vec3(edges.positions[i + 1]) + 0.5), stroke);
        }
        return;
    }
    const double height = solid == doubleCone ? 0.5 : 1;
    for (int i = 0; i < 96; ++i)
        drawing.edge(clip, aroundAxis(i * 3.75, 1, height), aroundAxis((i + 1) * 3.75, 1, height), stroke);
}

// The way of the mixture. No solid hides it.
void drawWay(Drawing& drawing, const Settings& s, Space solid, const Pane& pane, const mat4& clip) {
    const Pane whole{0, 0, pane.width, pane.height};
    std::vector<vec2> line;
    for (int i = 0; i <= 64; ++i) {
        const vec3 color = shownAs(mixed(s.way, s.from, s.to, i / 64.0));
        if (const auto pixel = pictureFromPane(whole, clip, placeOf(solid, color))) line.push_back(*pixel);
    }
    drawing.line(line, {ink, 4});
    drawing.line(line, {white, 2});
}

struct Label {
    std::string name, numbers;
};
Label labelOf(const Settings& s, Space solid) {
    const auto numbers = [](const std::string& first, double second, double third) {
        return first + formatted("  %.2f", second) + formatted("  %.2f", third);
    };
    if (solid == cube) {
        return {"RGB: cube", s.solids.written == Written::hex
                                 ? hexFromSrgb(s.from) + "  to  " + hexFromSrgb(s.to)
                                 : numbers(formatted("%.2f", s.from.r), s.from.g, s.from.b)};
    }
    const Hsl hsl = hslFromRgb(s.from);
    const Hsv hsv = hsvFromRgb(s.from);
    const std::string turn = hsl.saturation == 0 ? "no hue" : formatted("%.0f°", hsl.hue);
    if (solid == doubleCone) return {"HSL: double cone", numbers(turn, hsl.saturation, hsl.lightness)};
    return {"HSV: cone", numbers(turn, hsv.saturation, hsv.value)};
}

void drawLabel(Drawing& drawing, const Settings& s, const FrameInfo& frame, Space solid, const Pane& pane) {
    const Label label = labelOf(s, solid);
    const double top = pane.height / unit(frame);
    words(drawing, frame, {12, top - 8}, label.name, ink, 18);
    words(drawing, frame, {12, top - 32}, label.numbers, faint, 15);
}

}  // namespace

MeshData solidMesh(Space solid) {
    MeshData shape = solid == cube ? box(vec3(0), vec3(1))
                                   : lathe(std::vector<vec2>{{0, 0}, {0.5, solid == cone ? 1 : 0.5}, {0, 1}}, 96);
    shape.normals.clear();
    shape.texCoords.assign(shape.positions.size(), fvec2(0));
    if (solid == cube) {
        for (fvec3& position : shape.positions) position = fvec3(modelFromRgb() * vec3(position));
        for (std::uint32_t i = 0; i < shape.positions.size(); ++i) shape.indices.push_back(i);
    }
    for (const fvec3& corner : square().positions) {
        shape.indices.push_back(static_cast<std::uint32_t>(shape.positions.size()));
        shape.positions.push_back(corner);
        shape.texCoords.emplace_back(1, 0);
    }
    return shape;
}

MeshData spectrumMesh() {
    MeshData mesh{.primitive = Primitive::triangleFan};
    for (const vec2& xy : spectralLocus()) mesh.positions.emplace_back(xy, 0);
    return mesh;
}

Pane paneOf(const FrameInfo& frame, Space solid) {
    const int low = stripsHeight(frame), width = std::max(frame.width() / 3, 1);
    return {solid * width, low, width, std::max(1, frame.height() - low)};
}

std::optional<vec2> markIn(const Settings& s, const FrameInfo& frame, Space space, const vec3& color) {
    if ((s.shows == Shows::diagram) != (space == inDiagram)) return {};
    if (space != inDiagram)
        return pictureFromPane(paneOf(frame, space), clipFromModel(s, frame), placeOf(space, color));
    const ChromaticityDiagram diagram{s.diagram};
    const auto at = diagram.placeOf(color);
    return at ? std::optional(diagram.plotIn(frame).pixel(*at)) : std::nullopt;
}

void drawMarks(Drawing& drawing, const Settings& s, const FrameInfo& frame) {
    drawing.in({0, 0, frame.width(), frame.height()});
    for (const Space space : {cube, doubleCone, cone, inDiagram}) {
        for (const auto& [color, size] : {std::pair(s.to, 13), {s.from, 19}}) {
            const auto at = markIn(s, frame, space, color);
            if (!at) continue;
            drawing.point(*at, size, ink);
            drawing.point(*at, size - 2, white);
            drawing.point(*at, size - 6, vec4(color, 1));
        }
    }
}

void drawOverSolids(Drawing& drawing, const Settings& s, const FrameInfo& frame) {
    const mat4 clip = clipFromModel(s, frame);
    for (const Space solid : {cube, doubleCone, cone}) {
        const Pane pane = paneOf(frame, solid);
        drawing.in(pane);
        drawOutline(drawing, solid, clip);
        drawWay(drawing, s, solid, pane, clip);
        drawLabel(drawing, s, frame, solid, pane);
    }
}

void drawStrips(Drawing& drawing, const Settings& s, const FrameInfo& frame) {
    const double u = unit(frame);
    drawing.in({0, 0, frame.width(), stripsHeight(frame)});
    const double raised = frame.isUpright() ? stripsHeight(frame) / u - 256 : 0;  // the strips, above the curves
    const Box box = frame.isUpright() ? Box{vec2(76, 56) * u, vec2(620, raised - 40) * u}
                                      : Box{vec2(660, 52) * u, vec2(940, 236) * u};
    const Plot plot{box, {0, 1, "part of the way"}, {0, 1, "lightness as seen"}};
    // A small picture keeps its words large: the strips are between a way's name and how uneven it is, so many times as wide as high.
    const double height = 46, left = std::max(76.0, 12 + 3.4 * wordSize(frame, 16) / u);
    const double right = std::min(520.0, 650 - 5.8 * wordSize(frame, 14) / u);
    const double above = raised + 232 + std::max(14.0, (leastWords + 3) / u - 3);
    words(drawing, frame, {left, above}, "mixed in", faint, 14);
    words(drawing, frame, {right + 8, above}, "uneven by", faint, 14);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::vector<vec3> colors = strip(s, static_cast<Way>(i));
        const double top = raised + 226 - 54 * double(i), wide = (right - left) / double(colors.size());
        std::vector<vec2> curve;
        for (std::size_t k = 0; k < colors.size(); ++k) {
            // From whole pixel to whole pixel, so that nothing shines through between two
            const vec2 low = glm::round(vec2(left + wide * double(k), top - height) * u);
            const vec2 high = glm::round(vec2(left + wide * double(k + 1), top) * u);
            drawing.fill({low, high}, vec4(shownAs(colors[k]), 1));
            if (isBeyond(colors[k])) drawing.fill({low, {high.x, low.y + 4 * u}}, ink);
            curve.emplace_back(double(k) / s.solids.steps, asSeen(colors[k]).x);
        }
        words(drawing, frame, {12, top - 12}, wayNames.at(i), wayColors.at(i), 16);
        if (const auto percent = unevenness(stepsOf(colors)))
            words(drawing, frame, {right + 10, top - 12}, formatted("%.0f %%", *percent), wayColors.at(i), 16);
        drawing.curve(plot, curve, {wayColors.at(i), 2});
    }
    drawing.axes(plot);
}

void drawMixture(Drawing& drawing, const Settings& s, const FrameInfo& frame) {
    const ChromaticityDiagram diagram{s.diagram};
    std::vector<vec2> line;
    for (int i = 0; i <= 64; ++i) {
        if (const auto at = diagram.placeOf(mixed(s.way, s.from, s.to, i / 64.0))) line.push_back(*at);
    }
    drawing.curve(diagram.plotIn(frame), line, {ink, 4});
    drawing.curve(diagram.plotIn(frame), line, {white, 2});
}

}  // namespace mv::color_models
