// What measures shadow-lights: which part of the lights reaches each pixel, against rays.
#include <numeric>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "shared/lit_reference.h"

using namespace mv;

namespace {

Study study() {
    Study study;
    study.quantity = "mean over the lights of lit or not, of the pixels that face the first";
    study.reference = "one ray through each pixel and one to each light, in double precision";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto& progress) {
        const Scene scene = demo.scene(frame);
        std::vector<int> all(scene.lights.size());
        std::iota(all.begin(), all.end(), 0);
        return litReference(scene, frame, {.lights = all}, progress);
    };
    study.scenes = {{"circle", {{"scene", "circle"}}}, {"lamps", {{"scene", "lamps"}}}};
    const std::vector<std::string> counts{"1", "2", "4", "8"}, sizes{"256", "512", "1024", "2048"};
    study.lines = {{"volumes, by lights", {{"method", "volumes"}, {"keep", "off"}}, "lights", counts, {"circle"}},
                   {"maps, by lights", {{"method", "maps"}, {"keep", "off"}}, "lights", counts, {"circle"}},
                   {"maps, by resolution", {{"method", "maps"}, {"keep", "off"}}, "resolution", sizes}};
    study.axis = ErrorAxis::fraction;
    study.wrongBeyond = 0.05;  // less than one light of eight
    study.says =
        "Beside the frame's own cost each light costs about the same, by maps and by volumes: eight take four to five "
        "times as long as one. Volumes are right but in the band of one pixel at edges; of maps about half as many "
        "pixels are wrong when they are twice as large, and with every light there are more edges to be wrong at.";
    return study;
}

const bool studied = addStudy("shadow-lights", study());

}  // namespace
