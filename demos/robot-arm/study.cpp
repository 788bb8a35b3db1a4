// The readouts of robot-arm, and its study: how far from the target the arm's end comes in so many iterations,
// from 60 starts.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "mv/demo/lesson.h"
#include "mv/motion/two_link.h"
#include "robot-arm.h"

namespace mv::robot_arm {
namespace {

void tellWalker(const Settings& s, int index, Numbers& numbers) {
    const double now = double(index) / cycleFrames;
    numbers.set("slide", offOf(trackOf(s, now, Method::forward)));
    if (!isForward(s)) numbers.set("slip", offOf(trackOf(s, now, s.method)));
}

std::size_t pairsAt(const Settings& s, double cycles) {
    const Jointed thing = person(s.upper, s.lower);
    return inEachOther(thing, worldFromParts(thing.tree, personAngles(s, cycles))).size();
}

void tellPerson(const Settings& s, int index, Numbers& numbers) {
    constexpr double cycleSeconds = cycleFrames / 60.0, before = 1e-9;
    const auto count = posesOf(s.person.routine).size();
    double jump = 0;
    for (const Curve<double>& curve : curvesOf(s)) {
        for (std::size_t i = 0; i < count; ++i) {
            const double pose = double(i) / double(count);
            jump = std::max(jump, std::abs(curve.at(pose).velocity - curve.at(pose - before).velocity));
        }
    }
    std::size_t most = 0;
    for (int i = 0; i < cycleFrames; ++i) most = std::max(most, pairsAt(s, cyclesAt(i)));
    numbers.set("turn-jump", jump / cycleSeconds);
    numbers.set("through", double(pairsAt(s, cyclesAt(index))));
    numbers.set("through-most", double(most));
}

void tellIteration(const IkResult& found, Numbers& numbers) {
    numbers.set("residual", found.history.back().residual);
    numbers.set("iterations-used", double(found.history.size()) - 1);
    numbers.set("at-limit", double(found.atLimit.size()));
}

// Infinitely many are not told.
void tellSolutions(const Settings& s, Numbers& numbers) {
    const TwoLinkAnswer answer = twoLinkAngles(s.upper, s.lower, vec2(targetOf(s)));
    if (answer.solutions != TwoLinkSolutions::infinitelyMany) numbers.set("solutions", double(answer.solutions));
}

}  // namespace

void readOut(Gpu&, const Settings& s, const Frame& frame, Numbers& numbers) {
    if (isWalker(s)) return tellWalker(s, frame.index(), numbers);
    if (isPerson(s)) return tellPerson(s, frame.index(), numbers);
    const Jointed thing = thingOf(s);
    const IkResult found = find(s, thing, frame.index());
    const vec3 end = stickOf(thing, worldFromParts(thing.tree, found.degrees)).back();
    numbers.set("end-x", end.x);
    numbers.set("end-y", end.y);
    numbers.set("end-z", end.z);
    if (isForward(s)) return;
    numbers.set("to-target", glm::distance(end, targetOf(s)));
    if (isLinks(s)) tellSolutions(s, numbers);
    if (iterates(s)) tellIteration(found, numbers);
}

// How far the arm's end is from the target, from each of 60 starts; at the start where nothing iterates.
std::vector<double> values(const Settings& s) {
    const Jointed thing = arm(s.upper, s.lower, s.arm.limits);
    const Method by = iterates(s) ? s.method : Method::dls;
    const int most = iterates(s) ? s.iterations : 0;
    std::vector<double> distances(60);
    for (int k = 0; double& each : distances) each = byIteration(thing, armStart(k++), targetOf(s), most, by).distance;
    return distances;
}

namespace {

using namespace mv::claims;

// Geometry: the reach of the free arm is a ball about its shoulder, and the nearest point of a ball is on the way to its middle.
Reference nearest(const Demo& demo) {
    const auto s = settingsOf<Settings>(demo);
    const double away = std::hypot(s.target.x, s.target.y, s.target.z);
    const double least = s.beyond > 0 ? s.beyond : std::max(0.0, away - (legOf(s) + armHand));
    return {.values = std::vector<double>(60, least)};
}

Study study() {
    Study study;
    study.quantity = "the distance in metres of the arm's end from the target, from each of 60 starts";
    study.reference = "the distance from the target to the ball that the arm reaches";
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) { return nearest(demo); };
    const KnobSetting arm{"scene", "arm"}, free{"limits", "off"};
    study.scenes = {{"reachable", {arm, free}},
                    {"at the edge", {arm, free, {"target-x", "1.44"}, {"target-y", "1.152"}, {"target-z", "1.536"}}},
                    {"1e-3 beyond", {arm, free, {"beyond", "0.001"}}},
                    {"1 beyond", {arm, free, {"beyond", "1"}}},
                    {"100 beyond", {arm, free, {"beyond", "100"}}}};
    const std::vector<std::string> iterations{"1", "2", "4", "8", "16", "32", "64"};
    for (const std::string method : {"ccd", "transpose", "dls"}) {
        study.lines.push_back(
            {.method = method, .settings = {{"method", method}}, .knob = "iterations", .values = iterations});
    }
    study.wrongBeyond = 0.0025;
    const auto far = [](const char* scene) { return atLeast(of::rms, rows("ccd", "transpose").in(scene), 0.01); };
    const auto asNear = [](const char* method) {
        return ratio(of::rms, rows(method).in("100 beyond").from(8), rows(method).in("1e-3 beyond").from(8), 0.9, 1.1);
    };
    study.says = {
        claim("all-starts",
              "Damped least squares is within 2.5 mm of the nearest point after 32 iterations, from all starts.",
              {atMost(of::max, rows("dls").from(32), 0.0025)}),
        claim("to-its-tolerance",
              "Within reach and at the edge that is its tolerance, a thousand millionth of the reach.",
              {atMost(of::max, rows("dls").in("reachable").from(32), 2.5e-9),
               atMost(of::max, rows("dls").in("at the edge").from(32), 2.5e-9)}),
        claim("slow-where-straight",
              "At the edge and beyond, where the arm ends up straight, coordinate descent and Jacobian transpose are "
              "after 64 iterations still more than a centimetre off.",
              {far("at the edge"), far("1e-3 beyond"), far("1 beyond"), far("100 beyond")}),
        claim("first-steps", "In up to eight iterations coordinate descent comes nearer than both others.",
              {ratio(of::rms, rows("ccd").upTo(8), rows("dls").upTo(8), 0, 0.99),
               ratio(of::rms, rows("ccd").upTo(8), rows("transpose").upTo(8), 0, 0.99)}),
        claim("far-is-as-near",
              "How far beyond the reach the target is makes from eight iterations on no difference above a tenth.",
              {asNear("ccd"), asNear("transpose"), asNear("dls")}),
        claim("done-sooner",
              "At the edge damped least squares is done in less than 0.6 of the time of 64 iterations of the others.",
              {ratio(of::time, rows("dls").in("at the edge").at(64), rows("ccd").in("at the edge").at(64), 0, 0.6),
               ratio(of::time, rows("dls").in("at the edge").at(64), rows("transpose").in("at the edge").at(64), 0,
                     0.6)}),
        note("Times are of 60 targets: 1 ms is 17 microseconds for each. A method ends when it is at its goal, so what "
             "is allowed beyond that costs nothing. Beyond the reach the goal is inside of it by a thousandth, 2.4 mm, "
             "which is what remains. No joint turns by more than 20 degrees in an iteration."),
    };
    study.reads = {"target-x", "target-y", "target-z", "beyond", "upper", "lower"};
    study.ofValues = true;
    return study;
}

const bool studied = addStudy("robot-arm", study());

}  // namespace
}  // namespace mv::robot_arm
