// The readouts of ray-trace, and its study: the noise of a few samples, and the time to find a triangle among many.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "mv/demo/lesson.h"
#include "ray-trace.h"
#include "values.h"

namespace mv::ray_trace {

void readOut(Gpu&, const Settings& s, const Made& made, const Frame&, Numbers& numbers) {
    const TracePicture& picture = made.picture;
    const double pixels = double(picture.light().size());
    double all = 0, most = 0, off = 0;
    for (std::size_t i = 0; i < picture.light().size(); ++i) {
        all += picture.cut()[i];
        most = std::max(most, picture.cut()[i]);
        const vec3 sum = picture.light()[i] + picture.cut()[i] - 1.0;
        off = std::max({off, std::abs(sum.x), std::abs(sum.y), std::abs(sum.z)});
    }
    numbers.set("rays", double(picture.rays()) / pixels);
    numbers.set("cut", 100 * all / pixels);
    numbers.set("cut-most", 100 * most);
    if (s.room == TracedRoom::white) numbers.set("missing", off);
}

namespace {

using namespace mv::claims;

Study study() {
    Study study;
    study.quantity =
        "the grey of 24 x 16 pixels, the middle of 48 x 32, by each of 8 seeds; of triangles t of 1000 rays to the "
        "teapot's; of leaving 1 for each of 100 000 rays that meets again what it leaves; of glass the colours of 48 x "
        "32 "
        "pixels";
    study.reference =
        "4096 samples a pixel of a sequence with a seed of its own; every triangle by the textbook's form; 0; the same "
        "rays for 256 wavelengths";
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) { return referenceOf(demo); };
    study.ofValues = true;
    study.reads = {"room",      "depth",     "shadows", "lamp-size",  "index", "eye-turn", "eye-height",
                   "triangles", "highlight", "falloff", "globe-turn", "abbe",  "filtered"};
    study.wrongBeyond = 0.02;
    study.problem = "triangles";
    study.scenes = {{"outlines", {{"room", "soft-shadow"}, {"eye-height", "5"}, {"lamp-size", "0"}}},
                    {"soft shadow", {{"room", "soft-shadow"}, {"eye-height", "5"}, {"lamp-size", "2"}}},
                    {"smooth", {{"room", "lamp"}, {"eye-height", "5"}, {"lamp-size", "2"}}},
                    {"globes", {{"room", "globes"}, {"lamp-size", "0"}}},
                    {"triangles", {{"room", "teapot"}}},
                    {"leaving", {{"room", "strips"}}},
                    {"glass", {{"room", "glass-ball"}, {"index", "1.7847"}, {"abbe", "25.68"}}}};
    for (const std::string pattern : {"random", "regular", "jittered", "sequence"})
        study.lines.push_back({.method = pattern,
                               .settings = {{"pattern", pattern}},
                               .knob = "samples",
                               .values = {"1", "4", "16", "64", "256"},
                               .scenes = {"outlines", "soft shadow", "smooth"}});
    for (const bool isFiltered : {false, true})
        study.lines.push_back({.method = isFiltered ? "averaged" : "one texel",
                               .settings = {{"filtered", isFiltered ? "on" : "off"}},
                               .knob = "samples",
                               .values = {"1", "4", "16", "64", "256"},
                               .scenes = {"globes"}});
    const std::vector<std::string> triangles{"1024", "4096", "16384", "65536", "262144", "1048576"};
    for (const std::string structure : {"none", "boxes", "grid", "tree"}) {
        const std::ptrdiff_t sizes = structure == "none" ? 4 : 6;
        study.lines.push_back({.method = structure,
                               .settings = {{"structure", structure}},
                               .knob = "triangles",
                               .values = {triangles.begin(), triangles.begin() + sizes},
                               .scenes = {"triangles"}});
    }
    for (const std::string leave : {"point", "components", "largest", "bounded"})
        study.lines.push_back({.method = leave,
                               .settings = {{"leave", leave}},
                               .knob = "triangles",
                               .values = {"1024", "16384", "262144", "1048576"},
                               .scenes = {"leaving"}});
    study.lines.push_back({.method = "wavelengths",
                           .settings = {},
                           .knob = "wavelengths",
                           .values = {"1", "3", "4", "8", "16", "32"},
                           .scenes = {"glass"}});
    const auto falls = [](const char* method, const char* scene, double power) {
        // The slope is of the mean square's power p / 2, within 0.15 of the former
        return slope(of::rms, rows(method).in(scene), power / 2 - 0.075, power / 2 + 0.075);
    };
    study.says = {
        claim("random", "At random the mean square falls as 1 by the samples, everywhere.",
              {falls("random", "outlines", -1), falls("random", "soft shadow", -1), falls("random", "smooth", -1)}),
        claim("outlines", "At outlines it falls as the power -1.5 in cells or in a sequence.",
              {falls("regular", "outlines", -1.5), falls("jittered", "outlines", -1.5),
               falls("sequence", "outlines", -1.5)}),
        claim("smooth", "Where all is smooth, as the power -2; in regular cells up to 64 samples.",
              {slope(of::rms, rows("regular").in("smooth").upTo(64), -1.075, -0.925), falls("jittered", "smooth", -2),
               falls("sequence", "smooth", -2)}),
        note(
            "A pixel's places and the lamp's are paired at random: what depends on both falls as 1 by the samples, and "
            "is the last that is left of the regular cells' error, and a part of a soft shadow's."),
        claim("soft-shadow", "In a soft shadow it falls faster than at random, too.",
              {slope(of::rms, rows("regular", "jittered", "sequence").in("soft shadow"), -0.825, -0.55)}),
        claim(
            "texture",
            "A globe's picture averaged over each ray's cone leaves at most 85 % of the error that one texel for each "
            "ray has, at any number of samples; the rest is the globes' outlines.",
            {ratio(of::rms, rows("averaged"), rows("one texel"), 0.5, 0.85)}),
        claim("texture-by-samples", "With more samples both come to the same picture, as outlines do.",
              {falls("averaged", "globes", -1.5), falls("one texel", "globes", -1.5)}),
        claim("same-triangle", "Each way to find a triangle finds the same.",
              {zero(of::wrong, rows("none", "boxes", "grid", "tree"))}),
        claim("every-triangle",
              "To ask every triangle takes time in proportion to their number, or a little more where they leave the "
              "cache.",
              {slope(of::time, rows("none"), 0.9, 1.25)}),
        claim("boxes", "With a box for each patch it is a part of that.",
              {ratio(of::time, rows("boxes").upTo(65536), rows("none"), 0, 0.4)}),
        claim("grid", "A grid takes about the cube root of their number.", {slope(of::time, rows("grid"), 0.1, 0.5)}),
        claim("tree", "A thousandfold the triangles takes the tree less than 3 times the time: about the logarithm, 2.",
              {ratio(of::time, rows("tree").at(1048576), rows("tree").at(1024), 1, 3)}),
        claim("one-index",
              "With one index for all wavelengths the glass ball's colours are wrong by more than four times what "
              "three wavelengths leave.",
              {ratio(of::rms, rows("wavelengths").at(1), rows("wavelengths").at(3), 4, HUGE_VAL)}),
        claim("three-for-glass",
              "Three wavelengths, one for each primary, leave more than ten times the error of 32, and 1 % of the "
              "colours wrong.",
              {ratio(of::rms, rows("wavelengths").at(3), rows("wavelengths").at(32), 10, HUGE_VAL),
               value(of::wrong, rows("wavelengths").at(3), 0.5, 1.5)}),
        claim("more-wavelengths", "From four on the error falls by the number of wavelengths, or faster.",
              {slope(of::rms, rows("wavelengths").from(4), -1.6, -1)}),
        claim("glass-alone", "They are traced where glass is met: 32 take less than 16 times the time of one.",
              {ratio(of::time, rows("wavelengths").at(32), rows("wavelengths").at(1), 1, 16)}),
        note("None stops at 65536 triangles: a million times a thousand rays would take the study minutes. The picture "
             "is made of the same rays; its knob stops earlier."),
        claim("leaves-the-floor",
              "Of the rays that leave a floor y = 0 from the point itself a quarter or more meet it again, and as many "
              "from off it by each coordinate's roundings, which are 0 along y.",
              {atLeast(of::wrong, rows("point", "components").in("leaving"), 25)}),
        claim("leaves-strips",
              "Off it by roundings of the largest coordinate 2 % or more do where triangles are 512 times as long as "
              "wide, and more where they are longer; with a bound none.",
              {atLeast(of::wrong, rows("largest").in("leaving"), 2), zero(of::wrong, rows("bounded").in("leaving"))}),
    };
    return study;
}

[[maybe_unused]] const bool studied = addStudy("ray-trace", study());

}  // namespace
}  // namespace mv::ray_trace
