// The study of shadow-methods: the lit fraction by every method, against rays.
#include <cmath>
#include <string>

#include "mv/demo/demo.h"
#include "shadow-methods.h"
#include "shared/false_shadows.h"
#include "shared/lit_reference.h"

using namespace mv::claims;

namespace mv::shadow_methods {

// Draw what a study measures: the first method alone.
void drawAlone(Gpu& gpu, const Settings& s, const Frame& frame) {
    gpu.found.reset();
    drawScene(gpu, beginScene(gpu, s, s.method, frame), s.method);
}

namespace {

// A line of the study along the map's resolution, the map drawn again in each frame.
StudyLine mapLine(const std::string& name, const std::string& method, const std::string& slopeBias,
                  const std::string& receiver = "on", const std::string& keep = "off") {
    return {name,
            {{"method", method}, {"slope-bias", slopeBias}, {"receiver", receiver}, {"keep", keep}},
            "resolution",
            {"256", "512", "1024", "2048", "4096"}};
}

Study study() {
    Study study;
    study.quantity = "lit fraction of the pixels whose surface faces the light";
    study.reference = "a ray in double precision from each pixel to the light; 64 for the root mean square";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto& progress) {
        return litReference(demo.scene(frame), frame, {.pixelSide = 8}, progress);
    };
    study.scenes = {{"cube on plane", {{"scene", "cube-on-plane"}, {"against", "off"}}},
                    {"still life", {{"scene", "still-life"}, {"against", "off"}}}};
    study.lines = {{"no shadow", {{"method", "none"}}},
                   {"matrix", {{"method", "matrix"}}},
                   {"volumes", {{"method", "volume"}}},
                   {"volumes, made anew", {{"method", "volume"}, {"keep", "off"}}},
                   mapLine("map, 1 tap", "map", "2"),
                   mapLine("map, hardware 2x2", "map-hardware", "2"),
                   mapLine("map, PCF 3x3", "pcf3", "4"),
                   mapLine("map, PCF 5x5", "pcf5", "6"),
                   mapLine("map, 1 tap, kept", "map", "2", "on", "on"),
                   mapLine("map, 1 tap, receiver left out, no bias", "map", "0", "off")};
    study.reads = {"scene", "ball-height", "spin-x", "spin-y", "distance"};
    study.axis = ErrorAxis::fraction;
    const auto none = rows("no shadow"), matrix = rows("matrix"), map = rows("map, 1 tap"),
               kept = rows("map, 1 tap, kept");
    const auto maps = rows("map, 1 tap", "map, hardware 2x2", "map, PCF 3x3", "map, PCF 5x5", "map, 1 tap, kept",
                           "map, 1 tap, receiver left out, no bias");
    const char *const plane = "cube on plane", *const still = "still life";
    study.says = {
        claim("matrix-on-a-plane",
              "On one plane the matrix is exact away from edges, in at most 1.5 times the time that no shadow "
              "takes; and no map, however fine, has fewer wrong pixels, or takes less than 0.95 of its time.",
              {zero(of::wrongAwayFromEdges, matrix.in(plane)), ratio(of::time, matrix.in(plane), none, 0, 1.5),
               unbeaten(matrix.in(plane), maps), ratio(of::wrong, maps.in(plane), matrix, 1, HUGE_VAL),
               ratio(of::time, maps.in(plane), matrix, 0.95, HUGE_VAL)}),
        claim("matrix-on-bodies", "Where bodies shade bodies the matrix is wrong in 2.2 % of the pixels.",
              {value(of::wrong, matrix.in(still), 2.15, 2.25)}),
        claim("volumes", "Volumes are exact away from edges in both scenes.",
              {zero(of::wrongAwayFromEdges, rows("volumes", "volumes, made anew"))}),
        claim("plane-halves",
              "With one tap the wrong pixels on the plane are about halved when the map's side is doubled.",
              {slope(of::wrong,
                     rows("map, 1 tap", "map, 1 tap, kept", "map, 1 tap, receiver left out, no bias").in(plane), -1.1,
                     -0.85)}),
        claim("round-bodies",
              "Where the light grazes a round body, texels and bias move the shadow by more than a texel, and that "
              "gets less more slowly than at other edges: in the still life the slope is between -1/2 and -0.9, "
              "and without bias nearer to -1.",
              {slope(of::wrong, rows("map, 1 tap", "map, hardware 2x2", "map, 1 tap, kept").in(still), -0.9, -0.5),
               slope(of::wrong, rows("map, 1 tap, receiver left out, no bias").in(still), -1, -0.85)}),
        claim("texels-finer-than-pixels",
              "On the plane the maps' texels are finer than pixels in the end. Lookups of several texels have less "
              "than ten wrong pixels of 297 000 there from 2048 on, and one at 4096 is no slope any more: up to "
              "2048 that of the hardware's lookup is -1.",
              {slope(of::wrong, rows("map, hardware 2x2").in(plane).upTo(2048), -1.1, -0.9),
               atMost(of::wrong, rows("map, hardware 2x2", "map, PCF 3x3", "map, PCF 5x5").in(plane).from(2048),
                      0.0033)}),
        claim("wide-kernels",
              "A wider kernel needs more bias, which at coarse maps loses whole parts of the still life's shadows: "
              "that mends faster than edges do, and the slope is steeper than -1.",
              {slope(of::wrong, rows("map, PCF 3x3", "map, PCF 5x5").in(still), -1.5, -1),
               atLeast(of::wrongAwayFromEdges, rows("map, PCF 3x3", "map, PCF 5x5").in(still).at(256), 0.015),
               atMost(of::wrongAwayFromEdges, rows("map, PCF 3x3", "map, PCF 5x5").in(still).from(2048), 0.0011)}),
        claim("kept",
              "A kept map draws nothing again, and from 256 to 4096 texels a side the frame takes at most 2.5 "
              "times as long; one that is drawn anew takes three times as long at least.",
              {ratio(of::count("fragments"), kept.at(4096), kept.at(256), 1, 1),
               ratio(of::time, kept.at(4096), kept.at(256), 0, 2.5),
               ratio(of::time, map.at(4096), map.at(256), 3, HUGE_VAL)})};
    return study;
}

const bool studied = addStudy("shadow-methods", study());
const bool probed =
    addProbes("shadow-methods", {wrongShadows("pixels of a coarse grid whose shadow is not what rays show")});

}  // namespace
}  // namespace mv::shadow_methods
