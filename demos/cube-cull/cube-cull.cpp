// cube-cull: a cube or a teapot whose back faces, front faces or both are discarded before they are drawn.
#include "cube-cull.h"

#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/wide_lines.h"

namespace mv::cube_cull {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    drawBody(gpu, gpu.program, s, frame);
    drawWide(frame, [&] { gpu.axes.draw(); });
}

void drawBody(Gpu& gpu, const Program& program, const Settings& s, const Frame& frame) {
    // Discard the unwanted faces. OpenGL starts with GL_CCW as the winding of front faces, and culls GL_BACK
    if (s.cull != Cull::none) glEnable(GL_CULL_FACE);
    if (s.cull == Cull::front) glCullFace(GL_FRONT);
    if (s.cull == Cull::both) glCullFace(GL_FRONT_AND_BACK);
    if (s.winding == Winding::cw) glFrontFace(GL_CW);
    if (s.depth) glEnable(GL_DEPTH_TEST);

    // Look at the origin from the z axis
    const mat4 clipFromView = perspective(50, frame.aspect(), 0.2, 100);
    frame.show("viewFromModel", viewFromModel(s));
    frame.show("clipFromView", clipFromView);

    // Draw
    if (gpu.bodyFor.changed(s.body, s.divisions)) gpu.body = Mesh(bodyOf(s), "body");
    program.use();
    program.set("viewFromModel", viewFromModel(s));
    program.set("clipFromView", clipFromView);
    gpu.body.draw();
}

mat4 viewFromModel(const Settings& s) {
    return lookAt(vec3(0, 0, s.zDist), vec3(0, 0, 0), vec3(0, 1, 0)) * rotateX(-s.spinX) * rotateY(-s.spinY);
}

}  // namespace mv::cube_cull
