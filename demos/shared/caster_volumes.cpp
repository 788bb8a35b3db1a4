#include "shared/caster_volumes.h"

#include <glm/matrix.hpp>

namespace mv {

CasterVolumes::CasterVolumes(const Scene& scene) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const SceneObject& object = scene.objects[i];
        if (object.casts) casters_.push_back({i, ClosedMesh(object.mesh, object.name)});
    }
}

bool CasterVolumes::follow(const Scene& scene, const vec4& light, Extrude extrude) {
    bool any = false;
    for (Caster& caster : casters_) {
        const SceneObject& object = scene.objects[caster.object];
        const std::pair wanted(glm::inverse(object.worldFromObject) * light, extrude);
        if (caster.made == wanted) continue;
        caster.volume = shadowVolume(caster.closed, wanted.first, extrude);
        caster.mesh = Mesh(caster.volume, object.name + " volume");
        caster.made = wanted;
        any = true;
    }
    return any;
}

void CasterVolumes::forget() {
    for (Caster& caster : casters_) caster.made.reset();
}

int CasterVolumes::around(const Scene& scene, const vec3& point, std::size_t first, std::size_t last) const {
    int sum = 0;
    for (std::size_t i = first; i < last; ++i) {
        const Caster& caster = casters_[i];
        const mat4 objectFromWorld = glm::inverse(scene.objects[caster.object].worldFromObject);
        const vec3 pointInObject(objectFromWorld * vec4(point, 1));
        if (caster.made) sum += volumesAround(caster.closed, caster.made->first, pointInObject);
    }
    return sum;
}

}  // namespace mv
