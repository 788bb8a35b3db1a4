// X26: hue, saturation and lightness of greys, of what is lighter than white, and of all colours of 8 bits. Y23: OKLab's greys.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/math/color.h"

using namespace mv;
using namespace mv::test;

namespace {

// As it is usually written: nobody asks for greys, or for what is beyond white.
fvec3 usualHsl(const fvec3& rgb) {
    const float most = std::max({rgb.r, rgb.g, rgb.b}), least = std::min({rgb.r, rgb.g, rgb.b});
    const float chroma = most - least, lightness = (most + least) / 2;
    const float hue = most == rgb.r   ? (rgb.g - rgb.b) / chroma
                      : most == rgb.g ? 2 + (rgb.b - rgb.r) / chroma
                                      : 4 + (rgb.r - rgb.g) / chroma;
    return {60 * hue, lightness < 0.5F ? chroma / (most + least) : chroma / (2 - most - least), lightness};
}

[[maybe_unused]] const bool x26greys = addRow([] {
    double naive = 0, ours = 0;
    for (int i = 0; i <= 255; ++i) {
        const float grey = static_cast<float>(i) / 255;
        const fvec3 usual = usualHsl(fvec3(grey));
        for (int k = 0; k < 2; ++k) naive = worse(naive, std::abs(static_cast<double>(usual[k])));
        const HslOf<float> hsl = hslFromRgb(fvec3(grey));
        ours = worse(ours, static_cast<double>(std::abs(hsl.hue) + std::abs(hsl.saturation)));
    }
    return Row{.id = "X26 greys",
               .input = "the 256 greys",
               .measured = "hue and saturation, which ought to be 0; inf: NaN",
               .naive = "(g - b) / (max - min) in float",
               .naiveError = naive,
               .ours = "hslFromRgb",
               .ourError = ours,
               .tolerance = 0,
               .reason = "a grey has no hue: 0 by definition"};
});

[[maybe_unused]] const bool x26beyond = addRow([] {
    const fvec3 usual = usualHsl({1.5F, 1, 1});
    return Row{.id = "X26 beyond white",
               .input = "the colour (1.5, 1, 1), whose lightness is 1.25",
               .measured = "how far the saturation is below 0; 0 where it is refused",
               .naive = "(max - min) / (2 - max - min)",
               .naiveError = std::max(0.0, -static_cast<double>(usual.y)),
               .ours = "hslFromRgb refuses it",
               .ourError = accepted([] { (void)hslFromRgb(vec3(1.5, 1, 1)); }),
               .tolerance = 0,
               .reason = "refused"};
});

[[maybe_unused]] const bool x26all = addRow([] {
    long changed = 0, changedIn8 = 0;
    const auto in8 = [](float part) { return std::round(part * 255) / 255; };
    for (int code = 0; code < 1 << 24; ++code) {
        const fvec3 bytes(code >> 16, code >> 8 & 255, code & 255);
        const HslOf<float> hsl = hslFromRgb(bytes / 255.0F);
        const auto differs = [&](const fvec3& rgb) {
            return std::round(rgb.r * 255) != bytes.r || std::round(rgb.g * 255) != bytes.g ||
                   std::round(rgb.b * 255) != bytes.b;
        };
        changed += differs(rgbFromHsl(hsl)) ? 1 : 0;
        const HslOf<float> stored{in8(hsl.hue / 360) * 360, in8(hsl.saturation), in8(hsl.lightness)};
        changedIn8 += differs(rgbFromHsl(stored)) ? 1 : 0;
    }
    return Row{.id = "X26 all",
               .input = "all 2^24 colours of 8 bits, to HSL and back",
               .measured = "part of them that has become another",
               .naive = "HSL in 8 bits a number",
               .naiveError = static_cast<double>(changedIn8) / (1 << 24),
               .ours = "hslFromRgb and rgbFromHsl in float",
               .ourError = static_cast<double>(changed) / (1 << 24),
               .tolerance = 0,
               .reason = "each comes back"};
});

// OKLab by the numbers that were published first.
vec3 oklabOf2021(const vec3& linear) {
    const mat3 cones(0.4122214708, 0.2119034982, 0.0883024619, 0.5363325363, 0.6806995451, 0.2817188376, 0.0514459929,
                     0.1073969566, 0.6299787005),
        roots(0.2104542553, 1.9779984951, 0.0259040371, 0.7936177850, -2.4285922050, 0.7827717662, -0.0040720468,
              0.4505937099, -0.8086757660);
    const vec3 seen = cones * linear;
    return roots * vec3(std::cbrt(seen.x), std::cbrt(seen.y), std::cbrt(seen.z));
}

[[maybe_unused]] const bool y23 = addRow([] {
    double naive = 0, ours = 0;
    for (int i = 0; i <= 255; ++i) {
        const auto error = [&](const vec3& lab) { return glm::distance(lab, vec3(std::cbrt(i / 255.0), 0, 0)); };
        naive = worse(naive, error(oklabOf2021(vec3(i / 255.0))));
        ours = worse(ours, error(oklabFromLinear(vec3(i / 255.0))));
    }
    return Row{.id = "Y23",
               .input = "256 greys from black to white, as OKLab",
               .measured = "distance from the grey of that lightness, which has a and b of 0",
               .naive = "the matrices of 2021, of ten digits, times the colour",
               .naiveError = naive,
               .ours = "oklabFromLinear: CSS Color 4's, by differences from green",
               .ourError = ours,
               .tolerance = 0,
               .reason = "the differences are 0, and so is what is multiplied with them"};
});

}  // namespace
