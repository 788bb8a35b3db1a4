// The study of shadow-volume: its shadows against rays, and what its stencil buffer holds.
#include <algorithm>
#include <cmath>

#include "mv/demo/lesson.h"
#include "shadow-volume.h"
#include "shared/false_shadows.h"
#include "shared/lit_reference.h"

using namespace mv::claims;

namespace mv::shadow_volume {
namespace {

bool isOneCount(const Demo& demo, const FrameInfo& frame) {
    const Settings s = settingsOf<Settings>(demo);
    return !needsGroups(s, casterPlaces(sceneOf(s, frame)).size());
}

std::vector<double> pixelsInShadow(Probing& probing) {
    const std::vector<unsigned char> counts = probing.stencil();
    const std::vector<float> depths = probing.depths();
    if (counts.empty()) return {};
    long dark = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) dark += counts[i] > 0 && depths[i] < 1 ? 1 : 0;
    return {double(dark)};
}

std::vector<double> largestCount(Probing& probing) {
    const std::vector<unsigned char> counts = probing.stencil();
    const std::vector<float> depths = probing.depths();
    if (counts.empty() || !isOneCount(probing.demo(), probing.frame())) return {};
    int most = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (depths[i] < 1) most = std::max(most, int(counts[i]));  // else nothing is seen there
    }
    return {double(most)};
}

Study study() {
    Study study;
    study.quantity = "lit or in shadow, of the pixels that face the light";
    study.reference = "one ray through each pixel and one to the light, in double precision";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto& progress) {
        return litReference(demo.scene(frame), frame, {}, progress);
    };
    study.scenes = {{"cube", {{"scene", "cube"}}},
                    {"still-life", {{"scene", "still-life"}}},
                    {"40 shells", {{"scene", "nested"}, {"shells", "40"}}},
                    {"eye in a volume", {{"scene", "cube"}, {"eye", "in-volume"}}}};
    study.lines = {{"z-fail", {}},
                   {"z-fail, every triangle", {{"silhouette", "off"}}},
                   {"z-pass", {{"method", "z-pass"}}},
                   {"z-pass, started", {{"method", "z-pass-started"}}},
                   {"z-pass, started, geometry shader", {{"method", "z-pass-started"}, {"by", "geometry-shader"}}}};
    study.reads = {"scene",        "shells",      "eye",    "far",    "light-turn",
                   "light-height", "at-infinity", "spin-x", "spin-y", "distance"};
    study.axis = ErrorAxis::fraction;
    const auto zFail = rows("z-fail"), zPass = rows("z-pass"), started = rows("z-pass, started"),
               every = rows("z-fail, every triangle");
    study.says = {
        claim("exact",
              "Volumes drawn out from silhouettes are exact: away from edges no pixel is wrong, by z-fail, by "
              "z-pass that starts with the count at the eye, and by plain z-pass where "
              "the eye is outside; at "
              "edges at most 0.0015 % are.",
              {zero(of::wrongAwayFromEdges, rows("z-fail", "z-pass, started")),
               zero(of::wrongAwayFromEdges, zPass.in("cube")), zero(of::wrongAwayFromEdges, zPass.in("still-life")),
               zero(of::wrongAwayFromEdges, zPass.in("40 shells")),
               atMost(of::wrong, rows("z-fail", "z-pass, started"), 0.0015)}),
        claim("neighbours-know",
              "On a processor too, silhouettes that a geometry shader finds are exact: away from edges no pixel is "
              "wrong.",
              {zero(of::wrongAwayFromEdges, rows("z-pass, started, geometry shader")),
               atMost(of::wrong, rows("z-pass, started, geometry shader"), 0.0015)}),
        claim("eye-in-volume", "With the eye in a volume, plain z-pass is wrong everywhere.",
              {atLeast(of::wrong, zPass.in("eye in a volume"), 100)}),
        claim("every-triangle-costs",
              "Drawing out every triangle of the still life's round bodies fills ten times the fragments and takes "
              "nine times as long at least.",
              {ratio(of::count("fragments"), every.in("still-life"), zFail, 10, HUGE_VAL),
               ratio(of::time, every.in("still-life"), zFail, 9, HUGE_VAL)}),
        claim("every-triangle-errs",
              "On boxes that is as exact; on round bodies, drawn on a processor, it is less, since the inner sides "
              "cancel only up to rounding.",
              {zero(of::wrongAwayFromEdges, every.in("cube")), zero(of::wrongAwayFromEdges, every.in("40 shells")),
               zero(of::wrongAwayFromEdges, every.in("eye in a volume")),
               atLeast(of::wrongAwayFromEdges, every.in("still-life"), 0.005)}),
        claim("no-caps", "Z-pass needs no caps, which are half of a box's volume at least.",
              {ratio(of::count("volume triangles"), rows("z-pass", "z-pass, started"), zFail, 0, 0.5)})};
    return study;
}

const bool studied = addStudy("shadow-volume", study());
const bool probed =
    addProbes("shadow-volume", {{{{"shadow-pixels", "pixels of the scene whose count is not 0"}}, pixelsInShadow},
                                {{{"stencil-max", "largest count of a pixel, where all is one count"}}, largestCount},
                                wrongShadows()});

}  // namespace
}  // namespace mv::shadow_volume
