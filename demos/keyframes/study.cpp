// The readouts of keyframes, and its study: how near polynomials and curves through nodes come to a function,
// and how long a value takes.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "keyframes.h"
#include "mv/demo/lesson.h"
#include "mv/geometry/closest.h"
#include "mv/motion/arc_length.h"

namespace mv::keyframes {
namespace {

// The distance to the nearest of the straight lines from key to key.
double distanceToPolygon(const std::vector<vec2>& keys, const vec3& place) {
    double least = HUGE_VAL;
    for (std::size_t i = 1; i < keys.size(); ++i) {
        const vec3 foot = closestOnSegment(place, vec3(keys[i - 1], 0), vec3(keys[i], 0));
        least = std::min(least, glm::distance(place, foot));
    }
    return least;
}

void tellPlaces(const Settings& s, const Motion<vec3>& motion, Numbers& numbers) {
    vec2 low = s.keys[0], high = s.keys[0];
    for (const vec2& key : s.keys) {
        low = glm::min(low, key);
        high = glm::max(high, key);
    }
    double out = 0, off = 0;
    for (int i = 0; i <= std::lround(60 * motion.end()); ++i) {
        const vec2 place(motion.position(i / 60.0)), beyond = glm::max(low - place, place - high);
        out = std::max({out, beyond.x, beyond.y});
        off = std::max(off, distanceToPolygon(s.keys, vec3(place, 0)));
    }
    numbers.set("overshoot", out);
    numbers.set("off-polygon", off);
}

void tellBall(const Settings& s, Numbers& numbers) {
    const Motion<vec3> motion = ballMotion(s);
    tellPlaces(s, motion, numbers);
    if (!s.curve.isEased()) numbers.set("curve-length", ArcLength(motion.curve()).length());
    if (s.curve.startsAtOnce()) return;
    const Jumps jumps = jumpsOf(motion, timesOf(s.keys.size()));
    numbers.set("velocity-jump", jumps.velocity);
    numbers.set("end-jump", jumps.end);
    if (!s.curve.isStraight()) numbers.set("acceleration-jump", jumps.acceleration);
}

void tellCamera(const Settings& s, double time, Numbers& numbers) {
    const View view = viewAt(s.camera, s.curve, std::fmod(time, lap), s.camera.zoom);
    numbers.set("subject-size", view.sizeOf(figureHeight));
    numbers.set("door-size", view.sizeOf(doorHeight, doorBehindFigure));
}

}  // namespace

void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers) {
    if (s.which == Which::ball) return tellBall(s, numbers);
    if (s.which == Which::camera) return tellCamera(s, frame.time(), numbers);
    if (s.which != Which::runge) return;
    numbers.set("polynomial-error", gpu.sampled.polynomialError());
    numbers.set("curve-error", gpu.sampled.curveError());
}

// The polynomial is taken by its form.
std::vector<double> values(const Settings& s) {
    return s.curve.kind == KeyCurve::Kind::lagrange ? polynomialValues(s) : curveValues(s);
}

namespace {

using namespace mv::claims;

// The function itself, in long double.
Reference exactValues(const Demo& demo) {
    const bool isRunge = settingsOf<Settings>(demo).nodes.function == FunctionNodes::Function::runge;
    Reference right;
    for (int i = 0; i < samples; ++i) {
        const long double x = static_cast<long double>(2 * i + 1) / samples - 1;
        right.values.push_back(static_cast<double>(isRunge ? 1 / (1 + 25 * x * x) : std::sin(3 * x)));
    }
    return right;
}

const char* const runge = "Runge's function";
const char* const sine = "sin 3x";

Study study() {
    Study study;
    study.quantity = "1000 values between the nodes";
    study.reference = "the function itself, in long double";
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) { return exactValues(demo); };
    study.axis = ErrorAxis::max;
    study.scenes = {{runge, {{"scene", "runge"}, {"function", "runge"}}},
                    {sine, {{"scene", "runge"}, {"function", "sine"}}}};
    const auto line = [&](const std::string& method, std::vector<KnobSetting> settings) {
        study.lines.push_back({method, std::move(settings), "nodes", {"5", "7", "11", "13", "21", "41", "61", "81"}});
    };
    line("linear", {{"curve", "linear"}});
    line("Bezier", {{"curve", "bezier"}});
    line("B-spline", {{"curve", "b-spline"}});
    line("Catmull-Rom", {{"curve", "catmull-rom"}});
    line("natural spline", {{"curve", "natural"}});
    line("clamped spline", {{"curve", "clamped"}});
    line("polynomial, even", {{"curve", "lagrange"}});
    line("polynomial, Chebyshev", {{"curve", "lagrange"}, {"nodes-at", "chebyshev"}});
    line("textbook, even", {{"curve", "lagrange"}, {"form", "textbook"}});
    line("textbook in float, even", {{"curve", "lagrange"}, {"form", "float"}});
    study.wrongBeyond = 0.01;
    study.says = {
        claim("runge-swings",
              "Through even nodes of Runge's function one polynomial is off by 60 at 21 nodes and by 5e11 at 81.",
              {value(of::max, rows("polynomial, even").in(runge).at(21), 59.5, 60.5),
               value(of::max, rows("polynomial, even").in(runge).at(81), 4.5e11, 5.5e11)}),
        claim("chebyshev-comes-near",
              "Through Chebyshev's it comes nearer with each node: below 0.02 at 21, 4e-4 at 41.",
              {atMost(of::max, rows("polynomial, Chebyshev").in(runge).at(21), 2e-2),
               atMost(of::max, rows("polynomial, Chebyshev").in(runge).at(41), 4e-4)}),
        claim("smooth-and-even",
              "Of sin 3x even nodes are right to 1e-12 at 21, and from there on what the keys are rounded by grows: at "
              "61 "
              "and 81 the polynomial is off by more than a hundredth.",
              {atMost(of::max, rows("polynomial, even").in(sine).at(21), 1e-12),
               atLeast(of::max, rows("polynomial, even").in(sine).from(61), 0.01)}),
        claim("float-is-gone", "The textbook's form in float is off by more than 10 at 41 even nodes of sin 3x.",
              {atLeast(of::max, rows("textbook in float, even").in(sine).from(41), 10)}),
        claim("smooth-and-chebyshev", "Through 21 or more of Chebyshev's nodes of sin 3x it is right to 1e-14.",
              {atMost(of::max, rows("polynomial, Chebyshev").in(sine).from(21), 1e-14)}),
        claim("square", "What is straight from node to node errs by the square of their distance; so does a B-spline.",
              {slope(of::max, rows("linear", "B-spline").in(sine).from(11), -2.2, -1.8)}),
        claim("cube", "A Catmull-Rom curve errs by its cube.",
              {slope(of::max, rows("Catmull-Rom").in(sine).from(11), -3.3, -2.8)}),
        claim("fourth", "A spline that has the velocities at its ends errs by its fourth power.",
              {slope(of::max, rows("clamped spline").in(sine).from(11), -4.4, -3.8)}),
        claim("natural-ends",
              "A natural spline does so only where the function has no acceleration at its ends. Sin 3x has: by the "
              "square.",
              {slope(of::max, rows("natural spline").in(sine).from(11), -2.3, -1.8)}),
        claim("bezier-is-slow", "A Bezier curve of all nodes comes near as their distance, no faster.",
              {slope(of::max, rows("Bezier").in(sine).from(11), -1.2, -0.8)}),
        claim("barycentric-is-faster",
              "The barycentric form takes less than half of the textbook's time from 21 nodes on.",
              {ratio(of::time, rows("polynomial, even").from(21), rows("textbook, even"), 0, 0.5)}),
        claim("spline-is-faster",
              "From 41 nodes on a spline takes less than half of the time of the polynomial's barycentric form.",
              {ratio(of::time, rows("clamped spline").from(41), rows("polynomial, even"), 0, 0.5)}),
        note("A millisecond for 1000 values is a microsecond for each, and the curve is made in this time, too.")};
    study.reads = {"function"};
    study.ofValues = true;
    return study;
}

const bool studied = addStudy("keyframes", study());

}  // namespace
}  // namespace mv::keyframes
