#include "shared/caster_volumes.h"

#include <cstddef>
#include <glm/matrix.hpp>
#include <utility>

namespace mv {

void CasterVolumes::followCasters(const Scene& scene) {
    std::size_t known = 0;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const SceneObject& object = scene.objects[i];
        if (!object.casts) continue;
        if (known == casters_.size() || casters_[known].data != object.mesh) {
            Caster caster{i, object.mesh, ClosedMesh(object.mesh, object.name)};
            if (known == casters_.size()) {
                casters_.push_back(std::move(caster));
            } else {
                casters_[known] = std::move(caster);
            }
        }
        casters_[known++].object = i;
    }
    casters_.erase(casters_.begin() + static_cast<std::ptrdiff_t>(known), casters_.end());
}

bool CasterVolumes::follow(const Scene& scene, const vec4& light, Extrude extrude) {
    followCasters(scene);
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

int CasterVolumes::around(const Scene& scene, const vec4& light, const vec3& point, std::size_t first,
                          std::size_t last) const {
    int sum = 0;
    for (std::size_t i = first; i < last; ++i) {
        const Caster& caster = casters_[i];
        const mat4 objectFromWorld = glm::inverse(scene.objects[caster.object].worldFromObject);
        sum += volumesAround(caster.closed, objectFromWorld * light, vec3(objectFromWorld * vec4(point, 1)));
    }
    return sum;
}

}  // namespace mv
