// cube-persp: a cube in perspective, whose pyramid of view is set by near, far, the field of view and the aspect.
#include "cube-persp.h"

#include "mv/gl/functions.h"
#include "mv/math/transform.h"

namespace mv::cube_persp {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    // Let near faces hide far ones, and leave room for the volume of view
    glEnable(GL_DEPTH_TEST);
    const Pane pane = paneOf(s, frame);
    glViewport(pane.x, pane.y, pane.width, pane.height);

    // Place the cube in front of the eye, and map the view volume to the cube from -1 to 1
    gpu.program.use();
    gpu.program.set("viewFromModel", viewFromModel(s));
    gpu.program.set("clipFromView", clipFromView(s));
    frame.show("viewFromModel", viewFromModel(s));
    frame.show("clipFromView", clipFromView(s));
    frame.show("clipFromViewByFrustum", frustum(nearWindow(s)));

    // Draw
    gpu.cube.draw();
}

// Turn the cube about its middle, then move it away from the eye.
mat4 viewFromModel(const Settings& s) { return translate(0, 0, -2) * rotateX(s.spinX) * rotateY(s.spinY); }

// `perspective` describes only a view volume whose axis is the line of sight.
mat4 clipFromView(const Settings& s) {
    return s.shift == 0 ? perspective(s.fov, s.aspect, s.near, s.far) : frustum(nearWindow(s));
}

// The view volume, given by its window on the plane z = -near, which a shift moves.
FrustumBounds nearWindow(const Settings& s) {
    FrustumBounds window = frustumBounds(s.fov, s.aspect, s.near, s.far);
    const double moved = s.shift * window.right;
    window.left += moved;
    window.right += moved;
    return window;
}

}  // namespace mv::cube_persp
