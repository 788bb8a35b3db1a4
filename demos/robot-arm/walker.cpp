// A walker. Its gait sets the places of the feet, whatever moves the legs.
#include <algorithm>
#include <glm/geometric.hpp>

#include "mv/formatted.h"
#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "mv/motion/two_link.h"
#include "robot-arm.h"
#include "walk.h"

namespace mv::robot_arm {
namespace {

Walk walkOf(const Settings& s) { return {.upper = s.upper, .lower = s.lower, .poses = s.poses}; }
Jointed legsAt(const Settings& s, double cycles) { return legs(s.upper, s.lower, walkOf(s).hip(cycles)); }
Pane rowOf(const Settings& s, const FrameInfo& frame, int row, int rows) {
    const Pane pane = paneOf(s, frame);
    const int height = std::max(pane.height / rows, 1);
    return {0, pane.y + pane.height - height * (row + 1), pane.width, height};
}
mat4 clipFromGround(const Settings& s, const Pane& pane, double hip) {
    const double wide = 1.6 * legOf(s) * pane.aspect();
    const mat4 clipFromView = ortho(-0.7 * wide, 0.3 * wide, -0.2 * legOf(s), 1.4 * legOf(s), -20, 20);
    return clipFromView * rotateY(-18) * translate(-hip, 0, 0);
}

// Show the near foot in each frame of the last two cycles, and a mark wherever it must stand.
void showTrack(JointedOverlay& overlay, const std::vector<Step>& track) {
    overlay.below.fill({{0, 0}, {double(overlay.pane().width), overlay.pixel(vec3(0)).y}}, robotEarth);
    std::vector<vec2> way;
    for (const Step& step : track) {
        way.push_back(overlay.pixel(step.foot));
        if (!step.wanted.stands) continue;
        const vec2 mark = overlay.pixel(vec3(step.wanted.position, legSide));
        overlay.below.line(mark - vec2(0, 14), mark, {robotInk, 1.5});
        overlay.above.point(way.back(), 5, robotRed);
    }
    overlay.above.line(way, {robotGrey, 1.5});
}

void sayTrack(JointedOverlay& overlay, const Settings& s, const std::vector<Step>& track, Method by) {
    const double off = offOf(track);
    const bool isInverse = by != Method::forward;
    overlay.say(isInverse ? "inverse: " + nameOf(by) : formatted("forward, %.0f right poses a cycle", s.poses));
    overlay.say(formatted("the foot that stands is off by up to %.2g m", off), off > 1e-3 ? robotRed : robotInk);
    if (isInverse && !std::ranges::all_of(track, &Step::isInReach))
        overlay.say("the leg does not reach all of the foot's way", robotRed);
}

}  // namespace

// Draw a walker by played angles above, and one by inverse kinematics below, on the same ground.
void drawWalkers(Gpu& gpu, const Settings& s, const Frame& frame) {
    const double now = double(frame.index()) / cycleFrames;
    const std::vector<Method> methods =
        isForward(s) ? std::vector{Method::forward} : std::vector{Method::forward, s.method};
    const auto pane = [&](std::size_t row) { return rowOf(s, frame, int(row), int(methods.size())); };
    const auto inUnits = [&](std::size_t row) { return rowOf(s, frame.inUnits(), int(row), int(methods.size())); };
    for (std::size_t row = 0; row < methods.size(); ++row) {
        gpu.overlay.look(inUnits(row), clipFromGround(s, pane(row), walkOf(s).hip(now).x));
        const std::vector<Step> track = trackOf(s, now, methods[row]);
        showTrack(gpu.overlay, track);
        sayTrack(gpu.overlay, s, track, methods[row]);
    }

    // Draw the legs. Both panes have the same camera
    beginParts(gpu, frame);
    const Jointed thing = legsAt(s, now);
    for (std::size_t row = 0; row < methods.size(); ++row) {
        const Angles angles = walking(s, now, methods[row]);
        const std::vector<mat4> worldFromPart = worldFromParts(thing.tree, angles);
        drawParts(gpu, pane(row), thing, worldFromPart);
        if (s.matrices && row + 1 == methods.size())
            gpu.overlay.product(frame.inUnits(), thing, worldFromPart, angles, besideOf(s, frame.inUnits()), true);
    }
    glViewport(0, 0, frame.width(), frame.height());
}

// The angles of the legs. Forward: a few right poses, with even changes of the angles between them. Inverse: computed for each
// time from the places that the feet must have.
Angles walking(const Settings& s, double cycles, Method by) {
    Angles angles = walkOf(s).played(cycles);
    const vec2 hip = walkOf(s).hip(cycles);
    Jointed thing = legsAt(s, cycles);
    for (const int side : {0, 1}) {
        const vec2 foot = walkOf(s).foot(side, cycles).position;
        thing.end.joint = side == 0 ? 2 : 4;
        if (by == Method::closed) std::ranges::copy(byFormula(s, foot - hip, 1), angles.begin() + 2 * side + 1);
        if (by >= Method::ccd)
            angles = byIteration(thing, angles, vec3(foot, side == 0 ? legSide : -legSide), s.iterations, by).degrees;
    }
    return angles;
}

std::vector<Step> trackOf(const Settings& s, double now, Method by) {
    std::vector<Step> track;
    for (int i = -2 * cycleFrames; i <= 0; ++i) {
        const double cycles = now + double(i) / cycleFrames;
        const Jointed thing = legsAt(s, cycles);
        const vec3 foot = thing.tree.endPosition(walking(s, cycles, by), thing.end);
        const FootTarget wanted = walkOf(s).foot(0, cycles);
        const TwoLinkAnswer answer = twoLinkAngles(s.upper, s.lower, wanted.position - walkOf(s).hip(cycles));
        track.push_back({foot, wanted, answer.solutions != TwoLinkSolutions::none});
    }
    return track;
}

// The largest distance of the standing foot from its mark, in metres.
double offOf(const std::vector<Step>& track) {
    double most = 0;
    for (const Step& step : track) {
        if (step.wanted.stands) most = std::max(most, glm::distance(vec2(step.foot), step.wanted.position));
    }
    return most;
}

}  // namespace mv::robot_arm
