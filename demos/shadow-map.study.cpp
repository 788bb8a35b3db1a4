// What measures shadow-map: its shadows against rays.
#include <array>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "shared/false_shadows.h"
#include "shared/lit_reference.h"

using namespace mv;

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
    return line;
}

std::vector<double> falsePixels(Probing& probing) {
    const auto wrong = falseShadows(probing);
    if (!wrong) return {};
    return {wrong->dark, wrong->lit, double(wrong->pixels)};
}

Study study() {
    Study study;
    study.quantity = "lit fraction of the pixels whose surface faces the light";
    study.reference = "a ray in double precision from each pixel to the light; 64 for the root mean square";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto& progress) {
        return litReference(demo.scene(frame), frame, {.pixelSide = 8}, progress);
    };
    study.scenes = {{"cube on plane", lit("cube-on-plane", {"-2.2", "3.6", "1.4"}, {"0", "0", "0"})},
                    {"still life", lit("still-life", {"-3.4", "4.2", "2.6"}, {"0.4", "0.5", "-0.8"})}};
    study.lines = {line("1 tap", "none", "2"),
                   line("hardware 2x2", "hardware", "2"),
                   line("PCF 3x3", "pcf3", "4"),
                   line("PCF 5x5", "pcf5", "6"),
                   line("1 tap, map kept", "none", "2", {{"keep", "on"}}),
                   line("1 tap, receiver left out", "none", "2", {{"receiver", "off"}}),
                   line("1 tap, back faces, receiver left out, no bias", "none", "0",
                        {{"receiver", "off"}, {"map-faces", "back"}}),
                   line("1 tap, frustum fitted", "none", "2", {{"frustum", "fitted"}})};
    study.axis = ErrorAxis::fraction;
    study.says =
        "What is misjudged lies within a texel of a shadow's edge, so it halves when the resolution doubles, while "
        "beyond 1024 the time grows with the texels: fitting the frustum buys more than refining the map, and keeping "
        "the map makes its resolution nearly free. Leaving the receiver out costs no accuracy, and back faces without "
        "any bias are about as right as front faces with one.";
    return study;
}

const bool studied = addStudy("shadow-map", study());
const bool probed =
    addProbes("shadow-map", {{{{"falsely-dark", "pixels that are dark though the light reaches them", "%"},
                               {"falsely-lit", "pixels that are lit though they are in shadow", "%"},
                               {"pixels-asked", "how many pixels were compared with rays for these two"}},
                              falsePixels}});

}  // namespace
