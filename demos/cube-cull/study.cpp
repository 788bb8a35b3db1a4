// The readouts of cube-cull.
#include <glm/matrix.hpp>

#include "cube-cull.h"
#include "mv/gl/triangle_count.h"

namespace mv::cube_cull {

void readOut(Gpu& gpu, const Settings& s, const Frame&, Numbers& numbers) {
    const vec3 eye = vec3(inverse(viewFromModel(s)) * vec4(0, 0, 0, 1));  // in the cube's own coordinates
    int faces = 0;
    for (int axis = 0; axis < 3; ++axis) faces += (eye[axis] > 0.5) + (eye[axis] < -0.5);
    numbers.set("facing", faces);
    const TriangleCount triangles = countTriangles(gpu.cube);
    numbers.set("culled", double(triangles.culled));
    numbers.set("outside", double(triangles.outside));
    numbers.set("surviving", double(triangles.surviving));
}

}  // namespace mv::cube_cull
