// The scene of cube-shadows: casters, floor and wall, light and eye. The whole scene moves with its middle, wherever in the
// world the floor is.
#include <cmath>
#include <glm/geometric.hpp>

#include "cube-shadows.h"
#include "mv/error.h"
#include "mv/math/projection.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"
#include "shared/narrow_view.h"
#include "shared/scenes.h"

namespace mv::cube_shadows {
namespace {

vec3 onSphere(double radius, double theta, double phi) {
    const double t = radians(theta), p = radians(phi);
    return radius * vec3(std::sin(p) * std::cos(t), std::sin(p) * std::sin(t), std::cos(p));
}

vec3 eyeFromMiddle(const Settings& s) { return onSphere(s.distance, s.theta, s.phi); }

ObjectId floorOf(Which scene) {
    return scene == Which::stillLife ? stillLifeInRoomScene::floor : cubeInRoomScene::floor;
}
ObjectId wallOf(Which scene) { return scene == Which::stillLife ? stillLifeInRoomScene::wall : cubeInRoomScene::wall; }

// Floor and wall are the same round the cube and round the still life.
const Scene& room() {
    static const Scene room = cubeInRoom();
    return room;
}
mat4 worldFromFloor(const Settings& s) {
    const mat4 level = translate(middleOf(s)) * room()[cubeInRoomScene::floor].worldFromObject;
    if (s.scene != Which::plane) return level;
    return level * rotateX(-s.tilt) * translate(0, 0, -500) * scale(100, 1, 100);  // no end is in sight
}
mat4 worldFromWall(const Settings& s) {
    return translate(middleOf(s)) * room()[cubeInRoomScene::wall].worldFromObject * rotateX(-s.tilt);
}

// Take the plane's point nearest to the middle of the scene, so that coordinates relative to it stay small.
Plane planeOf(const Settings& s, const mat4& worldFromGround) {
    const vec3 normal(worldFromGround[1]), point(worldFromGround[3]), middle = middleOf(s);
    return {normal, middle - glm::dot(normal, middle - point) * normal};
}

}  // namespace

vec4 Plane::inWorld() const { return {normal, -glm::dot(normal, origin)}; }

vec3 middleOf(const Settings& s) { return {0, 0, floorBelow - s.planeDistance}; }

vec4 lightOf(const Settings& s) {
    if (s.atInfinity) return {onSphere(1, s.lightTheta, s.lightPhi), 0};
    return {middleOf(s) + onSphere(s.lightDistance, s.lightTheta, s.lightPhi), 1};
}

std::vector<Ground> groundsOf(const Settings& s) {
    std::vector<Ground> grounds{{floorOf(s.scene), PlaneKind::floor, planeOf(s, worldFromFloor(s)), 1}};
    if (s.scene != Which::plane) grounds.push_back({wallOf(s.scene), PlaneKind::wall, planeOf(s, worldFromWall(s)), 2});
    return grounds;
}

// Whether the eye is in front of the plane, and so sees shadows. On the original's plane both sides show shadows.
bool showsFront(const Settings& s, const Plane& plane) {
    return s.scene == Which::plane || glm::dot(plane.normal, middleOf(s) + eyeFromMiddle(s) - plane.origin) > 0;
}

Scene sceneOf(const Settings& s, const FrameInfo& frame) {
    const bool life = s.scene == Which::stillLife;
    Scene scene = life ? stillLifeInRoom() : cubeInRoom();
    for (SceneObject& object : scene.objects) {
        if (object.casts) object.worldFromObject = translate(middleOf(s) + vec3(0, 0, s.lift)) * object.worldFromObject;
        object.receives = !object.casts;
        std::vector<fvec4>& colors = object.mesh.colors;
        if (colors.empty()) colors.assign(object.mesh.positions.size(), fvec4(object.color, 1));
    }
    if (!life) scene[cubeInRoomScene::cube].mesh.normals.clear();  // the cube is shown in its own colours, unlit
    scene[floorOf(s.scene)].worldFromObject = worldFromFloor(s);
    scene[wallOf(s.scene)].worldFromObject = worldFromWall(s);
    if (s.scene == Which::plane) scene.objects.resize(wallOf(s.scene).index);  // without the wall, the last of them
    scene.lights = {{.position = lightOf(s)}};
    // The eye looks at the middle, whose distance from the world's origin drops out of the product in double
    scene.viewFromWorld = lookAt(eyeFromMiddle(s), vec3(0), vec3(0, 0, 1)) * translate(-middleOf(s));
    scene.clipFromView = perspective(fovyAcross(s.fov, frame.aspect()), frame.aspect(), 1, 100);
    return scene;
}

void check(const Settings& s) {
    if (s.formula == Formula::axisAligned && s.tilt != 0)
        throw Error("--tilt", "must be 0 for --formula axis-aligned, which knows no other planes", numberText(s.tilt));
    if (s.space != Space::world || s.formula != Formula::general) return;
    for (const Ground& ground : groundsOf(s)) {
        if (lightSide(ground.plane.localOf(lightOf(s)), ground.plane.local()) != 0 &&
            lightSide(lightOf(s), ground.plane.inWorld()) == 0)
            throw Error("--plane-distance",
                        "must be less for --space world: so far out the light cannot be told from the plane",
                        numberText(s.planeDistance));
    }
}

}  // namespace mv::cube_shadows
