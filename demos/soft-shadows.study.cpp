// What measures soft-shadows: the part of the lamp that is seen, against rays, and the width of a penumbra.
#include <algorithm>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/geometry/lamp.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/lit_reference.h"
#include "shared/scenes.h"

using namespace mv;

namespace {

// The penumbra of the caster's upper edge that is farthest from the lamp.
Penumbra farEdge(const Probing& probing) {
    const Demo& demo = probing.demo();
    const Scene scene = demo.scene(probing.frame());
    const bool isCube = demo.word("scene") == "cube";
    const mat4& worldFromCaster = scene[isCube ? cubeOnThePlane : topOfTheTable].worldFromObject;
    const vec3 edge = isCube ? vec3(0.5, 1, 0) : vec3(0.75, 0.72, 0);
    return penumbraOf(scene.lights.front(), worldFromCaster * vec4(edge, 1), worldFromCaster * vec4(1, 0, 0, 0));
}

// As it is drawn along a line across it, seen from straight above: from where it is wholly dark to where it is hardly.
std::vector<double> widthDrawn(Probing& probing) {
    const Penumbra penumbra = farEdge(probing);
    constexpr int pixels = 1024;
    const vec3 up(0, 1, 0);
    const double half = penumbra.width + 0.25;
    const Camera above{
        .viewFromWorld = lookAt(penumbra.middle + up, penumbra.middle, glm::cross(penumbra.outwards, -up)),
        // The floor, and nothing that stands on it
        .clipFromView = ortho(-half, half, -half / pixels, half / pixels, 0.999, 1.001)};
    const std::vector<float> lit = probing.measured(pixels, 1, above);
    constexpr float wholly = 0.001F, hardly = 0.999F;
    if (lit.empty() || lit.front() > wholly || lit.back() < hardly) return {};  // another shadow, or none
    const auto end = std::find_if(lit.begin(), lit.end(), [](float part) { return part >= hardly; });
    const auto start = std::find_if(lit.begin(), end, [](float part) { return part > wholly; });
    return {double(end - start) * 2 * half / pixels};
}

Study study() {
    Study study;
    study.quantity = "part of the lamp that is seen from each pixel's surface, 0..1";
    study.reference = "1024 rays a pixel, in double precision";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto& progress) {
        return litReference(demo.scene(frame), frame, {.lightSide = 32, .doubled = true}, progress);
    };
    // Turned, so that no row of the reference's points runs along an edge of the caster.
    study.scenes = {{"cube", {{"lamp-turn", "30"}, {"caster-height", "0"}}},
                    {"table", {{"scene", "table"}, {"lamp-size", "0.5"}, {"lamp-turn", "30"}, {"caster-height", "0"}}}};
    const std::vector<std::string> counts{"1", "4", "16", "64", "256", "1024"};
    study.lines = {{"matrix, float", {{"method", "matrix"}}, "lights", counts},
                   {"matrix, 8-bit", {{"method", "matrix"}, {"accumulate", "8-bit"}}, "lights", counts},
                   {"maps", {{"method", "maps"}}, "lights", {"1", "4", "16", "64", "256"}},
                   {"pcf", {{"method", "pcf"}}, "taps", {"1", "3", "5", "7", "9", "15", "31"}},
                   {"pcss", {{"method", "pcss"}}, "taps", {"3", "5", "9", "15", "31"}}};
    study.wrongBeyond = 0.05;  // a step that is seen, of shadow beside light
    study.width = 320;
    study.height = 240;
    study.says =
        "On one plane nothing comes near points with a shadow matrix: 64 of them are wrong by 0.003, 1024 by 0.0004, "
        "and each costs a caster's triangles; in 8 bits the sum ends at 0.001. A blur of fixed size is wrong by 0.05 "
        "with every kernel; pcss by 0.005 under a cube, but by 0.026 under a table, where casters at several heights "
        "share a pyramid, and there only a map for each point goes further.";
    return study;
}

const bool studied = addStudy("soft-shadows", study());
const bool probed = addProbes(
    "soft-shadows",
    {{{{"penumbra", "width of the penumbra of the caster's far upper edge on the floor, as drawn"}}, widthDrawn},
     {{{"penumbra-theory", "lamp-size * edge's height / (lamp's height - edge's height), unturned"}},
      [](Probing& probing) { return std::vector<double>{farEdge(probing).width}; }}});

}  // namespace
