// cube-cull: a cube or a teapot whose back faces, front faces or both are discarded before they are drawn.
#include "cube-cull.h"

#include <array>

#include "mv/gl/state.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/wide_lines.h"

namespace mv::cube_cull {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    drawBody(gpu, gpu.program, s, frame);
    drawWide(frame, [&] { gpu.axes.draw(); });
}

void drawBody(Gpu& gpu, const Program& program, const Settings& s, const Frame& frame) {
    // Discard the unwanted faces. The winding of a face's corners on the screen tells whether one sees its front
    setEnabled(GL_CULL_FACE, s.cull != Cull::none);
    glCullFace(glFaces(s.cull));
    glFrontFace(glWinding(s.winding));
    setEnabled(GL_DEPTH_TEST, s.depth);

    // Look at the origin from the z axis
    frame.show("viewFromModel", viewFromModel(s));
    frame.show("clipFromView", clipFromView(frame.aspect()));

    // Draw
    const Mesh& body = gpu.body.of({s.body, s.divisions}, [&] { return Mesh(bodyOf(s), "body"); });
    program.use();
    program.set("viewFromModel", viewFromModel(s));
    program.set("clipFromView", clipFromView(frame.aspect()));
    body.draw();
}

mat4 viewFromModel(const Settings& s) {
    return lookAt(vec3(0, 0, s.zDist), vec3(0, 0, 0), vec3(0, 1, 0)) * rotateX(-s.spinX) * rotateY(-s.spinY);
}

mat4 clipFromView(double aspect) { return perspective(50, aspect, 0.2, 100); }

// OpenGL starts with GL_BACK and GL_CCW, and discards nothing.
GLenum glFaces(Cull cull) {
    constexpr std::array<GLenum, 4> faces{GL_BACK, GL_BACK, GL_FRONT, GL_FRONT_AND_BACK};  // in the order of Cull
    return faces.at(std::size_t(cull));
}
GLenum glWinding(Winding winding) {
    constexpr std::array<GLenum, 2> windings{GL_CCW, GL_CW};  // in the order of Winding
    return windings.at(std::size_t(winding));
}

}  // namespace mv::cube_cull
