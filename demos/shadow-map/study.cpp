// The study of shadow-map: its shadows against rays.
#include <array>
#include <string>
#include <vector>

#include "mv/demo/lesson.h"
#include "shadow-map.h"
#include "shared/false_shadows.h"
#include "shared/lit_reference.h"

using namespace mv;
using namespace mv::claims;

namespace {

using Place = std::array<std::string, 3>;

// The settings of a study's scene: where its light is and looks to, with a map of 60 by 60 degrees.
std::vector<KnobSetting> lit(const std::string& scene, const Place& from, const Place& to) {
    return {{"scene", scene},      {"light-x", from[0]},  {"light-y", from[1]}, {"light-z", from[2]},
            {"target-x", to[0]},   {"target-y", to[1]},   {"target-z", to[2]},  {"fov", "60"},
            {"window-width", "1"}, {"window-height", "1"}};
}

// A line of the study: a map drawn again in every frame and pushed back by its slope alone, unless it says otherwise.
StudyLine line(const std::string& method, const std::string& filter, const std::string& slopeBias,
               const std::vector<KnobSetting>& settings = {}) {
    StudyLine line{method, {{"bias", "0"}, {"keep", "off"}, {"filter", filter}, {"slope-bias", slopeBias}}};
    line.settings.insert(line.settings.end(), settings.begin(), settings.end());
    line.knob = "resolution";
    line.values = {"256", "512", "1024", "2048", "4096"};
    line.scenes = {"cube on plane", "still life"};
    return line;
}

// What rays are cast into: overhead, where the ball itself is not in the picture, a round one casts instead of the one with sides.
Scene exactScene(const Demo& demo, const FrameInfo& frame) {
    Scene scene = demo.scene(frame);
    const auto s = settingsOf<shadow_map::Settings>(demo);
    if (s.scene != shadow_map::Which::overhead) return scene;
    constexpr int round = 256;  // is off the sphere by 0.00008 of its radius
    scene.objects = shadow_map::overhead(round, s.cord, frame.aspect()).objects;
    return scene;
}

std::vector<double> falsePixels(Probing& probing) {
    const auto wrong = falseShadows(probing, exactScene(probing.demo(), probing.frame()));
    if (!wrong) return {};
    return {wrong->dark, wrong->lit, double(wrong->pixels)};
}

Study study() {
    Study study;
    study.quantity = "lit fraction of the pixels whose surface faces the light";
    study.reference = "a ray in double precision from each pixel to the light; 64 for the root mean square";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto& progress) {
        return litReference(exactScene(demo, frame), frame, {.pixelSide = 8}, progress);
    };
    study.scenes = {{"cube on plane", lit("cube-on-plane", {"-2.2", "3.6", "1.4"}, {"0", "0", "0"})},
                    {"still life", lit("still-life", {"-3.4", "4.2", "2.6"}, {"0.4", "0.5", "-0.8"})},
                    {"cords", {{"scene", "overhead"}, {"sides", "64"}, {"cord", "0.006"}}},
                    {"ball", {{"scene", "overhead"}, {"cord", "0.001"}, {"resolution", "4096"}}}};
    study.lines = {line("1 tap", "none", "2"),
                   line("hardware 2x2", "hardware", "2"),
                   line("PCF 3x3", "pcf3", "4"),
                   line("PCF 5x5", "pcf5", "6"),
                   line("1 tap, map kept", "none", "2", {{"keep", "on"}}),
                   line("1 tap, receiver left out", "none", "2", {{"receiver", "off"}}),
                   line("1 tap, back faces, receiver left out, no bias", "none", "0",
                        {{"receiver", "off"}, {"map-faces", "back"}}),
                   line("1 tap, frustum fitted", "none", "2", {{"frustum", "fitted"}}),
                   {"thin casters", {{"keep", "off"}}, "resolution", {"256", "512", "1024", "2048", "4096"}, {"cords"}},
                   {"coarse casters", {{"keep", "off"}}, "sides", {"4", "6", "8", "12", "24", "48"}, {"ball"}}};
    study.reads = {"scene",    "projection", "light-x", "light-y",  "light-z", "target-x", "target-y",
                   "target-z", "spin-x",     "spin-y",  "distance", "sides",   "cord"};
    study.axis = ErrorAxis::fraction;
    const auto anew = rows("1 tap"), kept = rows("1 tap, map kept"), fitted = rows("1 tap, frustum fitted");
    const char* const still = "still life";
    study.says = {
        claim("half-for-twice",
              "With one tap what is misjudged lies within a texel of a shadow's edge, so that about half as many "
              "pixels are wrong when the resolution doubles; a hardware lookup of 2x2 texels changes nothing in that.",
              {slope(of::wrong,
                     rows("1 tap", "hardware 2x2", "1 tap, map kept", "1 tap, receiver left out",
                          "1 tap, back faces, receiver left out, no bias"),
                     -1.1, -0.85),
               slope(of::wrong, fitted.in("cube on plane"), -1.1, -0.85)}),
        claim("round-bodies",
              "Where the light grazes a round body, texels and bias move the shadow by more than a texel, and that "
              "gets less more slowly than at other edges. Where the frustum is fitted to the still life and the "
              "texels are finest, it is more of what is left, and the slope is between -1/2 and -0.9.",
              {slope(of::wrong, fitted.in(still), -0.9, -0.5),
               slope(of::wrongAwayFromEdges, fitted.in(still), -0.9, -0.5)}),
        claim("wide-kernels",
              "A wider kernel needs more bias, which at coarse maps loses whole parts of shadows, away from edges, "
              "too. They come back with finer maps, from 2048 on wholly, so that the slope in the still life is "
              "steeper than -1.",
              {slope(of::wrong, rows("PCF 3x3", "PCF 5x5").in(still), -1.5, -1),
               atLeast(of::wrongAwayFromEdges, rows("PCF 3x3", "PCF 5x5").in(still).at(256), 0.02),
               zero(of::wrongAwayFromEdges, rows("PCF 3x3", "PCF 5x5").in(still).from(2048))}),
        claim("pays-for-texels",
              "From 1024 to 4096 a map that is drawn anew fills 10 to 16 times the fragments, and the frame takes "
              "1.8 times as long at least.",
              {ratio(of::count("fragments"), anew.at(4096), anew.at(1024), 10, 16),
               ratio(of::time, anew.at(4096), anew.at(1024), 1.8, 16)}),
        claim("kept",
              "A kept map draws nothing again: as many fragments are filled for any resolution, the same pixels are "
              "wrong, and at 4096 the frame takes less than half of the time, so that drawing the map was most of it.",
              {ratio(of::count("fragments"), kept.at(4096), kept.at(1024), 1, 1), ratio(of::wrong, kept, anew, 1, 1),
               ratio(of::time, kept.at(4096), anew.at(4096), 0, 0.5)}),
        claim("fitting",
              "Fitting the frustum leaves at most six in ten of the wrong pixels, nearly what twice the resolution "
              "would do, and takes at most twice as long.",
              {ratio(of::wrong, fitted, anew, 0, 0.6), ratio(of::time, fitted, anew, 0, 2)}),
        claim("receiver", "Leaving the receiver out makes as many pixels wrong, by as much.",
              {ratio(of::wrong, rows("1 tap, receiver left out"), anew, 1, 1),
               ratio(of::rms, rows("1 tap, receiver left out"), anew, 1, 1)}),
        claim("thin-casters",
              "Cords thinner than a texel have dashes for shadows. Measured on a processor, the wrong part falls more "
              "slowly than the resolution grows; from 1024 texels on, where a texel is hardly wider than a cord, all "
              "of it lies "
              "within a pixel of an edge.",
              {slope(of::wrong, rows("thin casters"), -1, -0.65),
               atLeast(of::wrongAwayFromEdges, rows("thin casters").at(256), 0.1),
               zero(of::wrongAwayFromEdges, rows("thin casters").from(1024))}),
        claim("coarse-casters",
              "A polygonal ball throws a polygonal shadow, too small by an area that falls as the square of its sides. "
              "Measured on a processor, with the finest map, up to 12 sides the wrong part falls nearly so, as a power "
              "between -2 and -1.4; with 24 sides it is less than a tenth of what it is with 4, and the map's own "
              "error is most of it.",
              {slope(of::wrong, rows("coarse casters").upTo(12), -2, -1.4),
               ratio(of::wrong, rows("coarse casters").at(24), rows("coarse casters").at(4), 0, 0.1)}),
        claim("back-faces", "Back faces without any bias are as right as front faces with one, within 15 %.",
              {ratio(of::wrong, rows("1 tap, back faces, receiver left out, no bias"), anew, 0.85, 1.15)})};
    return study;
}

const bool studied = addStudy("shadow-map", study());
const bool probed =
    addProbes("shadow-map", {{{{"falsely-dark", "pixels that are dark though the light reaches them", "%"},
                               {"falsely-lit", "pixels that are lit though they are in shadow", "%"},
                               {"pixels-asked", "how many pixels were compared with rays for these two"}},
                              falsePixels}});

}  // namespace
