// The shadow volumes of a scene's casters on the GPU, made again when what casts or the light changes.
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
        MeshData data;       // what the edges were found in
        ClosedMesh closed;
        ShadowVolume volume = {};
        Mesh mesh = {};
        std::optional<std::pair<vec4, Extrude>> made = {};  // for this light, in the object's space
    };

    // Finds the edges of what casts in the scene, and makes the volumes for this light (homogeneous, world space). The edges
    // of a caster whose mesh is as it was are kept; and its volume where it also stands to the light as it stood, and
    // `extrude` is the same. True when one was made. Error: what ClosedMesh or shadowVolume refuses.
    bool follow(const Scene& scene, const vec4& light, Extrude extrude = Extrude::silhouette);
    // Finds the edges alone, and makes no volume. Error: what ClosedMesh refuses.
    void followCasters(const Scene& scene);
    // The next follow() makes all of them.
    void forget();
    const std::vector<Caster>& casters() const { return casters_; }
    // How many volumes of the casters numbered first .. last - 1, of this light, a point of the world is in, after follow() or
    // followCasters().
    int around(const Scene& scene, const vec4& light, const vec3& point, std::size_t first, std::size_t last) const;

  private:
    std::vector<Caster> casters_;
};

}  // namespace mv
