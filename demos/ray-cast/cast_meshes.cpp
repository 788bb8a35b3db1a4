#include "cast_meshes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "mv/geometry/shapes.h"
#include "mv/math/transform.h"
#include "shared/ray_structures.h"

namespace mv {
namespace {

void addTriangle(MeshData& mesh, const vec3& a, const vec3& b, const vec3& c) {
    for (const vec3& point : {a, b, c}) {
        mesh.positions.emplace_back(point);
        mesh.normals.emplace_back(glm::normalize(glm::cross(b - a, c - a)));
    }
}

// Straight upwards; along the waves so fine that no chord is off by more than 1.3e-4.
MeshData flagMesh() {
    constexpr int cells = 512;
    MeshData mesh;
    for (int i = 0; i <= cells; ++i) {
        for (const double v : {0.0, 1.0}) {
            const auto at = cast::flag(double(i) / cells, v, 1.0);
            mesh.positions.emplace_back(at.point);
            mesh.normals.emplace_back(glm::normalize(glm::cross(at.alongU, at.alongV)));
        }
        if (i == cells) break;
        const auto low = static_cast<std::uint32_t>(2 * i);
        for (const std::uint32_t corner : {0U, 2U, 3U, 0U, 3U, 1U}) mesh.indices.push_back(low + corner);
    }
    return mesh;
}

// Edges where the profile turns: 256 sides, so that no chord is off by more than 1e-4.
MeshData roundMesh(const std::vector<vec2>& profile) { return withoutTexCoords(lathe(profile, 256, 10)); }

MeshData diskMesh() {
    const vec3 normal = glm::normalize(cast::diskNormal), u = glm::normalize(glm::cross(normal, vec3(0, 1, 0))),
               v = glm::cross(normal, u);
    MeshData mesh;
    const auto rim = [&](int i) {
        const double angle = i * pi / 128;
        return cast::aboveOrigin + cast::diskRadius * (std::cos(angle) * u + std::sin(angle) * v);
    };
    for (int i = 0; i < 256; ++i) addTriangle(mesh, cast::aboveOrigin, rim(i), rim(i + 1));
    return mesh;
}

MeshData placedTorus() {
    MeshData mesh = withoutTexCoords(torus(cast::torusMajor, cast::torusMinor, 256, 128));
    for (auto& position : mesh.positions) position += fvec3(cast::aboveOrigin);
    return mesh;
}

MeshData placedSphere(const mat4& worldFromObject) {
    MeshData mesh = withoutTexCoords(sphere(1, 128, 64));
    const mat3 worldFromNormal = glm::transpose(glm::inverse(mat3(worldFromObject)));
    for (auto& position : mesh.positions) position = worldFromObject * vec4(vec3(position), 1);
    for (auto& normal : mesh.normals) normal = glm::normalize(worldFromNormal * vec3(normal));
    return mesh;
}

// A mesh of the object in the world, at scale 1.
MeshData castMeshOf(CastKind kind) {
    MeshData mesh;
    switch (kind) {
        case CastKind::plane: {
            const vec3 a = cast::floorCorner, b = a + cast::floorAlong, c = b + cast::floorUp;
            addTriangle(mesh, a, b, c);
            addTriangle(mesh, a, c, a + cast::floorUp);
            break;
        }
        case CastKind::box:
            mesh = withoutTexCoords(box(cast::boxLow, cast::boxHigh));
            break;
        case CastKind::triangle:
            addTriangle(mesh, cast::triangle[0], cast::triangle[1], cast::triangle[2]);
            break;
        case CastKind::polygon: {
            const std::array<vec3, 10> corners = cast::star();
            for (std::size_t i = 0; i < corners.size(); ++i)
                addTriangle(mesh, vec3(0.6, 0.85, 2), corners.at(i), corners.at((i + 1) % corners.size()));
            break;
        }
        case CastKind::surface:
            mesh = flagMesh();
            break;
        case CastKind::teapot:
            break;
        case CastKind::sphere:
            mesh = placedSphere(translate(cast::sphereCenter));
            break;
        case CastKind::transformed:
            mesh = placedSphere(cast::worldFromEllipsoid());
            break;
        case CastKind::cylinder:
            mesh = roundMesh({{0, 0},
                              {cast::cylinderRadius, 0},
                              {cast::cylinderRadius, cast::cylinderHeight},
                              {0, cast::cylinderHeight}});
            break;
        case CastKind::cone:
            mesh = roundMesh({{0, 0}, {cast::coneRadius, 0}, {0, cast::coneHeight}});
            break;
        case CastKind::disk:
            mesh = diskMesh();
            break;
        case CastKind::torus:
            mesh = placedTorus();
            break;
    }
    return mesh;
}

}  // namespace

SceneObject castMesh(CastKind kind, double scale) {
    const auto which = static_cast<std::size_t>(kind);
    return {.name = castKindNames.at(which),
            .mesh = castMeshOf(kind),
            .worldFromObject = mv::scale(scale, scale, scale),
            .color = castColors.at(which)};
}

std::vector<SceneTriangle> castTriangles(const std::vector<CastKind>& kinds, int teapotCells) {
    std::vector<SceneTriangle> triangles;
    for (const CastKind kind : kinds) {
        const int number = static_cast<int>(kind);
        if (kind == CastKind::teapot) {
            triangles = teapotTriangles(teapotCells);
            for (SceneTriangle& one : triangles) one.object = number;
            continue;
        }
        const MeshData mesh = castMeshOf(kind);
        const std::size_t corners = mesh.indices.empty() ? mesh.positions.size() : mesh.indices.size();
        const auto corner = [&](std::size_t i) {
            return vec3(mesh.positions[mesh.indices.empty() ? i : mesh.indices[i]]);
        };
        for (std::size_t i = 0; i + 2 < corners; i += 3)
            triangles.push_back({corner(i), corner(i + 1), corner(i + 2), number, static_cast<int>(i / 3)});
    }
    return triangles;
}

}  // namespace mv
