#include "mv/gl/triangle_count.h"

#include <array>
#include <vector>

#include "mv/error.h"
#include "mv/gl/feedback.h"
#include "mv/math/types.h"

namespace mv {
namespace {

bool beyondOnePlane(const std::array<fvec4, 3>& corners) {
    for (int axis = 0; axis < 3; ++axis) {
        bool allBelow = true, allAbove = true;
        for (const fvec4& corner : corners) {
            allBelow &= corner[axis] < -corner.w;
            allAbove &= corner[axis] > corner.w;
        }
        if (allBelow || allAbove) return true;
    }
    return false;
}

// The sign of the triangle's area on the screen, counter-clockwise positive. As a determinant of (x, y, w) it needs no
// division, so that a corner behind the eye (w < 0) does not turn the triangle round (Olano and Greer 1997).
double signedArea(const std::array<fvec4, 3>& c) {
    const mat3 m(vec3(c[0].x, c[0].y, c[0].w), vec3(c[1].x, c[1].y, c[1].w), vec3(c[2].x, c[2].y, c[2].w));
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[1][0] * (m[0][1] * m[2][2] - m[0][2] * m[2][1]) +
           m[2][0] * (m[0][1] * m[1][2] - m[0][2] * m[1][1]);
}

bool culledBy(const FaceCulling& culling, double area) {
    if (!culling.isOn) return false;
    if (culling.face == GL_FRONT_AND_BACK) return true;
    const bool facesFront = (culling.front == GL_CCW) ? area > 0 : area < 0;
    return (culling.face == GL_FRONT) == facesFront;
}

}  // namespace

FaceCulling currentCulling() {
    GLint face = 0, front = 0;
    glGetIntegerv(GL_CULL_FACE_MODE, &face);
    glGetIntegerv(GL_FRONT_FACE, &front);
    return {glIsEnabled(GL_CULL_FACE) == GL_TRUE, GLenum(face), GLenum(front)};
}

TriangleCount sortTriangles(const std::vector<fvec4>& corners, const FaceCulling& culling) {
    TriangleCount count;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const std::array<fvec4, 3> triangle{corners[i], corners[i + 1], corners[i + 2]};
        ++count.submitted;
        if (beyondOnePlane(triangle)) {
            ++count.outside;
        } else if (culledBy(culling, signedArea(triangle))) {
            ++count.culled;
        } else {
            ++count.surviving;
        }
    }
    return count;
}

TriangleCount countTriangles(const Mesh& mesh) {
    const GLenum p = mesh.primitive();
    if (p != GL_TRIANGLES && p != GL_TRIANGLE_STRIP && p != GL_TRIANGLE_FAN) {
        throw Error("countTriangles", "needs a mesh of triangles");
    }
    return sortTriangles(transformedPositions(mesh));
}

}  // namespace mv
