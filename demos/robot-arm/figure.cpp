// The figures over two links, or the arm: ghosts, the way of the end, the target, and words.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "mv/formatted.h"
#include "mv/motion/two_link.h"
#include "robot-arm.h"

namespace mv::robot_arm {
namespace {

using Words = std::vector<std::string>;
const vec4 pale(0.25, 0.42, 0.70, 0.3), other(0.10, 0.55, 0.40, 0.7);

std::string place(const Settings& s, const vec3& at) {
    const std::string inPlane = shortNumber(at.x) + ", " + shortNumber(at.y);
    return "(" + inPlane + (isArm(s) ? ", " + shortNumber(at.z) : "") + ")";
}
void stick(JointedOverlay& overlay, const Jointed& thing, const Angles& angles, const Stroke& stroke) {
    overlay.stick(thing, worldFromParts(thing.tree, angles), stroke);
}

// How many solutions two links have for the target.
std::string counted(const TwoLinkAnswer& answer) {
    static const std::array<std::string, 4> counts{"no solution", "one solution", "two solutions",
                                                   "infinitely many solutions"};
    return counts.at(static_cast<std::size_t>(answer.solutions));
}

// The way of two links' end in the last 300 frames, and in the next 300.
void showWay(JointedOverlay& overlay, const Settings& s, int index) {
    const auto way = [&](int from, int to) {
        std::vector<vec2> places;
        for (int i = from; i <= to; ++i) {
            const Angles angles = anglesAt(s, i);
            places.push_back(overlay.pixel(vec3(twoLinkEnd(s.upper, s.lower, {angles[0], angles[1]}), 0)));
        }
        return places;
    };
    overlay.below.line(way(index, index + 300), {vec4(vec3(robotRed), 0.35), 1.5});
    overlay.above.line(way(std::max(0, index - 300), index), {robotRed, 2});
}

std::string meters(double length) { return formatted("%.3g", length); }

// The axes of each of two links, at its joint, and how long it is.
void showAxes(JointedOverlay& overlay, const Settings& s, const Jointed& thing,
              const std::vector<mat4>& worldFromPart) {
    const std::array lengths{s.upper, s.lower};
    for (std::size_t i = 0; i < worldFromPart.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        const auto at = [&](double x, double y) { return overlay.pixel(vec3(worldFromPart[i] * vec4(x, y, 0, 1))); };
        const auto axis = [&](const vec2& to, const vec2& beside, const std::string& name, const vec4& color) {
            overlay.above.arrow(at(0, 0), at(to.x, to.y), {color, 2.5});
            overlay.above.textAround(at(beside.x, beside.y), name + number, {overlay.size(), color, vec4(0)});
        };
        axis({0, 0.5}, {0, 0.6}, "y", vec4(0.05, 0.45, 0.1, 1));
        axis({0.5, 0}, {0.5, 0.17}, "x", robotRed);
        overlay.above.textAround(at(0.6 * lengths.at(i), -0.3), "l" + number + " = " + meters(lengths.at(i)),
                                 {overlay.size(), vec4(0.75 * thing.parts[i].color, 1), vec4(1, 1, 1, 0.6)});
    }
}

// What each matrix of two links does; where the angles are given, also the end as the slide's formula has it.
Words aboutMatrices(const Settings& s, const vec3& end) {
    const std::string l1 = meters(s.upper), l2 = meters(s.lower);
    Words words{"turn by θ1", l1 + " m along x, then turn by θ2", "the product: turn by θ1 + θ2, from the elbow on"};
    if (!isForward(s)) return words;
    const auto line = [&](const std::string& name, const std::string& function, double value) {
        words.push_back(name + " = " + l1 + " " + function + " θ1 + " + l2 + " " + function +
                        "(θ1 + θ2) = " + shortNumber(value));
    };
    words.push_back("the end: worldFromLower * (" + l2 + ", 0, 1)");
    line("x", "cos", end.x);
    line("y", "sin", end.y);
    return words;
}

// In closed form: all solutions, or some of infinitely many, and why there are so many.
Words showSolutions(JointedOverlay& overlay, const Settings& s, const Jointed& thing, const Angles& angles) {
    const vec2 target(targetOf(s));
    const TwoLinkAnswer answer = twoLinkAngles(s.upper, s.lower, target);
    const std::string why(answer.reason);
    const std::size_t colon = why.find(':');  // a long reason has two lines
    Words words{counted(answer) + ":", why.substr(0, colon)};
    if (colon != std::string::npos) words.push_back(why.substr(colon + 2));
    if (answer.distance > 0) words.push_back(formatted("nearest point: %.3g m away", answer.distance));
    if (answer.solutions == TwoLinkSolutions::infinitelyMany) {
        for (int degrees = 0; degrees < 360; degrees += 15)
            stick(overlay, thing, {double(degrees), angles[1]}, {pale, 3});
    } else {
        stick(overlay, thing, byFormula(s, target, 0), {pale, 7});
    }
    overlay.target(targetOf(s), stickOf(thing, worldFromParts(thing.tree, angles)).back());
    return words;
}

// The poses from the start on, and what the arm comes to from other starts.
void showPoses(JointedOverlay& overlay, const Settings& s, const Jointed& thing, int taken) {
    const vec3 target = targetOf(s);
    for (int k = 0; k < taken; ++k)  // a run of fewer iterations is the beginning of a longer one
        stick(overlay, thing, byIteration(thing, anglesAt(s, 0), target, k, s.method).degrees, {pale, 2.5});
    for (int k = 0; isArm(s) && s.arm.others && k < 8; ++k)
        stick(overlay, thing, byIteration(thing, armStart(k), target, mostIterations, s.method).degrees, {other, 2.5});
}

// The target, in space with its height above the table, and where the ball of the reach is cut at that height.
void showTarget(JointedOverlay& overlay, const Settings& s, const vec3& goal) {
    const vec3 target = targetOf(s);
    const double reach = legOf(s) + armHand;
    overlay.target(target, goal);
    if (!isArm(s)) return;
    overlay.above.edge(overlay.clipFromWorld(), target, {target.x, table, target.z}, {robotGrey, 1});
    if (std::abs(target.y) < reach) overlay.circleAt(target.y, std::sqrt(std::pow(reach, 2) - std::pow(target.y, 2)));
}

// How fast each of the methods comes near.
void plotResiduals(JointedOverlay& overlay, const Settings& s, const Jointed& thing, const Frame& frame) {
    std::vector<ResidualCurve> curves;
    for (const Method by : {Method::ccd, Method::transpose, Method::dls}) {
        const IkResult result = byIteration(thing, anglesAt(s, 0), targetOf(s), mostIterations, by);
        curves.push_back({nameOf(by), result.history, by == s.method});
    }
    const int left = frame.isUpright() ? frame.width() * 11 / 20 : paneOf(s, frame).width;
    overlay.residuals(frame, curves, left, s.iterations, mostIterations);
}

Words showIterations(JointedOverlay& overlay, const Settings& s, const Jointed& thing, const IkResult& found,
                     const Frame& frame) {
    static const std::array<std::string, 5> ends{"reached", "out of reach, its projection reached",
                                                 "out of reach, its projection not yet",
                                                 "stalled: no step comes nearer", "not yet there"};
    const int taken = static_cast<int>(found.history.size()) - 1;
    const vec3 target = targetOf(s);
    showPoses(overlay, s, thing, taken);
    showTarget(overlay, s, found.goal);
    const std::string armSolutions =
        found.goal == target ? "4 angles for 3 coordinates: in general infinitely many solutions" : "no solution";
    Words words{
        nameOf(s.method) + ": " + ends.at(static_cast<std::size_t>(found.end)),
        formatted("iterations: %.0f", taken) + formatted(", joints at a limit: %.0f", double(found.atLimit.size())),
        isArm(s) ? armSolutions : counted(twoLinkAngles(s.upper, s.lower, vec2(target))),
        "target at " + place(s, target)};
    if (found.goal != target) {
        words.push_back("projected to " + place(s, found.goal));
        frame.say("The target is out of reach: the end goes for its projection, " + place(s, found.goal) + ".");
    }
    plotResiduals(overlay, s, thing, frame);
    return words;
}

Words showMethod(JointedOverlay& overlay, const Settings& s, const Jointed& thing, const IkResult& found,
                 const Frame& frame) {
    if (iterates(s)) return showIterations(overlay, s, thing, found, frame);
    if (s.method == Method::closed) return showSolutions(overlay, s, thing, found.degrees);
    if (isLinks(s)) showWay(overlay, s, frame.index());
    return {"forward: the angles are given"};
}

}  // namespace

void showLinks(JointedOverlay& overlay, const Settings& s, const Jointed& thing, const IkResult& found,
               const std::vector<mat4>& worldFromPart, const Frame& frame) {
    if (isLinks(s)) overlay.ring(std::abs(s.upper - s.lower), legOf(s));
    Words words = showMethod(overlay, s, thing, found, frame);
    const vec3 end = stickOf(thing, worldFromPart).back();
    overlay.above.point(overlay.clipFromWorld(), end, 7, robotInk);
    words.push_back("end at " + place(s, end));
    for (const std::string& each : words) overlay.say(each);
    overlay.angles(thing, worldFromPart, found.degrees);
    if (isLinks(s)) showAxes(overlay, s, thing, worldFromPart);
    if (s.matrices)
        overlay.product(frame, thing, worldFromPart, found.degrees, besideOf(s, frame), isLinks(s),
                        isLinks(s) ? aboutMatrices(s, end) : Words());
}

// Left of the matrices and the plot, where these are shown; above them in a picture that is higher than wide.
Pane paneOf(const Settings& s, const FrameInfo& frame) {
    const bool besides = s.matrices || (iterates(s) && !isWalker(s));
    if (!besides) return {0, 0, std::max(frame.width(), 1), frame.height()};
    const int high = std::max(frame.height() * 2 / 5, 1);
    if (frame.isUpright()) return {0, frame.height() - high, frame.width(), high};
    return {0, 0, std::max(frame.width() * 3 / 5, 1), frame.height()};
}
Pane besideOf(const Settings& s, const FrameInfo& frame) {
    const Pane pane = paneOf(s, frame);
    if (frame.isUpright()) return {0, 0, frame.width(), std::max(frame.height() - pane.height, 1)};
    return {pane.width, 0, std::max(frame.width() - pane.width, 1), frame.height()};
}

}  // namespace mv::robot_arm
