// Frames that move along a curve in space: where a car, a camera or a cross-section looks, and which way is up.
//
// Forward is the direction of the velocity. The turn about it is left as a choice: by an up vector (this file),
// or by turning as little as possible (mv/motion/minimizing_frame.h).
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "mv/math/types.h"

namespace mv {

// Three perpendicular unit vectors, right-handed: right = forward x up. In world space.
struct PathFrame {
    vec3 forward{0, 0, -1}, up{0, 1, 0}, right{1, 0, 0};
};

// Places a thing that looks along -z with y up, as cameras do: right, up and -forward are where x, y and z go.
// Trap: the camera's view matrix is the inverse, lookAt(position, position + forward, up).
mat4 worldFromFrame(const PathFrame& frame, const vec3& position);

// The frame turned about its forward axis by `degrees`, right-handed: seen from behind clockwise, leaning to the right.
PathFrame rolled(const PathFrame& frame, double degrees);

// The frame turned as little as possible until its forward is the direction of the velocity: about the axis
// perpendicular to both, without a turn about the path. Refused: a velocity of 0, NaN, infinity, directions within 1e-6
// rad of opposite ones, between which every way is as short.
PathFrame turnedTo(const PathFrame& frame, const vec3& velocity);

// The frame along a velocity with its up in the half plane of the given up, which need not be perpendicular nor of unit
// length: fixed up where it is the same along the path, (0, 1, 0) mostly. Only the direction of the velocity counts.
// Refused: a velocity of 0 (at a cusp of the path there is no forward), up 0 or within 1e-12 rad
// of the velocity's line, NaN, infinity. Equals the turn of lookAt, inverted.
// Trap: in a loop the path points straight up; before and after that fixed up is on other sides, and the frame turns
// over.
PathFrame frameByUp(const vec3& velocity, const vec3& up);

// Up from the acceleration alone: the slide's rule, wrong for whatever stands on the ground, kept to compare with (slip
// E22). On a flat bend the acceleration is level, and the car lies on its side; on a straight it vanishes, and is
// refused; at a point of inflection it turns over. The up is the principal normal of Frenet's frame, the same at any
// speed. Refused: as by frameByUp, the acceleration in the place of up.
PathFrame frameByAcceleration(const vec3& velocity, const vec3& acceleration);

// Up from acceleration minus gravity, the direction in which the seat presses a passenger: the frame banks as a
// well-built road does. On a flat bend of radius r at speed v it leans inwards by atan(v^2/(g r)); on a straight it is
// upright; in a loop it is upside down at the top when the speed suffices. Here the speed does matter: velocity and
// acceleration are per second where gravity is, (0, -9.81, 0) for metres. Refused: as by frameByUp, the difference in
// the place of up; it is 0 in free fall.
PathFrame frameByBanking(const vec3& velocity, const vec3& acceleration, const vec3& gravity);

// A path as functions of a parameter, of which velocity and acceleration are the derivatives.
struct Path {
    std::function<vec3(double)> position, velocity, acceleration;
};
struct PathSample {
    vec3 position{0}, velocity{0}, acceleration{0};
};

// intervals + 1 samples, at equal steps of the parameter from `from` to `to`, the ends included exactly. Refused: fewer
// than 1 interval, from = to, a function that is not there, NaN and infinity of any of them.
std::vector<PathSample> samplesOf(const Path& path, double from, double to, int intervals);

// Throws Error(subject, ...) with the number of the first sample that has NaN, infinity or a velocity of 0: at a cusp a
// path has no forward. For all that follows samples.
void requireMoving(std::string_view subject, std::span<const PathSample> samples);

// The frames of a whole path by a rule that can fail, and where it did.
struct FramesByRule {
    std::vector<PathFrame> frames;
    // Samples where the rule's up is 0 or along the path. Such a frame is the one before it by turnedTo; the first
    // sample, which has none before it, takes the world axis least aligned with it for up, on a tie y before z before
    // x.
    std::vector<std::size_t> vanished;
    // Samples whose up has turned by more than 90 degrees about the path since the frame before.
    std::vector<std::size_t> flipped;
};

// frameByUp, frameByAcceleration and frameByBanking at each sample. A refusal of up by those is noted instead. Refused:
// what requireMoving refuses, and what turnedTo does between neighbours.
FramesByRule framesByUp(std::span<const PathSample> samples, const vec3& up);
FramesByRule framesByAcceleration(std::span<const PathSample> samples);
FramesByRule framesByBanking(std::span<const PathSample> samples, const vec3& gravity);

}  // namespace mv
