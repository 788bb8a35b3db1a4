#include "mv/geometry/shadow_volume.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "mv/error.h"
#include "mv/geometry/check.h"
#include "mv/math/require.h"

namespace mv {
namespace {

void requireLight(const vec4& light) {
    requireFinite("shadow volume", "the light", light);
    if (light == vec4(0)) throw Error("shadow volume", "the light must not be (0, 0, 0, 0)");
    if (light.w < 0) throw Error("shadow volume", "the light's w must not be negative", vectorText(light));
}

std::string pointText(const fvec3& p) { return vectorText(vec3(p)); }

}  // namespace

ClosedMesh::ClosedMesh(const MeshData& mesh, const std::string& name) {
    const std::string subject = name.empty() ? "mesh" : "mesh " + name;
    const auto drawn = trianglesOf(mesh);
    const std::vector<std::uint32_t> first = weldByPosition(mesh.positions);

    // Number the positions that are used, in the order of the mesh
    std::vector<std::uint32_t> number(first.size(), 0);
    for (std::uint32_t i = 0; i < first.size(); ++i) {
        if (first[i] == i) {
            number[i] = static_cast<std::uint32_t>(positions_.size());
            positions_.push_back(mesh.positions[i]);
        } else {
            number[i] = number[first[i]];
        }
    }
    for (const auto& [i, j, k] : drawn) {
        const std::array<std::uint32_t, 3> corner{number[i], number[j], number[k]};
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
        triangles_.push_back(corner);
    }
    if (triangles_.empty()) throw Error(subject, "must have triangles to cast a shadow");

    // Pair each directed edge with its reverse
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> triangleOfEdge;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = triangles_[t][i], to = triangles_[t][(i + 1) % 3];
            if (triangleOfEdge.try_emplace({from, to}, t).second) continue;
            throw Error(subject, "must have two triangles at each edge, in opposite directions; run twice one way is",
                        pointText(positions_[from]) + " to " + pointText(positions_[to]));
        }
    }
    for (const auto& [ends, triangle] : triangleOfEdge) {
        const auto& [from, to] = ends;
        const auto reverse = triangleOfEdge.find({to, from});
        if (reverse == triangleOfEdge.end()) {
            throw Error(subject, "must have two triangles at each edge, in opposite directions; run by one only is",
                        pointText(positions_[from]) + " to " + pointText(positions_[to]));
        }
        if (from < to) edges_.push_back({{from, to}, {triangle, reverse->second}});
    }
}

std::vector<bool> facesLight(const ClosedMesh& mesh, const vec4& light) {
    requireLight(light);
    const auto& positions = mesh.positions();
    std::vector<bool> faces;
    faces.reserve(mesh.triangles().size());
    for (const auto& [i, j, k] : mesh.triangles()) {
        const vec3 a(positions[i]), b(positions[j]), c(positions[k]);
        // The light's height over the triangle's plane, times twice the triangle's area. Rounding may put a light near the
        // plane on either side of it; the surface is closed with either answer.
        faces.push_back(glm::dot(glm::cross(b - a, c - a), vec3(light) - light.w * a) > 0);
    }
    return faces;
}

namespace {

std::vector<ClosedMesh::Edge> silhouetteOf(const ClosedMesh& mesh, const std::vector<bool>& faces) {
    std::vector<ClosedMesh::Edge> edges;
    for (const ClosedMesh::Edge& edge : mesh.edges()) {
        const auto [left, right] = edge.triangle;
        if (faces[left] == faces[right]) continue;
        edges.push_back(edge);
        if (faces[left]) continue;
        std::swap(edges.back().vertex[0], edges.back().vertex[1]);
        std::swap(edges.back().triangle[0], edges.back().triangle[1]);
    }
    return edges;
}

}  // namespace

std::vector<ClosedMesh::Edge> silhouette(const ClosedMesh& mesh, const vec4& light) {
    return silhouetteOf(mesh, facesLight(mesh, light));
}

ShadowVolume shadowVolume(const ClosedMesh& mesh, const vec4& light, Extrude extrude) {
    const std::vector<bool> faces = facesLight(mesh, light);
    const auto count = static_cast<std::uint32_t>(mesh.positions().size());
    const bool atInfinity = light.w == 0;

    // The points, and where the light throws them: away from it, to infinity. All to one place when it is there itself.
    ShadowVolume volume;
    volume.positions.reserve(2 * std::size_t(count));
    for (const fvec3& p : mesh.positions()) volume.positions.emplace_back(p, 1.0F);
    for (std::uint32_t i = 0; i < (atInfinity ? 1 : count); ++i) {
        const vec3 direction = light.w * vec3(mesh.positions()[i]) - vec3(light);
        requireFitsFloat("shadow volume", "directions away from the light", direction);
        volume.positions.emplace_back(fvec3(direction), 0.0F);
    }
    const auto thrown = [&](std::uint32_t i) { return atInfinity ? count : count + i; };

    // Sides: a facing triangle runs its edge a, b; its neighbour in the surface, the side, runs it b, a. The two sides that
    // facing neighbours draw out from one edge cancel; so they are the same two triangles, each the other way round.
    std::vector<std::uint32_t>& indices = volume.indices;
    const auto addSide = [&](std::uint32_t a, std::uint32_t b) {
        if (atInfinity) {
            indices.insert(indices.end(), {b, a, thrown(a)});
        } else if (a < b) {
            indices.insert(indices.end(), {b, a, thrown(a), b, thrown(a), thrown(b)});
        } else {
            indices.insert(indices.end(), {b, a, thrown(b), thrown(b), a, thrown(a)});
        }
        ++volume.edges;
    };
    const auto& triangles = mesh.triangles();
    if (extrude == Extrude::silhouette) {
        for (const ClosedMesh::Edge& edge : silhouetteOf(mesh, faces)) addSide(edge.vertex[0], edge.vertex[1]);
    } else {
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            if (!faces[t]) continue;
            for (std::size_t i = 0; i < 3; ++i) addSide(triangles[t][i], triangles[t][(i + 1) % 3]);
        }
    }
    volume.sides = indices.size();

    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (faces[t]) indices.insert(indices.end(), triangles[t].begin(), triangles[t].end());
    }
    volume.lightCap = indices.size() - volume.sides;

    for (std::size_t t = 0; t < triangles.size() && !atInfinity; ++t) {
        const auto [a, b, c] = triangles[t];
        if (extrude == Extrude::silhouette && !faces[t]) {
            indices.insert(indices.end(), {thrown(a), thrown(b), thrown(c)});
        } else if (extrude == Extrude::everyTriangle && faces[t]) {
            indices.insert(indices.end(), {thrown(c), thrown(b), thrown(a)});
        }
    }
    volume.darkCap = indices.size() - volume.sides - volume.lightCap;
    return volume;
}

int volumesAround(const ClosedMesh& mesh, const vec4& light, const vec3& point) {
    const std::vector<bool> faces = facesLight(mesh, light);
    const vec3 toLight = vec3(light) - light.w * point;
    int around = 0;
    for (std::size_t t = 0; t < faces.size(); ++t) {
        if (!faces[t]) continue;
        const auto& [i, j, k] = mesh.triangles()[t];
        const vec3 a = vec3(mesh.positions()[i]) - point;
        const vec3 b = vec3(mesh.positions()[j]) - point;
        const vec3 c = vec3(mesh.positions()[k]) - point;
        // Behind the triangle, and within the pyramid that the light throws it into
        if (glm::dot(glm::cross(b - a, c - a), a) <= 0) continue;
        const double u = glm::dot(glm::cross(a, b), toLight);
        const double v = glm::dot(glm::cross(b, c), toLight);
        const double w = glm::dot(glm::cross(c, a), toLight);
        if (u >= 0 && v >= 0 && w >= 0) ++around;
    }
    return around;
}

}  // namespace mv
