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
    // What a program does not read is not uploaded: with `colored` the meshes have no texture coordinates.
    enum class Surface { colored, textured };
    explicit SceneMeshes(Surface surface = Surface::colored) : surface_(surface) {}
    // Uploads each object's mesh that is not what was uploaded for the object of its place, named like the object, and
    // deletes those of objects that are gone. Where objects stand and what colours they have is no part of it.
    void follow(const Scene& scene);
    // Each object with its mesh, in the order of the scene that was followed last:
    //     for (const auto& [object, mesh] : meshes.of(scene)) { program.set(...); mesh.draw(); }
    // Refused: a scene of another number of objects.
    std::vector<std::pair<const SceneObject&, const Mesh&>> of(const Scene& scene) const;

  private:
    struct Uploaded {
        MeshData data;
        Mesh mesh;
    };
    Surface surface_;
    std::vector<Uploaded> uploaded_;
};

}  // namespace mv
