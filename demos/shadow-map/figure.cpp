// The scene of shadow-map, and the figures over it: the frustum, rays, the map in the corner.
#include "mv/demo/seen.h"
#include "mv/geometry/shapes.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shadow-map.h"
#include "shared/light_rays.h"
#include "shared/scenes.h"

namespace mv::shadow_map {

Scene sceneOf(const Settings& s, const FrameInfo& frame) {
    Scene scene = s.scene == Which::cubeOnPlane ? cubeOnPlane(frame.aspect())
                  : s.scene == Which::stillLife ? stillLife(frame.aspect())
                  : s.scene == Which::overhead  ? overhead(s.sides, s.cord, frame.aspect())
                                                : sphereAndCube(frame.aspect());
    if (s.scene == Which::sphereAndCube) scene[sphereOfSphereAndCube].mesh = sphere(1, s.sides, 3 * s.sides / 4);
    scene.lights = {{.position = lightOf(s)}};
    scene.viewFromWorld = seenFrom(s.orbit, scene.viewFromWorld);
    return scene;
}

// A ball and three cords that hang above the picture, so that only their shadows are seen.
Scene overhead(int sides, double cord, double aspect) {
    Scene scene = floorAlone(aspect);
    scene.objects.push_back({.name = "ball", .mesh = sphere(0.35, sides, 3 * sides / 4)});
    scene.objects.back().worldFromObject = translate(2.05, 2.6, 3.4);
    const MeshData straight = box(-vec3(1.5, cord / 2, cord / 2), vec3(1.5, cord / 2, cord / 2));
    for (const double turn : {15, 50, -40}) {
        const std::string name = "cord " + std::to_string(scene.objects.size() - 1);
        scene.objects.push_back({.name = name, .mesh = straight});
        scene.objects.back().worldFromObject = translate(3.1, 2.4, 3.3) * rotateY(turn);
    }
    scene.viewFromWorld = lookAt({2.5, 2, 6.5}, {2.3, 0, 3.2}, {0, 1, 0});
    scene.clipFromView = perspective(50, aspect, 0.5, 30);
    return scene;
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Scene scene = seen(sceneOf(s, frame), frame);
    const LightView light = lightView(s, scene);
    if (s.showFrustum) gpu.overlay.drawFrustum(frame, scene.clipFromWorld(), light);
    if (s.showRays) drawSceneRays(gpu.drawing, scene, frame);
    if (s.showMap) gpu.overlay.drawMap(frame, gpu.map, light);
}

void tell(const Settings& s, const Scene& scene, const LightView& light, const Frame& frame) {
    frame.show("viewFromWorld", scene.viewFromWorld);
    frame.show("clipFromView", scene.clipFromView);
    frame.show("lightFromWorld", light.viewFromWorld);
    frame.show("mapFromWorld", light.mapFromWorld());
    frame.count("texels a lookup", looksAlong(s.filter) * looksAlong(s.filter) * (s.filter == Filter::none ? 1 : 4));
}

}  // namespace mv::shadow_map
