// Planar shadows and reflections.
//
// A plane is (a, b, c, d) with a x + b y + c z + d = 0; its normal (a, b, c) may have any length but 0 and points to
// either side. A light is homogeneous: (x, y, z, 1) is a point (another w > 0 is the point (x, y, z)/w), (x, y, z, 0)
// the direction *towards* a light at infinity.
//
// The errors in docs/library.md are of numbers that are 0 or from 1e-100 to 1e100 in size. Beyond, a component of the unit
// normal, or its product with the light, may vanish: a light may then count as lying in the plane.
#pragma once
#include <array>
#include <concepts>

#include "mv/math/types.h"

namespace mv {

// The matrix that moves every point along its ray from the light onto the plane, in the space of light and plane:
// (n.L) I - L n^T, row i being L_i (a, b, c, d) taken from the diagonal, with n scaled to a unit normal and turned to
// the side of the light. So n.L is the light's height, and w' = n.L - L.w (n.p) is positive for every p lower than the
// light, those that cast a true shadow. Which side of the plane is called positive makes no difference: a light below a
// floor throws shadows on its underside. Divide by w' as after a projection: as a factor in clipFromModel the GPU does.
// For the plane y = 0 it is y_L times the textbook's translate(L) * m * translate(-L), whose m has -1/y_L in row 4.
// Refused: a zero normal, a light (0, 0, 0, 0) or with w < 0, NaN, infinity, overflow, and a light in the plane:
// a point lower than 1e-6 of its distance from the origin (in float, where the GPU computes w', less than 4 bits of
// such a height are left), a direction less than 1e-12 rad above it (rounding of the double; w' is constant, so nothing
// cancels). Trap: casters above the light or behind the plane get shadows too, false ones: cut them off with
// shadowCasterBounds. Trap: with the plane D away from the origin the result loses D*D*eps/height, even in double: 1e-4
// units at D = 1e6.
mat4 shadowProjection(const vec4& light, const vec4& plane);

// The same in coordinates relative to origin, a point on the plane: it maps p - origin to p' - origin, where light,
// plane and origin are given in world space. The plane then has d = 0 exactly and nothing cancels, wherever it is. Use:
//     clipFromModel = clipFromCamera * (cameraFromWorld * translate(origin)) * shadowProjection(light, plane, origin) *
//                     (translate(-origin) * worldFromModel)
// with each bracket multiplied first, in double. Refused besides the above: an origin off the plane by more than
// 1e-12 of the coordinates' size; the shadow falls on the parallel plane through the origin.
mat4 shadowProjection(const vec4& light, const vec4& plane, const vec3& origin);

// Two half spaces h, in the space of light and plane, in which a point p of a caster has to lie to cast a true shadow:
// dot(h, vec4(p, 1)) > 0. [0]: in front of the plane, on the light's side. [1]: lower than the light, which is w' of
// shadowProjection; for a light at infinity the constant n.L. For gl_ClipDistance[0..1]. Points with 0 (in the plane;
// at the light's height, whose shadow is at infinity) are no casters; GL keeps them, and clips what is at infinity
// itself. Refuses what shadowProjection refuses. Relative to an origin: pass light - origin and a plane with d = 0.
std::array<vec4, 2> shadowCasterBounds(const vec4& light, const vec4& plane);

// Which side of the plane the light is on: 1 where the normal points, -1 behind, and 0 where it lies in the plane as far
// as shadowProjection is concerned, which then refuses it; for those who have something else to draw instead. Refused:
// what shadowProjection refuses for other reasons.
int lightSide(const vec4& light, const vec4& plane);

// The matrix that mirrors in the plane, I - 2 n n^T with unit n: its own inverse, w unchanged. Mirrored faces have
// their winding turned over: swap glFrontFace while drawing them. Refused: a zero normal, NaN, infinity, overflow.
// Equals Householder's reflection for d = 0; MV.js and GLU have none.
mat4 reflection(const vec4& plane);

// Float calls are errors: rounded light and plane would lose what the checks promise; see mv/math/transform.h.
template <std::same_as<float> T, glm::qualifier Q>
mat4 shadowProjection(const glm::vec<4, T, Q>& light, const glm::vec<4, T, Q>& plane) = delete;
template <std::same_as<float> T, glm::qualifier Q>
mat4 shadowProjection(const glm::vec<4, T, Q>& light, const glm::vec<4, T, Q>& plane,
                      const glm::vec<3, T, Q>& origin) = delete;
template <std::same_as<float> T, glm::qualifier Q>
std::array<vec4, 2> shadowCasterBounds(const glm::vec<4, T, Q>& light, const glm::vec<4, T, Q>& plane) = delete;
template <std::same_as<float> T, glm::qualifier Q>
int lightSide(const glm::vec<4, T, Q>& light, const glm::vec<4, T, Q>& plane) = delete;
template <std::same_as<float> T, glm::qualifier Q>
mat4 reflection(const glm::vec<4, T, Q>& plane) = delete;

}  // namespace mv
