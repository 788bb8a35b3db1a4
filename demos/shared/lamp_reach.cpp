#include "shared/lamp_reach.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mv/geometry/bounds.h"
#include "mv/math/projection.h"

namespace mv {

bool canReach(const Scene& scene, const mat4& clipFromWorld, const vec3& lamp, double reach) {
    const auto planes = planesFromClip(clipFromWorld);
    const bool outside = std::any_of(planes.begin(), planes.end(),
                                     [&](const vec4& plane) { return glm::dot(vec3(plane), lamp) + plane.w < -reach; });
    return !outside && std::any_of(scene.objects.begin(), scene.objects.end(), [&](const SceneObject& object) {
        const Bounds bounds = boundsOf(object.mesh, object.worldFromObject);
        return glm::distance(glm::clamp(lamp, bounds.low, bounds.high), lamp) < reach;
    });
}

}  // namespace mv
