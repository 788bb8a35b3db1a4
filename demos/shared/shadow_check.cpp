#include "shared/shadow_check.h"

#include <algorithm>
#include <cmath>

#include "shared/lit_reference.h"
#include "shared/measured.h"

namespace mv {

std::optional<FalseShadows> ShadowCheck::compare(const Scene& scene, const Frame& frame,
                                                 const std::function<void()>& draw) {
    if (!floatTargets()) return {};
    constexpr double mostSide = 96;
    const double scale = std::min(1.0, mostSide / std::max(frame.width(), frame.height()));
    const int width = std::max(1, int(std::lround(scale * frame.width())));
    const int height = std::max(1, int(std::lround(scale * frame.height())));
    target_.fit(width, height, {.depth = true, .stencil = true, .color = GL_R32F}, "shadow check");
    const std::vector<float> drawn = drawMeasured(target_, frame, draw);

    const Reference right = litReference(scene, FrameInfo(frame.index(), width, height), {}, {});
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

}  // namespace mv
