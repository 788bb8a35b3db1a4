// The six faces of a cube map: which direction is looked up where, and the cameras that draw them.
//
// The faces are numbered in OpenGL's order: +x, -x, +y, -y, +z, -z. Directions are those that a shader's texture() is
// given, in the space of the cube. Trap: of each face s and t are as seen from outside the cube, as if t went downwards; a
// camera at the middle that draws one so that it is found again stands on its head (cubeFaceView).
#pragma once
#include "mv/math/types.h"

namespace mv {

inline constexpr int cubeFaces = 6;

// A place of a cube map: s and t are 0..1, as a texture coordinate's.
struct CubePlace {
    int face;
    vec2 at;
};

// The place at which a direction of any length is looked up. A direction between two faces, or at a corner of three, is
// looked up in the first in the order x, y, z: OpenGL leaves that open. Refused: the vector 0, which is no direction,
// and NaN and infinity.
CubePlace cubePlace(const vec3& direction);

// The direction to a place of a face: the point of the cube -1..1 there. Refused: a face outside 0..5, NaN.
vec3 cubeDirection(const CubePlace& place);

// viewFromWorld of a camera in the origin that looks through this face: with perspective(90, 1, near, far) it draws what
// is found by cubePlace(). The matrix turns and does not mirror, so fronts stay fronts. Refused: a face outside 0..5.
mat4 cubeFaceView(int face);

}  // namespace mv
