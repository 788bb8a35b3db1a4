// The scenes of soft-shadows, and the points that represent their lamp.
#include <cmath>

#include "mv/geometry/lamp.h"
#include "mv/math/sampling.h"
#include "mv/math/transform.h"
#include "shared/scenes.h"
#include "soft-shadows.h"

namespace mv::soft_shadows {

static constexpr double tubeWidth = 1.0 / 12;  // of its length

std::vector<vec3> pointsOf(const Settings& s, const SceneLight& lamp) {
    if (!isByPoints(s)) return {vec3(lamp.position)};
    const int side = int(std::lround(std::sqrt(s.lights)));
    if (s.lampShape != Shape::disc) return lampPoints(lamp, side, 15);
    std::vector<vec3> points;
    for (const vec2& at : jitteredSquare(side, 15)) {
        const vec2 p = onDisc(2.0 * at - 1.0);
        points.push_back(vec3(lamp.position) + p.x * lamp.halfU + p.y * lamp.halfV);
    }
    return points;
}

// From the square -1..1 to the unit disc: squares round the middle become circles, and equal areas equal areas.
// Source: Shirley and Chiu, "A low distortion map between disk and square" (1997).
vec2 onDisc(const vec2& onSquare) {
    const double x = onSquare.x, y = onSquare.y;
    if (x == 0 && y == 0) return vec2(0);
    const bool isFlat = std::abs(x) > std::abs(y);
    const double radius = isFlat ? x : y, angle = isFlat ? 45 * y / x : 90 - 45 * x / y;
    return radius * vec2(std::cos(radians(angle)), std::sin(radians(angle)));
}

Scene sceneOf(const Settings& s, const FrameInfo& frame) {
    const bool isCube = s.scene == Which::cube;
    Scene scene = isCube ? cubeOnPlane(frame.aspect()) : table(frame.aspect());
    for (SceneObject& object : scene.objects) {
        if (object.casts) object.worldFromObject = translate(0, s.casterHeight, 0) * object.worldFromObject;
    }
    const SceneObject& caster = scene[isCube ? cubeOnThePlane : topOfTheTable];
    const mat4 worldFromLamp = caster.worldFromObject * rotateY(s.lampTurn) * scale(s.lampSize / 2);
    scene.lights[0].halfU = worldFromLamp * vec4(1, 0, 0, 0);
    scene.lights[0].halfV = worldFromLamp * vec4(0, 0, s.lampShape == Shape::tube ? tubeWidth : 1, 0);
    scene.viewFromWorld = scene.viewFromWorld * (rotateX(s.spinX) * rotateY(s.spinY));
    return scene;
}

}  // namespace mv::soft_shadows
