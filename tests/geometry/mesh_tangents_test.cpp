#include "mv/geometry/mesh_tangents.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "../math/support.h"
#include "mv/geometry/check.h"
#include "mv/geometry/shapes.h"
#include "mv/geometry/teapot.h"

using namespace mv;
using namespace mv::test;

namespace {

// Unit tangents across unit normals, to what floats round; w is 1 or -1; the mesh is well formed.
void expectFrames(const MeshTangents& made) {
    ASSERT_EQ(made.tangents.size(), made.mesh.positions.size());
    EXPECT_NO_THROW(validate(made.mesh));
    for (std::size_t i = 0; i < made.tangents.size(); ++i) {
        const vec3 tangent(made.tangents[i]), normal = glm::normalize(vec3(made.mesh.normals[i]));
        EXPECT_NEAR(glm::length(tangent), 1, 1e-6) << i;
        EXPECT_NEAR(glm::dot(tangent, normal), 0, 1e-6) << i;
        EXPECT_EQ(std::abs(made.tangents[i].w), 1) << i;
    }
}

// Two squares with the corner x = 0 in common: u grows away from it on both sides, as on a mirrored model.
MeshData mirroredSquares() {
    return {.positions = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {0, 1, 0}, {1, 1, 0}},
            .normals = std::vector<fvec3>(6, fvec3(0, 0, 1)),
            .texCoords = {{1, 0}, {0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 1}},
            .indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4}};
}

}  // namespace

TEST(MeshTangents, run_along_growing_u) {
    for (const MeshData& mesh : {sphere(2, 64, 32), torus(3, 1, 64, 32)}) {
        const MeshTangents made = meshTangents(mesh);
        expectFrames(made);
        EXPECT_EQ(made.split, 0U);
        EXPECT_EQ(made.free, 0U);
        EXPECT_EQ(made.mesh.positions, mesh.positions);
        for (std::size_t i = 0; i < made.tangents.size(); ++i) {
            const vec3 p(mesh.positions[i]);
            const double fromAxis = std::hypot(p.x, p.z);
            if (fromAxis < 1e-3) continue;  // at a pole east is anywhere
            const vec3 east = vec3(p.z, 0, -p.x) / fromAxis;
            EXPECT_EQ(made.tangents[i].w, 1);
            // The triangles on both sides are half a slice away, but the two at a vertex are not quite its mirror images: a
            // tenth of a slice, which is 0.1 rad.
            EXPECT_LT(glm::distance(vec3(made.tangents[i]), east), 0.01) << i;
        }
    }
}

TEST(MeshTangents, a_seam_is_none) {
    const MeshData mesh = sphere(1, 16, 8);
    const MeshTangents made = meshTangents(mesh);
    int pairs = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        for (std::size_t j = i + 1; j < mesh.positions.size(); ++j) {
            const bool isPole = std::abs(mesh.positions[i].y) > 0.999F;
            if (isPole || mesh.positions[i] != mesh.positions[j]) continue;
            EXPECT_EQ(made.tangents[i], made.tangents[j]);
            ++pairs;
        }
    }
    EXPECT_EQ(pairs, 7);
}

TEST(MeshTangents, at_a_pole_each_slice_keeps_its_own) {
    const MeshData mesh = sphere(1, 16, 8);
    const MeshTangents made = meshTangents(mesh);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (mesh.positions[i].y < 0.999F) continue;
        // The middle of the slice that the vertex belongs to
        const double around = 2 * pi * double(mesh.texCoords[i].x);
        const vec3 east(-std::sin(around), 0, -std::cos(around));
        EXPECT_LT(glm::distance(vec3(made.tangents[i]), east), 2 * pi / 16) << i;  // a slice
    }
}

TEST(MeshTangents, a_mirrored_texture_splits_what_both_sides_share) {
    const MeshTangents made = meshTangents(mirroredSquares());
    expectFrames(made);
    EXPECT_EQ(made.split, 2U);
    ASSERT_EQ(made.tangents.size(), 8U);
    for (std::size_t t = 0; t < made.mesh.indices.size(); t += 3) {
        const bool isLeft = t < 6;
        for (std::size_t i = t; i < t + 3; ++i) {
            EXPECT_EQ(made.tangents[made.mesh.indices[i]], isLeft ? fvec4(-1, 0, 0, -1) : fvec4(1, 0, 0, 1)) << i;
        }
    }
}

TEST(MeshTangents, seen_from_behind_the_frame_is_mirrored) {
    MeshData mesh = mirroredSquares();
    for (fvec3& normal : mesh.normals) normal = {0, 0, -1};
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) std::swap(mesh.indices[t], mesh.indices[t + 1]);
    const MeshTangents made = meshTangents(mesh);
    for (std::size_t i = 0; i < made.tangents.size(); ++i) {
        const fvec4 tangent = made.tangents[i];
        const vec3 third = double(tangent.w) * glm::cross(vec3(made.mesh.normals[i]), vec3(tangent));
        EXPECT_EQ(third, vec3(0, 1, 0)) << i;  // v grows upwards everywhere
    }
}

TEST(MeshTangents, without_a_texture_to_follow_any_will_do) {
    MeshData mesh = sphere(1, 12, 6);
    for (fvec2& texCoord : mesh.texCoords) texCoord = {0.5F, 0.25F};
    const MeshTangents made = meshTangents(mesh);
    expectFrames(made);
    EXPECT_EQ(made.free, mesh.positions.size());
    for (const fvec4& tangent : made.tangents) EXPECT_EQ(tangent.w, 1);
}

TEST(MeshTangents, a_triangle_that_says_nothing_does_not_count) {
    MeshData mesh = mirroredSquares();
    const MeshTangents before = meshTangents(mesh);
    mesh.indices.insert(mesh.indices.end(), {0, 0, 1, 2, 2, 2});
    const MeshTangents after = meshTangents(mesh);
    EXPECT_EQ(after.tangents, before.tangents);
}

TEST(MeshTangents, neither_size_nor_scale_of_texture_matters) {
    const MeshTangents plain = meshTangents(tessellated(teapot(), 4));
    expectFrames(plain);
    for (const float size : {1e-15F, 1e15F}) {
        MeshData mesh = tessellated(teapot(), 4);
        for (fvec3& position : mesh.positions) position *= size;
        for (fvec2& texCoord : mesh.texCoords) texCoord *= 1e6F;
        const MeshTangents made = meshTangents(mesh);
        expectFrames(made);
        double largest = 0;
        for (std::size_t i = 0; i < made.tangents.size(); ++i)
            largest = std::max(largest, double(glm::distance(fvec3(made.tangents[i]), fvec3(plain.tangents[i]))));
        // Positions times that size round anew, by 6e-8 of the teapot's size; triangles at its tips are a hundredth of it.
        EXPECT_LT(largest, 1e-4) << size;
    }
}

TEST(MeshTangents, refuses_what_has_no_frames) {
    MeshData mesh = mirroredSquares();
    mesh.normals.clear();
    EXPECT_EQ(refusal([&] { (void)meshTangents(mesh); }), "mesh: must have normals and texCoords to have tangents");
    mesh = mirroredSquares();
    mesh.normals[3] = fvec3(0);
    EXPECT_EQ(refusal([&] { (void)meshTangents(mesh); }), "mesh: normals[3] must not be 0");
    EXPECT_EQ(refusal([] { (void)meshTangents(wireCube()); }), "mesh: must be made of triangles to have tangents");
}
