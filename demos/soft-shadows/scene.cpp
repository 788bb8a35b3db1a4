// The scenes of soft-shadows, and the points that represent their lamp.
#include <cmath>

#include "mv/geometry/lamp.h"
#include "mv/math/transform.h"
#include "shared/scenes.h"
#include "soft-shadows.h"

namespace mv::soft_shadows {

std::vector<vec3> pointsOf(const Settings& s, const SceneLight& lamp) {
    if (!isByPoints(s)) return {vec3(lamp.position)};
    return lampPoints(lamp, int(std::lround(std::sqrt(s.lights))), 15);
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
    scene.lights[0].halfV = worldFromLamp * vec4(0, 0, 1, 0);
    scene.viewFromWorld = scene.viewFromWorld * (rotateX(s.spinX) * rotateY(s.spinY));
    return scene;
}

}  // namespace mv::soft_shadows
