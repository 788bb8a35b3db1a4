#include "mv/math/color.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/mat2x3.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "mv/error.h"
#include "mv/math/require.h"

namespace mv {
namespace {

template <typename T>
void requirePart(const char* subject, const char* name, T value) {
    if (!(value >= 0 && value <= 1)) {
        throw Error(subject, std::string(name).append(" must be 0 to 1"), numberText(static_cast<double>(value)));
    }
}

template <typename T>
void requireParts(const char* subject, const glm::vec<3, T>& rgb) {
    for (int i = 0; i < 3; ++i) {
        if (!(rgb[i] >= 0 && rgb[i] <= 1)) {
            throw Error(subject, "red, green and blue must be 0 to 1", vectorText(vec3(rgb)));
        }
    }
}

// The hue of a colour that is no grey: `most` is its largest component and `chroma` that less the smallest. At two
// equal largest ones both forms agree.
template <typename T>
T hueOf(const glm::vec<3, T>& rgb, T most, T chroma) {
    if (most == rgb.r) {
        const T hue = 60 * ((rgb.g - rgb.b) / chroma);
        // A hue just below 0 may round to a whole turn
        return hue >= 0 ? hue : (hue + 360 < 360 ? hue + 360 : T(0));
    }
    if (most == rgb.g) return 120 + 60 * ((rgb.b - rgb.r) / chroma);
    return 240 + 60 * ((rgb.r - rgb.g) / chroma);
}

// The colour of that hue whose largest component is `most` and whose smallest is `least`.
template <typename T>
glm::vec<3, T> colorOfHue(const char* subject, T hue, T most, T least) {
    requireFinite(subject, "hue", static_cast<double>(hue));
    const T turned = std::fmod(hue, T(360));
    const T sixths = (turned < 0 ? turned + 360 : turned) / 60;
    const T sector = std::floor(sixths), along = sixths - sector;
    const T rising = least + (most - least) * along, falling = most - (most - least) * along;
    switch (static_cast<int>(sector)) {
        case 1:
            return {falling, most, least};
        case 2:
            return {least, most, rising};
        case 3:
            return {least, falling, most};
        case 4:
            return {rising, least, most};
        case 5:
            return {most, least, falling};
        default:
            return {most, rising, least};  // 0, or a whole turn to rounding
    }
}

// A matrix whose rows have the sum 1, so that it keeps what is three times the same number: what the first and the last number
// weigh in each row. The middle one has what is left to 1, and is not asked for, so that greys stay greys to the last bit.
struct KeepsGrey {
    std::array<vec2, 3> weights;

    vec3 operator()(const vec3& v) const {
        const vec2 beside(v.x - v.y, v.z - v.y);
        return {v.y + dot(weights[0], beside), v.y + dot(weights[1], beside), v.y + dot(weights[2], beside)};
    }
};

// Light to what the eye's three kinds of cones are given, and, below, of their cube roots L, a and b: in L the weights have the
// sum 1, in a and b 0.
const KeepsGrey conesFromLinear{{vec2(0.412221469470763, 0.0514459932675022),
                                 vec2(0.2119034958178252, 0.1073969535369406),
                                 vec2(0.0883024591900564, 0.6299787016738222)}};
// The inverse, of exact fractions: where its products nearly cancel, what a rounded number lacks would grow.
const KeepsGrey linearFromCones{{vec2(4.076741636075958, 0.23096990318210484),
                                 vec2(-1.268437973285032, -0.3413193760026576),
                                 vec2(-0.0041960761386754565, 1.7076146940746117)}};
const vec2 lightnessOfRoots(0.210454268309314, -0.0040720430116193);
const glm::dmat2 abFromRoots(1.9779985324311684, 0.0259040424655478, 0.450593709617411, -0.8086757549230774);
// The columns for a and b: what they add to L in each root, by exact fractions too.
const glm::dmat2x3 rootsFromAb(0.396337777376175, -0.10556134581565857, -0.08948417752981183, 0.2158037573099136,
                               -0.06385417282581335, -1.2914855480194094);

// The primaries' X, Y, Z in such amounts that they make up white.
mat3 matrixOfPrimaries() {
    const auto xyz = [](const vec2& xy) { return vec3(xy.x / xy.y, 1, (1 - xy.x - xy.y) / xy.y); };
    const mat3 unscaled(xyz(srgbPrimaries[0]), xyz(srgbPrimaries[1]), xyz(srgbPrimaries[2]));
    const vec3 amounts = inverse(unscaled) * xyz(srgbWhite);
    return {unscaled[0] * amounts.r, unscaled[1] * amounts.g, unscaled[2] * amounts.b};
}

}  // namespace

double linearFromSrgb(double srgb) {
    requireFinite("linearFromSrgb", "srgb", srgb);
    const double size = std::abs(srgb);
    return std::copysign(size <= 0.04045 ? size / 12.92 : std::pow((size + 0.055) / 1.055, 2.4), srgb);
}

double srgbFromLinear(double linear) {
    requireFinite("srgbFromLinear", "linear", linear);
    const double size = std::abs(linear);
    return std::copysign(size <= 0.0031308 ? 12.92 * size : 1.055 * std::pow(size, 1 / 2.4) - 0.055, linear);
}

vec3 linearFromSrgb(const vec3& srgb) {
    return {linearFromSrgb(srgb.r), linearFromSrgb(srgb.g), linearFromSrgb(srgb.b)};
}
vec3 srgbFromLinear(const vec3& linear) {
    return {srgbFromLinear(linear.r), srgbFromLinear(linear.g), srgbFromLinear(linear.b)};
}

template <typename T>
HslOf<T> hslFromRgb(const glm::vec<3, T>& rgb) {
    requireParts("hslFromRgb", rgb);
    const T most = std::max({rgb.r, rgb.g, rgb.b}), least = std::min({rgb.r, rgb.g, rgb.b}), chroma = most - least;
    const T lightness = (most + least) / 2;
    if (chroma == 0) return {0, 0, lightness};
    // Above one half, from what is missing to white: 2 - most - least would lose its last places
    const T room = most + least <= 1 ? most + least : (1 - most) + (1 - least);
    return {hueOf(rgb, most, chroma), std::min(chroma / room, T(1)), lightness};
}

template <typename T>
glm::vec<3, T> rgbFromHsl(const HslOf<T>& hsl) {
    requirePart("rgbFromHsl", "saturation", hsl.saturation);
    requirePart("rgbFromHsl", "lightness", hsl.lightness);
    if (hsl.saturation == 0) return glm::vec<3, T>(hsl.lightness);
    const T half = hsl.saturation * std::min(hsl.lightness, 1 - hsl.lightness);
    return colorOfHue("rgbFromHsl", hsl.hue, std::min(hsl.lightness + half, T(1)), hsl.lightness - half);
}

template <typename T>
HsvOf<T> hsvFromRgb(const glm::vec<3, T>& rgb) {
    requireParts("hsvFromRgb", rgb);
    const T most = std::max({rgb.r, rgb.g, rgb.b}), chroma = most - std::min({rgb.r, rgb.g, rgb.b});
    if (chroma == 0) return {0, 0, most};
    return {hueOf(rgb, most, chroma), chroma / most, most};
}

template <typename T>
glm::vec<3, T> rgbFromHsv(const HsvOf<T>& hsv) {
    requirePart("rgbFromHsv", "saturation", hsv.saturation);
    requirePart("rgbFromHsv", "value", hsv.value);
    if (hsv.saturation == 0) return glm::vec<3, T>(hsv.value);
    return colorOfHue("rgbFromHsv", hsv.hue, hsv.value, hsv.value - hsv.saturation * hsv.value);
}

template HslOf<float> hslFromRgb(const fvec3&);
template HslOf<double> hslFromRgb(const vec3&);
template fvec3 rgbFromHsl(const HslOf<float>&);
template vec3 rgbFromHsl(const HslOf<double>&);
template HsvOf<float> hsvFromRgb(const fvec3&);
template HsvOf<double> hsvFromRgb(const vec3&);
template fvec3 rgbFromHsv(const HsvOf<float>&);
template vec3 rgbFromHsv(const HsvOf<double>&);

vec3 oklabFromLinear(const vec3& linear) {
    requireFinite("oklabFromLinear", "linear", linear);
    const vec3 cones = conesFromLinear(linear);
    const vec3 roots(std::cbrt(cones.x), std::cbrt(cones.y), std::cbrt(cones.z));
    const vec2 beside(roots.x - roots.y, roots.z - roots.y);
    return {roots.y + dot(lightnessOfRoots, beside), abFromRoots * beside};
}

vec3 linearFromOklab(const vec3& oklab) {
    requireFinite("linearFromOklab", "oklab", oklab);
    const vec3 roots = oklab.x + rootsFromAb * vec2(oklab.y, oklab.z);
    return linearFromCones(roots * roots * roots);
}

mat3 xyzFromLinear() {
    static const mat3 matrix = matrixOfPrimaries();
    return matrix;
}

mat3 linearFromXyz() {
    static const mat3 matrix = inverse(xyzFromLinear());
    return matrix;
}

double luminance(const vec3& linear) {
    requireFinite("luminance", "linear", linear);
    return (xyzFromLinear() * linear).y;
}

vec2 chromaticity(const vec3& xyz) {
    requireFinite("chromaticity", "xyz", xyz);
    const double sum = xyz.x + xyz.y + xyz.z;
    if (!(sum > 0)) throw Error("chromaticity", "X + Y + Z must be above 0", vectorText(xyz));
    return vec2(xyz) / sum;
}

vec2 uvFromXy(const vec2& xy) {
    requireFinite("uvFromXy", "xy", xy);
    const double divisor = 12 * xy.y - 2 * xy.x + 3;
    if (!(divisor > 0)) throw Error("uvFromXy", "12y - 2x + 3 must be above 0", vectorText(xy));
    return vec2(4 * xy.x, 9 * xy.y) / divisor;
}

std::span<const SpectralLight> colorMatching() {
    static const std::array<SpectralLight, 81> table{
        {{380, {0.001368, 3.9e-05, 0.00645}}, {385, {0.002236, 6.4e-05, 0.01055}}, {390, {0.004243, 0.00012, 0.02005}},
         {395, {0.00765, 0.000217, 0.03621}}, {400, {0.01431, 0.000396, 0.06785}}, {405, {0.02319, 0.00064, 0.1102}},
         {410, {0.04351, 0.00121, 0.2074}},   {415, {0.07763, 0.00218, 0.3713}},   {420, {0.13438, 0.004, 0.6456}},
         {425, {0.21477, 0.0073, 1.03905}},   {430, {0.2839, 0.0116, 1.3856}},     {435, {0.3285, 0.01684, 1.62296}},
         {440, {0.34828, 0.023, 1.74706}},    {445, {0.34806, 0.0298, 1.7826}},    {450, {0.3362, 0.038, 1.77211}},
         {455, {0.3187, 0.048, 1.7441}},      {460, {0.2908, 0.06, 1.6692}},       {465, {0.2511, 0.0739, 1.5281}},
         {470, {0.19536, 0.09098, 1.28764}},  {475, {0.1421, 0.1126, 1.0419}},     {480, {0.09564, 0.13902, 0.81295}},
         {485, {0.05795, 0.1693, 0.6162}},    {490, {0.03201, 0.20802, 0.46518}},  {495, {0.0147, 0.2586, 0.3533}},
         {500, {0.0049, 0.323, 0.272}},       {505, {0.0024, 0.4073, 0.2123}},     {510, {0.0093, 0.503, 0.1582}},
         {515, {0.0291, 0.6082, 0.1117}},     {520, {0.06327, 0.71, 0.07825}},     {525, {0.1096, 0.7932, 0.05725}},
         {530, {0.1655, 0.862, 0.04216}},     {535, {0.22575, 0.91485, 0.02984}},  {540, {0.2904, 0.954, 0.0203}},
         {545, {0.3597, 0.9803, 0.0134}},     {550, {0.43345, 0.99495, 0.00875}},  {555, {0.51205, 1, 0.00575}},
         {560, {0.5945, 0.995, 0.0039}},      {565, {0.6784, 0.9786, 0.00275}},    {570, {0.7621, 0.952, 0.0021}},
         {575, {0.8425, 0.9154, 0.0018}},     {580, {0.9163, 0.87, 0.00165}},      {585, {0.9786, 0.8163, 0.0014}},
         {590, {1.0263, 0.757, 0.0011}},      {595, {1.0567, 0.6949, 0.001}},      {600, {1.0622, 0.631, 0.0008}},
         {605, {1.0456, 0.5668, 0.0006}},     {610, {1.0026, 0.503, 0.00034}},     {615, {0.9384, 0.4412, 0.00024}},
         {620, {0.85445, 0.381, 0.00019}},    {625, {0.7514, 0.321, 0.0001}},      {630, {0.6424, 0.265, 5e-05}},
         {635, {0.5419, 0.217, 3e-05}},       {640, {0.4479, 0.175, 2e-05}},       {645, {0.3608, 0.1382, 1e-05}},
         {650, {0.2835, 0.107, 0}},           {655, {0.2187, 0.0816, 0}},          {660, {0.1649, 0.061, 0}},
         {665, {0.1212, 0.04458, 0}},         {670, {0.0874, 0.032, 0}},           {675, {0.0636, 0.0232, 0}},
         {680, {0.04677, 0.017, 0}},          {685, {0.0329, 0.01192, 0}},         {690, {0.0227, 0.00821, 0}},
         {695, {0.01584, 0.005723, 0}},       {700, {0.011359, 0.004102, 0}},      {705, {0.008111, 0.002929, 0}},
         {710, {0.00579, 0.002091, 0}},       {715, {0.004109, 0.001484, 0}},      {720, {0.002899, 0.001047, 0}},
         {725, {0.002049, 0.00074, 0}},       {730, {0.00144, 0.00052, 0}},        {735, {0.001, 0.000361, 0}},
         {740, {0.00069, 0.000249, 0}},       {745, {0.000476, 0.000172, 0}},      {750, {0.000332, 0.00012, 0}},
         {755, {0.000235, 8.5e-05, 0}},       {760, {0.000166, 6e-05, 0}},         {765, {0.000117, 4.2e-05, 0}},
         {770, {8.3e-05, 3e-05, 0}},          {775, {5.9e-05, 2.1e-05, 0}},        {780, {4.2e-05, 1.5e-05, 0}}}};
    return table;
}

std::vector<vec2> spectralLocus() {
    std::vector<vec2> places;
    for (const SpectralLight& light : colorMatching()) {
        if (light.nanometres <= 700) places.push_back(chromaticity(light.xyz));
    }
    return places;
}

}  // namespace mv
