// The figures of motions between keys: ways, graphs over time, and words.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "keyframes.h"
#include "mv/formatted.h"
#include "mv/gl/word_size.h"
#include "mv/motion/nodes.h"

namespace mv::keyframes {
namespace {

enum class Part { upper, lower, both };  // of the right side of the picture
const vec4 red(0.75, 0.15, 0.1, 1), blue(0.1, 0.3, 0.7, 1), paleBlue(0.62, 0.72, 0.9, 1), grey(0.75, 0.75, 0.75, 1),
    ink(0.1, 0.1, 0.1, 1), orange(0.9, 0.5, 0.1, 1);

double unit(const Pane& pane) { return std::min(pane.width, pane.height) / 560.0; }
// Ten metres each way and a margin, for what goes beyond its keys.
double metre(const Pane& pane) { return std::min(pane.width, pane.height) / 12.5; }
TextStyle wordStyle(const FrameInfo& frame, const vec4& color) {
    return {.height = std::clamp(frame.height() / 33, leastWords, 20), .color = color, .background = vec4(0)};
}
TextStyle numberStyle(double unit) {
    return {.height = std::max(leastWords, static_cast<int>(14 * unit)), .color = vec4(1), .background = vec4(0)};
}

Pane wholePane(const FrameInfo& frame) { return {0, 0, frame.width(), frame.height()}; }
// On the right, with room for what is written along the axes.
Box boxOf(const FrameInfo& frame, Part part) {
    const double room = std::min(64.0, frame.width() / 12.0), half = frame.height() / 2.0;
    const double low = part == Part::upper ? half : 0, high = part == Part::lower ? half : 2 * half;
    return {{leftPane(frame).width + room, low + std::min(48.0, half / 4)},
            {frame.width() - room / 4, high - std::min(40.0, half / 4)}};
}
void words(Drawing& drawing, const FrameInfo& frame, int line, const std::string& text, const vec4& color = ink) {
    const TextStyle style = wordStyle(frame, color);
    drawing.in(wholePane(frame));
    drawing.text({10, frame.height() - 6 - line * (style.height + 4)}, text, style);
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
    const std::string isCut = off > 0.5 ? ", which the graph below cuts off and the one on the right does not" : "";
    words(drawing, frame, 2, "one polynomial: off by " + formatted("%.2g", off) + isCut, red);
    if (!shown.warning) return;
    const std::size_t comma = shown.warning->find("; ") + 2;
    words(drawing, frame, 3, shown.warning->substr(0, comma), red);
    words(drawing, frame, 4, shown.warning->substr(comma), red);
}

// With keys of its own red, computed blue; the wider one is shown.
void drawOverTime(Drawing& drawing, const Settings& s, double now, const FrameInfo& frame, Part part,
                  const std::string& name, double (*size)(const View&)) {
    std::array<std::vector<vec2>, 2> lines;
    double highest = 0;
    for (const Zoom zoomedBy : {Zoom::separate, Zoom::computed}) {
        auto& line = lines.at(std::size_t(zoomedBy));
        for (int i = 0; i <= 120; ++i) {
            line.emplace_back(i * lap / 120, size(viewAt(s.camera, s.curve, i * lap / 120, zoomedBy)));
            highest = std::max(highest, line.back().y);
        }
    }
    const Plot plot{
        boxOf(frame, part), {0, lap, "s; red: angle with keys of its own, blue: computed"}, {0, 1.15 * highest, name}};
    const Zoom zoom = s.camera.zoom;
    drawing.in(wholePane(frame));
    for (const double key : {0.0, lap / 2, lap})
        drawing.line(plot.pixel({key, 0}), plot.pixel({key, plot.y.high}), {grey, 1});
    drawing.curve(plot, lines[0], {red, zoom == Zoom::separate ? 3.5 : 1.5});
    drawing.curve(plot, lines[1], {blue, zoom == Zoom::computed ? 3.5 : 1.5});
    drawing.line(plot.pixel({now, 0}), plot.pixel({now, plot.y.high}), {orange, 1.5});
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

void showValues(Drawing& drawing, const Settings& s, const Sampled& shown, const FrameInfo& frame) {
    // The values, up to half of the function's height beyond it
    const Pane pane = leftPane(frame);
    const bool isRunge = s.nodes.function == FunctionNodes::Function::runge;
    const double top = frame.height() - std::min(140.0, frame.height() / 3.5);
    const double x = std::min(50.0, frame.width() / 12.0), y = std::min(48.0, frame.height() / 8.0);
    const Plot plot{{{x, y}, {pane.width - x / 2, top}}, {-1, 1, "x"}, {isRunge ? -0.5 : -2, isRunge ? 1.5 : 2}};
    // How far they are off, however far that is
    Box box = boxOf(frame, Part::both);
    box.high.y = top;
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

// How large the subject is at the first key, and is to stay; then its size and the angle over time.
void showZoom(Drawing& drawing, const Settings& s, double now, const FrameInfo& frame) {
    const Zoom zoom = s.camera.zoom;
    const View first = viewAt(s.camera, s.curve, 0, zoom), view = viewAt(s.camera, s.curve, now, zoom);
    const Pane pane = leftPane(frame);
    const double half = first.sizeOf(figureHeight) * pane.height / 2;
    drawing.in(pane);
    for (const double y : {pane.height / 2.0 - half, pane.height / 2.0 + half})
        drawing.line({0, y}, {double(pane.width), y}, {ink, 1});
    const std::string angle = formatted(", angle of view %.1f deg", view.fovy);
    words(drawing, frame, 0, formatted("distance %.1f m", view.distance) + angle);
    drawOverTime(drawing, s, now, frame, Part::upper, "subject, part of the picture's height",
                 [](const View& v) { return v.sizeOf(figureHeight); });
    drawOverTime(drawing, s, now, frame, Part::lower, "angle of view, deg", [](const View& v) { return v.fovy; });
}

// The edge of the camera's picture, and each of its properties over time, as a number between its least and its largest.
void showFlight(Drawing& drawing, const Settings& s, double now, const Pane& seen, const FrameInfo& frame) {
    drawing.in(seen);
    const double right = seen.width, top = seen.height;
    drawing.line(std::array{vec2(0, 0), vec2(right, 0), vec2(right, top), vec2(0, top), vec2(0, 0)}, {ink, 2});
    struct Row {
        std::string name;
        double (*number)(const CameraAt&);
    };
    static const std::array<Row, 5> rows{{
        {"eye: m from its first key", [](const CameraAt& c) { return glm::distance(c.eye, cameraKeys()[0].eye); }},
        {"center: m from its first key",
         [](const CameraAt& c) { return glm::distance(c.center, cameraKeys()[0].center); }},
        {"up: deg from the vertical",
         [](const CameraAt& c) { return degrees(std::acos(std::clamp(glm::normalize(c.up).y, -1.0, 1.0))); }},
        {"aspect: width by height", [](const CameraAt& c) { return c.aspect; }},
        {"fovy: deg", [](const CameraAt& c) { return c.fovy; }},
    }};
    const Box whole = boxOf(frame, Part::both);
    const double rowHeight = (whole.high.y - whole.low.y) / double(rows.size());
    drawing.in(wholePane(frame));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::vector<vec2> line;
        for (int k = 0; k <= 120; ++k) line.emplace_back(k * lap / 120, rows.at(i).number(cameraAt(s, k * lap / 120)));
        const auto byHeight = [](const vec2& a, const vec2& b) { return a.y < b.y; };
        const double low = std::min_element(line.begin(), line.end(), byHeight)->y,
                     high = std::max(std::max_element(line.begin(), line.end(), byHeight)->y, low + 1e-6);
        const double bottom = whole.high.y - rowHeight * double(i + 1);
        const Plot plot{{{whole.low.x, bottom + 0.12 * rowHeight}, {whole.high.x, bottom + 0.62 * rowHeight}},
                        {0, lap, ""},
                        {low, high, ""}};
        for (const double key : {0.0, 2.0, 4.0, lap}) {
            drawing.line(plot.pixel({key, low}), plot.pixel({key, high}), {grey, 1});
            if (i + 1 == rows.size())
                drawing.textAround(plot.pixel({key, low}) - vec2(0, 0.25 * rowHeight), formatted("%.0f s", key),
                                   wordStyle(frame, ink));
        }
        drawing.curve(plot, line, {blue, 2});
        const double value = rows.at(i).number(cameraAt(s, now));
        drawing.point(plot.pixel({now, value}), 9, orange);
        drawing.text({whole.low.x, bottom + 0.95 * rowHeight}, rows.at(i).name + formatted(": %.2f", value),
                     wordStyle(frame, ink));
    }
    words(drawing, frame, 0, nameOf(s.curve.kind) + ": keys at 0, 2, 4 and 6 s");
}

Pane leftPane(const FrameInfo& frame) { return {0, 0, std::max(frame.width() * 7 / 12, 1), frame.height()}; }
Plot easePlot(const FrameInfo& frame) {
    return {boxOf(frame, Part::lower), {0, 1, "part of the time between two keys"}, {-0.5, 1.5, "part of the way"}};
}
vec2 pixelOf(const Pane& pane, const vec2& place) {
    return vec2(pane.width, pane.height) / 2.0 + metre(pane) * (place - vec2(5, 5));
}
// Warn of curves that are not what they seem.
void tell(const Settings& s, const Frame& frame) {
    if (s.curve.startsAtOnce()) frame.say("the root leaves each key at infinite speed, which the graph cuts off");
    const auto warning = swingWarning(timesOf(s.keys.size()));
    if (warning && s.curve.kind == KeyCurve::Kind::lagrange) frame.say(*warning);
}

}  // namespace mv::keyframes
