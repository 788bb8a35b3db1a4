// The shadow volumes of a scene's casters on the GPU, made again when the light moves.
#pragma once
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "mv/geometry/scene.h"
#include "mv/geometry/shadow_volume.h"
#include "mv/gl/mesh.h"

namespace mv {

class CasterVolumes {
  public:
    struct Caster {
        std::size_t object;  // index in Scene::objects
        ClosedMesh closed;
        ShadowVolume volume = {};
        Mesh mesh = {};
        std::optional<std::pair<vec4, Extrude>> made = {};  // for this light, in the object's space
    };

    CasterVolumes() = default;
    // Finds the edges of what casts in the scene. Error: what ClosedMesh refuses.
    explicit CasterVolumes(const Scene& scene);
    // Makes the volumes for this light (homogeneous, world space). Those of a caster that stands to the light as it stood
    // are kept, unless `extrude` has changed. True when one was made. Error: what shadowVolume refuses.
    bool follow(const Scene& scene, const vec4& light, Extrude extrude = Extrude::silhouette);
    // The next follow() makes all of them.
    void forget();
    const std::vector<Caster>& casters() const { return casters_; }
    // How many volumes of the casters numbered first .. last - 1 a point of the world is in, after follow().
    int around(const Scene& scene, const vec3& point, std::size_t first, std::size_t last) const;

  private:
    std::vector<Caster> casters_;
};

}  // namespace mv
