// shadow-floor: a square, its shadow on a floor, and the light that throws it, to be walked round and moved about.
#include "shadow-floor.h"

#include <cmath>

#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"

namespace mv::shadow_floor {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    // Place the light once, for the whole picture
    const vec3 light = lightOf(s, frame);
    const mat4 viewFromWorld = viewFromWorldOf(s), clipFromView = clipFromViewOf(frame);
    frame.show("viewFromWorld", viewFromWorld);
    frame.show("clipFromView", clipFromView);

    // Draw floor, square and light. The floor is lowered by 0.0001, so that the shadow lies on its upper side and, seen
    // from below, behind it. (glPolygonOffset moves towards the eye, and would pull the shadow through the floor there.)
    glEnable(GL_DEPTH_TEST);
    gpu.program.use();
    gpu.program.set("clipFromView", clipFromView);
    gpu.program.set("crop", false);
    gpu.program.set("shadowFromModel", mat4(1));
    gpu.program.set("floorHalf", floorSide / 2);
    const mat4 worldFromSquare = translate(0, 0.5, 0);
    const mat4 worldFromFloor = translate(0, -0.0001, 0) * scale(floorSide);
    drawMesh(gpu.program, gpu.plate, vec4(1, 0, 0, 1), viewFromWorld * worldFromSquare);
    drawMesh(gpu.program, gpu.plate, vec4(0.5, 0.5, 0.5, 1), viewFromWorld * worldFromFloor);
    drawMesh(gpu.program, gpu.ball, vec4(1, 0.6, 0, 1), viewFromWorld * translate(light));

    // Draw the square flattened onto the floor. The square is level, so either all of it casts a shadow or nothing does
    const CasterVerdict verdict = judgeCaster("square", corners, vec4(light, 1), planeOfShadow);
    tell(s, light, verdict, frame);
    if (verdict.casts) drawShadow(gpu, s, light, worldFromSquare, frame);
}

// Draw the shadow. With `crop` on, the shader ends it at the floor's edge.
void drawShadow(Gpu& gpu, const Settings& s, const vec3& light, const mat4& worldFromSquare, const Frame& frame) {
    const mat4 shadowFromWorld = shadowProjection(vec4(light, 1), planeOfShadow);
    frame.show("shadowFromWorld", shadowFromWorld);
    gpu.program.set("shadowFromModel", shadowFromWorld * worldFromSquare);
    gpu.program.set("crop", s.crop);
    drawMesh(gpu.program, gpu.plate, vec4(0.2, 0, 0, 1), viewFromWorldOf(s) * shadowFromWorld * worldFromSquare);
}

void drawMesh(const Program& program, const Mesh& mesh, const vec4& color, const mat4& viewFromModel) {
    program.set("viewFromModel", viewFromModel);
    program.set("color", color);
    mesh.draw();
}

// The light goes round a circle of radius 1, or stays in its middle.
vec3 lightOf(const Settings& s, const FrameInfo& frame) {
    const double theta = 0.02 * frame.index(), radius = s.circle ? 1 : 0;
    return {s.lightX + radius * std::sin(theta), s.lightHeight, s.lightZ + radius * std::cos(theta)};
}

// The eye looks at the origin, about which the world is turned.
mat4 viewFromWorldOf(const Settings& s) {
    return lookAt(vec3(1, 1, s.zDist), vec3(0, 0, 0), vec3(0, 1, 0)) * (rotateX(s.spinX) * rotateY(s.spinY));
}

mat4 clipFromViewOf(const FrameInfo& frame) { return perspective(60, frame.aspect(), 0.2, 100); }

}  // namespace mv::shadow_floor
