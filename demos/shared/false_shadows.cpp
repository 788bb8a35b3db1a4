#include "shared/false_shadows.h"

#include <algorithm>
#include <cmath>

#include "mv/demo/cached.h"
#include "mv/demo/demo.h"
#include "shared/lit_reference.h"

namespace mv {

std::optional<FalseShadows> falseShadows(Probing& probing) {
    return falseShadows(probing, probing.demo().scene(probing.frame()));
}

std::optional<FalseShadows> falseShadows(Probing& probing, const Scene& scene) {
    constexpr double mostSide = 96;
    const FrameInfo& picture = probing.frame();
    const double scale = std::min(1.0, mostSide / std::max(picture.width(), picture.height()));
    const int width = std::max(1, int(std::lround(scale * picture.width())));
    const int height = std::max(1, int(std::lround(scale * picture.height())));
    // Through the picture's own camera: the grid has its shape but for rounding
    const std::vector<float> drawn = probing.measured(width, height, Camera{scene.viewFromWorld, scene.clipFromView});
    if (drawn.empty()) return {};

    // Kept while the scene rests: how its shadows are drawn changes nothing of it.
    static Cached<Reference, Scene, int, int> rays;
    const Reference& right = rays.of({scene, width, height}, [](const Scene& rested, int across, int down) {
        return litReference(rested, FrameInfo(1, across, down), {}, {});
    });
    FalseShadows result;
    long dark = 0, lit = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (right.regions[i] < 0 || drawn[i] < 0) continue;
        ++result.pixels;
        const bool isLit = drawn[i] > 0.5F, shouldBe = right.values[i] > 0.5;
        dark += shouldBe && !isLit ? 1 : 0;
        lit += isLit && !shouldBe ? 1 : 0;
    }
    if (result.pixels == 0) return result;
    result.dark = 100.0 * double(dark) / double(result.pixels);
    result.lit = 100.0 * double(lit) / double(result.pixels);
    return result;
}

Probe wrongShadows(Literal help) {
    return {.numbers = {{"wrong", help, "%"}}, .measure = [](Probing& probing) -> std::vector<double> {
                const auto found = falseShadows(probing);
                if (!found) return {};
                return {found->dark + found->lit};
            }};
}

}  // namespace mv
