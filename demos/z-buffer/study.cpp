// The readouts of z-buffer, and its study: how many pairs of points the depths of each format and mapping put in
// order.
#include <cctype>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "z-buffer.h"

namespace mv::z_buffer {

using namespace claims;

// Judges pairs of points, one the part `separation` farther away: 1 for each whose depths are equal or the wrong way
// round.
static constexpr int pairCount = 100000;
std::vector<double> values(const Settings& s) {
    const mat4 clip = clipFromView(s, 1);
    return misorderedPairs(s.near, s.far, s.separation, pairCount, [&](float distance) {
        return (nearIsOne(s) ? -1 : 1) * keptDepth(s.format, depthOf(s, clip, distance));
    });
}

void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers) {
    // Compare the colours with what rays find
    const mat4 clip = clipFromView(s, frame.aspect());
    const double end = s.mapping == Mapping::infinite ? std::numeric_limits<double>::infinity() : s.far;
    const auto wrong =
        wrongPart(gpu.drawn.read(), colorsByRays(platesOf(s), {.tangents = {1 / clip[0][0], 1 / clip[1][1]},
                                                               .near = s.near,
                                                               .far = end,
                                                               .opacity = s.opacity,
                                                               .background = background,
                                                               .width = frame.width(),
                                                               .height = frame.height()}));
    frame.bindTarget();  // the figure is drawn next
    if (wrong) numbers.set("wrong-pixels", 100 * *wrong);

    const std::vector<double> pairs = values(s);
    numbers.set("misordered", 100 * std::accumulate(pairs.begin(), pairs.end(), 0.0) / pairCount);
}

namespace {

Study study() {
    Study study;
    study.quantity = "pairs of points at distances z and z (1 + separation) whose depths are not in order";
    study.reference = "which of the two is nearer, as they were made";
    study.makeReference = [](const Demo&, const ReferenceFrame&, const auto&) {
        return Reference{.values = std::vector<double>(pairCount, 0)};
    };
    study.problem = "far";
    study.scenes = {{"separation 1e-4", {{"near", "0.1"}, {"separation", "1e-4"}}},
                    {"separation 1e-5", {{"near", "0.1"}, {"separation", "1e-5"}}},
                    {"separation 1e-6", {{"near", "0.1"}, {"separation", "1e-6"}}}};
    for (const std::string mapping : {"standard", "infinite", "reversed", "flipped", "logarithmic"}) {
        for (const std::string format : {"D16", "D24", "D32F"}) {
            if (mapping == "flipped" && format != "D32F") continue;  // what it does to integers, reversed shows
            std::string word = format;
            for (char& letter : word) letter = char(std::tolower(letter));
            std::string method = format;
            method.append(" ").append(mapping);
            study.lines.push_back({.method = method,
                                   .settings = {{"format", word}, {"mapping", mapping}},
                                   .knob = "far",
                                   .values = {"100", "1e4", "1e6"}});
        }
    }
    study.axis = ErrorAxis::fraction;
    const auto reversed = rows("D32F reversed");
    study.says = {
        claim("reversed-float",
              "Float with reversed depth and glClipControl has every pair in order, and no other has at every "
              "separation.",
              {zero(of::wrong, reversed),
               atLeast(of::wrong,
                       rows("D16 standard", "D16 infinite", "D16 reversed", "D16 logarithmic", "D24 standard",
                            "D24 infinite", "D24 reversed", "D24 logarithmic", "D32F standard", "D32F infinite",
                            "D32F flipped", "D32F logarithmic")
                           .in("separation 1e-6"),
                       0.1)}),
        note("These are the depths alone. In a picture the rasterizer also rounds corners to 1/256 of a pixel, "
             "which moves depths: a road 1e-6 of the distance above the ground fights with it at its far end even "
             "so."),
        claim("without-clip-control",
              "Reversed without glClipControl, the float has up to three quarters of the pairs wrong.",
              {value(of::wrong, rows("D32F flipped").in("separation 1e-6"), 30, 75)}),
        claim("standard-float", "With standard depth the float misorders as many pairs as 24 bits do.",
              {ratio(of::wrong, rows("D32F standard"), rows("D24 standard"), 0.999, 1.001)}),
        claim("reversed-integer",
              "Reversing gains integers little: of the pairs that 24 bits misorder, where these are more than 1 %, "
              "at least five in six stay wrong.",
              {ratio(of::wrong, rows("D24 reversed").in("separation 1e-4").from(1e4), rows("D24 standard"), 0.83, 1),
               ratio(of::wrong, rows("D24 reversed").in("separation 1e-5"), rows("D24 standard"), 0.83, 1),
               ratio(of::wrong, rows("D24 reversed").in("separation 1e-6"), rows("D24 standard"), 0.83, 1)}),
        claim("logarithmic",
              "A logarithm in 24 bits or float orders all pairs down to 1e-5 apart; closer ones it does not.",
              {zero(of::wrong, rows("D24 logarithmic", "D32F logarithmic").in("separation 1e-4")),
               zero(of::wrong, rows("D24 logarithmic", "D32F logarithmic").in("separation 1e-5")),
               value(of::wrong, rows("D24 logarithmic", "D32F logarithmic").in("separation 1e-6"), 0.1, 20)}),
        claim("too-few-bits", "16 bits misorder a fifth of the pairs at least, whatever the mapping.",
              {atLeast(of::wrong, rows("D16 standard", "D16 infinite", "D16 reversed", "D16 logarithmic"), 20)}),
        note("The times are those of this model on a CPU and say nothing of a GPU's.")};
    study.ofValues = true;
    return study;
}

const bool studied = addStudy("z-buffer", study());

}  // namespace
}  // namespace mv::z_buffer
