// Projections from camera space to clip space, and the steps after them: planes, normalised device coordinates, pixels.
//
// Camera space looks along -z; near and far are distances in front of the eye, so what is seen lies at z = -near to
// z = -far. Clip space is OpenGL's: after division by w all of x, y, z are within [-1, 1], z = -1 at near.
#pragma once
#include <array>
#include <concepts>
#include <cstddef>

#include "mv/math/types.h"

namespace mv {

// clipFromCamera of a parallel projection: the box left..right, bottom..top, z = -near..-far becomes the cube [-1, 1].
// Any finite bounds, in camera units; each pair may be swapped, which mirrors that axis (near > far turns the depth
// order over), and near may be negative: behind the eye. Refused: a pair of equal bounds, NaN, infinity, bounds so
// close or so far apart that the matrix overflows.
// Equals MV.js ortho(), glm::orthoRH_NO and glOrtho. Row 3 on paper is (0, 0, -2/(far-near), -(far+near)/(far-near));
// with a plus in the last place, as sometimes printed, the box lands 2(far+near)/(far-near) away from the cube.
mat4 ortho(double left, double right, double bottom, double top, double near, double far);

// clipFromCamera of a symmetric perspective: fovy is the full vertical angle of view in degrees, aspect is width over
// height. Refused: fovy outside (0, 180), aspect <= 0, near <= 0 (near = 0 would give every point depth 1), far <=
// near, NaN, infinity, overflow. Below 1e-290 degrees fovy has fewer digits as radians, here and below. Equals MV.js
// perspective(), glm::perspectiveRH_NO and gluPerspective. Trap: GLM's fovy is in radians.
mat4 perspective(double fovy, double aspect, double near, double far);

// The same with the far plane at infinity: nothing in front of the eye is too far away, directions (w = 0) included,
// whose z equals their w bit for bit, in float too: depth 1, at the end of the range and not beyond it. For shadow
// volumes, skies, and wherever `far` would be a guess. Beside a far plane it costs near/far of the depth buffer's
// range, 1 % at far/near = 100. Refused: fovy outside (0, 180), aspect <= 0, near <= 0, NaN, infinity.
// Equals glm::infinitePerspective, and the limit of perspective() as far grows; MV.js has none.
// Source: Everitt and Kilgard, "Practical and Robust Stenciled Shadow Volumes" (2002).
mat4 infinitePerspective(double fovy, double aspect, double near);

// clipFromCamera of a general perspective, whose window on the plane z = -near is left..right, bottom..top: off-axis
// for stereo, tiles and walls of screens. left > right or bottom > top mirrors. Refused: equal bounds, near <= 0, far
// <= near, NaN, infinity, overflow. Equals glFrustum and glm::frustumRH_NO; MV.js has none.
mat4 frustum(double left, double right, double bottom, double top, double near, double far);

// The arguments of frustum() by name.
struct FrustumBounds {
    double left, right, bottom, top, near, far;
};

// The bounds for which frustum() is perspective(fovy, aspect, near, far), to be shifted or cut. Refuses what
// perspective refuses, and a window that overflows.
FrustumBounds frustumBounds(double fovy, double aspect, double near, double far);
mat4 frustum(const FrustumBounds& bounds);

// The order of the planes below.
enum FrustumPlane : std::size_t { leftPlane, rightPlane, bottomPlane, topPlane, nearPlane, farPlane };

// The six planes (n, d) of a view volume in the space that clipFromWorld maps from: n has unit length and points
// inwards, and dot(n, p) + d is the distance of p inside the plane. Index with FrustumPlane. A plane at infinity, as
// the far one of infinitePerspective(), is (0, 0, 0, 1), which has no normal and holds every point. Source: Gribb and
// Hartmann, "Fast Extraction of Viewing Frustum Planes from the World-View-Projection Matrix" (2001). Refused: NaN,
// infinity, and a plane whose normal has cancelled to less than 1e-10 of its terms. The far plane's is 2 near/far of
// them, known to 1e-16: good to 1e-6 up to far/near = 1e8, refused from about 1e10, where perspectivePlanes takes over;
// from about 1e16 on the matrix is that of a far plane at infinity. In float it is off by 0.5 % at 1e5 and gone at 1e8.
// A multiple of the matrix has the same planes, however large or small.
std::array<vec4, 6> planesFromClip(const mat4& clipFromWorld);

// The same six planes, in camera space, straight from the arguments of perspective(), without cancellation at any
// far/near, and with far = infinity: those of infinitePerspective(). Refuses what else perspective refuses.
std::array<vec4, 6> perspectivePlanes(double fovy, double aspect, double near, double far);

// The eight corners of a view volume in the space that clipFromWorld maps from: corner i is what goes to x, y, z = -1
// or +1 by bits 0, 1, 2 of i, so 0..3 are near and 4..7 far where z runs from near to far. For drawing a frustum, or to
// ask what it holds. Each is off by no more than some roundings of the matrix's own entries would move it, for entries that
// are 0 or from 1e-10 to 1e10 in size. Refused: NaN, infinity, a matrix without an inverse or so near one without that
// elimination does not find it, a volume without end (far at infinity).
std::array<vec3, 8> viewVolumeCorners(const mat4& clipFromWorld);

// clip.xyz / clip.w. Refused: w <= 0 (at or behind the plane through the eye: dividing would show such a point mirrored
// in front; clip before dividing), NaN, infinity, a w so small that the quotient overflows.
vec3 ndcFromClip(const vec4& clip);

// The place of a point of normalised device coordinates in a viewport of width x height pixels (z is not read): x to
// the right, y up, (-1, -1) at (0, 0) and (1, 1) at (width, height). The centre of pixel (i, j) is at (i + 1/2, j +
// 1/2). Points outside [-1, 1] fall outside the viewport. Refused: width or height below 1, NaN, infinity. Equals
// glViewport(0, 0, width, height). Trap: rows of most image files, and mouse positions, count downwards.
vec2 pixelFromNdc(const vec2& ndc, int width, int height);
vec2 pixelFromNdc(const vec3& ndc, int width, int height);

// Float calls are errors rather than GLM's, which would win under `using namespace mv, glm`; see mv/math/transform.h.
template <std::same_as<float> T>
mat4 ortho(T left, T right, T bottom, T top, T near, T far) = delete;
template <std::same_as<float> T>
mat4 perspective(T fovy, T aspect, T near, T far) = delete;
template <std::same_as<float> T>
mat4 infinitePerspective(T fovy, T aspect, T near) = delete;
template <std::same_as<float> T>
mat4 frustum(T left, T right, T bottom, T top, T near, T far) = delete;
template <std::same_as<float> T, glm::qualifier Q>
std::array<vec4, 6> planesFromClip(const glm::mat<4, 4, T, Q>& clipFromWorld) = delete;
template <std::same_as<float> T, glm::qualifier Q>
std::array<vec3, 8> viewVolumeCorners(const glm::mat<4, 4, T, Q>& clipFromWorld) = delete;
template <std::same_as<float> T, glm::qualifier Q>
vec3 ndcFromClip(const glm::vec<4, T, Q>& clip) = delete;
template <std::same_as<float> T, glm::qualifier Q>
vec2 pixelFromNdc(const glm::vec<2, T, Q>& ndc, int width, int height) = delete;
template <std::same_as<float> T, glm::qualifier Q>
vec2 pixelFromNdc(const glm::vec<3, T, Q>& ndc, int width, int height) = delete;

}  // namespace mv
