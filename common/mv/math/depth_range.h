// The projections of mv/math/projection.h with another range of depths than OpenGL's -1 at near to 1 at far, and the general
// perspective without a far plane.
//
// The other ranges are those of Direct3D, Metal, Vulkan and WebGPU, and of OpenGL after glClipControl(GL_LOWER_LEFT,
// GL_ZERO_TO_ONE). Each third row is computed by itself: taken from OpenGL's by z' = (w - z)/2 a reversed one has lost
// near/far to a rounding of 1, and with it what it is for.
// Trap: planesFromClip(), clipVolume() and unProject() take OpenGL's range, and have near and far wrong of another one. The planes
// are those of projection.h's matrix of the same arguments; to unProject() the depth d of zeroToOne or oneToZero is (1 + d)/2.
#pragma once
#include "mv/math/types.h"

namespace mv {

// The values of clip space's z / w at near and at far.
enum class DepthRange {
    zeroToOne,     // 0 at near, 1 at far
    oneToZero,     // reversed: 1 at near, 0 at far. In a float buffer its steps are as fine as the distances
    oneToMinusOne  // reversed within OpenGL's range, of which a float buffer makes no use
};

// perspective(fovy, aspect, near, far) of projection.h for such a range; far at infinity is allowed, and is 1, 0 or -1 there.
// Refused: what that refuses. Equals glm::perspectiveRH_ZO, and with near and far exchanged, which perspective() refuses, the reversed one.
// Trap: with near at 1, glClearDepth must be 0 and the depth test GL_GREATER.
mat4 perspective(double fovy, double aspect, double near, double far, DepthRange range);

// ortho() likewise. Equals glm::orthoRH_ZO. Depth is even there, so a reversed range brings nothing but agreement with what else is
// drawn.
mat4 ortho(double left, double right, double bottom, double top, double near, double far, DepthRange range);

// frustum() of projection.h with the far plane at infinity, in OpenGL's range: an off-centre window, of a shifted lens or of one
// eye of two, that clips nothing in the distance. Refused: equal bounds, near <= 0, NaN, infinity, overflow.
// Source: Everitt and Kilgard, "Practical and Robust Stenciled Shadow Volumes" (2002).
mat4 infiniteFrustum(double left, double right, double bottom, double top, double near);

}  // namespace mv
