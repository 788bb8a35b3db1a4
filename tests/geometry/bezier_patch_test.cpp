#include "mv/geometry/bezier_patch.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <string>

#include "../math/support.h"
#include "mv/geometry/check.h"

using namespace mv;
using namespace mv::test;

namespace {

// Over the square 0..3 x 0..3 in x and z, with these heights: its parameters are x/3 and z/3, and it faces down.
BezierPatch overSquare(const std::array<double, 16>& heights) {
    BezierPatch patch;
    for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t i = 0; i < 4; ++i) patch.points[4 * j + i] = vec3(i, heights[4 * j + i], j);
    }
    return patch;
}
const BezierPatch bent = overSquare({0, 1, -1, 2, 1, 0, 3, 1, 2, 2, -2, 0, 1, 0, 0, 4});

// Its upper edge is one point: a quarter of a hill that is no cone, since its rows are not similar.
BezierPatch tip() {
    BezierPatch patch = bent;
    for (std::size_t i = 0; i < 4; ++i) patch.points[12 + i] = vec3(1.5, 5, 3);
    return patch;
}

}  // namespace

TEST(BezierPatch, corners_are_control_points) {
    EXPECT_EQ(pointOf(bent, 0, 0).position, bent.points[0]);
    EXPECT_EQ(pointOf(bent, 1, 0).position, bent.points[3]);
    EXPECT_EQ(pointOf(bent, 0, 1).position, bent.points[12]);
    EXPECT_EQ(pointOf(bent, 1, 1).position, bent.points[15]);
}

// The definition, by Bernstein's polynomials.
TEST(BezierPatch, is_the_sum_of_its_points_by_their_weights) {
    const auto weight = [](std::size_t i, double t) {
        return std::array<double, 4>{1, 3, 3, 1}[i] * std::pow(t, double(i)) * std::pow(1 - t, 3.0 - double(i));
    };
    for (const double u : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        for (const double v : {0.0, 0.35, 1.0}) {
            vec3 sum(0);
            for (std::size_t k = 0; k < 16; ++k) sum += weight(k % 4, u) * weight(k / 4, v) * bent.points[k];
            // 16 terms of which none is larger than 4, each of some roundings of 1e-16
            EXPECT_LE(glm::distance(pointOf(bent, u, v).position, sum), 1e-14);
        }
    }
}

TEST(BezierPatch, derivatives_are_those_of_the_position) {
    const double h = 1e-5;
    for (const double u : {0.1, 0.5, 0.8}) {
        for (const double v : {0.2, 0.7}) {
            const SurfacePoint at = pointOf(bent, u, v);
            const auto central = [&](double du, double dv) {
                return (pointOf(bent, u + du, v + dv).position - pointOf(bent, u - du, v - dv).position) / (2 * h);
            };
            // A central difference is off by h^2/6 times a third derivative (below 100 here) and by 1e-16/h.
            EXPECT_LE(glm::distance(at.alongU, central(h, 0)), 1e-8);
            EXPECT_LE(glm::distance(at.alongV, central(0, h)), 1e-8);
            EXPECT_LE(std::abs(glm::dot(at.normal, at.alongU)) + std::abs(glm::dot(at.normal, at.alongV)), 1e-14);
            EXPECT_GT(glm::dot(at.normal, glm::cross(at.alongU, at.alongV)), 0);
        }
    }
}

TEST(BezierPatch, normal_at_a_collapsed_edge_is_the_limit) {
    const BezierPatch patch = tip();
    for (const double u : {0.0, 0.3, 1.0}) {
        const SurfacePoint at = pointOf(patch, u, 1);
        EXPECT_EQ(at.alongU, vec3(0));
        double before = 1;
        for (const double away : {1e-2, 1e-4, 1e-6}) {
            const double off = glm::distance(at.normal, pointOf(patch, u, 1 - away).normal);
            EXPECT_LE(off, 20 * away) << u;  // it goes to 0 as the distance does
            EXPECT_LT(off, before);
            before = off;
        }
    }
    // The same edge at v = 0, at u = 0 and at u = 1: the patch with its points in other orders.
    BezierPatch below, left, right;
    for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t i = 0; i < 4; ++i) {
            below.points[4 * (3 - j) + i] = patch.points[4 * j + i];
            left.points[4 * i + (3 - j)] = patch.points[4 * j + i];
            right.points[4 * i + j] = patch.points[4 * j + i];
        }
    }
    const vec3 normal = pointOf(patch, 0.3, 1).normal;
    EXPECT_LE(glm::distance(pointOf(below, 0.3, 0).normal, -normal), 1e-14);
    EXPECT_LE(glm::distance(pointOf(left, 0, 0.3).normal, normal), 1e-14);
    EXPECT_LE(glm::distance(pointOf(right, 1, 0.3).normal, -normal), 1e-14);
}

TEST(BezierPatch, mesh_of_a_flat_patch) {
    const MeshData mesh = tessellated(std::array{overSquare({})}, 5);
    EXPECT_NO_THROW(validate(mesh));
    EXPECT_EQ(mesh.positions.size(), 36U);
    EXPECT_EQ(triangleCount(mesh), 50U);
    double area = 0;
    for (const auto& [a, b, c] : trianglesOf(mesh)) {
        const fvec3 doubled = glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
        area += doubled.y / 2;
    }
    EXPECT_NEAR(area, -9, 1e-5);  // fronts below, as the normals: floats of 3
    for (const fvec3& normal : mesh.normals) EXPECT_EQ(normal, fvec3(0, -1, 0));
    // A collapsed edge loses one of the two triangles of each of its cells.
    EXPECT_EQ(triangleCount(tessellated(std::array{tip()}, 5)), 45U);
}

TEST(BezierPatch, refuses_in_words) {
    const auto expectRefusal = [](const std::function<void()>& call, const std::string& words) {
        EXPECT_NE(refusal(call).find(words), std::string::npos) << refusal(call);
    };
    expectRefusal([] { (void)pointOf(bent, -0.1, 0); }, "u must be 0 to 1");
    expectRefusal([] { (void)pointOf(bent, 0, notANumber); }, "v must be 0 to 1");
    expectRefusal([] { (void)pointOf(BezierPatch{}, 0.5, 0.5); }, "must have a normal");
    BezierPatch large = bent;
    large.points[5] = vec3(1e308, 0, 0);
    expectRefusal([&] { (void)pointOf(large, 0.5, 0.5); }, "must be finite");
    large.points[5] = vec3(1e40, 0, 0);
    expectRefusal([&] { (void)tessellated(std::array{large}, 3); }, "within 1e38");
    expectRefusal([] { (void)tessellated(std::array{bent}, 0); }, "divisions must be 1 to 256");
    expectRefusal([] { (void)tessellated(std::array{bent}, 257); }, "divisions must be 1 to 256");
}
