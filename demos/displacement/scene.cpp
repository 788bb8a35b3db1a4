// The scene of displacement: the wall or the orange, the lamp, the eye.
#include <cmath>
#include <glm/matrix.hpp>

#include "displacement.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv::displacement {

Scene sceneOf(const Settings& s, const FrameInfo& frame) {
    Scene scene;
    scene.clipFromView = perspective(50, frame.aspect(), 0.05, 100);
    scene.viewFromWorld = s.body == ReliefBody::wall ? rotateY(s.angle) * translate(0, 0, -s.distance)
                                                     : translate(0, 0, -1 - s.distance) * worldFromBody(s);
    scene.lights = {{.position = vec4(glm::transpose(mat3(worldFromBody(s))) * towardsLamp(s), 0)}};
    return scene;
}

mat4 worldFromBody(const Settings& s) {
    return s.body == ReliefBody::orange ? rotateX(s.spinX) * rotateY(s.spinY) : mat4(1);
}
vec3 towardsLamp(const Settings& s) { return {rotateY(s.lampTurn) * rotateX(-s.lampHeight) * vec4(0, 0, 1, 0)}; }
// Highlights have the eye at infinity, as the lamp.
vec3 towardsEye(const Settings& s) {
    if (s.body == ReliefBody::wall) return {-std::sin(radians(s.angle)), 0, std::cos(radians(s.angle))};
    return {glm::transpose(worldFromBody(s)) * vec4(0, 0, 1, 0)};
}
vec3 eyeOf(const Settings& s, const FrameInfo& frame) { return {glm::inverse(sceneOf(s, frame).viewFromWorld)[3]}; }

}  // namespace mv::displacement
