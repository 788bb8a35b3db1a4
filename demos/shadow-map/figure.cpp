// The scene of shadow-map, and the figures over it: the frustum, rays, the map in the corner.
#include "mv/demo/seen.h"
#include "shadow-map.h"
#include "shared/light_rays.h"
#include "shared/scenes.h"

namespace mv::shadow_map {

Scene sceneOf(const Settings& s, const FrameInfo& frame) {
    Scene scene = s.scene == Which::cubeOnPlane ? cubeOnPlane(frame.aspect())
                  : s.scene == Which::stillLife ? stillLife(frame.aspect())
                                                : sphereAndCube(frame.aspect());
    scene.lights = {{.position = lightOf(s)}};
    scene.viewFromWorld = seenFrom(s.orbit, scene.viewFromWorld);
    return scene;
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Scene scene = seen(sceneOf(s, frame), frame);
    const LightView light = lightView(s, scene);
    if (s.showFrustum) gpu.overlay.drawFrustum(scene.clipFromWorld(), light);
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
