// X54: sight along a bumped surface. And X49 of meshes: tangents where the texture is mirrored, or says nothing.
#include <cmath>
#include <glm/geometric.hpp>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/geometry/mesh_tangents.h"
#include "mv/geometry/shapes.h"
#include "shared/relief.h"

using namespace mv;
using namespace mv::test;

namespace {

// The shift as it is written in most texts: v.xy / v.z.
vec2 plainShift(const vec3& view, double depth, double height) { return -depth * (1 - height) / view.z * vec2(view); }

[[maybe_unused]] const bool x54along = addRow([] {
    double naive = 0, ours = 0;
    for (const double degrees : {87.0, 89.0, 89.9, 90.0}) {
        const vec3 view(std::sin(radians(degrees)), 0, degrees == 90 ? 0 : std::cos(radians(degrees)));
        naive = worse(naive, glm::length(plainShift(view, 1, 0)));
        ours = worse(ours, glm::length(parallaxShift(view, 1, 0)));
    }
    return Row{.id = "X54 along",
               .input = "parallax of depth 1, seen at 87° to 90°",
               .measured = "the largest shift, in depths",
               .naive = "v.xy / v.z",
               .naiveError = naive,
               .ours = "parallaxShift: v.z no less than 0.05",
               .ourError = ours,
               .tolerance = 20,
               .reason = "1/0.05: the shift of sight at 87°"};
});

[[maybe_unused]] const bool x54flat = addRow([] {
    const vec3 view(1, 0, 0);
    return Row{.id = "X54 depth 0",
               .input = "parallax of depth 0, seen along the surface",
               .measured = "the shift, of which there is none",
               .naive = "v.xy / v.z",
               .naiveError = glm::length(plainShift(view, 0, 0)),
               .ours = "parallaxShift",
               .ourError = glm::length(parallaxShift(view, 0, 0)),
               .tolerance = 0,
               .reason = "a relief without depth is the surface"};
});

// The usual form: of each vertex the sum of its triangles' tangents, made unit.
double worstOfSums(const MeshData& mesh) {
    double worst = 0;
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        vec3 sum(0);
        for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
            const auto corner = [&](std::size_t i) { return mesh.indices[t + i]; };
            if (corner(0) != vertex && corner(1) != vertex && corner(2) != vertex) continue;
            const vec3 a(mesh.positions[corner(1)] - mesh.positions[corner(0)]),
                b(mesh.positions[corner(2)] - mesh.positions[corner(0)]);
            const vec2 ofA(mesh.texCoords[corner(1)] - mesh.texCoords[corner(0)]),
                ofB(mesh.texCoords[corner(2)] - mesh.texCoords[corner(0)]);
            sum += (ofB.y * a - ofA.y * b) / (ofA.x * ofB.y - ofB.x * ofA.y);
        }
        worst = worse(worst, std::abs(glm::length(glm::normalize(sum)) - 1));
    }
    return worst;
}
double worstOfOurs(const MeshData& mesh) {
    const MeshTangents made = meshTangents(mesh);
    double worst = 0;
    for (std::size_t i = 0; i < made.tangents.size(); ++i) {
        const vec3 tangent(made.tangents[i]);
        worst = worse(worst, std::abs(glm::length(tangent) - 1));
        worst = worse(worst, std::abs(glm::dot(tangent, glm::normalize(vec3(made.mesh.normals[i])))));
    }
    return worst;
}
Row tangents(const std::string& id, const std::string& input, const MeshData& mesh) {
    return {.id = id,
            .input = input,
            .measured = "how far the worst tangent is from unit length, and ours from across the normal",
            .naive = "normalize(sum of the triangles' tangents)",
            .naiveError = worstOfSums(mesh),
            .ours = "meshTangents",
            .ourError = worstOfOurs(mesh),
            .tolerance = 1e-6,
            .reason = "some roundings of floats"};
}

[[maybe_unused]] const bool x49mirrored = addRow([] {
    return tangents("X49 mesh mirrored", "a wall whose texture is mirrored at a row of vertices",
                    wallPiece({ReliefBody::wall, 0, true}, -2, 2, 4, 2));
});
[[maybe_unused]] const bool x49equal = addRow([] {
    MeshData mesh = sphere(1, 16, 8);
    for (fvec2& texCoord : mesh.texCoords) texCoord = fvec2(0.5F);
    return tangents("X49 mesh equal", "a sphere whose texture coordinates are all equal", mesh);
});

}  // namespace
