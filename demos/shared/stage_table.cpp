#include "shared/stage_table.h"

#include <algorithm>

namespace mv {
namespace {

// What goes through a stage, in words.
struct Flow {
    bool isOn;
    std::string in, out;
};

std::array<Flow, 11> flowsOf(const PatchDraw& patch) {
    const auto number = [&](long count, GLenum primitive) {
        return patch.isCounted ? primitivesText(count, primitive) : "not counted";
    };
    const std::string before = number(patch.toGeometry, patch.before), after = number(patch.sent, patch.after);
    const bool cut = patch.isTessellated, drawn = patch.hasFragments;
    return {{
        {true, "", patch.mode == GL_TRIANGLES ? "54 corners" : "16 points"},
        {true, "each vertex", patch.isBent ? "moved" : "as it was"},
        {cut, "1 patch", "1 patch, levels"},
        {cut, "levels " + std::to_string(patch.inner) + ", " + std::to_string(patch.outer), before},
        {cut, "each u, v", "a vertex"},
        {patch.hasGeometry, before, after},
        {patch.isCounted, after, std::to_string(patch.cornersFound) + " corners"},
        {drawn, after, "fragments"},
        {drawn, "each fragment", "a colour"},
        {drawn, "colour, depth", "pixels"},
        {false, "", ""},
    }};
}

}  // namespace

std::string primitivesText(long number, GLenum primitive) {
    const std::string word = primitive == GL_POINTS ? "point" : primitive == GL_LINES ? "line" : "triangle";
    return std::to_string(number) + " " + word + (number == 1 ? "" : "s");
}

void drawStageTable(Drawing& drawing, const Box& box, const PatchDraw& patch) {
    const std::array<Flow, 11> flows = flowsOf(patch);
    const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
    const double line = height / double(stageNames.size() + 1);
    // Four columns, or two of them where there is no room for their words
    const auto largestWords = [&](double across) { return static_cast<int>(std::min(0.5 * line, width / across)); };
    const bool all = largestWords(36) >= 8;
    const int words = largestWords(all ? 36 : 25);
    if (words < 8) return;
    const vec4 ink(0.1, 0.1, 0.1, 1), grey(0.62, 0.62, 0.64, 1), programmable(0.86, 0.91, 0.97, 1);
    const std::array<double, 4> columns{0.01 * width, 0.37 * width, 0.59 * width, (all ? 0.79 : 0.62) * width};
    double y = box.high.y;
    const auto cells = [&](const std::array<std::string, 4>& texts, const vec4& color) {
        for (std::size_t i = 0; i < texts.size(); ++i) {
            if (!texts[i].empty() && (all || i == 0 || i == 3))
                drawing.text({box.low.x + columns.at(i), y - 0.5 * (line - words) + 2}, texts[i],
                             {words, color, vec4(0)});
        }
        y -= line;
    };
    cells({"OpenGL", "Direct3D 11", "in", "out"}, ink);
    for (std::size_t i = 0; i < stageNames.size(); ++i) {
        const StageName& stage = stageNames.at(i);
        const Flow& flow = flows.at(i);
        if (stage.isProgrammable && flow.isOn)
            drawing.fill({{box.low.x, y - line + 1}, {box.high.x, y - 1}}, programmable);
        const std::string off = all ? "" : "off";
        cells({stage.openGl, stage.direct3d[2], flow.isOn ? flow.in : "off", flow.isOn ? flow.out : off},
              flow.isOn ? ink : grey);
    }
    drawing.line({box.low.x, box.high.y - line}, {box.high.x, box.high.y - line}, {ink, 1});
}

}  // namespace mv
