#include "mv/geometry/shapes.h"

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "../math/support.h"
#include "mv/geometry/check.h"

using namespace mv;
using namespace mv::test;

namespace {

// Profiles for lathe()
const std::vector<vec2> cylinder{{0, 0}, {1, 0}, {1, 2}, {0, 2}};
const std::vector<vec2> doubleCone{{0, -1}, {1, 0}, {0, 1}};
const std::vector<vec2> bowl{{0, 0}, {1, 0.2}, {1.5, 1}, {1.4, 1}, {0.9, 0.3}, {0, 0.1}};

struct NamedMesh {
    std::string name;
    MeshData mesh;
};

std::vector<NamedMesh> solids() {
    return {{"colorCube", colorCube()},
            {"box", box({-1, 2, 3}, {4, 2.5, 10})},
            {"smallest sphere", sphere(1, 3, 2)},
            {"sphere", sphere(2.5, 32, 16)},
            {"tiny sphere", sphere(1e-37, 8, 5)},
            {"uneven sphere", sphere(1e6, 7, 201)},
            {"torus", torus(2, 0.5, 24, 12)},
            {"smallest torus", torus(1, 0.3, 3, 3)},
            {"tiny torus", torus(3e-37, 1e-37, 9, 7)},
            {"thin torus", torus(1e6, 1, 64, 5)},
            {"cylinder", lathe(cylinder, 16)},
            {"double cone", lathe(doubleCone, 3)},
            {"smooth cone", lathe(doubleCone, 5, 180)},
            {"bowl", lathe(bowl, 24)}};
}

std::vector<NamedMesh> shapes() {
    auto all = solids();
    all.push_back({"wireCube", wireCube()});
    all.push_back({"square", square()});
    all.push_back({"axes", axes(1.5)});
    all.push_back({"ringStrip", ringStrip(90, 110, 100)});
    all.push_back({"disc", ringStrip(0, 1, 3)});
    all.push_back({"grid", grid(4, 3, 10, 20)});
    return all;
}

// Unlike ==, tells 0 from -0.
bool sameBits(const fvec3& a, const fvec3& b) {
    for (int i = 0; i < 3; ++i) {
        if (std::bit_cast<std::uint32_t>(a[i]) != std::bit_cast<std::uint32_t>(b[i])) return false;
    }
    return true;
}

// ---- properties of all

TEST(Shapes, AreWellFormed) {
    for (const auto& [name, mesh] : shapes()) EXPECT_NO_THROW(validate(mesh)) << name;
}

TEST(Shapes, SolidsAreClosedAndFaceOutwards) {
    for (const auto& [name, mesh] : solids()) {
        EXPECT_TRUE(isClosed(mesh)) << name;
        EXPECT_GT(signedVolume(mesh), 0) << name;
    }
}

TEST(Shapes, NormalsAreUnitAndOnTheSideOfTheFace) {
    int checked = 0;
    for (const auto& [name, mesh] : shapes()) {
        for (const fvec3& normal : mesh.normals) EXPECT_NEAR(glm::length(vec3(normal)), 1, 2e-7) << name;  // float
        if (mesh.normals.empty()) continue;
        for (const auto& [i, j, k] : trianglesOf(mesh)) {
            const vec3 a(mesh.positions[i]);
            // Divided by its size: the cross product of sides of 1e-37 would vanish even in double at 1e-200.
            const vec3 b = vec3(mesh.positions[j]) - a;
            const vec3 c = vec3(mesh.positions[k]) - a;
            const vec3 face = glm::normalize(glm::cross(b / glm::length(b), c / glm::length(c)));
            for (const std::uint32_t corner : {i, j, k}) {
                EXPECT_GT(glm::dot(face, vec3(mesh.normals[corner])), 0) << name;
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 1000);
}

// u runs to the right and v upwards seen from outside, so that no picture is mirrored.
TEST(Shapes, PicturesAreNotMirrored) {
    int checked = 0;
    for (const auto& [name, mesh] : shapes()) {
        if (mesh.texCoords.empty()) continue;
        for (const auto& [i, j, k] : trianglesOf(mesh)) {
            const vec2 a(mesh.texCoords[i]);
            const vec2 b = vec2(mesh.texCoords[j]) - a;
            const vec2 c = vec2(mesh.texCoords[k]) - a;
            EXPECT_GT(b.x * c.y - b.y * c.x, 0) << name;
            ++checked;
        }
        for (const fvec2& t : mesh.texCoords) EXPECT_TRUE(t.x >= 0 && t.x <= 1 && t.y >= 0 && t.y <= 1) << name;
    }
    EXPECT_GT(checked, 300);
}

// ---- each shape's numbers

TEST(ColorCube, IsTheCourses) {
    const MeshData cube = colorCube();
    ASSERT_EQ(cube.positions.size(), 36u);
    EXPECT_EQ(triangleCount(cube), 12u);
    EXPECT_EQ(signedVolume(cube), 1);
    EXPECT_TRUE(cube.normals.empty() && cube.texCoords.empty() && cube.indices.empty());

    // In the order of the faces: +z red, +x yellow, -y green, +y cyan, -z blue, -x magenta.
    const std::vector<std::pair<fvec3, fvec4>> faces{{{0, 0, 1}, {1, 0, 0, 1}},  {{1, 0, 0}, {1, 1, 0, 1}},
                                                     {{0, -1, 0}, {0, 1, 0, 1}}, {{0, 1, 0}, {0, 1, 1, 1}},
                                                     {{0, 0, -1}, {0, 0, 1, 1}}, {{-1, 0, 0}, {1, 0, 1, 1}}};
    for (std::size_t i = 0; i < 36; ++i) {
        EXPECT_EQ(cube.colors[i], faces[i / 6].second);
        EXPECT_EQ(glm::dot(cube.positions[i], faces[i / 6].first), 0.5f);
    }
    // The first face vertex by vertex: quad(1, 0, 3, 2), as the triangles 1 0 3 and 1 3 2.
    const std::vector<fvec3> first{{-0.5f, 0.5f, 0.5f}, {-0.5f, -0.5f, 0.5f}, {0.5f, -0.5f, 0.5f},
                                   {-0.5f, 0.5f, 0.5f}, {0.5f, -0.5f, 0.5f},  {0.5f, 0.5f, 0.5f}};
    EXPECT_TRUE(std::equal(first.begin(), first.end(), cube.positions.begin()));
    // And the first vertex of each face, by which the order of its corners is fixed: v1 v2 v3 v6 v4 v5.
    const std::vector<fvec3> starts{{-0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f},    {0.5f, -0.5f, 0.5f},
                                    {0.5f, 0.5f, -0.5f}, {-0.5f, -0.5f, -0.5f}, {-0.5f, 0.5f, -0.5f}};
    for (std::size_t face = 0; face < 6; ++face) EXPECT_EQ(cube.positions[6 * face], starts[face]);
}

TEST(WireCube, IsTheTwelveEdgesInTheCoursesOrder) {
    const MeshData wire = wireCube();
    ASSERT_EQ(wire.positions.size(), 24u);
    EXPECT_EQ(wire.primitive, Primitive::lines);
    EXPECT_EQ(triangleCount(wire), 0u);
    const std::vector<fvec3> v{{-0.5f, -0.5f, 0.5f},  {-0.5f, 0.5f, 0.5f},  {0.5f, 0.5f, 0.5f},  {0.5f, -0.5f, 0.5f},
                               {-0.5f, -0.5f, -0.5f}, {-0.5f, 0.5f, -0.5f}, {0.5f, 0.5f, -0.5f}, {0.5f, -0.5f, -0.5f}};
    const std::string ends = "011223304556677404152637";
    for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(wire.positions[i], v[static_cast<std::size_t>(ends[i] - '0')]) << i;
}

TEST(Square, LiesInTheGroundAndFacesUp) {
    const MeshData s = square();
    ASSERT_EQ(s.positions.size(), 6u);
    EXPECT_EQ(triangleCount(s), 2u);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(s.positions[i], fvec3(s.texCoords[i].x - 0.5f, 0, 0.5f - s.texCoords[i].y));
        EXPECT_EQ(s.normals[i], fvec3(0, 1, 0));
    }
    EXPECT_FALSE(isClosed(s));
}

TEST(Axes, AreRedGreenAndBlue) {
    const MeshData a = axes(1.5);
    ASSERT_EQ(a.positions.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        fvec3 axis(0);
        axis[static_cast<int>(i / 2)] = 1;
        EXPECT_EQ(a.positions[i], (i % 2 == 0 ? -1.5f : 1.5f) * axis);
        EXPECT_EQ(a.colors[i], fvec4(axis, 1));
    }
    EXPECT_EQ(refusal([] { axes(0); }), "axes: halfLength must be greater than 0 and at most 1e+38, 0");
    EXPECT_EQ(refusal([] { axes(notANumber); }), "axes: halfLength must be greater than 0 and at most 1e+38, nan");
}

TEST(RingStrip, IsTheCoursesTrack) {
    const MeshData track = ringStrip(90, 110, 100);
    ASSERT_EQ(track.positions.size(), 202u);
    EXPECT_EQ(triangleCount(track), 200u);
    for (std::size_t i = 0; i <= 100; ++i) {
        const double theta = radians(3.6 * static_cast<double>(i));
        const vec2 direction(std::cos(theta), std::sin(theta));
        const vec3 outer(track.positions[2 * i]);
        const vec3 inner(track.positions[2 * i + 1]);
        EXPECT_LT(glm::length(outer - vec3(110.0 * direction, 0)), 1e-5);  // floats of size 110: 4e-6
        EXPECT_LT(glm::length(inner - vec3(90.0 * direction, 0)), 1e-5);
    }
    EXPECT_TRUE(sameBits(track.positions[0], track.positions[200]));
    EXPECT_TRUE(sameBits(track.positions[1], track.positions[201]));

    // The trap of its page: fronts face -z.
    double area = 0;
    for (const auto& [i, j, k] : trianglesOf(track)) {
        const vec3 a(track.positions[i]);
        const double z = glm::cross(vec3(track.positions[j]) - a, vec3(track.positions[k]) - a).z;
        EXPECT_LT(z, 0);
        area -= z / 2;
    }
    // Chords instead of arcs: a 100-gon has sin(3.6 deg) / rad(3.6 deg) of the circle's area.
    EXPECT_NEAR(area, pi * (110 * 110 - 90 * 90) * std::sin(radians(3.6)) / radians(3.6), 0.01);
    EXPECT_EQ(refusal([] { ringStrip(-1, 1, 8); }), "ringStrip: inner must be at least 0, -1");
    EXPECT_EQ(refusal([] { ringStrip(2, 1, 8); }),
              "ringStrip: outer must be greater than inner and at most 1e+38, inner 2, outer 1");
    EXPECT_EQ(refusal([] { ringStrip(1, 2, 2); }), "ringStrip: segments must be 3 to 4096, 2");
}

TEST(Box, FillsItsBoundsAndMatchesTheColorCube) {
    const MeshData b = box({-1, 2, 3}, {4, 2.5, 10});
    ASSERT_EQ(b.positions.size(), 36u);
    EXPECT_EQ(signedVolume(b), 5 * 0.5 * 7);
    EXPECT_EQ(box(vec3(-0.5), vec3(0.5)).positions, colorCube().positions);
    for (std::size_t i = 0; i < 36; ++i) {
        // Upright on the sides: v = 1 at the top.
        if (b.normals[i].y == 0) {
            EXPECT_EQ(b.texCoords[i].y, b.positions[i].y == 2.5f ? 1.0f : 0.0f);
        }
    }
    EXPECT_EQ(refusal([] {
                  box({0, 0, 0}, {1, 0, 1});
              }),
              "box: lo must be below hi in each coordinate, as floats, (0, 0, 0) and (1, 0, 1)");
    EXPECT_NE(refusal([] { box({1e8, 0, 0}, {1e8 + 1, 1, 1}); }), "nothing was refused");
    EXPECT_EQ(refusal([] { box({0, notANumber, 0}, {1, 1, 1}); }), "box: lo must be finite, (0, nan, 0)");
    EXPECT_EQ(refusal([] {
                  box({0, 0, 0}, {1, 1, 1e39});
              }),
              "box: lo and hi must lie within 1e+38, (0, 0, 0) and (1, 1, 1e+39)");
}

TEST(Sphere, HasItsCountsAndItsSeamAndPolesAreExact) {
    const int slices = 12;
    const int stacks = 6;
    const MeshData s = sphere(2, slices, stacks);
    ASSERT_EQ(s.positions.size(), 2u * 12 + 5u * 13);
    EXPECT_EQ(triangleCount(s), 2u * 12 * 5);
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_TRUE(sameBits(s.positions[i], {0, -2, 0}));
        EXPECT_TRUE(sameBits(s.positions[s.positions.size() - 1 - i], {0, 2, 0}));
    }
    for (std::size_t row = 0; row < 5; ++row) {
        const std::size_t first = 12 + row * 13;
        EXPECT_TRUE(sameBits(s.positions[first], s.positions[first + 12]));
        EXPECT_EQ(s.texCoords[first].x, 0);
        EXPECT_EQ(s.texCoords[first + 12].x, 1);
    }
    for (std::size_t i = 0; i < s.positions.size(); ++i) {
        EXPECT_NEAR(glm::length(vec3(s.positions[i])), 2, 5e-7);  // floats of size 2
        EXPECT_LT(glm::length(vec3(s.positions[i]) / 2.0 - vec3(s.normals[i])), 2e-7);
    }
    // u = 0 at +x and, a quarter of the way east, -z.
    const std::size_t equator = 12 + 2 * 13;
    EXPECT_LT(glm::length(vec3(s.positions[equator]) - vec3(2, 0, 0)), 5e-7);
    EXPECT_LT(glm::length(vec3(s.positions[equator + 3]) - vec3(0, 0, -2)), 5e-7);
}

TEST(Sphere, ApproachesTheBallFromInside) {
    const double ball = 4.0 / 3 * pi;
    double previous = HUGE_VAL;
    for (const int n : {8, 16, 32, 64}) {
        const double missing = 1 - signedVolume(sphere(1, 2 * n, n)) / ball;
        EXPECT_GT(missing, 0);
        EXPECT_LT(missing, previous / 3.5);  // the error falls by 4 when n doubles
        previous = missing;
    }
}

TEST(Sphere, RefusalsSayWhatWouldHaveBeenRight) {
    EXPECT_EQ(refusal([] { sphere(0, 8, 8); }), "sphere: radius must be 1e-37 to 1e+38, 0");
    EXPECT_EQ(refusal([] { sphere(notANumber, 8, 8); }), "sphere: radius must be 1e-37 to 1e+38, nan");
    EXPECT_EQ(refusal([] { sphere(1, 2, 8); }), "sphere: slices must be 3 to 4096, 2");
    EXPECT_EQ(refusal([] { sphere(1, 8, 1); }), "sphere: stacks must be 2 to 4096, 1");
    EXPECT_EQ(refusal([] { sphere(1, 8, 5000); }), "sphere: stacks must be 2 to 4096, 5000");
}

TEST(Torus, HasItsCountsAndItsSeamsAreExact) {
    const MeshData t = torus(2, 0.5, 12, 6);
    ASSERT_EQ(t.positions.size(), 13u * 7);
    EXPECT_EQ(triangleCount(t), 2u * 12 * 6);
    for (std::size_t row = 0; row < 7; ++row) EXPECT_TRUE(sameBits(t.positions[13 * row], t.positions[13 * row + 12]));
    for (std::size_t i = 0; i < 13; ++i) EXPECT_TRUE(sameBits(t.positions[i], t.positions[6 * 13 + i]));
    for (std::size_t i = 0; i < t.positions.size(); ++i) {
        const vec3 p(t.positions[i]);
        const vec3 middle = 2.0 * glm::normalize(vec3(p.x, 0, p.z));
        EXPECT_NEAR(glm::length(p - middle), 0.5, 1e-6);  // floats of size 2.5: 2e-7 in each coordinate
        EXPECT_LT(glm::length((p - middle) / 0.5 - vec3(t.normals[i])), 2e-6);
    }
    // From the outermost line upwards: a quarter round the tube is the top, half is the hole.
    EXPECT_LT(glm::length(vec3(torus(2, 0.5, 4, 4).positions[5 * 1]) - vec3(2, 0.5, 0)), 5e-7);
    EXPECT_LT(glm::length(vec3(torus(2, 0.5, 4, 4).positions[5 * 2]) - vec3(1.5, 0, 0)), 5e-7);
}

TEST(Torus, ApproachesPappusVolume) {
    const double whole = 2 * pi * pi * 2 * 0.5 * 0.5;
    double previous = HUGE_VAL;
    for (const int n : {8, 16, 32, 64}) {
        const double missing = 1 - signedVolume(torus(2, 0.5, 2 * n, n)) / whole;
        EXPECT_GT(missing, 0);
        EXPECT_LT(missing, previous / 3.5);  // the error falls by 4 when n doubles
        previous = missing;
    }
}

TEST(Torus, RefusalsSayWhatWouldHaveBeenRight) {
    EXPECT_EQ(refusal([] { torus(1, 0, 8, 8); }), "torus: minor must be 1e-37 to 1e+38, 0");
    EXPECT_EQ(refusal([] { torus(1, 2, 8, 8); }), "torus: major must be 2 to 1e+38, 1");
    EXPECT_NE(refusal([] { torus(1, 1, 8, 8); }), "nothing was refused");
    EXPECT_NE(refusal([] { torus(1e9, 1, 8, 8); }), "nothing was refused");
    EXPECT_EQ(refusal([] { torus(notANumber, 1, 8, 8); }), "torus: major must be 1 to 1e+38, nan");
    EXPECT_EQ(refusal([] { torus(2, 1, 8, 2); }), "torus: stacks must be 3 to 4096, 2");
}

TEST(Lathe, TurnsAProfileIntoASolidOfGuldinsVolume) {
    // Chords instead of arcs: an n-gon has n/2 sin(2 pi/n) of the circle's pi.
    const int n = 16;
    const double part = n / 2.0 * std::sin(2 * pi / n) / pi;
    EXPECT_NEAR(signedVolume(lathe(cylinder, n)), part * 2 * pi, 1e-6);  // floats of size 2
    EXPECT_NEAR(signedVolume(lathe(doubleCone, n)), part * 2 * pi / 3, 1e-6);
    // A sphere's profile gives the sphere.
    std::vector<vec2> half;
    for (int i = 0; i <= 12; ++i) half.emplace_back(i % 12 == 0 ? 0 : std::sin(pi * i / 12), -std::cos(pi * i / 12));
    EXPECT_NEAR(signedVolume(lathe(half, 24)), signedVolume(sphere(1, 24, 12)), 1e-6);
}

TEST(Lathe, IsSmoothExceptAtEdges) {
    // A cylinder's turns are 90 degrees: every row of the profile's inner points is double, the poles are level.
    const MeshData edged = lathe(cylinder, 8);
    ASSERT_EQ(edged.positions.size(), 8u + 2 * 9 + 2 * 9 + 8);
    int sides = 0;
    for (const fvec3& normal : edged.normals) {
        EXPECT_TRUE(normal.y == 0 || std::abs(normal.y) == 1) << normal.y;
        sides += normal.y == 0 ? 1 : 0;
    }
    EXPECT_EQ(sides, 2 * 9);
    // With a crease of 90 degrees there is no edge left, and the normals of the corners point half way between.
    const MeshData smooth = lathe(cylinder, 8, 90);
    ASSERT_EQ(smooth.positions.size(), 8u + 9 + 9 + 8);
    EXPECT_NEAR(smooth.normals[8].y, -std::sqrt(0.5), 1e-6);
    // v runs by length: 1, 2 and 1.
    EXPECT_EQ(smooth.texCoords[8].y, 0.25f);
    EXPECT_EQ(smooth.texCoords[8 + 9].y, 0.75f);
    // The tip of a cone is sharp: its normals lean outwards. At 180 degrees it is rounded off.
    EXPECT_NEAR(lathe(doubleCone, 8).normals.back().y, std::sqrt(0.5), 1e-6);
    EXPECT_EQ(lathe(doubleCone, 8, 180).normals.back().y, 1);
}

TEST(Lathe, RefusalsSayWhatWouldHaveBeenRight) {
    const auto turned = [](std::vector<vec2> profile) { return refusal([&] { lathe(profile, 8); }); };
    EXPECT_EQ(turned({{0, 0}, {0, 1}}), "lathe: the profile must have at least 3 points, 2");
    EXPECT_EQ(turned({{0.5, 0}, {1, 1}, {0, 2}}),
              "lathe: point 0 of the profile, an end, must lie on the axis, (0.5, 0)");
    EXPECT_EQ(turned({{0, 0}, {0, 1}, {0, 2}}),
              "lathe: the radius of point 1 of the profile must be 1e-37 to 1e+38, 0");
    EXPECT_EQ(turned({{0, 0}, {1, 1}, {1, 1 + 1e-9}, {0, 2}}),
              "lathe: point 2 of the profile must differ from the one before, as floats, (1, 1.000000001)");
    EXPECT_EQ(turned({{0, 2}, {1, 1}, {0, 0}}), "lathe: the profile must have the outside on its right");
    EXPECT_EQ(turned({{0, 0}, {1, notANumber}, {0, 2}}), "lathe: point 1 of the profile must be finite, (1, nan)");
    EXPECT_EQ(turned({{0, 0}, {1, 2e38}, {0, 2}}), "lathe: point 1 of the profile must lie within 1e+38, (1, 2e+38)");
    EXPECT_EQ(refusal([] { lathe(cylinder, 2); }), "lathe: slices must be 3 to 4096, 2");
    EXPECT_EQ(refusal([] { lathe(cylinder, 8, 181); }), "lathe: crease must be 0 to 180 degrees, 181");
}

TEST(Grid, HasItsCountsAndSizes) {
    const MeshData g = grid(4, 3, 10, 20);
    ASSERT_EQ(g.positions.size(), 5u * 4);
    EXPECT_EQ(triangleCount(g), 2u * 4 * 3);
    EXPECT_EQ(g.positions.front(), fvec3(-5, 0, 10));
    EXPECT_EQ(g.positions.back(), fvec3(5, 0, -10));
    EXPECT_EQ(g.texCoords.front(), fvec2(0, 0));
    EXPECT_EQ(g.texCoords.back(), fvec2(1, 1));
    double area = 0;
    for (const auto& [i, j, k] : trianglesOf(g)) {
        const vec3 a(g.positions[i]);
        area += glm::cross(vec3(g.positions[j]) - a, vec3(g.positions[k]) - a).y / 2;
    }
    EXPECT_NEAR(area, 200, 1e-4);  // floats of size 10
    EXPECT_EQ(refusal([] { grid(0, 1); }), "grid: cellsX must be 1 to 4096, 0");
    EXPECT_EQ(refusal([] { grid(1, 1, -1, 1); }), "grid: sizeX must be 1e-30 to 1e+38, -1");
}

}  // namespace
