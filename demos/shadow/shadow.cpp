// shadow: a square and its shadow on the plane y = 0, flattened by one matrix along the rays of a circling light.
#include "shadow.h"

#include <cmath>

#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/shadow.h"

namespace mv::shadow {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const vec4 light = lightOf(s, frame);
    const mat4 worldFromModel = worldFromModelOf(s), clipFromView = clipFromViewOf(frame);
    frame.show("worldFromModel", worldFromModel);
    frame.show("viewFromWorld", viewFromWorld);
    frame.show("clipFromView", clipFromView);

    // Draw the square. No half space cuts it: (0, 0, 0, 1) is positive everywhere
    glEnable(GL_DEPTH_TEST);
    gpu.program.use();
    gpu.program.set("worldFromModel", worldFromModel);
    gpu.program.set("viewFromModel", viewFromWorld * worldFromModel);
    gpu.program.set("clipFromView", clipFromView);
    gpu.program.set("abovePlane", vec4(0, 0, 0, 1));
    gpu.program.set("belowLight", vec4(0, 0, 0, 1));
    gpu.program.set("color", vec4(1, 0, 0, 1));
    gpu.square.draw();

    // Draw the square again, flattened onto the plane, as its shadow
    const CasterVerdict verdict = judgeCaster("square", cornersOf(worldFromModel), light, planeOfShadow);
    tell(verdict, frame);
    if (verdict.casts) drawShadow(gpu, light, worldFromModel, frame);
}

void drawShadow(Gpu& gpu, const vec4& light, const mat4& worldFromModel, const Frame& frame) {
    const mat4 shadowFromWorld = shadowProjection(light, planeOfShadow);
    frame.show("shadowFromWorld", shadowFromWorld);
    gpu.program.set("viewFromModel", viewFromWorld * shadowFromWorld * worldFromModel);

    // Discard the false shadow. GL clips all points with w <= 0, but only in a parallel view is this w that of the
    // shadow: a perspective multiplies it by the depth, so that a false shadow behind the eye has w > 0 again. And w
    // does not tell which points lie below the plane. So each pixel of the shadow carries the distances of the point
    // that casts it, and the shader discards the pixel when this point is not between plane and light. The distances
    // are linear on the caster, and interpolation undoes the division by w: they stay exact where GL clips at w = 0
    const auto [abovePlane, belowLight] = shadowCasterBounds(light, planeOfShadow);
    gpu.program.set("abovePlane", abovePlane);
    gpu.program.set("belowLight", belowLight);
    gpu.program.set("color", vec4(0, 0, 0, 1));
    gpu.square.draw();
}

// The light goes round in a circle.
vec4 lightOf(const Settings& s, const FrameInfo& frame) {
    const double theta = 0.1 * frame.index();
    return {std::sin(theta), s.lightHeight, std::cos(theta), 1};
}

mat4 worldFromModelOf(const Settings& s) { return translate(0, s.squareHeight, 0) * rotateZ(s.tilt); }

// A parallel projection. The view widens with the picture, so the square stays square.
mat4 clipFromViewOf(const FrameInfo& frame) { return ortho(-2 * frame.aspect(), 2 * frame.aspect(), -2, 2, -4, 4); }

// The square's corners, in world space.
std::array<vec3, 4> cornersOf(const mat4& worldFromModel) {
    std::array<vec3, 4> corners{vec3(-0.5, 0, 0.5), vec3(0.5, 0, 0.5), vec3(0.5, 0, -0.5), vec3(-0.5, 0, -0.5)};
    for (vec3& corner : corners) corner = vec3(worldFromModel * vec4(corner, 1));
    return corners;
}

}  // namespace mv::shadow
