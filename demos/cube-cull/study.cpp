// The readouts of cube-cull, and its study: what is seen with and without culling, and how long that takes.
#include <cmath>
#include <glm/matrix.hpp>
#include <string>
#include <vector>

#include "cube-cull.h"
#include "mv/demo/lesson.h"
#include "mv/gl/triangle_count.h"
#include "shared/seen_pixels.h"

namespace mv::cube_cull {

using namespace claims;

void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers) {
    const vec3 eye = vec3(inverse(viewFromModel(s)) * vec4(0, 0, 0, 1));  // in the body's own coordinates
    int faces = 0;
    for (int axis = 0; axis < 3; ++axis) faces += (eye[axis] > 0.5) + (eye[axis] < -0.5);
    if (s.body == Body::cube) numbers.set("facing", faces);
    // The teapot's corners are shared, and OpenGL ES gives none back that are drawn by indices: the processor multiplies them
    const TriangleCount triangles =
        s.body == Body::cube ? countTriangles(*gpu.body) : sortTriangles(clipCorners(bodyOf(s), s, frame.aspect()));
    numbers.set("culled", double(triangles.culled));
    numbers.set("outside", double(triangles.outside));
    numbers.set("surviving", double(triangles.surviving));
}

void drawDistances(Gpu& gpu, const Settings& s, const Frame& frame) {
    if (!gpu.distances)
        gpu.distances = Program::fromFiles("distance", {"cube-cull/cube-cull.vert", "cube-cull/distance.frag"});
    drawBody(gpu, *gpu.distances, s, frame);
}

namespace {

// Less than the body's walls are apart where it can be looked through, and more than a pixel's slope but at a silhouette.
constexpr double wrongBeyond = 0.05;

std::vector<double> wrongPixels(Probing& probing) {
    constexpr int side = 300;
    const auto shown = probing.measured(side, side);
    if (shown.empty()) return {};
    const auto nearest =
        nearestFaces(settingsOf<Settings>(probing.demo()), FrameInfo(probing.frame().index(), side, side));
    double wrong = 0, seen = 0;
    for (std::size_t i = 0; i < nearest.size(); ++i) {
        if (nearest[i] < 0) continue;
        ++seen;
        wrong += std::abs(double(shown[i]) - nearest[i]) > wrongBeyond ? 1 : 0;
    }
    if (seen == 0) return {};
    return {100 * wrong / seen};
}

Study study() {
    Study study;
    study.quantity = "distance of what is seen, along the gaze";
    study.reference = "a ray in double precision through each pixel's middle, to the first of the same triangles";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto&) {
        Reference reference{.values = nearestFaces(settingsOf<Settings>(demo), frame)};
        reference.regions = regionsOfSeen(reference.values);
        return reference;
    };
    study.wrongBeyond = wrongBeyond;
    // From where no edge of the lid or of the spout lets the eye in
    study.scenes = {{"large", {{"body", "teapot"}, {"spin-x", "0"}, {"z-dist", "-4"}, {"apart", "off"}}},
                    {"small", {{"body", "teapot"}, {"spin-x", "0"}, {"z-dist", "-10"}, {"apart", "off"}}}};
    for (const std::string cull : {"none", "back"}) {
        study.lines.push_back({.method = "cull " + cull,
                               .settings = {{"cull", cull}},
                               .knob = "divisions",
                               .values = {"1", "4", "16", "64"}});
    }
    study.lines.push_back(
        {.method = "cull front", .settings = {{"cull", "front"}, {"divisions", "16"}}, .scenes = {"small"}});
    study.reads = {"body", "divisions", "z-dist", "spin-x", "spin-y"};
    study.axis = ErrorAxis::fraction;
    const auto none = rows("cull none"), back = rows("cull back");
    study.says = {
        claim("same-picture",
              "Where no edge lets the eye in, culling back faces leaves out nothing that is seen: fewer than one pixel "
              "in a thousand is wrong, as without culling. Of the front faces it leaves out nearly all that is seen.",
              {atMost(of::wrong, rows("cull none", "cull back"), 0.1), atLeast(of::wrong, rows("cull front"), 80)}),
        claim("half-of-many",
              "Of 260000 triangles culling saves a processor between a fifth and four fifths of the "
              "frame's time: half of them are never set up, but their corners are transformed all the same.",
              {ratio(of::time, back.at(64), none, 0.2, 0.8)}),
        claim("fewer-pixels",
              "Of the pixels filled it saves less: where the depth test is on, a back face is filled only if it comes "
              "before the front face that hides it. From 992 triangles on that is between an eighth and a fifth of "
              "them.",
              {ratio(of::count("fragments"), back.from(4), none, 0.8, 0.875)}),
        note("Triangles are counted as the mesh has them, 2 for each cell of a patch, less those that collapse to an "
             "edge.")};
    return study;
}

const bool studied = addStudy("cube-cull", study());
const bool probed =
    addProbes("cube-cull",
              {{{{"wrong-pixels",
                  "of the pixels in which rays meet the body, those that do not show the first face on the way", "%"}},
                wrongPixels}});

}  // namespace
}  // namespace mv::cube_cull
