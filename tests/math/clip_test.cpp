#include "mv/math/clip.h"

#include "mv/math/projection.h"
#include "support.h"

using namespace mv;
using namespace mv::test;

namespace {

using Polygon = std::vector<vec4>;

const Polygon unitSquare{{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 1}};

std::vector<vec3> divided(const Polygon& polygon) {
    std::vector<vec3> corners;
    for (const vec4& p : polygon) corners.push_back(vec3(p) / p.w);
    return corners;
}

double areaOf(const Polygon& polygon) { return polygonArea(divided(polygon)); }

TEST(ClipPolygon, KeepsWhatIsInsideAndDropsWhatIsOutside) {
    EXPECT_EQ(clipPolygon(unitSquare, clipVolume()), unitSquare);
    const vec4 right[] = {{1, 0, 0, -2}};  // x >= 2
    EXPECT_TRUE(clipPolygon(unitSquare, right).empty());
    EXPECT_EQ(clipPolygon({}, right), Polygon{});
}

TEST(ClipPolygon, BothSidesOfACutMakeTheWhole) {
    Random random(20);
    for (int i = 0; i < 200; ++i) {
        const vec4 plane(random.direction(), random.number(-1, 0.5));
        const vec4 front[] = {plane}, back[] = {-plane};
        const Polygon a = clipPolygon(unitSquare, front), b = clipPolygon(unitSquare, back);
        EXPECT_NEAR(areaOf(a) + areaOf(b), 1, 1e-14);  // a few roundings of numbers of size 1
        for (const vec4& p : a) EXPECT_GE(glm::dot(plane, p), -1e-15);
    }
}

// A neighbour walks the shared edge the other way; the seam between them must not open.
TEST(ClipPolygon, CutsASharedEdgeAtTheSameBits) {
    Random random(22);
    const Polygon backwards(unitSquare.rbegin(), unitSquare.rend());
    for (int i = 0; i < 200; ++i) {
        const vec4 plane[] = {vec4(random.direction(), random.number(-1, 0.5))};
        const Polygon a = clipPolygon(unitSquare, plane), b = clipPolygon(backwards, plane);
        EXPECT_EQ(a.size(), b.size());
        for (const vec4& p : a) EXPECT_NE(std::find(b.begin(), b.end(), p), b.end());
    }
}

TEST(ClipPolygon, SegmentsAreCutOnce) {
    const vec4 left[] = {{-1, 0, 0, 0.25}};  // x <= 0.25
    const Polygon cut = clipPolygon({{0, 0, 0, 1}, {1, 0, 0, 1}}, left);
    EXPECT_EQ(cut, (Polygon{{0, 0, 0, 1}, {0.25, 0, 0, 1}}));
    EXPECT_EQ(clipPolygon({{1, 0, 0, 1}, {0, 0, 0, 1}}, left), (Polygon{{0.25, 0, 0, 1}, {0, 0, 0, 1}}));
    EXPECT_EQ(clipPolygon({{0.25, 0, 0, 1}, {1, 0, 0, 1}}, left), (Polygon{{0.25, 0, 0, 1}}));  // touches
}

TEST(ClipPolygon, CornersOnTheBoundStay) {
    const vec4 bottom[] = {{0, 1, 0, 0}};  // y >= 0 holds of the whole square
    EXPECT_EQ(clipPolygon(unitSquare, bottom), unitSquare);
}

// X25: a segment from before the eye to behind it. Cut in clip space it ends at the near plane; divided first, its far
// end would show up in front, mirrored.
TEST(ClipExtremes, X25SegmentThroughTheEye) {
    const mat4 clipFromView = perspective(90, 1, 0.5, 10);
    const vec4 front = clipFromView * vec4(0.25, 0, -1, 1), behind = clipFromView * vec4(0.25, 0, 1, 1);
    EXPECT_LT(behind.w, 0);
    const Polygon cut = clipPolygon({front, behind}, clipVolume());
    ASSERT_EQ(cut.size(), 2U);
    EXPECT_EQ(cut[0], front);
    EXPECT_NEAR(cut[1].w, 0.5, 1e-15);               // at the near plane
    EXPECT_NEAR(cut[1].x / cut[1].w, 0.5, 1e-15);    // 0.25/0.5 with 90 degrees
    EXPECT_NEAR(behind.x / behind.w, -0.25, 1e-15);  // the naive twin: on the other side of the picture
    EXPECT_TRUE(clipPolygon({behind, behind + vec4(0, 0.1, 0, 0)}, clipVolume()).empty());
    EXPECT_EQ(refusal([] {
                  clipPolygon({{0, 0, notANumber, 1}}, clipVolume());
              }),
              "clipPolygon: each corner must be finite, (0, 0, nan, 1)");
}

TEST(PolygonArea, OfFlatPolygonsInSpace) {
    const vec3 triangle[] = {{0, 0, 0}, {3, 0, 0}, {0, 0, 4}};
    EXPECT_EQ(polygonArea(triangle), 6);
    EXPECT_EQ(polygonArea(std::span(triangle).first(2)), 0);
    EXPECT_EQ(polygonArea({}), 0);
    const vec3 bad[] = {{0, 0, 0}, {infinite, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(refusal([&] { polygonArea(bad); }), "polygonArea: each corner must be finite, (inf, 0, 0)");
}

}  // namespace
