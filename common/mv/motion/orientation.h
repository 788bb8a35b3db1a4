// Orientations: quaternions, turns between them, and yaw, pitch and roll.
//
// A quaternion q = w + x i + y j + z k turns a vector v to q v q*, right-handed by 2 acos(w/|q|) about (x, y, z); q and
// -q are the same orientation. Every function takes quaternions of any length but 0 and returns them of unit length, to
// some roundings: nothing drifts, however many turns are multiplied. All refuse NaN and infinity.
// Source of the algebra: Shoemake, "Animating rotation with quaternion curves", SIGGRAPH 1985.
#pragma once
#include "mv/math/types.h"

namespace mv {

// A quaternion, no turn unless said otherwise. A type of our own: GLM's includes <glm/gtc/matrix_transform.hpp>, whose
// lookAt and rotate mv's headers show to nobody (see mv/math/transform.h). The order is that of glm::dquat's
// constructor.
// Trap: glTF, and GLM's memory, have w last.
struct quat {
    double w = 1, x = 0, y = 0, z = 0;

    bool operator==(const quat&) const = default;
};

// The orientation turned by `degrees` about the axis, right-handed, as rotate(degrees, axis). Any finite angle: whole
// turns are taken off in whole numbers, quarters too, so 0, 180 and 360 degrees are exact. 360 degrees more give -q.
// The axis may have any length but 0. Refused: axis 0, NaN, infinity. Equals glm::angleAxis, whose angle is in radians.
quat quatFromAxis(double degrees, const vec3& axis);

// The matrix that turns a point by q: rotate(...) as a quaternion. The matrix is orthogonal to rounding for a q of any
// length. Refused: 0, NaN, infinity. Equals glm::mat4_cast of the unit quaternion.
mat4 rotationMatrix(const quat& q);

// The orientation of a rotation matrix, of the two with w >= 0 (w = 0: with the first of x, y, z that is not 0
// positive). The upper left 3x3 is read. The largest of the four components is a root's and divides the others, so no
// turn is worse than another. Refused: NaN, infinity, an entry of R^T R that is more than 1e-6 off the identity's
// (float has 1e-7; decompose takes scales off), a mirror. Equals glm::quat_cast but for the sign.
// Source: Shepperd, "Quaternion from rotation matrix", J. Guidance and Control 1 (1978).
// Trap: the sign jumps where w passes 0: between two orientations the way is slerp's to choose, not the sign's.
quat quatFromMatrix(const mat4& rotation);

// b's turn first, then a's, as with matrices: rotationMatrix(a * b) = rotationMatrix(a) * rotationMatrix(b).
quat operator*(const quat& a, const quat& b);

// The angle of the turn that takes one orientation to the other, in degrees: 0 to 180, with an error of 1e-13 or so.
// Computed by the atan2 of the sum and the difference; acos of the dot product is off by 1e-6 degrees near 0. Source:
// Kahan, "How futile are mindless assessments of roundoff in floating-point computation?" (2006), section 12.
double angleBetween(const quat& a, const quat& b);

// Which of the two turns from one orientation to another: by 180 degrees and less, or by the rest to 360.
enum class Way { shorter, longer };

// The orientation at t on the way from `from` (t = 0) to `to` (t = 1), at constant angular speed about one axis. t
// beyond 0 to 1 goes on at that speed. From sum and difference of the ends, which are perpendicular, and the atan2 of
// their lengths: nothing cancels at 0 degrees, and signs of the ends do not matter, but for the sign of the result,
// which is continuous in t and that of `from` at 0.
// At 180 degrees, as far as rounding can tell (1e-15), both ways are equally long: shorter is the one between the ends
// when the first of w, x, y, z of either that is not 0 (to 1e-15) is positive; it is the same in both directions.
// Refused: t beyond -1e6 to 1e6, where less than ten digits of the angle would be left; the longer way between ends
// less than 4e-12 rad apart, which has no axis. Equals glm::slerp but for these. Trap: slerp through several keys one
// after the other jumps in angular velocity at each.
quat slerp(const quat& from, const quat& to, double t, Way way = Way::shorter);

// The straight line between the ends instead of the arc, made a unit quaternion again: the shorter way, chosen as by
// slerp, about the same axis, cheaper, but slower at the ends than in the middle: at 180 degrees by a factor of 2, at
// 90 of 1.17. At t = 0, 1/2 and 1 it is slerp; between, up to 8.2 degrees off where the turn is 180. Refused: as by
// slerp.
quat nlerp(const quat& from, const quat& to, double t);

// Yaw about y, pitch about x, roll about z, in degrees, for a thing that looks along -z with y up: yaw > 0 turns it to
// the left, pitch > 0 its nose up, roll > 0 leans it to the left.
struct YawPitchRoll {
    double yaw = 0, pitch = 0, roll = 0;
    bool locked = false;  // gimbal lock: pitch is 90 or -90, where only yaw - roll or yaw + roll is defined
};

// The orientation rotateY(yaw) * rotateX(pitch) * rotateZ(roll): roll acts first, in the thing's own space. Any finite
// angles.
quat quatFromYawPitchRoll(double yaw, double pitch, double roll);

// The angles of an orientation: yaw and roll in (-180, 180], pitch in [-90, 90]. Within 1e-14 rad or so of straight up
// or down it is locked: pitch is then 90 or -90, roll 0, and yaw has the whole turn. Near there yaw and roll lose
// digits, to 1e-14 degrees/cos(pitch) each, but not the orientation that they make together.
// Source: Bernardes and Viollet, "Quaternion to Euler angles conversion", PLoS ONE 17 (2022): half the sum and half the
// difference of yaw and roll are each one atan2.
// Trap: interpolating the three angles is no turn about one axis, and near the poles the path runs round in circles.
YawPitchRoll yawPitchRollOf(const quat& q);

}  // namespace mv
