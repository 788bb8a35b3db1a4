// shadow: a square and its shadow on the plane y = 0, flattened by one matrix along the rays of a circling light.
#include "shadow.h"

#include <cmath>

#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/shadow.h"
#include "mv/math/shadow_caster.h"

namespace mv::shadow {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const vec4 light = lightOf(s, frame);
    const mat4 worldFromModel = worldFromModelOf(s), clipFromView = clipFromViewOf(frame);
    frame.show("worldFromModel", worldFromModel);
    frame.show("viewFromWorld", viewFromWorld);
    frame.show("clipFromView", clipFromView);

    // Draw the square. No half space cuts anything off it: (0, 0, 0, 1) is positive everywhere
    glEnable(GL_DEPTH_TEST);
    gpu.program.use();
    gpu.program.set("worldFromModel", worldFromModel);
    gpu.program.set("viewFromModel", viewFromWorld * worldFromModel);
    gpu.program.set("clipFromView", clipFromView);
    gpu.program.set("abovePlane", vec4(0, 0, 0, 1));
    gpu.program.set("belowLight", vec4(0, 0, 0, 1));
    gpu.program.set("color", vec4(1, 0, 0, 1));
    gpu.square.draw();

    // Draw it once more, flattened onto the plane: the shadow
    const CasterVerdict verdict = judgeCaster("square", cornersOf(worldFromModel), light, planeOfShadow);
    if (!verdict.sentence.empty()) frame.say(verdict.sentence);
    if (verdict.casts) drawShadow(gpu, light, worldFromModel, frame);
}

void drawShadow(Gpu& gpu, const vec4& light, const mat4& worldFromModel, const Frame& frame) {
    const mat4 shadowFromWorld = shadowProjection(light, planeOfShadow);
    frame.show("shadowFromWorld", shadowFromWorld);
    gpu.program.set("viewFromModel", viewFromWorld * shadowFromWorld * worldFromModel);

    // Discard the false shadow. GL itself drops what has w <= 0, but only in a parallel view is that the w of the
    // shadow: in perspective it is multiplied by the depth, and a false shadow behind the eye has w > 0 again. And w
    // says nothing of what lies below the plane. So each pixel of the shadow carries the distances of the point that
    // casts it, and is discarded when that point is not between plane and light. They are linear on the caster, and the
    // interpolation undoes the division by w: it stays exact where GL cuts at w = 0.
    const auto [abovePlane, belowLight] = shadowCasterBounds(light, planeOfShadow);
    gpu.program.set("abovePlane", abovePlane);
    gpu.program.set("belowLight", belowLight);
    gpu.program.set("color", vec4(0, 0, 0, 1));
    gpu.square.draw();
}

// It goes round.
vec4 lightOf(const Settings& s, const FrameInfo& frame) {
    const double theta = 0.1 * frame.index();
    return {std::sin(theta), s.lightHeight, std::cos(theta), 1};
}

mat4 worldFromModelOf(const Settings& s) { return translate(0, s.squareHeight, 0) * rotateZ(s.tilt); }

// A box. The square stays one in a picture that is not square.
mat4 clipFromViewOf(const FrameInfo& frame) { return ortho(-2 * frame.aspect(), 2 * frame.aspect(), -2, 2, -4, 4); }

// The square's corners, in world space.
std::array<vec3, 4> cornersOf(const mat4& worldFromModel) {
    std::array<vec3, 4> corners{vec3(-0.5, 0, 0.5), vec3(0.5, 0, 0.5), vec3(0.5, 0, -0.5), vec3(-0.5, 0, -0.5)};
    for (vec3& corner : corners) corner = vec3(worldFromModel * vec4(corner, 1));
    return corners;
}

}  // namespace mv::shadow
