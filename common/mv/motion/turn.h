// More of orientations: the inverse, the axis and the angle, a turned vector, the turn from one direction to another, and
// three angles in the orders that others use.
//
// Quaternions are those of mv/motion/orientation.h, of any length but 0, and come back with unit length. All refuse NaN
// and infinity.
#pragma once
#include "mv/math/types.h"
#include "mv/motion/orientation.h"

namespace mv {

// The turn back: inverse(q) * q is no turn. Refused: 0. Equals glm::inverse of a unit quaternion.
quat inverse(const quat& q);

// One turn about one axis.
struct AxisAngle {
    double degrees = 0;  // 0 to 180
    vec3 axis{1, 0, 0};  // of unit length
};

// The axis and the angle of an orientation, by the atan2 of |(x, y, z)| and |w|: to 1e-14 degrees at any angle, where 2 acos(w)
// is off by 1e-6 near 0. No turn has the axis (1, 0, 0); of 180 degrees both axes are right, and it is that of the quaternion
// given. Refused: 0. Equals glm::angle, in degrees, and glm::axis, but for turns above 180 degrees.
AxisAngle axisAngleOf(const quat& q);

// The vector turned by q: rotationMatrix(q) * v, with half the products. Refused: 0. Equals GLM's q * v for unit q.
vec3 turned(const quat& q, const vec3& v);

// The smallest turn that takes the direction `from` to the direction `to`, both of any length but 0. For opposite
// directions the turn is half a turn about an axis perpendicular to them: their cross product with the world axis that
// is least along them, on a tie z before y before x. Right to some roundings at any angle: by the larger of sine and
// cosine of half the angle; from 1 + cos, as it is mostly written, all digits are lost within 1e-8 rad of opposite.
// Refused: 0. Equals glm::rotation. Trap: it jumps where the directions pass through opposite.
quat turnBetween(const vec3& from, const vec3& to);

// The order in which three angles are multiplied, the last acting first: xyz is rotateX(x) * rotateY(y) * rotateZ(z). yxz is
// yaw, pitch and roll of orientation.h; xyz is what three.js has initially; zyx what is called yaw, pitch and roll of a thing
// that looks along x with z up.
enum class EulerOrder { yxz, xyz, zyx };

struct EulerAngles {
    vec3 degrees{0};  // about x, y and z
    bool locked =
        false;  // gimbal lock: the middle one is 90 or -90, and only sum or difference of the others is defined
};

// The orientation of three angles about x, y and z, in degrees. Any finite angles.
quat quatFromEuler(const vec3& degrees, EulerOrder order);

// The angles of an orientation, the middle one in [-90, 90], the others in (-180, 180]; in lock the last one is 0. Errors and
// traps are those of yawPitchRollOf, by which it is found: the axes are renamed, and where that is a mirror, all turns reversed.
EulerAngles eulerAnglesOf(const quat& q, EulerOrder order);

}  // namespace mv
