// cube-ortho: a cube in a parallel projection, whose box of view is set by its depth, width and height.
#include "cube-ortho.h"

#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv::cube_ortho {

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

    // Draw
    gpu.cube.draw();
}

// Turn the cube about its middle, then move it away from the eye.
mat4 viewFromModel(const Settings& s) { return translate(0, 0, -s.distance) * rotateX(s.spinX) * rotateY(s.spinY); }

mat4 clipFromView(const Settings& s) {
    return ortho(-s.width / 2, s.width / 2, -s.height / 2, s.height / 2, nearDistance(s), farDistance(s));
}

// Near and far are distances in front of the eye. The cube lies midway between them. Exchanged, they mirror the depths.
double nearDistance(const Settings& s) { return s.distance - halfDepth(s); }
double farDistance(const Settings& s) { return s.distance + halfDepth(s); }
double halfDepth(const Settings& s) { return s.mirrorDepth ? -s.depth / 2 : s.depth / 2; }

}  // namespace mv::cube_ortho
