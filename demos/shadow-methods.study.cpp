// What measures shadow-methods: the lit fraction by every method, against rays.
#include <string>

#include "mv/demo/demo.h"
#include "shared/false_shadows.h"
#include "shared/lit_reference.h"

using namespace mv;

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
    study.axis = ErrorAxis::fraction;
    study.says =
        "On one plane the matrix is exact for hardly more time than no shadow takes, and no map, however fine, has "
        "fewer "
        "wrong pixels or takes less time. Where bodies shade bodies the matrix is wrong in 2 % of the pixels and "
        "volumes "
        "are exact; a kept map nearly halves its error with each doubling of its side at little more time, while one "
        "that is drawn anew pays for every texel.";
    return study;
}

const bool studied = addStudy("shadow-methods", study());
const bool probed =
    addProbes("shadow-methods", {wrongShadows("pixels of a coarse grid whose shadow is not what rays show")});

}  // namespace
