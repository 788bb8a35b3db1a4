// The figures of the ball between its keys: its way, and its speed, acceleration and ease over time.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <vector>

#include "figure.h"
#include "mv/gl/word_size.h"

namespace mv::keyframes {
namespace {

const vec4 paleBlue(0.62, 0.72, 0.9, 1);

TextStyle numberStyle(double unit) {
    return {.height = std::max(leastWords, static_cast<int>(14 * unit)), .color = vec4(1), .background = vec4(0)};
}

// The size of a quantity, from key to key; at a key it may have two.
void drawGraph(Drawing& drawing, const Settings& s, const Motion<vec3>& motion, double now, const FrameInfo& frame,
               Part part, const std::string& name, vec3 CurvePoint<vec3>::*quantity) {
    const auto size = [&](const CurvePoint<vec3>& point) { return glm::length(point.*quantity); };
    const int spans = static_cast<int>(std::lround(motion.end()));
    const double end = motion.end(), beyond = motion.curve().isClosed() ? 0 : rest;
    const bool startsAtOnce = s.curve.startsAtOnce();
    std::vector<std::vector<vec2>> pieces{{{-beyond, 0}, {0, 0}}, {{end, 0}, {end + beyond, 0}}};
    double highest = 1e-6;
    for (int span = 0; span < spans; ++span) {
        pieces.emplace_back();
        for (int i = startsAtOnce ? 1 : 0; i <= 60; ++i) {
            const double time = span + i / 60.0;
            const auto point = i == 0 ? motion.after(span) : i == 60 ? motion.before(span + 1) : motion.at(time);
            pieces.back().emplace_back(time, size(point));
            highest = std::max(highest, size(point));
        }
    }
    if (startsAtOnce) highest *= 0.4;  // what is infinite is cut off anyway
    const Plot plot{boxOf(frame, part), {-beyond, end + beyond, "s"}, {0, 1.1 * highest, name}};
    drawing.in(wholePane(frame));
    for (int key = 0; key <= spans; ++key) {
        drawing.line(plot.pixel({key, 0}), plot.pixel({key, plot.y.high}), {grey, 1});
        const bool isEndless = startsAtOnce && key < spans;
        const double after = isEndless ? plot.y.high : size(motion.after(key));
        drawing.curve(plot, std::array{vec2(key, size(motion.before(key))), vec2(key, after)}, {red, 2.5});
    }
    for (const auto& piece : pieces) drawing.curve(plot, piece, {blue, 2});
    drawing.line(plot.pixel({now, 0}), plot.pixel({now, plot.y.high}), {orange, 1.5});
    drawing.axes(plot);
}

void drawEase(Drawing& drawing, const Settings& s, double now, const FrameInfo& frame) {
    const Plot plot = easePlot(frame);
    drawing.in(wholePane(frame));
    std::vector<vec2> way;
    for (int i = 0; i <= 200; ++i) way.emplace_back(i / 200.0, s.curve.eased(i / 200.0));
    for (const double y : {0.0, 1.0}) drawing.line(plot.pixel({0, y}), plot.pixel({1, y}), {grey, 1});
    drawing.curve(plot, way, {blue, 2});
    if (s.curve.isBezierEase()) {
        for (const std::size_t i : {0U, 1U}) {
            const vec2 handle = plot.pixel(s.curve.handles.at(i));
            drawing.line(plot.pixel(vec2(double(i))), handle, {red, 1});
            drawing.point(handle, 11, red);
        }
    }
    if (now >= 0 && now < double(s.keys.size() - 1)) {
        const double passed = now - std::floor(now);
        drawing.point(plot.pixel({passed, s.curve.eased(passed)}), 9, orange);
    }
    drawing.axes(plot);
}

}  // namespace

// The ball's places at every tenth of a second, too: where they are close it is slow.
void showWay(Drawing& drawing, const Settings& s, const Motion<vec3>& motion, double now, const Pane& pane) {
    drawing.in(pane);
    std::vector<vec2> polygon, way;
    for (const vec2& key : s.keys) polygon.push_back(pixelOf(pane, key));
    drawing.line(polygon, {grey, 1});
    const int frames = static_cast<int>(std::lround(60 * motion.end()));
    for (int i = 0; i <= frames; ++i) way.push_back(pixelOf(pane, motion.position(i / 60.0)));
    drawing.line(way, {blue, 1.5});
    for (std::size_t i = 0; i < way.size(); i += 6)
        drawing.point(way[i], 8 * unit(pane), double(i) / 60 <= now ? blue : paleBlue);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        drawing.point(polygon[i], 20 * unit(pane), red);
        drawing.textAround(polygon[i], std::to_string(i + 1), numberStyle(unit(pane)));
    }
}

// The velocity halfway to the next picture, in metres a second. A resting ball has none.
static std::optional<vec2> velocityShown(const Motion<vec3>& motion, double now) {
    if (now < 0 || now >= motion.end()) return std::nullopt;
    return vec2(motion.at(std::min(now + 1 / 120.0, motion.end())).velocity);
}

// How far it would come in a quarter of a second, too.
void showBall(Drawing& drawing, const Motion<vec3>& motion, double now, const Pane& pane) {
    const vec2 ball = pixelOf(pane, vec2(motion.position(std::clamp(now, 0.0, motion.end()))));
    const std::optional<vec2> velocity = velocityShown(motion, now);
    if (velocity) drawing.arrow(ball, ball + 0.25 * metre(pane) * *velocity, {orange, std::max(1.0, 3 * unit(pane))});
    drawing.point(ball, 24 * unit(pane), orange);
}

// Speed over time, and acceleration, or how it is eased.
void showGraphs(Drawing& drawing, const Settings& s, const Motion<vec3>& motion, double now, const FrameInfo& frame) {
    const std::string ease = s.curve.isEased() ? ", " + nameOf(s.curve.ease) : "";
    words(drawing, frame, 0, nameOf(s.curve.kind) + ease + ": a dot every tenth of a second");
    drawGraph(drawing, s, motion, now, frame, Part::upper, "speed, m/s; red: a jump", &CurvePoint<vec3>::velocity);
    if (s.curve.isStraight())
        drawEase(drawing, s, now, frame);
    else
        drawGraph(drawing, s, motion, now, frame, Part::lower, "acceleration, m/s^2", &CurvePoint<vec3>::acceleration);
}

Plot easePlot(const FrameInfo& frame) {
    return {boxOf(frame, Part::lower), {0, 1, "part of the time between two keys"}, {-0.5, 1.5, "part of the way"}};
}

}  // namespace mv::keyframes
