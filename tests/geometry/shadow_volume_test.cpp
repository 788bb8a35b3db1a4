#include "mv/geometry/shadow_volume.h"

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "../math/support.h"
#include "mv/geometry/check.h"
#include "mv/geometry/shapes.h"

using namespace mv;
using namespace mv::test;

namespace {

// How often each directed edge of the volume is run, ends compared as numbers: all at infinity in one place are one.
bool runsEachEdgeAsOftenBackwards(const ShadowVolume& volume) {
    using Point = std::array<float, 4>;
    std::map<std::array<Point, 2>, int> balance;
    const auto point = [&](std::uint32_t i) {
        const fvec4& p = volume.positions.at(i);
        return Point{p.x, p.y, p.z, p.w};
    };
    for (std::size_t t = 0; t < volume.indices.size(); t += 3) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Point from = point(volume.indices[t + i]), to = point(volume.indices[t + (i + 1) % 3]);
            if (from == to) return false;
            ++balance[{from, to}];
            --balance[{to, from}];
        }
    }
    for (const auto& [edge, sum] : balance) {
        if (sum != 0) return false;
    }
    return !volume.indices.empty();
}

// The volume's winding number round a point by its solid angle, in units of a full sphere, without any of the code under
// test: Van Oosterom and Strackee's formula, with points at infinity as directions.
double windingByAngle(const ShadowVolume& volume, const vec3& point) {
    double sum = 0;
    for (std::size_t t = 0; t < volume.indices.size(); t += 3) {
        std::array<vec3, 3> r;
        for (std::size_t i = 0; i < 3; ++i) {
            const vec4 p(volume.positions[volume.indices[t + i]]);
            r[i] = glm::normalize(p.w == 0 ? vec3(p) : vec3(p) - point);
        }
        const double triple = glm::dot(r[0], glm::cross(r[1], r[2]));
        sum += 2 * std::atan2(triple, 1 + glm::dot(r[0], r[1]) + glm::dot(r[1], r[2]) + glm::dot(r[2], r[0]));
    }
    return sum / (4 * pi);
}

const std::array<MeshData, 4> casters() {
    return {box({-1, -1, -1}, {1, 1, 1}), colorCube(), sphere(1, 24, 12), torus(1, 0.4, 24, 12)};
}

const vec4 above(0.3, 5, 0.4, 1), sun(0.3, 5, 0.4, 0);

}  // namespace

TEST(ClosedMesh, JoinsWhatTheSeamsRepeat) {
    // V - E + F is 2 for a ball, 0 for a ring, whatever its vertices are split into.
    const auto euler = [](const ClosedMesh& mesh) {
        return int(mesh.positions().size()) - int(mesh.edges().size()) + int(mesh.triangles().size());
    };
    for (const MeshData& mesh : {colorCube(), box({0, 0, 0}, {1, 2, 3}), sphere(2, 16, 8)}) {
        const ClosedMesh closed(mesh);
        EXPECT_EQ(euler(closed), 2);
        EXPECT_EQ(2 * closed.edges().size(), 3 * closed.triangles().size());
        EXPECT_EQ(closed.triangles().size(), triangleCount(mesh));
    }
    EXPECT_EQ(euler(ClosedMesh(torus(1, 0.3, 16, 8))), 0);
    EXPECT_EQ(ClosedMesh(colorCube()).positions().size(), 8U);
}

TEST(ClosedMesh, RefusesWhatHasNoInside) {
    MeshData cube = box({0, 0, 0}, {1, 1, 1});
    MeshData open = cube;
    for (auto* values : {&open.positions, &open.normals}) values->resize(values->size() - 3);
    open.texCoords.resize(open.positions.size());
    const std::string rule = "must have two triangles at each edge, in opposite directions; ";
    EXPECT_EQ(refusal([&] { ClosedMesh(open, "lid"); }).rfind("mesh lid: " + rule + "run by one only is", 0), 0U);
    std::swap(cube.positions[0], cube.positions[1]);
    EXPECT_EQ(refusal([&] { ClosedMesh{cube}; }).rfind("mesh: " + rule + "run twice one way is", 0), 0U);
    EXPECT_NE(refusal([] { ClosedMesh(square(), "sheet"); }).find("mesh sheet: "), std::string::npos);
    EXPECT_EQ(refusal([] { ClosedMesh(wireCube(), "wires"); }), "mesh wires: must have triangles to cast a shadow");
    EXPECT_EQ(refusal([] { ClosedMesh(MeshData{}); }), "mesh: there must be at least 1 position, 0");
}

TEST(FacesLight, RefusesWhatIsNoLight) {
    const ClosedMesh cube(colorCube());
    EXPECT_EQ(refusal([&] { facesLight(cube, vec4(0)); }), "shadow volume: the light must not be (0, 0, 0, 0)");
    EXPECT_EQ(refusal([&] {
                  silhouette(cube, {1, 2, 3, -1});
              }),
              "shadow volume: the light's w must not be negative, (1, 2, 3, -1)");
    EXPECT_EQ(refusal([&] {
                  shadowVolume(cube, {1, notANumber, 3, 1});
              }),
              "shadow volume: the light must be finite, (1, nan, 3, 1)");
    EXPECT_EQ(refusal([&] {
                  shadowVolume(cube, {1e39, 0, 0, 1});
              }),
              "shadow volume: directions away from the light must fit into floats, (-1e+39, 0.5, 0.5)");
}

TEST(Silhouette, IsTheOutlineOfACube) {
    const ClosedMesh cube(box({-1, -1, -1}, {1, 1, 1}));
    EXPECT_EQ(silhouette(cube, {0.2, 5, 0.1, 1}).size(), 4U);  // one face sees it
    EXPECT_EQ(silhouette(cube, {5, 5, 0.1, 1}).size(), 6U);    // two, and three: always a hexagon
    EXPECT_EQ(silhouette(cube, {5, 5, 5, 1}).size(), 6U);
    EXPECT_EQ(silhouette(cube, {1, 1, 1, 0}).size(), 6U);
    EXPECT_TRUE(silhouette(cube, {0.5, 0.5, 0.5, 1}).empty());  // a light inside
    // A light exactly in two faces' planes: they do not face it, and the outline is closed all the same.
    EXPECT_EQ(silhouette(cube, {1, 5, 1, 1}).size(), 4U);
    EXPECT_EQ(silhouette(cube, {0, 1, 0, 0}).size(), 4U);
}

TEST(Silhouette, FormsClosedLoops) {
    for (const MeshData& mesh : casters()) {
        const ClosedMesh closed(mesh);
        for (const vec4& light : {above, sun, vec4(1, 5, 1, 1), vec4(0, 1, 0, 0), vec4(-3, 0.1, 2, 1)}) {
            std::map<std::uint32_t, int> balance;
            const auto edges = silhouette(closed, light);
            EXPECT_GE(edges.size(), 3U);
            EXPECT_LT(edges.size(), closed.edges().size() / 2);
            for (const auto& edge : edges) {
                ++balance[edge.vertex[0]];
                --balance[edge.vertex[1]];
            }
            for (const auto& [vertex, sum] : balance) EXPECT_EQ(sum, 0) << vertex;
        }
    }
}

TEST(ShadowVolume, IsClosed) {
    for (const MeshData& mesh : casters()) {
        const ClosedMesh closed(mesh);
        // The last two lie exactly in planes of faces, the one before inside the box and the ball.
        for (const vec4& light :
             {above, sun, vec4(-3, 0.1, 2, 1), vec4(0.1, 0.2, 0.3, 1), vec4(1, 5, 1, 1), vec4(0, 0, -2, 0)}) {
            for (const Extrude extrude : {Extrude::silhouette, Extrude::everyTriangle}) {
                const ShadowVolume volume = shadowVolume(closed, light, extrude);
                if (volume.indices.empty()) {  // no face sees a light inside a convex solid
                    EXPECT_EQ(extrude, Extrude::everyTriangle);
                    continue;
                }
                EXPECT_TRUE(runsEachEdgeAsOftenBackwards(volume)) << light.x << " " << light.w;
            }
        }
    }
}

TEST(ShadowVolume, HasThePartsItCounts) {
    const ClosedMesh cube(box({-1, -1, -1}, {1, 1, 1}));
    // Two faces of two triangles see the light, eight do not; six edges, two triangles each.
    ShadowVolume volume = shadowVolume(cube, {5, 5, 0.1, 1});
    EXPECT_EQ(volume.edges, 6U);
    EXPECT_EQ(volume.sides, 36U);
    EXPECT_EQ(volume.lightCap, 12U);
    EXPECT_EQ(volume.darkCap, 24U);
    EXPECT_EQ(volume.indices.size(), 72U);
    EXPECT_EQ(volume.positions.size(), 16U);
    for (std::size_t i = 0; i < volume.lightCap; ++i) {
        EXPECT_EQ(volume.positions[volume.indices[volume.sides + i]].w, 1);
    }
    for (std::size_t i = 0; i < volume.darkCap; ++i) {
        EXPECT_EQ(volume.positions[volume.indices[volume.sides + volume.lightCap + i]].w, 0);
    }
    // A light at infinity makes one triangle an edge, and no cap there.
    volume = shadowVolume(cube, {5, 5, 0, 0});
    EXPECT_EQ(volume.edges, 6U);
    EXPECT_EQ(volume.sides, 18U);
    EXPECT_EQ(volume.lightCap, 12U);
    EXPECT_EQ(volume.darkCap, 0U);
    EXPECT_EQ(volume.positions.size(), 9U);
    EXPECT_EQ(volume.positions.back(), fvec4(-5, -5, 0, 0));
    // Every triangle: three edges each of four triangles.
    volume = shadowVolume(cube, {5, 5, 0.1, 1}, Extrude::everyTriangle);
    EXPECT_EQ(volume.edges, 12U);
    EXPECT_EQ(volume.sides, 72U);
    EXPECT_EQ(volume.lightCap, 12U);
    EXPECT_EQ(volume.darkCap, 12U);
}

// The stencil's count: a point is wound round as often as the way from it to the light leaves the solid.
TEST(ShadowVolume, WindsRoundWhatIsInShadow) {
    Random random(7);
    int inside = 0, outside = 0, twice = 0;
    for (const MeshData& mesh : casters()) {
        const ClosedMesh closed(mesh);
        for (const vec4& light : {above, vec4(-3, 0.1, 2, 1), vec4(4, 1.5, 0.2, 1), sun, vec4(5, 1.2, 0.3, 0)}) {
            const ShadowVolume volume = shadowVolume(closed, light);
            const ShadowVolume each = shadowVolume(closed, light, Extrude::everyTriangle);
            for (int i = 0; i < 40; ++i) {
                // Somewhere behind the solid's bounds, and anywhere
                const vec3 away = i % 2 ? -glm::normalize(vec3(light)) * random.number(1.5, 6) : vec3(0);
                const vec3 point = random.point(i % 2 ? 1 : 6) + away;
                const double angle = windingByAngle(volume, point);
                const int around = volumesAround(closed, light, point);
                EXPECT_NEAR(angle, around, 1e-4);  // positions are rounded to float; the angle's own rounding is 1e-12
                EXPECT_NEAR(windingByAngle(each, point), around, 1e-4);
                (around > 0 ? inside : outside) += 1;
                twice += around == 2 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(inside, 120);
    EXPECT_GT(outside, 120);
    EXPECT_GT(twice, 4);  // through both arms of the ring
}

// All that a light inside a solid could light is dark: the whole surface, at infinity, is the dark cap.
TEST(ShadowVolume, OfALightInsideDarkensEverything) {
    const ClosedMesh ball(sphere(1, 16, 8));
    const ShadowVolume volume = shadowVolume(ball, {0.1, 0.2, 0, 1});
    EXPECT_EQ(volume.edges, 0U);
    EXPECT_EQ(volume.darkCap, volume.indices.size());
    for (const vec3& point : {vec3(3, 0, 0), vec3(0, -9, 4)}) EXPECT_NEAR(windingByAngle(volume, point), 1, 1e-6);
}
