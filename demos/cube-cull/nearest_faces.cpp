#include <glm/matrix.hpp>
#include <utility>
#include <vector>

#include "cube-cull.h"
#include "mv/geometry/bvh.h"

namespace mv::cube_cull {
namespace {

Bvh treeOf(const MeshData& mesh) {
    std::vector<SceneTriangle> triangles;
    const auto corner = [&](std::size_t i) { return vec3(mesh.positions[mesh.indices.empty() ? i : mesh.indices[i]]); };
    const std::size_t corners = mesh.indices.empty() ? mesh.positions.size() : mesh.indices.size();
    for (std::size_t i = 0; i + 2 < corners; i += 3)
        triangles.push_back({corner(i), corner(i + 1), corner(i + 2), 0, int(i / 3)});
    return Bvh(std::move(triangles));
}

}  // namespace

std::vector<double> nearestFaces(const Settings& s, const FrameInfo& frame) {
    const Bvh tree = treeOf(bodyOf(s));
    const mat4 modelFromView = inverse(viewFromModel(s)), clip = clipFromView(frame.aspect());
    std::vector<double> distances;
    for (int row = 0; row < frame.height(); ++row) {
        for (int column = 0; column < frame.width(); ++column) {
            const vec3 way((2 * (column + 0.5) / frame.width() - 1) / clip[0][0],
                           (1 - 2 * (row + 0.5) / frame.height()) / clip[1][1], -1);  // t counts along the gaze
            const Ray ray{.origin = vec3(modelFromView * vec4(0.2 * way, 1)),
                          .direction = vec3(modelFromView * vec4(way, 0))};
            const auto hit = tree.nearest(ray, 100 - 0.2);
            distances.push_back(hit ? 0.2 + hit->hit.t : -1);
        }
    }
    return distances;
}

}  // namespace mv::cube_cull
