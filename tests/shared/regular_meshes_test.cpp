#include "gpu-stages/regular_meshes.h"

#include "../math/support.h"
#include "gpu-stages/control_net.h"
#include "mv/geometry/check.h"

using namespace mv;
using namespace mv::test;

namespace {

TEST(RegularMeshes, AreMeshesWithinTheirPane) {
    for (const RegularMesh& body : regularMeshes(5)) {
        EXPECT_NO_THROW(validate(body.mesh)) << body.name;
        for (const fvec3& p : body.mesh.positions) EXPECT_LE(p.x * p.x + p.y * p.y + p.z * p.z, 3) << body.name;
        EXPECT_EQ(long(body.irregular.positions.size()), body.topology.irregular());
        EXPECT_EQ(body.irregular.normals.size(), body.irregular.positions.size());
    }
    EXPECT_EQ(refusal([] { regularMeshes(2); }), "regularMeshes: must have 3 .. 64 cells, 2");
    EXPECT_EQ(refusal([] { regularMeshes(65); }), "regularMeshes: must have 3 .. 64 cells, 65");
}

// Rolled up without a seam: as many vertices round as there are cells.
TEST(RegularMeshes, HaveATubeWithoutASeam) {
    for (const int cells : {3, 7, 12, 64}) {
        const RegularMesh tube = regularMeshes(cells)[1];
        EXPECT_EQ(tube.topology.vertices(), cells * (cells + 1));
        EXPECT_EQ(tube.topology.boundaryEdges, 2 * cells);
    }
}

TEST(ControlNet, HasItsNormalsUpwards) {
    const MeshData net = controlNet();
    ASSERT_EQ(net.positions.size(), 16U);
    EXPECT_EQ(net.indices.size(), 3U * 18);
    for (const fvec3& normal : net.normals) EXPECT_GT(normal.y, 0);
    EXPECT_EQ(controlPoints().positions, net.positions);
    EXPECT_TRUE(controlPoints().indices.empty());
}

}  // namespace
