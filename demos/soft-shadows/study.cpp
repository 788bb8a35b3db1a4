// The study of soft-shadows: the part of the lamp that is seen, against rays, and the width of a penumbra.
#include <algorithm>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "mv/demo/lesson.h"
#include "mv/geometry/lamp.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/lit_reference.h"
#include "shared/scenes.h"
#include "soft-shadows.h"

using namespace mv::claims;

namespace mv::soft_shadows {
namespace {

// The penumbra of the caster's upper edge that is farthest from the lamp.
Penumbra farEdge(const Probing& probing) {
    const Settings s = settingsOf<Settings>(probing.demo());
    const Scene scene = sceneOf(s, probing.frame());
    const bool isCube = s.scene == Which::cube;
    const mat4& worldFromCaster = scene[isCube ? cubeOnThePlane : topOfTheTable].worldFromObject;
    const vec3 edge = isCube ? vec3(0.5, 1, 0) : vec3(0.75, 0.72, 0);
    const vec3 outwards = worldFromCaster * vec4(1, 0, 0, 0);
    SceneLight lamp = scene.lights.front();
    if (s.lampShape == Shape::disc) {  // as wide from every side
        lamp.halfU = s.lampSize / 2 * outwards;
        lamp.halfV = vec3(0);
    }
    return penumbraOf(lamp, worldFromCaster * vec4(edge, 1), outwards);
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
        Scene scene = demo.scene(frame);
        if (settingsOf<Settings>(demo).lampShape != Shape::disc)
            return litReference(scene, frame, {.lightSide = 32, .doubled = true}, progress);
        // A lamp that is no parallelogram, by points of its own
        const SceneLight lamp = scene.lights.front();
        constexpr int side = 32;
        scene.lights.clear();
        LitReferenceOptions options{.lights = {}};
        for (int i = 0; i < side * side; ++i) {
            const vec2 p = onDisc((2.0 * vec2(i % side, i / side) + 1.0) / double(side) - 1.0);
            scene.lights.push_back({.position = lamp.position + vec4(p.x * lamp.halfU + p.y * lamp.halfV, 0)});
            options.lights.push_back(i);
        }
        return litReference(scene, frame, options, progress);
    };
    // Turned, so that no row of the reference's points runs along an edge of the caster.
    study.scenes = {
        {"cube", {{"lamp-turn", "30"}, {"caster-height", "0"}, {"section", "off"}}},
        {"table",
         {{"scene", "table"}, {"lamp-size", "0.5"}, {"lamp-turn", "30"}, {"caster-height", "0"}, {"section", "off"}}},
        {"disc", {{"lamp-shape", "disc"}, {"caster-height", "0"}, {"section", "off"}}},
        {"tube",
         {{"lamp-shape", "tube"},
          {"lamp-size", "1.5"},
          {"lamp-turn", "30"},
          {"caster-height", "0"},
          {"section", "off"}}}};
    const std::vector<std::string> squares{"cube", "table"};
    const std::vector<std::string> counts{"1", "4", "16", "64", "256", "1024"};
    const std::vector<std::string> upTo256{counts.begin(), counts.end() - 1};
    study.lines = {{"matrix, float", {{"method", "matrix"}}, "lights", counts},
                   {"matrix, 8-bit", {{"method", "matrix"}, {"accumulate", "8-bit"}}, "lights", upTo256, squares},
                   {"maps", {{"method", "maps"}}, "lights", upTo256, squares},
                   {"pcf", {{"method", "pcf"}}, "taps", {"1", "3", "5", "7", "9", "15", "31"}, squares},
                   {"pcss", {{"method", "pcss"}}, "taps", {"3", "5", "9", "15", "31"}, squares}};
    study.reads = {"scene", "lamp-shape", "lamp-size", "lamp-turn", "caster-height", "spin-x", "spin-y"};
    study.wrongBeyond = 0.05;  // a step that is seen, of shadow beside light
    study.width = 320;
    study.height = 240;
    const auto points = rows("matrix, float"), bytes = rows("matrix, 8-bit"), maps = rows("maps"), pcf = rows("pcf"),
               pcss = rows("pcss");
    study.says = {
        claim("points-on-a-plane",
              "On one plane nothing comes near points with a shadow matrix, drawn on a processor: no map and no blur "
              "is at least as right and as fast as any number of them. 64 are wrong by 0.003, 1024 by 0.0004.",
              {unbeaten(points.in("cube"), rows("maps", "pcf", "pcss")),
               value(of::rms, points.in("cube").at(64), 0.0025, 0.0035),
               value(of::rms, points.in("cube").at(1024), 0.00035, 0.00045)}),
        claim("looks-cost-little",
              "On this GPU a blur's looks cost so little that it is faster than a single point, and more right.",
              {ratio(of::time, rows("pcf").in("cube").upTo(5), points.in("cube").at(1), 0, 1),
               ratio(of::rms, rows("pcf").in("cube").upTo(5), points.in("cube").at(1), 0, 1)}),
        claim("three-quarters",
              "A shadow's edge crosses the square root of N of the lamp's N cells, and only those err: the error "
              "falls as N^(-3/4).",
              {slope(of::rms, points.in("cube"), -0.85, -0.65), slope(of::rms, bytes.in("cube"), -0.85, -0.65),
               slope(of::rms, maps.in("cube"), -0.85, -0.65)}),
        claim("shapes",
              "Cells of equal area on a disc and on a tube do as well, measured on a processor: the error falls as a "
              "power "
              "between -0.6 and -0.8, and 64 points are wrong by 0.003 under each.",
              {slope(of::rms, points.in("disc"), -0.8, -0.6), slope(of::rms, points.in("tube"), -0.8, -0.6),
               value(of::rms, points.in("disc").at(64), 0.0025, 0.0035),
               value(of::rms, points.in("tube").at(64), 0.0025, 0.0035)}),
        claim("a-point-a-caster", "Each point draws the caster once more, in float and in 8 bits.",
              {ratio(of::count("triangles"), points.in("cube").at(64), points.in("cube").at(4), 10, 16),
               ratio(of::count("triangles"), bytes, points, 1, 1)}),
        claim("eight-bits",
              "Up to 256 points a sum in 8 bits is as right as one in float, within 10 %. More shares than steps "
              "it cannot hold, and is refused them: it ends at 0.001.",
              {ratio(of::rms, bytes, points, 0.9, 1.1), value(of::rms, bytes.in("cube").at(256), 0.0005, 0.0015)}),
        claim("blur",
              "A blur of fixed size does not get better with its kernel: it is wrong by 0.045 to 0.065 under the "
              "cube, and by 0.07 to 0.085 under the table.",
              {value(of::rms, pcf.in("cube"), 0.045, 0.065), value(of::rms, pcf.in("table"), 0.07, 0.085),
               settled(of::rms, pcf, 1.4)}),
        claim("pcss",
              "From 9 x 9 taps on pcss is wrong by 0.005 under the cube, and by 0.026 under the table, where "
              "casters at several heights share a pyramid; more taps change nothing.",
              {value(of::rms, pcss.in("cube").from(9), 0.0045, 0.0055),
               value(of::rms, pcss.in("table").from(9), 0.0255, 0.0265), settled(of::rms, pcss.from(9), 1.05)}),
        claim("maps-under-the-table",
              "There only a map for each point goes further: with 16 points and more the maps' error is less than "
              "three quarters of that, and points with a matrix, which shade the floor alone, stop at 0.1.",
              {ratio(of::rms, maps.in("table").from(16), pcss.in("table").at(9), 0, 0.75),
               atLeast(of::rms, points.in("table"), 0.095), atLeast(of::rms, pcf.in("table"), 0.07)})};
    return study;
}

const bool studied = addStudy("soft-shadows", study());
const bool probed = addProbes(
    "soft-shadows",
    {{{{"penumbra", "width of the penumbra of the caster's far upper edge on the floor, as drawn"}}, widthDrawn},
     {{{"penumbra-theory", "lamp-size * edge's height / (lamp's height - edge's height), unturned"}},
      [](Probing& probing) { return std::vector<double>{farEdge(probing).width}; }}});

}  // namespace
}  // namespace mv::soft_shadows
