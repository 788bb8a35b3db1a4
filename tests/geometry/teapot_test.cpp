#include "mv/geometry/teapot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "mv/geometry/check.h"
#include "mv/math/transform.h"

using namespace mv;

namespace {

// Newell's own points, turned from z upwards to y upwards.
vec3 upright(double x, double y, double z) { return {x, z, -y}; }

bool hasPoint(const std::vector<BezierPatch>& patches, const vec3& point) {
    for (const BezierPatch& patch : patches) {
        for (const vec3& one : patch.points) {
            if (glm::distance(one, point) < 1e-12) return true;
        }
    }
    return false;
}

}  // namespace

TEST(Teapot, has_the_points_of_the_original) {
    const auto patches = teapot();
    EXPECT_EQ(patches.size(), 32U);
    // One of each part: rim, body, bottom, handle, spout, lid.
    for (const vec3& point :
         {upright(0.749, -1.3375, 2.53125), upright(-1.12, 2, 0.45), upright(1.425, 0.798, 0),
          upright(-2.65, 0.3, 0.9375), upright(3.525, -0.25, 2.49375), upright(-0.728, 1.3, 2.55)}) {
        EXPECT_TRUE(hasPoint(patches, point)) << point.x << " " << point.y << " " << point.z;
    }
}

// The way that the front must look: away from the middle line of the rim, from the middle of the body, up from the lid, down from
// the bottom; the knob of the lid is narrow below; a tube is symmetrical about z = 0.
vec3 outside(std::size_t patch, const vec3& at) {
    if (patch < 4) return at - 1.45 * glm::normalize(vec3(at.x, 0, at.z)) - vec3(0, 2.4, 0);
    if (patch < 12) return at - vec3(0, 1.2, 0);
    if (patch < 16) return at - vec3(0, 2.95, 0);
    if (patch < 20) return {0, 1, 0};
    if (patch < 24) return {0, -1, 0};
    return {0, 0, at.z};
}

TEST(Teapot, fronts_are_outside) {
    const auto patches = teapot();
    for (std::size_t k = 0; k < patches.size(); ++k) {
        for (const double u : {0.1, 0.5, 0.9}) {
            for (const double v : {0.1, 0.5, 0.9}) {
                if (k >= 30 && v > 0.1) continue;  // the lip of the spout leads inside
                const SurfacePoint at = pointOf(patches[k], u, v);
                EXPECT_GT(glm::dot(at.normal, outside(k, at.position)), 0) << k << ": " << u << " " << v;
            }
        }
    }
}

TEST(Teapot, parts_of_a_round_body_meet_bit_for_bit) {
    const auto patches = teapot();
    // The body with its bottom, closed by a lid of our own: what is left open is the rim's inner edge.
    for (const int divisions : {1, 3, 8, 64}) {
        std::vector<BezierPatch> body(patches.begin(), patches.begin() + 12);
        body.insert(body.end(), patches.begin() + 20, patches.begin() + 24);
        const MeshData mesh = tessellated(body, divisions);
        const auto weld = weldByPosition(mesh.positions);
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (const auto& triangle : trianglesOf(mesh)) {
            for (std::size_t i = 0; i < 3; ++i) {
                const auto a = weld[triangle[i]], b = weld[triangle[(i + 1) % 3]];
                ++edges[{std::min(a, b), std::max(a, b)}];
            }
        }
        int open = 0;
        for (const auto& [edge, uses] : edges) {
            EXPECT_LE(uses, 2);
            if (uses == 1) ++open;
        }
        EXPECT_EQ(open, 4 * divisions) << divisions;
    }
}

TEST(Teapot, the_tip_of_the_lid_points_up) {
    const MeshData mesh = tessellated(teapot(), 16);
    EXPECT_NO_THROW(validate(mesh));
    float highest = 0;
    for (const fvec3& p : mesh.positions) highest = std::max(highest, p.y);
    EXPECT_EQ(highest, 3.15F);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const fvec3 up(0, 1, 0);
        if (mesh.positions[i] == 3.15F * up) {
            EXPECT_EQ(mesh.normals[i], up);
        }
        if (mesh.positions[i] == 0.0F * up) {
            EXPECT_EQ(mesh.normals[i], -up);
        }
    }
}
