// path: a car on a closed curve in space. Forward is the direction of its velocity; which way is up is a choice, and some
// choices fail.
#include "path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/strip.h"

namespace mv::path {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    glEnable(GL_DEPTH_TEST);
    gpu.program.use();
    gpu.drawing.begin(frame);
    const auto drawScene = s.show == Show::track ? drawTrack : drawPoses;
    drawScene(gpu, s, frame);
    glViewport(0, 0, frame.width(), frame.height());
    gpu.drawing.draw(frame);
}

void drawTrack(Gpu& gpu, const Settings& s, const Frame& frame) {
    makeLap(gpu, s.ride);

    // Put the car onto the curve, along its velocity, with the rule's up
    const double part = lapPart(s, frame);
    const PathSample now = motionAt(s.ride, parameterAt(s.ride, part));
    const PathFrame axes = frameAt(gpu.lap, part, now.velocity);
    const mat4 worldFromCar = worldFromFrame(axes, now.position);

    // Give the chase camera its place in the car's own frame
    const mat4 chaseFromCar = lookAt(vec3(0, 4.5, 11), vec3(0, 1.5, -8), worldUp);
    const mat4 chaseFromWorld = chaseFromCar * glm::inverse(worldFromCar);
    frame.show("worldFromCar", worldFromCar);
    frame.show("chaseFromWorld", chaseFromWorld);

    // Draw track and car from outside, and by the chase camera
    const Pane left = outsidePane(frame), right = paneAboveStrip(frame, 0.58, 1);
    drawFrom(gpu, left, clipFromOutside(s, left), worldFromCar);
    drawFrom(gpu, right, perspective(60, right.aspect(), 1, 400) * chaseFromWorld, worldFromCar);
    showTrack(gpu, s, now, axes, frame.inUnits());
}

// Remake the lap when one of these settings has changed.
void makeLap(Gpu& gpu, const Ride& ride) {
    const auto& [track, curve, up, transport, steps, spread, pace, speed, lengthBy, pieces] = ride;
    if (!gpu.lapFor.changed(track, curve, up, transport, steps, spread, pace, speed)) return;
    const std::vector<PathSample> samples = samplesOf(ride);
    FramesByRule by = framesOf(ride, samples);
    gpu.vanishedAt = std::move(by.vanished);
    gpu.lap = lapOf(samples, std::move(by.frames), carLength);
    gpu.trackOnGround = Mesh(trackMesh(gpu.lap.samples, gpu.lap.frames), "track");
}

using Samples = std::vector<PathSample>;

// Three rules ask the curve alone at each sample: up is the world's, the acceleration, or the acceleration minus gravity.
static FramesByRule framesFixed(const Ride&, const Samples& samples) { return framesByUp(samples, worldUp); }
static FramesByRule framesAccelerated(const Ride&, const Samples& samples) { return framesByAcceleration(samples); }
static FramesByRule framesBanked(const Ride&, const Samples& samples) {
    return framesByBanking(samples, vec3(0, -9.81, 0));
}

// The fourth rule carries the frame along the curve without a turn about it. `spread` closes the frames after a lap.
static FramesByRule framesCarried(const Ride& ride, const Samples& samples) {
    FramesByRule carried;
    carried.frames = minimizingFrames(samples, worldUp, ride.transport);
    if (ride.spread) carried.frames = closedFrames(samples, std::move(carried.frames));
    return carried;
}

FramesByRule framesOf(const Ride& ride, const Samples& samples) {
    constexpr std::array ofUp{framesFixed, framesAccelerated, framesBanked, framesCarried};  // in the order of Up
    return ofUp.at(std::size_t(ride.up))(ride, samples);
}

std::vector<PathSample> samplesOf(const Ride& ride) {
    std::vector<PathSample> samples;
    for (int i = 0; i <= ride.steps; ++i) samples.push_back(motionAt(ride, parameterAt(ride, double(i) / ride.steps)));
    return samples;
}

// Position, velocity and acceleration of the car, per second, at a parameter of the curve. At a steady pace the true
// acceleration has no part along the path. No rule reads that part, so it is left in.
PathSample motionAt(const Ride& ride, double parameter) {
    const CurvePoint<vec3> at = pathOf(ride).curve.at(parameter);
    const double rate = ride.speed / (ride.pace == Pace::way ? glm::length(at.velocity) : pathOf(ride).way.length());
    return {at.position, rate * at.velocity, rate * rate * at.acceleration};
}

// The part of the lap's time that has passed, 0 to 1, and the curve's parameter at this part.
double lapPart(const Settings& s, const FrameInfo& frame) {
    return std::fmod(s.start / 100 + frame.time() * s.ride.speed / pathOf(s.ride).way.length(), 1);
}
double parameterAt(const Ride& ride, double part) {
    if (ride.pace == Pace::parameter) return part;
    const ArcLength& way = pathOf(ride).way;
    return way.timeAt(part * way.length());
}

void drawFrom(Gpu& gpu, const Pane& pane, const mat4& clipFromWorld, const mat4& worldFromCar) {
    glViewport(pane.x, pane.y, pane.width, pane.height);
    gpu.program.set("clipFromWorld", clipFromWorld);
    gpu.program.set("worldFromModel", mat4(1));
    gpu.trackOnGround.draw();
    gpu.program.set("worldFromModel", worldFromCar * scale(carLength / 10));
    gpu.car.draw();
}

const TrackPath& pathOf(const Ride& ride) { return trackPath(ride.track, ride.curve); }

mat4 spinOf(const Settings& s) { return rotateX(s.spinX) * rotateY(s.spinY); }

Pane outsidePane(const FrameInfo& frame) { return paneAboveStrip(frame, 0, 0.58); }
mat4 clipFromOutside(const Settings& s, const Pane& pane) {
    const double half = 0.306 * std::max(1.0, 1.42 / pane.aspect());  // half height of the picture at distance 1
    return perspective(2 * degrees(std::atan(half)), pane.aspect(), 20, 400) *
           lookAt(vec3(-7, 72, 92), vec3(-7, 0, 4), worldUp) * spinOf(s);
}

}  // namespace mv::path
