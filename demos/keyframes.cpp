// keyframes: what moves between keys that somebody has set: a ball, the value of a function, a camera.
//
// Claims (each is a test in tests/claims/keyframes.cpp; X27 to X29 in docs/stability.md are the curves at their extremes):
// - [through-its-keys] Every kind of curve is at every key at its time, but for the B-spline and the Bezier curve.
// - [speed-jumps] Straight from key to key the speed is constant, and jumps at the keys. A spline's does not; that of a
//   uniform Catmull-Rom curve does not either, but its acceleration does.
// - [ends] Where it rests before and after, all kinds leave with a jump, but what is eased at both ends and the clamped
//   spline.
// - [who-feels-a-key] Who moves a key moves four spans of a Catmull-Rom curve or a B-spline, more of a spline, and all of
//   one polynomial.
// - [swings] Through more and more even nodes of Runge's function one polynomial swings more and more, and says so from 13
//   on; through as many of Chebyshev's, or in a spline, it comes nearer and nearer.
// - [float-swings-too] Even where the polynomial comes near, at sin 3x, 41 even nodes are too many for the textbook's form
//   in float.
// - [dolly-zoom] The angle of view computed from the distance keeps the subject's size; an angle with keys of its own has it
//   at the keys, and less between them. What is behind the subject swells.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/made_for.h"
#include "mv/geometry/closest.h"
#include "mv/geometry/plot.h"
#include "mv/geometry/scene.h"
#include "mv/gl/drawing.h"
#include "mv/gl/gl.h"
#include "mv/gl/on_demand.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "mv/motion/arc_length.h"
#include "mv/motion/nodes.h"
#include "shared/function_nodes.h"
#include "shared/key_curve.h"
#include "shared/street.h"

using namespace mv;

namespace {

enum class Which { ball, runge, camera };
enum class Zoom { separate, computed };
enum class Part { upper, lower, both };  // of the right side of the picture

constexpr double rest = 0.5;   // seconds, before the first key and after the last
constexpr double lap = 6;      // seconds of the camera, away and back
constexpr int samples = 1000;  // of a function, and of what goes through its nodes
const vec4 red(0.75, 0.15, 0.1, 1), blue(0.1, 0.3, 0.7, 1), paleBlue(0.62, 0.72, 0.9, 1), grey(0.75, 0.75, 0.75, 1),
    ink(0.1, 0.1, 0.1, 1), orange(0.9, 0.5, 0.1, 1);

struct Street {
    Program program{"keyframes"};
    Mesh mesh{meshOf(figureInStreet()), "street"};
};

struct Keyframes final : Demo {
    Choice<Which> which{this,
                        "scene",
                        Which::ball,
                        {{"ball", "through keys that are dragged, a second from each to the next"},
                         {"runge", "one polynomial through nodes of a function, and the curve through them"},
                         {"camera", "that goes away from what it looks at and zooms in"}},
                        "what has keys"};
    KeyCurve by{this};
    Points keys{this,
                "points",
                {{0.5, 2}, {1.5, 7.5}, {4, 9}, {5, 4.5}, {8, 1}, {9.5, 7}},
                {.low = vec2(0, 0), .high = vec2(10, 10), .least = 2, .most = 16, .grid = 0.1},
                "x,y of each key of the ball, dragged in the picture",
                "m"};
    FunctionNodes of{this};
    Choice<Zoom> zoom{this,
                      "zoom",
                      Zoom::separate,
                      {{"keys", "it has keys of its own"}, {"computed", "from the distance, for each picture"}},
                      "where the camera's angle of view comes from"};
    Real nearest{this, "near", 4, {2, 10}, "distance of the camera at its first and its last key", "m"};
    Real farthest{this, "far", 30, {10, 60}, "distance at the key between them", "m"};
    Real fovy{this, "fovy", 50, {20, 90}, "angle of view at the first key and the last", "deg"};

    Readout velocityJump{this, "velocity-jump", "how far the velocity jumps at a key, at most; the ends aside", "m/s"};
    Readout accelerationJump{this, "acceleration-jump", "the same of the acceleration, of what is not straight",
                             "m/s^2"};
    Readout endJump{this, "end-jump", "with which speed it begins or ends, the larger one", "m/s"};
    Readout curveLength{this, "curve-length", "how long the way is, of what is not eased", "m"};
    Readout overshoot{this, "overshoot", "how far it leaves the rectangle of its keys, of 60 places a second", "m"};
    Readout offPolygon{this, "off-polygon", "how far it leaves the straight lines from key to key, of the same places",
                       "m"};
    Readout polynomialError{this, "polynomial-error", "how far the polynomial is off, at most, at 1000 places"};
    Readout curveError{this, "curve-error", "how far the curve is off, at the same places"};
    Readout subjectSize{this, "subject-size", "height of the subject in the picture, part of the picture's"};
    Readout doorSize{this, "door-size", "the same of the door, 3 m high and 20 m behind the subject"};

    OnDemand<Street> street;
    Drawing drawing;

    Keyframes() {
        bindHandle("key", keys, [this](const FrameInfo& frame, const vec2& key) -> std::optional<vec2> {
            if (which != Which::ball) return std::nullopt;
            return pixelOf(leftPane(frame), key);
        });
        bindHandle("handle", by.handles, [this](const FrameInfo& frame, const vec2& handle) -> std::optional<vec2> {
            if (which != Which::ball || !by.isBezierEase()) return std::nullopt;
            return easePlot(frame).pixel(handle);
        });
        const auto only = [this](Which scene, Literal reason, std::initializer_list<Knob*> knobs) {
            for (Knob* knob : knobs) knob->onlyWhen([this, scene] { return which == scene; }, reason);
        };
        only(Which::ball, "only the ball has keys in a plane", {&keys});
        only(Which::runge, "only scene runge has nodes", {&of.function, &of.count, &of.spread, &of.form});
        only(Which::camera, "only scene camera has one", {&zoom, &nearest, &farthest, &fovy});
    }

    void init() override {}

    void draw(const Frame& frame) override {
        drawing.begin(frame);
        if (which == Which::ball) drawBall(frame);
        if (which == Which::runge) drawRunge(frame);
        if (which == Which::camera) drawCamera(frame);
        drawing.draw(frame);
    }

    // ---- a ball that moves through keys

    // A key a second.
    Motion<vec3> ballMotion() const {
        std::vector<Keyframe<vec3>> through;
        for (const vec2& key : keys.points()) through.push_back({double(through.size()), vec3(key, 0)});
        if (by.kind == KeyCurve::Kind::periodic) through.push_back({double(through.size()), through[0].value});
        return by.through(through, vec3(0), vec3(0));
    }

    // The time of the motion: before 0 and after its end the ball rests, and then begins again. A closed curve has no end.
    static double momentOf(const Motion<vec3>& motion, const Frame& frame) {
        if (motion.curve().isClosed()) return std::fmod(frame.time(), motion.end());
        return std::fmod(frame.time(), motion.end() + 2 * rest) - rest;
    }

    void drawBall(const Frame& frame) {
        const Pane pane = leftPane(frame);
        const Motion<vec3> motion = ballMotion();
        const double now = momentOf(motion, frame), unit = std::min(pane.width, pane.height) / 560.0;
        const auto pixelAt = [&](double time) { return pixelOf(pane, motion.position(time)); };

        // The way, and the ball's places at every tenth of a second: where they are close it is slow
        drawing.in(pane);
        std::vector<vec2> polygon, way;
        for (const vec2& key : keys.points()) polygon.push_back(pixelOf(pane, key));
        drawing.line(polygon, {grey, 1});
        const int frames = static_cast<int>(std::lround(60 * motion.end()));
        for (int i = 0; i <= frames; ++i) way.push_back(pixelAt(i / 60.0));
        drawing.line(way, {blue, 1.5});
        for (std::size_t i = 0; i < way.size(); i += 6) {
            drawing.point(way[i], 8 * unit, double(i) / 60 <= now ? blue : paleBlue);
        }
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            drawing.point(polygon[i], 20 * unit, red);
            drawing.textAround(polygon[i], std::to_string(i + 1), numberStyle(unit));
        }

        // The ball, and how far it would come in a quarter of a second, by its velocity halfway to the next picture
        const vec2 ball = pixelAt(std::clamp(now, 0.0, motion.end()));
        if (now >= 0 && now < motion.end()) {
            const vec3 velocity = motion.at(std::min(now + 1 / 120.0, motion.end())).velocity;
            drawing.arrow(ball, ball + velocityScale(pane) * vec2(velocity), {orange, std::max(1.0, 3 * unit)});
        }
        drawing.point(ball, 24 * unit, orange);
        words(frame, 0,
              by.kind.text() + (by.isEased() ? ", " + by.ease.text() : "") + ": a dot every tenth of a second");

        // Its speed over time, and its acceleration, or how it is eased
        drawGraph(frame, motion, now, Part::upper, "speed, m/s; red: a jump", &CurvePoint<vec3>::velocity);
        if (by.isStraight()) {
            drawEase(frame, now);
        } else {
            drawGraph(frame, motion, now, Part::lower, "acceleration, m/s^2", &CurvePoint<vec3>::acceleration);
        }
        if (by.startsAtOnce()) frame.say("the root leaves each key at infinite speed, which the graph cuts off");
        const auto times = timesOf(keys.size());
        if (const auto warning = swingWarning(times); warning && by.kind == KeyCurve::Kind::lagrange)
            frame.say(*warning);
        if (frame.readouts()) measure(motion, times);
    }

    static std::vector<double> timesOf(std::size_t count) {
        std::vector<double> times;
        for (std::size_t i = 0; i < count; ++i) times.push_back(double(i));
        return times;
    }

    // The size of a quantity, from key to key; at a key it may have two.
    void drawGraph(const Frame& frame, const Motion<vec3>& motion, double now, Part part, const std::string& name,
                   vec3 CurvePoint<vec3>::*quantity) {
        const auto size = [&](const CurvePoint<vec3>& point) { return glm::length(point.*quantity); };
        const int spans = static_cast<int>(std::lround(motion.end()));
        const double end = motion.end(), beyond = motion.curve().isClosed() ? 0 : rest;
        std::vector<std::vector<vec2>> pieces{{{-beyond, 0}, {0, 0}}, {{end, 0}, {end + beyond, 0}}};
        double highest = 1e-6;
        for (int span = 0; span < spans; ++span) {
            pieces.emplace_back();
            for (int i = by.startsAtOnce() ? 1 : 0; i <= 60; ++i) {
                const double time = span + i / 60.0;
                const auto point = i == 0 ? motion.after(span) : i == 60 ? motion.before(span + 1) : motion.at(time);
                pieces.back().emplace_back(time, size(point));
                highest = std::max(highest, size(point));
            }
        }
        if (by.startsAtOnce()) highest *= 0.4;  // what is infinite is cut off anyway
        const Plot plot{boxOf(frame, part), {-beyond, end + beyond, "s"}, {0, 1.1 * highest, name}};
        drawing.in(wholePane(frame));
        for (int key = 0; key <= spans; ++key) {
            drawing.line(plot.pixel({key, 0}), plot.pixel({key, plot.y.high}), {grey, 1});
            const bool isEndless = by.startsAtOnce() && key < spans;
            const double after = isEndless ? plot.y.high : size(motion.after(key));
            drawing.curve(plot, std::array{vec2(key, size(motion.before(key))), vec2(key, after)}, {red, 2.5});
        }
        for (const auto& piece : pieces) drawing.curve(plot, piece, {blue, 2});
        drawing.line(plot.pixel({now, 0}), plot.pixel({now, plot.y.high}), {orange, 1.5});
        drawing.axes(plot);
    }

    void drawEase(const Frame& frame, double now) {
        const Plot plot = easePlot(frame);
        drawing.in(wholePane(frame));
        std::vector<vec2> way;
        for (int i = 0; i <= 200; ++i) way.emplace_back(i / 200.0, by.eased(i / 200.0));
        for (const double y : {0.0, 1.0}) drawing.line(plot.pixel({0, y}), plot.pixel({1, y}), {grey, 1});
        drawing.curve(plot, way, {blue, 2});
        if (by.isBezierEase()) {
            for (const int i : {0, 1}) {
                const vec2 handle = plot.pixel(by.handles[std::size_t(i)]);
                drawing.line(plot.pixel(vec2(i)), handle, {red, 1});
                drawing.point(handle, 11, red);
            }
        }
        if (now >= 0 && now < double(keys.size() - 1)) {
            const double passed = now - std::floor(now);
            drawing.point(plot.pixel({passed, by.eased(passed)}), 9, orange);
        }
        drawing.axes(plot);
    }

    void measure(const Motion<vec3>& motion, const std::vector<double>& times) {
        vec2 low = keys[0], high = keys[0];
        for (const vec2& key : keys.points()) {
            low = glm::min(low, key);
            high = glm::max(high, key);
        }
        double out = 0, off = 0;
        for (int i = 0; i <= std::lround(60 * motion.end()); ++i) {
            const vec2 place(motion.position(i / 60.0)), beyond = glm::max(low - place, place - high);
            out = std::max({out, beyond.x, beyond.y});
            off = std::max(off, distanceToPolygon(vec3(place, 0)));
        }
        overshoot = out;
        offPolygon = off;
        if (!by.isEased()) curveLength = ArcLength(motion.curve()).length();
        if (by.startsAtOnce()) return;
        const Jumps jumps = jumpsOf(motion, times);
        velocityJump = jumps.velocity;
        endJump = jumps.end;
        if (!by.isStraight()) accelerationJump = jumps.acceleration;
    }

    // To the nearest of the straight lines from key to key.
    double distanceToPolygon(const vec3& place) const {
        double least = HUGE_VAL;
        for (std::size_t i = 1; i < keys.size(); ++i) {
            const vec3 foot = closestOnSegment(place, vec3(keys[i - 1], 0), vec3(keys[i], 0));
            least = std::min(least, glm::distance(place, foot));
        }
        return least;
    }

    // ---- one polynomial through many nodes, and a curve

    static double sampleAt(std::size_t i) { return (2 * double(i) + 1) / samples - 1; }
    template <class Value>
    static std::vector<double> sampled(const Value& value) {
        std::vector<double> values(samples);
        for (std::size_t i = 0; i < samples; ++i) values[i] = value(sampleAt(i));
        return values;
    }

    std::vector<double> polynomialValues() const { return sampled(of.polynomial()); }
    std::vector<double> curveValues() const {
        const Motion<double> motion = by.through(of.keys(), of.slopeAt(-1), of.slopeAt(1));
        return sampled([&](double x) { return motion.position(x); });
    }
    // For the study: the polynomial by its form.
    std::vector<double> values() const override {
        return by.kind == KeyCurve::Kind::lagrange ? polynomialValues() : curveValues();
    }

    struct Shown {
        std::vector<double> right, polynomial, curve;
        std::optional<std::string> warning = {};
        static double error(const std::vector<double>& a, const std::vector<double>& b) {
            double largest = 0;
            for (std::size_t i = 0; i < samples; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
            return largest;
        }
    };
    Shown shown;
    MadeFor<std::string> shownFor;

    void drawRunge(const Frame& frame) {
        std::string settings;
        for (const Knob* knob : knobs()) settings += knob->text() + " ";
        if (shownFor.changed(settings)) {
            shown = {.right = sampled([&](double x) { return of.valueAt(x); }),
                     .polynomial = polynomialValues(),
                     .curve = curveValues(),
                     .warning = swingWarning(of.places())};
        }
        polynomialError = Shown::error(shown.polynomial, shown.right);
        curveError = Shown::error(shown.curve, shown.right);

        // What they are, up to half of the function's height beyond it
        const Pane pane = leftPane(frame);
        const bool isRunge = of.function == FunctionNodes::Function::runge;
        const double top = frame.height() - std::min(140.0, frame.height() / 3.5);
        const double x = std::min(50.0, frame.width() / 12.0), y = std::min(48.0, frame.height() / 8.0);
        const Plot plot{{{x, y}, {pane.width - x / 2, top}}, {-1, 1, "x"}, {isRunge ? -0.5 : -2, isRunge ? 1.5 : 2}};
        // How far they are off, however far that is
        Box box = boxOf(frame, Part::both);
        box.high.y = top;
        const double highest = std::max({10.0, 10 * *polynomialError.value(), 10 * *curveError.value()});
        const Plot errors{box, {-1, 1, "x"}, {1e-17, highest, "how far they are off, drawn as 1e-17 at least", true}};

        drawing.in(wholePane(frame));
        drawing.curve(plot, curveOf(shown.right, 5), {grey, 7});
        drawBoth(plot, errors, shown.curve, blue);
        drawBoth(plot, errors, shown.polynomial, red);
        for (const auto& node : of.keys()) drawing.point(plot.pixel({node.time, node.value}), 6, ink);
        drawing.axes(plot);
        drawing.axes(errors);

        // What moves by them, in four seconds from left to right
        const std::size_t now = std::size_t(frame.index() % 240) * samples / 240;
        for (const auto& [values, color] : {std::pair(&shown.curve, blue), std::pair(&shown.polynomial, red)}) {
            const vec2 at = plot.pixel({sampleAt(now), (*values)[now]});
            if (plot.box.holds(at)) drawing.point(at, 14, color);
        }
        const std::string where = std::to_string(of.count) + " nodes, " + of.spread.text();
        words(frame, 0, std::string(isRunge ? "1/(1 + 25 x^2)" : "sin 3x") + ", grey, at " + where);
        words(frame, 1, by.kind.text() + ": off by " + rounded("%.2g", *curveError.value()), blue);
        const bool isCut = *polynomialError.value() > 0.5;
        words(frame, 2,
              "one polynomial: off by " + rounded("%.2g", *polynomialError.value()) +
                  (isCut ? ", which the graph below cuts off and the one on the right does not" : ""),
              red);
        if (!shown.warning) return;
        frame.say(*shown.warning);
        const std::size_t comma = shown.warning->find("; ") + 2;
        words(frame, 3, shown.warning->substr(0, comma), red);
        words(frame, 4, shown.warning->substr(comma), red);
    }

    static std::vector<vec2> curveOf(const std::vector<double>& values, std::size_t step = 1) {
        std::vector<vec2> curve;
        for (std::size_t i = 0; i < values.size(); i += step) curve.emplace_back(sampleAt(i), values[i]);
        return curve;
    }
    // What is off by less than the lowest error drawn is drawn there.
    void drawBoth(const Plot& plot, const Plot& errors, const std::vector<double>& values, const vec4& color) {
        std::vector<double> off;
        for (std::size_t i = 0; i < samples; ++i) {
            off.push_back(std::max(errors.y.low, std::abs(values[i] - shown.right[i])));
        }
        drawing.curve(plot, curveOf(values), {color, 2});
        drawing.curve(errors, curveOf(off), {color, 1.5});
    }

    // ---- a camera whose distance and angle of view have keys

    struct View {
        double distance, fovy;
        // How much of the picture's height a thing has that is so far behind the subject
        double sizeOf(double height, double behind = 0) const {
            return height / (2 * (distance + behind) * std::tan(radians(fovy / 2)));
        }
    };
    // The dolly zoom: the angle for which the subject is as large as at the first key.
    double fovyFor(double distance) const {
        return 2 * degrees(std::atan(nearest * std::tan(radians(fovy / 2)) / distance));
    }
    // Near, far and near again, and the angles for these.
    View viewAt(double time, Zoom zoomedBy) const {
        const auto between = [&](double end, double middle) {
            return by.through<double>({{0, end}, {lap / 2, middle}, {lap, end}}, 0, 0).position(time);
        };
        const double distance = between(nearest, farthest);
        return {distance, zoomedBy == Zoom::computed ? fovyFor(distance) : between(fovy, fovyFor(farthest))};
    }

    void drawCamera(const Frame& frame) {
        const double now = std::fmod(frame.time(), lap);
        const View view = viewAt(now, zoom);
        const Pane pane = leftPane(frame);
        const vec3 middle(0, figureHeight / 2, 0);
        const mat4 viewFromWorld = lookAt(middle + vec3(0, 0, view.distance), middle, vec3(0, 1, 0));
        const mat4 clipFromView = perspective(view.fovy, pane.aspect(), 0.5, 300);
        frame.show("viewFromWorld", viewFromWorld);
        frame.show("clipFromView", clipFromView);
        glEnable(GL_CULL_FACE);
        glViewport(pane.x, pane.y, pane.width, pane.height);
        street->program.use();
        street->program.set("clipFromWorld", clipFromView * viewFromWorld);
        street->mesh.draw();
        glViewport(0, 0, frame.width(), frame.height());

        // How large the subject is at the first key, and is to stay
        const double half = viewAt(0, zoom).sizeOf(figureHeight) * pane.height / 2;
        drawing.in(pane);
        for (const double y : {pane.height / 2.0 - half, pane.height / 2.0 + half}) {
            drawing.line({0, y}, {double(pane.width), y}, {ink, 1});
        }
        words(frame, 0, rounded("distance %.1f m", view.distance) + rounded(", angle of view %.1f deg", view.fovy));
        drawOverTime(frame, now, Part::upper, "subject, part of the picture's height",
                     [](const View& v) { return v.sizeOf(figureHeight); });
        drawOverTime(frame, now, Part::lower, "angle of view, deg", [](const View& v) { return v.fovy; });
        subjectSize = view.sizeOf(figureHeight);
        doorSize = view.sizeOf(doorHeight, doorBehindFigure);
    }

    // With keys of its own red, computed blue; the wider one is shown.
    void drawOverTime(const Frame& frame, double now, Part part, const std::string& name, double (*size)(const View&)) {
        std::array<std::vector<vec2>, 2> lines;
        double highest = 0;
        for (const Zoom zoomedBy : {Zoom::separate, Zoom::computed}) {
            auto& line = lines.at(std::size_t(zoomedBy));
            for (int i = 0; i <= 120; ++i) {
                line.emplace_back(i * lap / 120, size(viewAt(i * lap / 120, zoomedBy)));
                highest = std::max(highest, line.back().y);
            }
        }
        const Plot plot{boxOf(frame, part),
                        {0, lap, "s; red: angle with keys of its own, blue: computed"},
                        {0, 1.15 * highest, name}};
        drawing.in(wholePane(frame));
        for (const double key : {0.0, lap / 2, lap}) {
            drawing.line(plot.pixel({key, 0}), plot.pixel({key, plot.y.high}), {grey, 1});
        }
        drawing.curve(plot, lines[0], {red, zoom == Zoom::separate ? 3.5 : 1.5});
        drawing.curve(plot, lines[1], {blue, zoom == Zoom::computed ? 3.5 : 1.5});
        drawing.line(plot.pixel({now, 0}), plot.pixel({now, plot.y.high}), {orange, 1.5});
        drawing.axes(plot);
    }

    // ---- where things are in the picture

    static Pane wholePane(const FrameInfo& frame) { return {0, 0, frame.width(), frame.height()}; }
    static Pane leftPane(const FrameInfo& frame) { return {0, 0, std::max(frame.width() * 7 / 12, 1), frame.height()}; }
    // Ten metres each way and a margin, for what goes beyond its keys.
    static double metre(const Pane& pane) { return std::min(pane.width, pane.height) / 12.5; }
    static vec2 pixelOf(const Pane& pane, const vec2& place) {
        return vec2(pane.width, pane.height) / 2.0 + metre(pane) * (place - vec2(5, 5));
    }
    static double velocityScale(const Pane& pane) { return 0.25 * metre(pane); }
    // On the right, with room for what is written along the axes.
    static Box boxOf(const FrameInfo& frame, Part part) {
        const double room = std::min(64.0, frame.width() / 12.0), half = frame.height() / 2.0;
        const double low = part == Part::upper ? half : 0, high = part == Part::lower ? half : 2 * half;
        return {{leftPane(frame).width + room, low + std::min(48.0, half / 4)},
                {frame.width() - room / 4, high - std::min(40.0, half / 4)}};
    }
    static Plot easePlot(const FrameInfo& frame) {
        return {boxOf(frame, Part::lower), {0, 1, "part of the time between two keys"}, {-0.5, 1.5, "part of the way"}};
    }
    static TextStyle wordStyle(const FrameInfo& frame, const vec4& color) {
        return {.height = std::clamp(frame.height() / 33, 6, 20), .color = color, .background = vec4(0)};
    }
    static TextStyle numberStyle(double unit) {
        return {.height = std::max(6, static_cast<int>(14 * unit)), .color = vec4(1), .background = vec4(0)};
    }
    void words(const Frame& frame, int line, const std::string& text, const vec4& color = ink) {
        const TextStyle style = wordStyle(frame, color);
        drawing.in(wholePane(frame));
        drawing.text({10, frame.height() - 6 - line * (style.height + 4)}, text, style);
    }

    void check() const override {
        if (which == Which::runge && by.kind == KeyCurve::Kind::periodic &&
            of.function == FunctionNodes::Function::sine)
            throw Error("--curve periodic", "must have the same value at both ends, which sin 3x has not");
        if (which != Which::camera) return;
        for (int i = 0; i <= 60 * int(lap); ++i) {
            const View view = viewAt(i / 60.0, zoom);
            if (!(view.distance >= 1 && view.fovy >= 1 && view.fovy <= 170)) {
                throw Error(by.isBezierEase() ? "--handles" : "--ease",
                            "must keep the camera 1 m before its subject, and its angle of view in 1 .. 170",
                            by.isBezierEase() ? by.handles.text() : by.ease.text());
            }
        }
    }
};

constexpr Declaration declaration{
    .name = "keyframes",
    .sentence = "What moves between keys: straight, eased, by one polynomial, by splines.",
    .lookFor = "Straight from key to key the speed jumps; along a spline it does not; one polynomial swings.",
    .chapter = "Motion",
    .number = 34,
    .width = 960,
    .height = 560,
    .animated = true,
    .background = vec4(1, 1, 1, 1),
    .presets =
        {
            {"straight", "The speed is constant from key to key, and jumps at each of them: red lines in the graph."},
            {"spline",
             "A cubic spline through the same keys: neither velocity nor acceleration jumps between its ends.",
             {{"curve", "natural"}}},
            {"eased",
             "Straight again, but slowly off and slowly on: drag the two red handles of the lower graph.",
             {{"curve", "ease"}, {"ease", "bezier"}}},
            {"runge",
             "One polynomial through 21 even nodes is off by 60, the spline through them by less than 0.01.",
             {{"scene", "runge"}, {"curve", "natural"}},
             {{"polynomial-error", 59.5, 60.5}, {"curve-error", 0, 0.01}}},
            {"chebyshev",
             "The polynomial through as many nodes, denser to the ends, is off by 0.02.",
             {{"scene", "runge"}, {"curve", "natural"}, {"nodes-at", "chebyshev"}},
             {{"polynomial-error", 0.015, 0.025}}},
            {"dolly-zoom",
             "The camera goes away and zooms in: its subject stays as large, and the house behind it swells.",
             {{"scene", "camera"}, {"curve", "clamped"}, {"zoom", "computed"}}},
        },
};

const bool added = addDemo<Keyframes, declaration>();

}  // namespace
