#include "mv/gl/scene_meshes.h"

#include <string>

#include "mv/error.h"

namespace mv {

void SceneMeshes::follow(const Scene& scene) {
    const auto upload = [&](const SceneObject& object) -> Uploaded {
        const bool isTextured = surface_ == Surface::textured;
        return {object.mesh, Mesh(isTextured ? object.mesh : withoutTexCoords(object.mesh), object.name)};
    };
    const std::size_t count = scene.objects.size();
    if (uploaded_.size() > count) uploaded_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const SceneObject& object = scene.objects[i];
        if (i == uploaded_.size()) {
            uploaded_.push_back(upload(object));
        } else if (uploaded_[i].data != object.mesh) {
            uploaded_[i] = upload(object);
        }
    }
}

std::vector<std::pair<const SceneObject&, const Mesh&>> SceneMeshes::of(const Scene& scene) const {
    if (scene.objects.size() != uploaded_.size()) {
        throw Error("scene", "must be the one that was followed, of " + std::to_string(uploaded_.size()) + " objects",
                    std::to_string(scene.objects.size()));
    }
    std::vector<std::pair<const SceneObject&, const Mesh&>> pairs;
    pairs.reserve(uploaded_.size());
    for (std::size_t i = 0; i < uploaded_.size(); ++i) pairs.emplace_back(scene.objects[i], uploaded_[i].mesh);
    return pairs;
}

std::vector<std::pair<const SceneObject&, const Mesh&>> SceneMeshes::castersOf(const Scene& scene) const {
    std::vector<std::pair<const SceneObject&, const Mesh&>> casters;
    for (const auto& [object, mesh] : of(scene)) {
        if (object.casts) casters.emplace_back(object, mesh);
    }
    return casters;
}

}  // namespace mv
