#include "stage_table.h"

#include <algorithm>
#include <vector>

#include "mv/gl/word_size.h"

namespace mv {
namespace {

// The flow through a stage, in words.
struct Flow {
    bool isOn;
    std::string in, out;
};

constexpr double beside = 0.535;    // of the picture's width, that of the table beside the patch
constexpr double fourColumns = 38;  // times the words' height, the width of the whole table

std::size_t cornersOf(GLenum primitive) { return primitive == GL_POINTS ? 1 : primitive == GL_LINES ? 2 : 3; }

std::array<Flow, 11> flowsOf(const PatchDraw& patch) {
    const auto number = [](const CountedPrimitives& counted) {
        return counted.isCounted ? primitivesText(counted.number.generated, counted.primitive) : "not counted";
    };
    const std::string before = number(patch.toGeometry), after = number(patch.sent);
    const std::string corners = std::to_string(patch.sent.number.positions.size()) + " corners";
    const bool cut = patch.mode == GL_PATCHES, drawn = patch.hasFragments;
    return {{
        {true, "", patch.mode == GL_TRIANGLES ? "54 corners" : "16 points"},
        {true, "each vertex", patch.isBent ? "moved" : "as it was"},
        {cut, "1 patch", "1 patch, levels"},
        {cut, "levels " + std::to_string(patch.inner) + ", " + std::to_string(patch.outer), before},
        {cut, "each u, v", "a vertex"},
        {patch.hasGeometry, before, after},
        {patch.sent.isCounted, after, corners},
        {drawn, after, "fragments"},
        {drawn, "each fragment", "a colour"},
        {drawn, "colour, depth", "pixels"},
        {false, "", ""},
    }};
}

}  // namespace

double CountedPrimitives::found() const {
    return static_cast<double>(number.positions.size()) / static_cast<double>(cornersOf(primitive));
}

CountedPrimitives counted(const Program& program, GLenum mode, const std::function<void()>& draw) {
    const GLenum primitive = program.primitiveOut(mode);
    return {true, primitive, captured(primitive, draw)};
}

std::string primitivesText(long number, GLenum primitive) {
    const std::string word = primitive == GL_POINTS ? "point" : primitive == GL_LINES ? "line" : "triangle";
    return std::to_string(number) + " " + word + (number == 1 ? "" : "s");
}

bool narrowTable(const FrameInfo& frame) {
    return !frame.isUpright() && frame.inUnits().width() * beside < fourColumns * leastWords;
}

void drawStageTable(Drawing& drawing, const FrameInfo& frame, int direct3d, const PatchDraw& patch) {
    const vec2 size(frame.width(), frame.height());
    const bool isNarrow = narrowTable(frame);
    const Box box = frame.isUpright() ? Box{size * vec2(0.02, 0.02), size * vec2(0.98, 0.48)}
                    : isNarrow        ? Box{size * vec2(0.31, 0.02), size * vec2(0.99, 0.98)}
                                      : Box{size * vec2(0.99 - beside, 0.08), size * vec2(0.99, 0.94)};
    const std::array<Flow, 11> flows = flowsOf(patch);
    const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
    const double line = height / double(stageNames.size() + 1);
    // Four columns, or two of them where there is no room for their words: so many times as wide as these are high
    const bool all = width >= fourColumns * leastWords;
    const double across = all ? fourColumns : 19.5;
    if (line < leastWords || width < across * leastWords) return;
    const int words = std::max(leastWords, static_cast<int>(std::min(0.5 * line, width / across)));
    const vec4 ink(0.1, 0.1, 0.1, 1), grey(0.62, 0.62, 0.64, 1), programmable(0.86, 0.91, 0.97, 1);
    const std::array<double, 4> columns{0.01 * width, 0.36 * width, 0.61 * width, (all ? 0.805 : 0.66) * width};
    double y = box.high.y;
    const auto cells = [&](const std::array<std::string, 4>& texts, const vec4& color) {
        for (std::size_t i = 0; i < texts.size(); ++i) {
            if (!texts.at(i).empty() && (all || i == 0 || i == 3))
                drawing.text({box.low.x + columns.at(i), y - 0.5 * (line - words) + 2}, texts.at(i),
                             {words, color, vec4(0)});
        }
        y -= line;
    };
    cells({"OpenGL", "Direct3D " + std::to_string(direct3d), "in", "out"}, ink);
    for (std::size_t i = 0; i < stageNames.size(); ++i) {
        const StageName& stage = stageNames.at(i);
        const Flow& flow = flows.at(i);
        if (stage.isProgrammable && flow.isOn)
            drawing.fill({{box.low.x, y - line + 1}, {box.high.x, y - 1}}, programmable);
        const std::string name = stage.direct3d.at(static_cast<std::size_t>(direct3d - 9)), off = all ? "" : "off";
        cells({stage.openGl, name.empty() ? "-" : name, flow.isOn ? flow.in : "off", flow.isOn ? flow.out : off},
              flow.isOn ? ink : grey);
    }
    drawing.line({box.low.x, box.high.y - line}, {box.high.x, box.high.y - line}, {ink, 1});
}

void drawHeadings(Drawing& drawing, const FrameInfo& frame, bool isWater, bool computes) {
    const std::vector<Pane> panes = frame.panes(2);
    if (panes[0].width < 200 || panes[0].height < 64) return;
    const std::string left = isWater ? "the water, by a fragment shader" : "by a fragment shader";
    const std::string computed = isWater ? "light through it, by a compute shader" : "by a compute shader";
    const std::string right = computes ? computed : "no compute shader here";
    drawing.text({8, frame.height() - 6.0}, left, {.background = vec4(0)});
    drawing.text({panes[1].x + 8.0, frame.height() - 6.0}, right, {.background = vec4(0)});
}

}  // namespace mv
