// Model and view transforms, named as in MV.js, in degrees and double precision.
//
// Each function makes a fresh matrix; multiply yourself, the last factor acts first:
//     worldFromModel = translate(1, 0, 0) * rotateY(30) * scale(2)
//
// The deleted overloads are a guard. With <glm/gtc/matrix_transform.hpp> visible, lookAt(glm::vec3, ...) under
// `using namespace mv` would find glm::lookAt by argument-dependent lookup: in float, without the checks, and with
// rotate() in radians. The deleted functions have GLM's own signature plus a constraint, so they win against GLM's and
// stop the compiler; being templates, they leave braced arguments such as lookAt({0, 0, 4}, {0, 0, 0}, {0, 1, 0})
// alone.
#pragma once
#include <concepts>

#include "mv/math/types.h"

namespace mv {

// The matrix that moves a point by offset. Any finite offset; NaN or infinity is refused with Error.
// Equals MV.js translate() and glTranslated.
mat4 translate(const vec3& offset);
mat4 translate(double x, double y, double z);

// The matrix that multiplies x, y, z by the factors. Any finite factors: negative ones mirror, and turn
// counter-clockwise faces clockwise; 0 flattens, and the matrix then has no inverse. NaN or infinity is refused.
// Equals MV.js scalem() and glScaled. Trap: scale(s, v) of MV.js scales a vector; write s * v.
mat4 scale(const vec3& factors);
mat4 scale(double x, double y, double z);
mat4 scale(double factor);

// Turns by `degrees` about the x, y or z axis, counter-clockwise when the axis points at the viewer (right-handed):
// rotateX takes y to z, rotateY z to x, rotateZ x to y. Any finite angle; whole turns are taken off first, which is
// exact, so rotateX(360) is the identity and an angle of 1e9 keeps its accuracy. NaN or infinity is refused.
// Equals MV.js rotateX/Y/Z() since 2017 and glRotated. Trap: the MV.js of 2016 turned the other way.
mat4 rotateX(double degrees);
mat4 rotateY(double degrees);
mat4 rotateZ(double degrees);

// Turns by `degrees` about the axis through the origin, right-handed. The axis may have any length but 0; it is not
// changed (MV.js normalises the caller's array). Refused: axis 0, NaN, infinity.
// Equals MV.js rotate(angle, axis) and glRotated(angle, x, y, z).
mat4 rotate(double degrees, const vec3& axis);

// The view matrix cameraFromWorld of a camera at eye that looks at `at`: camera space has the eye at the origin, looks
// along -z, and up's image lies in the half plane x = 0, y > 0. All three are world space; up need not be
// perpendicular to the view nor of unit length.
// Refused: eye equal to at, up 0 or within 1e-12 rad of the line of sight (there is then no way to tell the roll: use
// lookAtAnyRoll), NaN, infinity, a coordinate of eye or at beyond 1e300.
// Equals MV.js lookAt(), glm::lookAtRH and gluLookAt, and has MV.js's operations in its order where up is 0.1 rad and more
// off the line of sight. The rotation part is orthogonal to rounding, and the roll that of the given numbers, at every
// accepted input: nearer to it, the cross product is computed without cancellation (the plain form is off by 1e-16/angle,
// in float by 3e-8/angle).
// Trap: this is the inverse of the camera's own placement worldFromCamera.
mat4 lookAt(const vec3& eye, const vec3& at, const vec3& up);

// lookAt for those who do not care about the roll: up is the world axis least aligned with the view, on a tie y before
// z before x. So looking along -z or along x is upright in y, and looking straight down or up has +z at the top.
// Refused: as lookAt, except for up. Trap: a moving camera jumps in roll where another axis becomes the least aligned
// one; a camera path needs an up of its own.
mat4 lookAtAnyRoll(const vec3& eye, const vec3& at);

// The matrix that takes normals where `m` takes points (an affine matrix: the last row is not read), to be normalised
// after use. The result is the cofactor matrix of the upper left 3x3, with the sign of the determinant, scaled so that
// a rotation, with or without a uniform scale, gives the rotation. For an invertible m it has the direction of MV.js
// normalMatrix(m, true), transpose(inverse(m)), and of gl_NormalMatrix; for a flattening one such as scale(1, 0, 1),
// where the inverse does not exist, it is still right. Each column is good to rounding and the sign is the exact
// determinant's (0 counts as positive), as long as the entries of a column are 0 or no less than 1e-70 of its largest
// one; columns may have any sizes. A matrix that leaves no surface at all (rank 0 or 1) gives the zero matrix. NaN or
// infinity is refused. Trap: under a mirror a face's winding turns over and its normal does not; glFrontFace has to
// follow.
mat3 normalMatrix(const mat4& m);

// The guard described above.
template <std::same_as<float> T, glm::qualifier Q>
mat4 translate(const glm::vec<3, T, Q>& offset) = delete;
template <std::same_as<float> T, glm::qualifier Q>
mat4 scale(const glm::vec<3, T, Q>& factors) = delete;
template <std::same_as<float> T, glm::qualifier Q>
mat4 rotate(T degrees, const glm::vec<3, T, Q>& axis) = delete;
template <std::same_as<float> T, glm::qualifier Q>
mat4 rotate(double degrees, const glm::vec<3, T, Q>& axis) = delete;
template <std::same_as<float> T, glm::qualifier Q>
mat4 lookAt(const glm::vec<3, T, Q>& eye, const glm::vec<3, T, Q>& at, const glm::vec<3, T, Q>& up) = delete;
template <std::same_as<float> T, glm::qualifier Q>
mat4 lookAtAnyRoll(const glm::vec<3, T, Q>& eye, const glm::vec<3, T, Q>& at) = delete;
template <std::same_as<float> T, glm::qualifier Q>
mat3 normalMatrix(const glm::mat<4, 4, T, Q>& m) = delete;

// GLM's forms that multiply onto a matrix, in float and in double alike: rotate's angle would be in radians.
template <std::floating_point T, glm::qualifier Q>
mat4 translate(const glm::mat<4, 4, T, Q>& m, const glm::vec<3, T, Q>& offset) = delete;
template <std::floating_point T, glm::qualifier Q>
mat4 scale(const glm::mat<4, 4, T, Q>& m, const glm::vec<3, T, Q>& factors) = delete;
template <std::floating_point T, glm::qualifier Q>
mat4 rotate(const glm::mat<4, 4, T, Q>& m, T angle, const glm::vec<3, T, Q>& axis) = delete;

}  // namespace mv
