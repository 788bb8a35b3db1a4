#include "mv/geometry/topology.h"

#include "../math/support.h"
#include "mv/geometry/shapes.h"

using namespace mv;
using namespace mv::test;

namespace {

TEST(Topology, OfATorusIsRegular) {
    const Topology torus = topologyOf(mv::torus(2, 1, 12, 8));
    EXPECT_EQ(torus.vertices(), 12 * 8);
    EXPECT_EQ(torus.edges, 3 * 12 * 8);
    EXPECT_EQ(torus.faces, 2 * 12 * 8);
    EXPECT_EQ(torus.euler(), 0);
    EXPECT_EQ(torus.irregular(), 0);
    EXPECT_EQ(torus.boundaryEdges, 0);
}

TEST(Topology, OfASphereIsNot) {
    const Topology sphere = topologyOf(mv::sphere(1, 8, 6));
    EXPECT_EQ(sphere.vertices(), 2 + 5 * 8) << "a pole is one vertex, and the seam is none";
    EXPECT_EQ(sphere.faces, 2 * 8 * 5);
    EXPECT_EQ(sphere.euler(), 2);
    EXPECT_EQ(sphere.irregular(), 2 + 2 * 8) << "the poles and the rings beside them";
}

TEST(Topology, OfASheetHasABorder) {
    const Topology sheet = topologyOf(grid(5, 3));
    EXPECT_EQ(sheet.euler(), 1);
    EXPECT_EQ(sheet.irregular(), 0);
    EXPECT_EQ(sheet.boundaryEdges, 2 * (5 + 3));
    EXPECT_EQ(topologyOf(box({0, 0, 0}, {1, 1, 1})).euler(), 2) << "without indices";
}

TEST(Topology, WhatIsMissingIsSixTimesEulersNumber) {
    for (const MeshData& mesh : {mv::torus(2, 1, 7, 5), mv::sphere(1, 9, 4), grid(3, 4), grid(1, 1), colorCube()}) {
        const Topology found = topologyOf(mesh);
        EXPECT_EQ(found.missing(), 6 * found.euler());
    }
}

TEST(Topology, RefusesWhatIsNoSurface) {
    EXPECT_EQ(refusal([] { topologyOf(wireCube()); }), "topologyOf: must be given separate triangles");
    MeshData fin{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}};
    fin.indices = {0, 1, 2, 0, 1, 3, 0, 1, 4};
    EXPECT_EQ(refusal([&] { topologyOf(fin); }), "topologyOf: must have two faces at most along an edge, 3");
}

}  // namespace
