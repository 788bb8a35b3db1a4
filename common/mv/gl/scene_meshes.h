// The meshes of a scene on the GPU.
#pragma once
#include <vector>

#include "mv/geometry/scene.h"
#include "mv/gl/mesh.h"

namespace mv {

// One mesh for each object, in the order of Scene::objects, named like it.
inline std::vector<Mesh> uploadMeshes(const Scene& scene) {
    std::vector<Mesh> meshes;
    meshes.reserve(scene.objects.size());
    for (const SceneObject& object : scene.objects) meshes.emplace_back(object.mesh, object.name);
    return meshes;
}

}  // namespace mv
