// The volumes made by a geometry shader, which is given each triangle with its neighbours.
#include <glm/matrix.hpp>

#include "neighbours.h"
#include "shadow-volume.h"

namespace mv::shadow_volume {

// Upload each caster's triangles with their neighbours. They stay as they are when the light moves.
static void followNeighbours(Gpu& gpu, const Settings& s) {
    if (!gpu.neighboursFor.changed(s.scene, s.shells)) return;
    gpu.neighbours.clear();
    for (const Caster& caster : gpu.volumes.casters())
        gpu.neighbours.emplace_back(withNeighbours(caster.closed), "neighbours");
}

// Draw the sides of the volumes of the casters first .. last - 1. The shader finds the silhouettes (shaders/shadow-volume/sides.geom).
void drawSidesByShader(Gpu& gpu, const Settings& s, const Scene& scene, std::size_t first, std::size_t last,
                       const vec4& color) {
    followNeighbours(gpu, s);
    gpu.sidesProgram->use();
    gpu.sidesProgram->set("color", color);
    for (std::size_t i = first; i < last; ++i) {
        const mat4& worldFromObject = scene.objects[gpu.volumes.casters()[i].object].worldFromObject;
        gpu.sidesProgram->set("clipFromObject", scene.clipFromWorld() * worldFromObject);
        gpu.sidesProgram->set("light", glm::inverse(worldFromObject) * scene.lights[0].position);
        gpu.neighbours[i].drawAs(GL_TRIANGLES_ADJACENCY);
    }
}

bool findsByShader(const Settings& s) { return s.by == By::geometryShader && s.silhouette; }
// A cap must have the very depths of the solid's faces, which only the same stages promise: so z-fail's volumes are the processor's.
bool isByShader(const Settings& s) { return findsByShader(s) && s.method != Method::zFail; }

}  // namespace mv::shadow_volume
