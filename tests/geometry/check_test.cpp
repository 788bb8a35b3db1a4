#include "mv/geometry/check.h"

#include <array>

#include "../math/support.h"
#include "mv/geometry/shapes.h"

using namespace mv;
using namespace mv::test;

namespace {

MeshData oneTriangle() {
    MeshData mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    return mesh;
}

TEST(Validate, NamesWhatIsWrong) {
    EXPECT_EQ(refusal([] { validate(oneTriangle()); }), "nothing was refused");
    EXPECT_EQ(refusal([] { validate(MeshData{}); }), "mesh: there must be at least 1 position, 0");

    const auto broken = [](const auto& change) {
        MeshData mesh = oneTriangle();
        change(mesh);
        return refusal([&] { validate(mesh); });
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(broken([](MeshData& m) {
                  m.normals = {{0, 0, 1}};
              }),
              "mesh: normals must be absent or as many as positions, 3, 1");
    EXPECT_EQ(broken([](MeshData& m) { m.colors.resize(4); }),
              "mesh: colors must be absent or as many as positions, 3, 4");
    EXPECT_EQ(broken([](MeshData& m) { m.texCoords.resize(2); }),
              "mesh: texCoords must be absent or as many as positions, 3, 2");
    EXPECT_EQ(broken([&](MeshData& m) { m.positions[1].y = nan; }), "mesh: positions[1] must be finite, nan");
    EXPECT_EQ(broken([](MeshData& m) { m.indices = {0, 1, 3}; }), "mesh: indices[2] must be less than 3, 3");
    EXPECT_EQ(broken([](MeshData& m) {
                  m.indices = {0, 1, 2, 0};
              }),
              "mesh: triangles need a multiple of 3 vertices, 4");
    EXPECT_EQ(broken([](MeshData& m) { m.primitive = Primitive::lines; }),
              "mesh: lines need a multiple of 2 vertices, 3");
    EXPECT_EQ(broken([](MeshData& m) {
                  m.primitive = Primitive::triangleFan;
                  m.indices = {0, 1};
              }),
              "mesh: a strip or fan needs at least 3 vertices, 2");
    EXPECT_EQ(broken([](MeshData& m) { m.primitive = Primitive::points; }), "nothing was refused");
}

TEST(TrianglesOf, FollowGlsOrder) {
    MeshData mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}};
    mesh.primitive = Primitive::triangleStrip;
    using Triangles = std::vector<std::array<std::uint32_t, 3>>;
    EXPECT_EQ(trianglesOf(mesh), (Triangles{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}));
    mesh.primitive = Primitive::triangleFan;
    EXPECT_EQ(trianglesOf(mesh), (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
    mesh.indices = {4, 3, 2};
    EXPECT_EQ(trianglesOf(mesh), (Triangles{{4, 3, 2}}));
    mesh.primitive = Primitive::points;
    EXPECT_TRUE(trianglesOf(mesh).empty());
}

TEST(IsClosed, FindsAMissingATurnedAndAMovedTriangle) {
    EXPECT_TRUE(isClosed(colorCube()));
    EXPECT_FALSE(isClosed(oneTriangle()));
    EXPECT_FALSE(isClosed(wireCube()));

    MeshData missing = colorCube();
    missing.positions.resize(33);
    missing.colors.resize(33);
    EXPECT_FALSE(isClosed(missing));

    MeshData turned = colorCube();
    std::swap(turned.positions[0], turned.positions[1]);
    EXPECT_FALSE(isClosed(turned));

    MeshData moved = sphere(1, 8, 5);
    float& x = moved.positions[8].x;  // one end of a seam, by one step of float: a gap is a gap
    x = std::nextafter(x, 2.0f);
    EXPECT_FALSE(isClosed(moved));
}

TEST(IsClosed, CountsMinusZeroAsZero) {
    MeshData mesh = box({0, 0, 0}, {1, 1, 1});
    for (std::size_t i = 0; i < 6; ++i) {  // one face's zeros only
        if (mesh.positions[i].x == 0) mesh.positions[i].x = -0.0f;
    }
    EXPECT_TRUE(isClosed(mesh));
}

TEST(SignedVolume, ChangesSignWithTheWinding) {
    MeshData inside = box({10, 10, 10}, {12, 13, 14});
    EXPECT_EQ(signedVolume(inside), 24);
    for (std::size_t i = 0; i < inside.positions.size(); i += 3)
        std::swap(inside.positions[i], inside.positions[i + 1]);
    EXPECT_TRUE(isClosed(inside));
    EXPECT_EQ(signedVolume(inside), -24);
    EXPECT_EQ(refusal([] { signedVolume(square()); }), "signedVolume: the mesh must be closed");
}

TEST(SignedVolume, KeepsASmallSolidFarAway) {
    const fvec3 offset(1e6f, -3e6f, 2e6f);
    MeshData far = sphere(100, 16, 9);
    MeshData near = far;
    for (std::size_t i = 0; i < far.positions.size(); ++i) {
        far.positions[i] += offset;                     // rounded: floats are 1/4 apart there
        near.positions[i] = far.positions[i] - offset;  // exact
    }
    // The same solid; seen from the far origin the terms would be 1e14 with a rounding of 0.01.
    EXPECT_NEAR(signedVolume(far) / signedVolume(near), 1, 1e-14);
}

}  // namespace
