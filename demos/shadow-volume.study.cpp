// What measures shadow-volume: its shadows against rays, and what its stencil buffer holds.
#include <algorithm>

#include "mv/demo/demo.h"
#include "shared/false_shadows.h"
#include "shared/lit_reference.h"

using namespace mv;

namespace {

bool isOneCount(const Demo& demo, const FrameInfo& frame) {
    const Scene scene = demo.scene(frame);
    const auto casts = [](const SceneObject& object) { return object.casts; };
    return std::count_if(scene.objects.begin(), scene.objects.end(), casts) <= 255 || demo.word("groups") == "off" ||
           demo.word("show") == "count";
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
                   {"z-pass, started", {{"method", "z-pass-started"}}}};
    study.axis = ErrorAxis::fraction;
    study.says =
        "Volumes drawn out from silhouettes are exact: no pixel is wrong but in the band of one pixel at edges, by "
        "z-fail and, with the eye outside, by z-pass. Drawing out every triangle costs some twenty times as much on "
        "curved solids and is less exact, since the inner sides cancel only up to rounding; with the eye in a volume "
        "z-pass is wrong everywhere.";
    return study;
}

const bool studied = addStudy("shadow-volume", study());
const bool probed =
    addProbes("shadow-volume", {{{{"shadow-pixels", "pixels of the scene whose count is not 0"}}, pixelsInShadow},
                                {{{"stencil-max", "largest count of a pixel, where all is one count"}}, largestCount},
                                wrongShadows()});

}  // namespace
