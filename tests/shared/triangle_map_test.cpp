#include "texture-map/triangle_map.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "mv/error.h"

using namespace mv;

namespace {

const TexturedTriangle tilted{{vec3(0.3, -1, 2), vec3(2, 0.5, 1), vec3(-0.4, 1, 1.5)},
                              {vec2(0.1, 0.2), vec2(0.9, 0), vec2(0.4, 1)}};

}  // namespace

TEST(TriangleMap, both_agree_on_the_plane) {
    const PlaneMap matrix = mapByMatrix(tilted), edges = mapByEdges(tilted);
    for (const vec3& weights : {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), vec3(0.2, 0.5, 0.3), vec3(-1, 3, -1)}) {
        const auto& [p, t] = tilted;
        const vec3 point = weights.x * p[0] + weights.y * p[1] + weights.z * p[2];
        const vec2 right = weights.x * t[0] + weights.y * t[1] + weights.z * t[2];
        EXPECT_LT(glm::distance(matrix.at(point), right), 1e-13);
        EXPECT_LT(glm::distance(edges.at(point), right), 1e-13);
    }
    EXPECT_LT(errorInFloats(edges, tilted), 1e-6);
}

TEST(TriangleMap, the_square_in_the_plane_z_0) {
    const TexturedTriangle first{{vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 1, 0)}, {vec2(0, 0), vec2(1, 0), vec2(0, 1)}};
    EXPECT_THROW((void)mapByMatrix(first), Error);
    EXPECT_EQ(mapByEdges(first).at({0.25, 0.5, 0}), vec2(0.25, 0.5));
}

TEST(TriangleMap, refuses) {
    TexturedTriangle line = tilted;
    line.texture = {vec2(0, 0), vec2(1, 1), vec2(2, 2)};
    EXPECT_THROW((void)pointFromTexture(line), Error);
    EXPECT_EQ(mapByEdges(line).at(line.points[0]), vec2(0, 0));
    line.points[2] = line.points[1];
    EXPECT_THROW((void)mapByEdges(line), Error);
}
