// The figures of a function and of the curves through its nodes: values, errors and words.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "figure.h"
#include "mv/formatted.h"

namespace mv::keyframes {
namespace {

std::vector<vec2> curveOf(const std::vector<double>& values, std::size_t step = 1) {
    std::vector<vec2> curve;
    for (std::size_t i = 0; i < values.size(); i += step) curve.emplace_back(sampleAt(i), values[i]);
    return curve;
}
// Values, and how far they are off: less than the lowest error of the plot is drawn there.
void drawBoth(Drawing& drawing, const Plot& plot, const Plot& errors, const std::vector<double>& right,
              const std::vector<double>& values, const vec4& color) {
    std::vector<double> off;
    for (std::size_t i = 0; i < samples; ++i) off.push_back(std::max(errors.y.low, std::abs(values[i] - right[i])));
    drawing.curve(plot, curveOf(values), {color, 2});
    drawing.curve(errors, curveOf(off), {color, 1.5});
}

void sayValues(Drawing& drawing, const Settings& s, const Sampled& shown, const FrameInfo& frame) {
    const bool isRunge = s.nodes.function == FunctionNodes::Function::runge;
    const std::string where = std::to_string(s.nodes.count) + " nodes, " + nameOf(s.nodes.spread);
    const double off = shown.polynomialError();
    words(drawing, frame, 0, std::string(isRunge ? "1/(1 + 25 x^2)" : "sin 3x") + ", grey, at " + where);
    words(drawing, frame, 1, nameOf(s.curve.kind) + ": off by " + formatted("%.2g", shown.curveError()), blue);
    const std::string cut = frame.isUpright() ? ", which the upper graph cuts off and the lower does not"
                                              : ", which the graph below cuts off and the one on the right does not";
    const std::string isCut = off > 0.5 ? cut : "";
    words(drawing, frame, 2, "one polynomial: off by " + formatted("%.2g", off) + isCut, red);
    if (!shown.warning) return;
    const std::size_t comma = shown.warning->find("; ") + 2;
    words(drawing, frame, 3, shown.warning->substr(0, comma), red);
    words(drawing, frame, 4, shown.warning->substr(comma), red);
}

}  // namespace

void showValues(Drawing& drawing, const Settings& s, const Sampled& shown, const FrameInfo& frame) {
    // The values, up to half of the function's height beyond it
    const Pane pane = leftPane(frame);
    const bool isRunge = s.nodes.function == FunctionNodes::Function::runge;
    const double top = frame.height() - std::min(140.0, frame.height() / 3.5);
    const double x = std::min(50.0, frame.width() / 12.0), y = std::min(48.0, frame.height() / 8.0);
    const Plot plot{
        {{x, pane.y + y}, {pane.width - x / 2, top}}, {-1, 1, "x"}, {isRunge ? -0.5 : -2, isRunge ? 1.5 : 2}};
    // How far they are off, however far that is
    Box box = boxOf(frame, Part::both);
    if (!frame.isUpright()) box.high.y = top;
    const double highest = std::max({10.0, 10 * shown.polynomialError(), 10 * shown.curveError()});
    const Plot errors{box, {-1, 1, "x"}, {1e-17, highest, "how far they are off, drawn as 1e-17 at least", true}};

    drawing.in(wholePane(frame));
    drawing.curve(plot, curveOf(shown.right, 5), {grey, 7});
    drawBoth(drawing, plot, errors, shown.right, shown.curve, blue);
    drawBoth(drawing, plot, errors, shown.right, shown.polynomial, red);
    for (const auto& node : s.nodes.keys()) drawing.point(plot.pixel({node.time, node.value}), 6, ink);
    drawing.axes(plot);
    drawing.axes(errors);

    // Balls that move by the functions, in four seconds from left to right
    const std::size_t now = std::size_t(frame.index() % 240) * samples / 240;
    for (const auto& [values, color] : {std::pair(&shown.curve, blue), std::pair(&shown.polynomial, red)}) {
        const vec2 at = plot.pixel({sampleAt(now), (*values)[now]});
        if (plot.box.holds(at)) drawing.point(at, 14, color);
    }
    sayValues(drawing, s, shown, frame);
}

}  // namespace mv::keyframes
