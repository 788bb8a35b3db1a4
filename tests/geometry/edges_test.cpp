#include "mv/geometry/edges.h"

#include <glm/geometric.hpp>

#include "../math/support.h"
#include "mv/geometry/shapes.h"

using namespace mv;
using namespace mv::test;

namespace {

std::size_t edgeCount(const MeshData& mesh) { return mesh.positions.size() / 2; }

TEST(Edges, OfABoxAreItsTwelveAndNoDiagonal) {
    const MeshData edges = edgesOf(box({-1, 0, 2}, {3, 1, 5}));
    EXPECT_EQ(edges.primitive, Primitive::lines);
    EXPECT_EQ(edgeCount(edges), 12U);
    for (std::size_t i = 0; i < edges.positions.size(); i += 2) {
        const fvec3 along = edges.positions[i + 1] - edges.positions[i];
        int axes = 0;
        for (int axis = 0; axis < 3; ++axis) axes += along[axis] != 0 ? 1 : 0;
        EXPECT_EQ(axes, 1);
    }
}

TEST(Edges, AreWhereTheSurfaceTurnsByMoreThanTheCrease) {
    EXPECT_EQ(edgeCount(edgesOf(sphere(1, 96, 48))), 0U);
    // A profile with one edge, a cone's foot: 32 parts of a circle, and the tip is a point
    const MeshData cone = lathe(std::vector<vec2>{{0, 0}, {1, 0}, {0, 1}}, 32);
    EXPECT_EQ(edgeCount(edgesOf(cone)), 32U);
    EXPECT_EQ(edgeCount(edgesOf(cone, 136)), 0U);  // its two faces meet at 135 degrees or less
    EXPECT_EQ(edgeCount(edgesOf(sphere(1, 8, 4), 1)), 8U * 4 + 8 * 3);
}

TEST(Edges, AreWhereTheSurfaceEnds) {
    EXPECT_EQ(edgeCount(edgesOf(square())), 4U);
    EXPECT_EQ(edgeCount(edgesOf(grid(5, 3))), 2U * (5 + 3));
}

TEST(Edges, RefuseACreaseThatIsNone) {
    EXPECT_EQ(refusal([] { edgesOf(square(), -1); }), "edgesOf: crease must be 0 .. 180 deg, -1");
    EXPECT_EQ(refusal([] { edgesOf(square(), notANumber); }), "edgesOf: crease must be 0 .. 180 deg, nan");
}

}  // namespace
