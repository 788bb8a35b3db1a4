#include "classic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "mv/error.h"
#include "mv/motion/ode_fixed.h"

namespace mv {
namespace {

constexpr int samples = 800;  // of a curve whose steps follow a tolerance
const std::array<vec4, 8> colors{vec4(0.10, 0.30, 0.70, 1), vec4(0.75, 0.15, 0.10, 1), vec4(0.15, 0.55, 0.25, 1),
                                 vec4(0.85, 0.50, 0.05, 1), vec4(0.50, 0.25, 0.65, 1), vec4(0.10, 0.60, 0.65, 1),
                                 vec4(0.55, 0.40, 0.25, 1), vec4(0.80, 0.35, 0.60, 1)};

double sampleTime(const Classic& classic, int i) {
    if (i == samples) return classic.time.high;  // and not what pow makes of it
    const double part = double(i) / samples;
    if (!classic.time.logarithmic) return classic.time.low + part * (classic.time.high - classic.time.low);
    return classic.time.low * std::pow(classic.time.high / classic.time.low, part);
}

void keep(ClassicSolution& solution, double t, std::span<const double> y) {
    solution.times.push_back(t);
    solution.states.emplace_back(y.begin(), y.end());
}

void requireMethod(const Classic& classic, OdeMethod method, double tolerance) {
    if (needsMechanical(method) && !classic.ode.problem.isMechanical) {
        throw Error("--method", "must be another for " + classic.ode.name + ", which has no positions and velocities",
                    methodName(method));
    }
    if (tolerance > 0 && !isAdaptive(method)) {
        throw Error("--tolerance", "must be 0 for a method that cannot estimate its error", methodName(method));
    }
}

}  // namespace

Classic classic(std::size_t which) {
    std::vector<OdeCase> cases = odeCases();
    if (which >= cases.size()) throw Error("classic", "there are 8, counted from 0", std::to_string(which));
    OdeCase& ode = cases[which];
    const Axis seconds{0, ode.end, "time"};
    const auto curves = [](const std::vector<std::string>& names) {
        std::vector<Classic::Curve> result;
        for (std::size_t i = 0; i < names.size(); ++i) result.push_back({i, names[i]});
        return result;
    };
    switch (which) {
        case 0:
        case 1:
            return {std::move(ode), seconds, {-1.2, 1.2, "place and speed"}, curves({"q", "v"})};
        case 2:
            return {std::move(ode), seconds, {-1.2, 1.2, "place"}, {{0, "q1"}, {9, "q10"}, {24, "q25"}, {49, "q50"}}};
        case 3:
            return {std::move(ode),
                    {1e-5, 1e11, "time", true},
                    {0, 1.1, "concentration"},
                    {{0, "y1"}, {1, "20000 y2", 20000}, {2, "y3"}}};
        case 4:
            return {std::move(ode), seconds, {-2.5, 2.5, "y"}, curves({"y"})};
        case 5:
            return {std::move(ode),
                    {1e-3, 321.8122, "time", true},
                    {1e-6, 10, "concentration", true},
                    curves({"y1", "y2", "y3", "y4", "y5", "y6", "y7", "y8"})};
        case 6:
            return {std::move(ode), seconds, {0.1, 1e6, "concentration", true}, curves({"y1", "y2", "y3"})};
        default:
            return {
                std::move(ode), seconds, {-6, 6, "x of the stars"}, curves({"x1", "x2", "x3", "x4", "x5", "x6", "x7"})};
    }
}

ClassicSolution solveClassic(const Classic& classic, OdeMethod method, double tolerance, int steps, bool isConfirmed) {
    requireMethod(classic, method, tolerance);
    const OdeCase& ode = classic.ode;
    ClassicSolution solution;
    keep(solution, ode.start, ode.initial);
    if (tolerance > 0) {
        std::vector<double> y(ode.initial.size());
        int next = 1;
        const auto sample = [&](const AcceptedStep& step) {
            for (; next <= samples && sampleTime(classic, next) <= step.to(); ++next) {
                const double t = std::max(sampleTime(classic, next), step.from());
                step.at(t, y);
                keep(solution, t, y);
            }
        };
        const AdaptiveOptions options{.relative = tolerance, .absolute = ode.absolute, .observe = sample};
        solution.result = integrateAdaptive(ode.problem, method, ode.start, ode.end, ode.initial, options);
        if (isConfirmed && solution.result.reachedEnd()) {
            solution.confirmation =
                confirmAdaptive(ode.problem, method, ode.start, ode.end, ode.initial, options, solution.result);
        }
    } else {
        FixedStepper stepper(ode.problem, method, ode.start, (ode.end - ode.start) / steps, ode.initial);
        while (stepper.index() < steps && stepper.step()) keep(solution, stepper.time(), stepper.state());
        solution.result = {.failure = stepper.failure(),
                           .t = stepper.time(),
                           .y = {stepper.state().begin(), stepper.state().end()},
                           .counts = stepper.counts()};
    }
    if (solution.result.reachedEnd() && !ode.reference.empty()) {
        double error = 0;
        for (std::size_t i = 0; i < ode.reference.size(); ++i) {
            error = std::max(error, std::abs(solution.result.y[i] / ode.reference[i] - 1));
        }
        solution.error = error;
    }
    return solution;
}

void drawClassic(Drawing& drawing, const Box& box, const Classic& classic, const ClassicSolution& solution) {
    const Plot plot{box, classic.time, classic.value};
    drawing.axes(plot);
    const auto valueOf = [&](const Classic::Curve& curve, const std::vector<double>& y) {
        const double value = curve.factor * y[curve.component];
        // Draw points beyond the axes just beyond them, where they are cut off
        const double span = plot.y.high - plot.y.low;
        return plot.y.logarithmic ? std::clamp(value, plot.y.low / 1e3, plot.y.high * 1e3)
                                  : std::clamp(value, plot.y.low - span, plot.y.high + span);
    };
    for (std::size_t i = 0; i < classic.curves.size(); ++i) {
        const Classic::Curve& curve = classic.curves[i];
        std::vector<vec2> points;
        for (std::size_t k = 0; k < solution.times.size(); ++k) {
            if (plot.x.logarithmic && solution.times[k] <= 0) continue;
            points.emplace_back(solution.times[k], valueOf(curve, solution.states[k]));
        }
        drawing.curve(plot, points, {colors[i], 2});
        if (!classic.ode.reference.empty()) {
            const vec2 end = plot.pixel({plot.x.high, valueOf(curve, classic.ode.reference)});
            drawing.point(end, 11, colors[i]);
            drawing.point(end, 7, vec4(1));
        }
        const double room = (box.size().x - 130) / double(std::max<std::size_t>(5, classic.curves.size()));
        const double x = box.low.x + 130 + room * double(i);
        drawing.text({x, box.high.y + 26}, curve.name, {14, colors[i], vec4(0)});
    }
}

}  // namespace mv
