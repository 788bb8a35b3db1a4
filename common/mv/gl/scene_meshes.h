// The meshes of a scene on the GPU.
#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "mv/geometry/scene.h"
#include "mv/gl/mesh.h"

namespace mv {

class SceneMeshes {
  public:
    // Meshes have no more attributes than the program reads: with `colored` the meshes have no texture coordinates.
    enum class Surface { colored, textured };
    explicit SceneMeshes(Surface surface = Surface::colored) : surface_(surface) {}
    // Uploads each object's mesh that is not what was uploaded for the object of its place, named like the object, and
    // deletes those of objects that are gone. Places and colours of objects are no part of it.
    void follow(const Scene& scene);
    // Each object with its mesh, in the order of the scene that was followed last:
    //     for (const auto& [object, mesh] : meshes.of(scene)) { program.set(...); mesh.draw(); }
    // Refused: a scene of another number of objects.
    std::vector<std::pair<const SceneObject&, const Mesh&>> of(const Scene& scene) const;
    // The same of the objects that cast a shadow alone.
    std::vector<std::pair<const SceneObject&, const Mesh&>> castersOf(const Scene& scene) const;

  private:
    struct Uploaded {
        MeshData data;
        Mesh mesh;
    };
    Surface surface_;
    std::vector<Uploaded> uploaded_;
};

}  // namespace mv
