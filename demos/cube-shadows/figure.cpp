// Drawn over cube-shadows, and told beside it: the cube's edges, the lamp, the light's rays, the matrices.
#include <glm/geometric.hpp>
#include <set>
#include <string>
#include <utility>

#include "cube-shadows.h"
#include "mv/demo/seen.h"
#include "mv/geometry/in_view.h"
#include "mv/geometry/shapes.h"
#include "mv/math/transform.h"
#include "shared/light_rays.h"
#include "shared/scenes.h"
#include "shared/wide_lines.h"

namespace mv::cube_shadows {

MeshData painted(MeshData mesh, const vec3& color) {
    mesh.colors.assign(mesh.positions.size(), fvec4(color, 1));
    mesh.normals.clear();
    mesh.texCoords.clear();
    return mesh;
}
MeshData lampShape() { return painted(sphere(0.12, 32, 16), {1, 0.6, 0}); }
MeshData edgesOfCube() { return painted(wireCube(), {0, 0, 0}); }

void drawEdgesAndLamp(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame) {
    // The edges lie a little outside the faces, which would cover parts of them
    if (s.scene != Which::stillLife)
        drawWide(frame, [&] {
            drawSurface(gpu, scene, *gpu.edges, scene[cubeInRoomScene::cube].worldFromObject * scale(2.004));
        });
    static const MeshData shape = lampShape();
    const mat4 worldFromLamp = translate(vec3(lightOf(s)));
    if (!s.atInfinity && isInView(shape, scene.clipFromWorld() * worldFromLamp))
        drawSurface(gpu, scene, *gpu.lamp, worldFromLamp);
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    if (s.rays) drawSceneRays(gpu.drawing, seen(sceneOf(s, frame), frame), frame);
}

void tell(const Settings& s, const Scene& scene, const Frame& frame) {
    const Plane floor = groundsOf(s).front().plane;
    frame.show("viewFromWorld", scene.viewFromWorld);
    frame.show("clipFromView", scene.clipFromView);
    if (isLit(s, floor)) frame.show("shadowFromWorld", flattened(s, mat4(1), floor, mat4(1)));
    std::set<std::string> said{""};
    for (const Ground& ground : groundsOf(s)) {
        for (const SceneObject& object : scene.objects) {
            if (!object.casts) continue;
            const std::string sentence = judged(s, object, ground).sentence;
            if (said.insert(sentence).second) frame.say(sentence);
        }
    }
}

void readOut(Gpu&, const Settings& s, const Frame&, Numbers& numbers) {
    const Plane floor = groundsOf(s).front().plane;
    numbers.set("light-height", glm::dot(floor.local(), floor.localOf(lightOf(s))));
}

}  // namespace mv::cube_shadows
