// color.h.
#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "accuracy/function.h"
#include "mv/math/color.h"

namespace mv::accuracy {
namespace {

using test::wide;
using test::Wide3;

using WideRows = std::array<Wide3, 3>;

Wide3 times(const WideRows& rows, const Wide3& v) { return {{dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)}}; }
// The same with all terms' sizes: what their roundings are a part of.
Wide3 timesSizes(const WideRows& rows, const Wide3& v) {
    Wide3 sum{{0, 0, 0}};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) sum[i] += abs(rows[i][k] * v[k]);
    }
    return sum;
}
WideRows inverted(const WideRows& m) {
    const Wide3 a = cross(m[1], m[2]), b = cross(m[2], m[0]), c = cross(m[0], m[1]);
    const Wide determinant = dot(m[0], a);
    WideRows result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = {{a[i] / determinant, b[i] / determinant, c[i] / determinant}};
    return result;
}
std::vector<Wide> listOf(const Wide3& v) { return {v[0], v[1], v[2]}; }

// A decimal of the sources.
Wide decimal(const char* digits) { return Wide(digits); }

// Rows of the sum 1 or 0: the middle number is what is left of that, where the source's is rounded to 16 digits.
Wide3 rowOf(int sum, const char* first, const char* last) {
    return {{decimal(first), sum - decimal(first) - decimal(last), decimal(last)}};
}
const WideRows& conesFromLight() {
    static const WideRows rows{{rowOf(1, "0.412221469470763", "0.0514459932675022"),
                                rowOf(1, "0.2119034958178252", "0.1073969535369406"),
                                rowOf(1, "0.0883024591900564", "0.6299787016738222")}};
    return rows;
}
const WideRows& labFromRoots() {
    static const WideRows rows{{rowOf(1, "0.210454268309314", "-0.0040720430116193"),
                                rowOf(0, "1.9779985324311684", "0.450593709617411"),
                                rowOf(0, "0.0259040424655478", "-0.8086757549230774")}};
    return rows;
}

// The rows of xyzFromLinear(), from the same primaries and white.
const WideRows& xyzFromLight() {
    static const WideRows rows = [] {
        const auto xyz = [](const Wide& x, const Wide& y) { return Wide3{{x / y, 1, (1 - x - y) / y}}; };
        const std::array<Wide3, 3> columns{xyz(decimal("0.64"), decimal("0.33")), xyz(decimal("0.30"), decimal("0.60")),
                                           xyz(decimal("0.15"), decimal("0.06"))};
        WideRows unscaled;
        for (std::size_t i = 0; i < 3; ++i) unscaled[i] = {{columns[0][i], columns[1][i], columns[2][i]}};
        const Wide3 amounts = times(inverted(unscaled), xyz(decimal("0.3127"), decimal("0.3290")));
        for (Wide3& row : unscaled) {
            for (std::size_t k = 0; k < 3; ++k) row[k] *= amounts[k];
        }
        return unscaled;
    }();
    return rows;
}
// A component: in the whole domain down to 1e-12, or up to 2.
Arguments parts(Random& random, Domain domain) {
    return {domain == Domain::whole ? random.logarithmic(1e-12, 2) : random.number(0, 1)};
}
// A colour: in the whole domain also as dark as 1e-12, as light, and as grey.
Arguments colors(Random& random, Domain domain) {
    Arguments a{};
    const double size = domain == Domain::whole ? random.logarithmic(1e-12, 1) : 1;
    const double apart = domain == Domain::whole ? random.logarithmic(1e-12, 1) : 1;
    const bool isLight = domain == Domain::whole && random.sign() > 0;
    const double grey = random.number(0, 1);
    for (std::size_t i = 0; i < 3; ++i) {
        const double part = size * (grey + apart * (random.number(0, 1) - grey));
        a[i] = isLight ? 1 - part : part;
    }
    return a;
}
Arguments hues(Random& random, Domain domain) {
    const double turns = domain == Domain::whole ? random.number(-1000, 1000) : random.number(0, 1);
    const double saturation = random.number(0, 1);
    const double third = domain == Domain::whole ? random.logarithmic(1e-12, 1) : random.number(0, 1);
    return {360 * turns, saturation, domain == Domain::whole && random.sign() > 0 ? 1 - third : third};
}
bool arePositive(const Arguments& a, double least, double most) {
    return std::all_of(a.begin(), a.begin() + 3,
                       [=](double part) { return part == 0 || (part >= least && part <= most); });
}
bool areParts(const Arguments& a) { return arePositive(a, 1e-150, 1); }
bool isHueAndParts(const Arguments& a) { return std::abs(a[0]) <= 360000 && arePositive({a[1], a[2]}, 1e-150, 1); }

// The hue between -60 and 300, so that no rounding goes round the whole turn.
Wide trueHue(const Arguments& a, const Wide& most, const Wide& chroma) {
    if (chroma == 0) return 0;
    if (most == a[0]) return 60 * (Wide(a[1]) - a[2]) / chroma;
    if (most == a[1]) return 120 + 60 * (Wide(a[2]) - a[0]) / chroma;
    return 240 + 60 * (Wide(a[0]) - a[1]) / chroma;
}
double hueWithoutTurn(double hue, const Arguments& a) {
    return a[0] >= a[1] && a[0] >= a[2] && hue > 180 ? hue - 360 : hue;
}
Truth cylinderTruth(const Arguments& a, bool isValue) {
    const Wide most = std::max({a[0], a[1], a[2]}), least = std::min({a[0], a[1], a[2]}), chroma = most - least;
    const Wide room = isValue ? most : most + least <= 1 ? Wide(most + least) : Wide(2 - most - least);
    const Wide saturation = chroma == 0 ? Wide(0) : chroma / room;
    Truth truth = entrywise({trueHue(a, most, chroma), saturation, isValue ? most : (most + least) / 2});
    truth.sizes = {Wide(360), sizeOf(truth.values[1]), sizeOf(truth.values[2])};
    return truth;
}
Truth hueTruth(const Arguments& a, bool isValue) {
    const Wide s = a[1], third = a[2];
    const Wide half = s * std::min<Wide>(third, 1 - third);
    const Wide most = isValue ? third : third + half, least = isValue ? third * (1 - s) : third - half;
    Wide sixths = fmod(Wide(a[0]), Wide(360)) / 60;
    if (sixths < 0) sixths += 6;
    // 1 up to a sixth of a turn away, from there to the next straight down to 0
    const auto component = [&](int middle) {
        Wide apart = abs(sixths - middle);
        apart = std::min<Wide>(apart, 6 - apart);
        return Wide(least + (most - least) * std::clamp<Wide>(2 - apart, 0, 1));
    };
    return oneBlock({component(0), component(2), component(4)});
}

}  // namespace

std::vector<Function> colorFunctions() {
    const std::string partsDomain = "1e-12 to 2";
    std::vector<Function> list;
    list.push_back(withForms(
        {.name = "linearFromSrgb",
         .header = "color.h",
         .returns = "the light of an sRGB component",
         .measured = "entrywise",
         .domain = partsDomain,
         .bound = 10,
         .reason =
             "in 2^-53: 2.4 times the 2.6 of a sum, a quotient and their constants, 1.9 of the exponent's rounding at "
             "the smallest base; and 1 ulp of the power itself",
         .sample = parts,
         .truth =
             [](const Arguments& a) {
                 const Wide size = abs(Wide(a[0]));
                 const Wide light = std::abs(a[0]) <= 0.04045
                                        ? Wide(size / decimal("12.92"))
                                        : Wide(pow((size + decimal("0.055")) / decimal("1.055"), decimal("2.4")));
                 return entrywise({a[0] < 0 ? -light : light});
             },
         .limits = "0, or from 1e-150 to 2 in size",
         .within = sizesBetween(1e-150, 2)},
        [](const Arguments& a) { return linearFromSrgb(a[0]); }));
    list.push_back(withForms(
        {.name = "srgbFromLinear",
         .header = "color.h",
         .returns = "the sRGB component of light",
         .measured = "entrywise",
         .domain = partsDomain,
         .bound = 12,
         .reason =
             "0.055 is taken from 0.095 at the least, which makes 2.4 of all before it, in 2^-53: 2 of the power, 1 of "
             "its exponent, 1.5 of the product and its constant; and 1 of the difference",
         .sample = parts,
         .truth =
             [](const Arguments& a) {
                 const Wide size = abs(Wide(a[0]));
                 const Wide code = std::abs(a[0]) <= 0.0031308
                                       ? Wide(decimal("12.92") * size)
                                       : Wide(decimal("1.055") * pow(size, 1 / decimal("2.4")) - decimal("0.055"));
                 return entrywise({a[0] < 0 ? -code : code});
             },
         .limits = "0, or from 1e-150 to 2 in size",
         .within = sizesBetween(1e-150, 2)},
        [](const Arguments& a) { return srgbFromLinear(a[0]); }));
    const std::string hueDomain = "colours, down to 1e-12 of black, white or a grey";
    list.push_back(withForms({.name = "hslFromRgb",
                              .header = "color.h",
                              .returns = "hue, saturation and lightness",
                              .measured = "the hue in ulp of 360, the others entrywise",
                              .domain = hueDomain,
                              .reason = "",
                              .sample = colors,
                              .truth = [](const Arguments& a) { return cylinderTruth(a, false); },
                              .limits = "components 0, or from 1e-150 to 1",
                              .within = areParts},
                             [](const Arguments& a) {
                                 const Hsl hsl = hslFromRgb(vectorAt(a, 0));
                                 return vec3(hueWithoutTurn(hsl.hue, a), hsl.saturation, hsl.lightness);
                             }));
    const std::string turnsDomain = "hues of -1000 to 1000 turns, down to 1e-12 of black or white";
    const std::string turnsLimits = "hues up to 1000 turns; the others 0, or from 1e-150 to 1";
    const std::string turnsReason =
        "in 2^-53 of the largest component: 4.3 of a hue to which a turn is added, 4 of its sixths; 1.5 ulp of the way "
        "between the components, and 1 of each of them";
    list.push_back(withForms({.name = "rgbFromHsl",
                              .header = "color.h",
                              .returns = "the colour of hue, saturation and lightness",
                              .measured = "ulp of the largest component",
                              .domain = turnsDomain,
                              .bound = 12,
                              .reason = turnsReason,
                              .sample = hues,
                              .truth = [](const Arguments& a) { return hueTruth(a, false); },
                              .limits = turnsLimits,
                              .within = isHueAndParts},
                             [](const Arguments& a) {
                                 return rgbFromHsl(Hsl{a[0], a[1], a[2]});
                             }));
    list.push_back(withForms({.name = "hsvFromRgb",
                              .header = "color.h",
                              .returns = "hue, saturation and value",
                              .measured = "the hue in ulp of 360, the others entrywise",
                              .domain = hueDomain,
                              .reason = "",
                              .sample = colors,
                              .truth = [](const Arguments& a) { return cylinderTruth(a, true); },
                              .limits = "components 0, or from 1e-150 to 1",
                              .within = areParts},
                             [](const Arguments& a) {
                                 const Hsv hsv = hsvFromRgb(vectorAt(a, 0));
                                 return vec3(hueWithoutTurn(hsv.hue, a), hsv.saturation, hsv.value);
                             }));
    list.push_back(withForms({.name = "rgbFromHsv",
                              .header = "color.h",
                              .returns = "the colour of hue, saturation and value",
                              .measured = "ulp of the largest component",
                              .domain = turnsDomain,
                              .bound = 12,
                              .reason = turnsReason,
                              .sample = hues,
                              .truth = [](const Arguments& a) { return hueTruth(a, true); },
                              .limits = turnsLimits,
                              .within = isHueAndParts},
                             [](const Arguments& a) {
                                 return rgbFromHsv(Hsv{a[0], a[1], a[2]});
                             }));
    list.push_back(withForms(
        {.name = "oklabFromLinear",
         .header = "color.h",
         .returns = "OKLab of light",
         .measured = "ulp of L",
         .domain = hueDomain,
         .bound = 65,
         .reason =
             "a is a sum of terms whose sizes are up to 5.14 times L, each with 12.5 roundings: 7.4 of a cube root "
             "(glibc's is off by up to 3.67 ulp), 1.2 that it leaves of the cones', 3.9 of the product",
         .sample = colors,
         .truth =
             [](const Arguments& a) {
                 const Wide3 cones = times(conesFromLight(), wide(vectorAt(a, 0)));
                 return oneBlock(listOf(times(labFromRoots(), {{cbrt(cones[0]), cbrt(cones[1]), cbrt(cones[2])}})));
             },
         .limits = "components 0, or from 1e-150 to 1",
         .within = areParts},
        [](const Arguments& a) { return oklabFromLinear(vectorAt(a, 0)); }));
    list.push_back(withForms(
        {.name = "linearFromOklab",
         .header = "color.h",
         .returns = "the light of an OKLab colour",
         .measured = "ulp of the terms, without their signs, of the cubes' roots too",
         .domain = "L from 1e-12 to 1, a and b up to 0.4 of it",
         .bound = 23,
         .reason = "in 2^-53: a cube makes 3 of each of its root's, 1.3 of a matrix entry and 3 of the product, and "
                   "adds 2; the "
                   "second product has 4.5 of an entry and 3",
         .sample =
             [](Random& random, Domain domain) {
                 const double l = domain == Domain::whole ? random.logarithmic(1e-12, 1) : random.number(0.1, 1);
                 const double a = random.number(-0.4, 0.4);
                 return Arguments{l, l * a, l * random.number(-0.4, 0.4)};
             },
         .truth =
             [](const Arguments& a) {
                 static const WideRows rootsFromLab = inverted(labFromRoots()),
                                       lightFromCones = inverted(conesFromLight());
                 const auto cubed = [](const Wide3& v) {
                     return Wide3{{v[0] * v[0] * v[0], v[1] * v[1] * v[1], v[2] * v[2] * v[2]}};
                 };
                 const Wide3 lab = wide(vectorAt(a, 0));
                 Truth truth = entrywise(listOf(times(lightFromCones, cubed(times(rootsFromLab, lab)))));
                 truth.sizes = listOf(timesSizes(lightFromCones, cubed(timesSizes(rootsFromLab, lab))));
                 for (Wide& size : truth.sizes) size = sizeOf(size);
                 return truth;
             },
         .limits = "numbers 0, or from 1e-90 to 1e90 in size",
         .within = sizesBetween(1e-90, 1e90)},
        [](const Arguments& a) { return linearFromOklab(vectorAt(a, 0)); }));
    list.push_back(withForms(
        {.name = "xyzFromLinear",
         .header = "color.h",
         .returns = "the matrix from linear sRGB to XYZ (timed and measured: its product with a colour)",
         .measured = "ulp of the largest of X, Y and Z",
         .domain = hueDomain,
         .bound = 8,
         .reason = "in 2^-53: 4.8 of an entry (14 of one in Z that is a twentieth of X's), and 3 of the product",
         .sample = colors,
         .truth = [](const Arguments& a) { return oneBlock(listOf(times(xyzFromLight(), wide(vectorAt(a, 0))))); },
         .limits = "components 0, or from 1e-150 to 1",
         .within = areParts},
        [](const Arguments& a) { return xyzFromLinear() * vectorAt(a, 0); }));
    list.push_back(
        withForms({.name = "linearFromXyz",
                   .header = "color.h",
                   .returns = "the matrix from XYZ to linear sRGB (timed and measured: its product with X, Y and Z)",
                   .measured = "ulp of the terms, without their signs",
                   .domain = hueDomain,
                   .bound = 7,
                   .reason = "in 2^-53: 3.5 of an entry, and 3 of the product",
                   .sample = colors,
                   .truth =
                       [](const Arguments& a) {
                           static const WideRows rows = inverted(xyzFromLight());
                           Truth truth = entrywise(listOf(times(rows, wide(vectorAt(a, 0)))));
                           truth.sizes = listOf(timesSizes(rows, wide(vectorAt(a, 0))));
                           for (Wide& size : truth.sizes) size = sizeOf(size);
                           return truth;
                       },
                   .limits = "X, Y and Z 0, or from 1e-150 to 1",
                   .within = areParts},
                  [](const Arguments& a) { return linearFromXyz() * vectorAt(a, 0); }));
    list.push_back(withForms(
        {.name = "luminance",
         .header = "color.h",
         .returns = "how bright light is",
         .measured = "entrywise",
         .domain = hueDomain,
         .bound = 8,
         .reason = "as of xyzFromLinear",
         .sample = colors,
         .truth = [](const Arguments& a) { return entrywise({dot(xyzFromLight()[1], wide(vectorAt(a, 0)))}); },
         .limits = "components 0, or from 1e-150 to 1",
         .within = areParts},
        [](const Arguments& a) { return luminance(vectorAt(a, 0)); }));
    list.push_back(withForms({.name = "chromaticity",
                              .header = "color.h",
                              .returns = "the place in the diagram of 1931",
                              .measured = "entrywise",
                              .domain = hueDomain,
                              .reason = "",
                              .sample = colors,
                              .truth =
                                  [](const Arguments& a) {
                                      const Wide sum = Wide(a[0]) + a[1] + a[2];
                                      return entrywise({a[0] / sum, a[1] / sum});
                                  },
                              .limits = "X, Y and Z 0, or from 1e-150 to 1",
                              .within = areParts},
                             [](const Arguments& a) { return chromaticity(vectorAt(a, 0)); }));
    list.push_back(withForms({.name = "uvFromXy",
                              .header = "color.h",
                              .returns = "the place in the diagram of 1976",
                              .measured = "entrywise",
                              .domain = "x and y from 1e-12 to 1",
                              .reason = "",
                              .sample =
                                  [](Random& random, Domain domain) {
                                      const double x = parts(random, Domain::ordinary)[0];
                                      const double least = domain == Domain::whole ? 1e-12 : 1e-3;
                                      return Arguments{x * random.logarithmic(least, 1), random.logarithmic(least, 1)};
                                  },
                              .truth =
                                  [](const Arguments& a) {
                                      const Wide divisor = 12 * Wide(a[1]) - 2 * Wide(a[0]) + 3;
                                      return entrywise({4 * Wide(a[0]) / divisor, 9 * Wide(a[1]) / divisor});
                                  },
                              .limits = "x and y 0, or from 1e-150 to 1",
                              .within =
                                  [](const Arguments& a) {
                                      return arePositive({a[0], a[1]}, 1e-150, 1);
                                  }},
                             [](const Arguments& a) { return uvFromXy(vec2(a[0], a[1])); }));
    return list;
}

}  // namespace mv::accuracy
