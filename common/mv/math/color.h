// Colours as numbers: sRGB as a screen is given it, light that adds up, hue, saturation and lightness, what is seen as
// even (OKLab), and the chromaticity diagram with the spectrum round it.
//
// A colour is a vec3 of red, green and blue. "srgb" is encoded as files and screens have it; "linear" is proportional to
// light. HSL and HSV are made of either by the same formulas; in use it is srgb.
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mv/math/types.h"

namespace mv {

// ---- sRGB and light

// The light of an encoded component: c / 12.92 up to 0.04045, above it ((c + 0.055) / 1.055)^2.4. 0 and 1 stay. Negative
// numbers, which colours beyond a screen's have, are treated as their sizes and keep their sign.
// Trap: the standard's two branches do not quite meet: at 0.04045 the light jumps by 2e-8 of 1.
// Refused: what is not finite. Source: IEC 61966-2-1:1999.
double linearFromSrgb(double srgb);
vec3 linearFromSrgb(const vec3& srgb);

// The encoded component of light: 12.92 x up to 0.0031308, above it 1.055 x^(1/2.4) - 0.055. 0 and 1 stay. The function
// is the inverse of the above to roundings, but between the two numbers where the branches change (8e-8 of 1 there).
// Refused: what is not finite. Source: IEC 61966-2-1:1999.
double srgbFromLinear(double linear);
vec3 srgbFromLinear(const vec3& linear);

// ---- hue, saturation, and lightness or value; for float and double

// A point of the double cone: hue in degrees, 0 up to below 360 (red 0, green 120, blue 240), saturation and lightness
// from 0 to 1.
template <typename T>
struct HslOf {
    T hue, saturation, lightness;
    bool operator==(const HslOf&) const = default;
};
using Hsl = HslOf<double>;

// A point of the cone: the same with the value, which is the largest of red, green and blue.
template <typename T>
struct HsvOf {
    T hue, saturation, value;
    bool operator==(const HsvOf&) const = default;
};
using Hsv = HsvOf<double>;

// The colour as HSL. A grey has no hue: it gets hue 0 and saturation 0, black and white among them.
// Trap: the hue jumps where a colour crosses a grey; who mixes by hue must ask for saturation 0 first.
// Refused: components outside 0..1, NaN; a lightness above 1 would give a saturation of -1.
// Source: Joblove and Greenberg, "Color spaces for computer graphics" (1978).
template <typename T>
HslOf<T> hslFromRgb(const glm::vec<3, T>& rgb);

// The inverse. The hue is any angle: whole turns are dropped. The hue is not read where the saturation is 0.
// Refused: saturation or lightness outside 0..1, a hue that is not finite.
template <typename T>
glm::vec<3, T> rgbFromHsl(const HslOf<T>& hsl);

// The same for HSV; black has saturation 0, too. Source: Smith, "Color gamut transform pairs" (1978).
template <typename T>
HsvOf<T> hsvFromRgb(const glm::vec<3, T>& rgb);
template <typename T>
glm::vec<3, T> rgbFromHsv(const HsvOf<T>& hsv);

// ---- what is seen as even

// Light as OKLab: lightness as seen, 0 for black to 1 for white, then green to red and blue to yellow, about -0.4 to 0.4.
// Distances in it are about those that are seen. Light may be negative. White is (1, 0, 0), and a grey of light x is
// (cbrt(x), 0, 0), both exactly.
// Trap: the author's own matrices of 25 January 2021 have ten digits, by which white has L = 0.9999999935 and b = 3.7e-8; colours
// differ by up to 4e-8 from those. CSS Color 4, culori and color.js have the ones used here.
// Refused: what is not finite. Source: Ottosson, "A perceptual color space for image processing" (2020), with the matrices
// of W3C, CSS Color Module Level 4, computed anew for the white of srgbWhite in 64 bits.
vec3 oklabFromLinear(const vec3& linear);

// The inverse, by the inverted matrices, so that there and back differs by roundings alone.
// Trap: OKLab holds colours that no screen shows: they come out below 0 or above 1.
// Refused: what is not finite.
vec3 linearFromOklab(const vec3& oklab);

// ---- chromaticity

// The primaries of sRGB and its white (D65) in the diagram of 1931. Source: IEC 61966-2-1:1999, which has BT.709's.
inline constexpr std::array<vec2, 3> srgbPrimaries{vec2(0.64, 0.33), vec2(0.30, 0.60), vec2(0.15, 0.06)};
inline constexpr vec2 srgbWhite{0.3127, 0.3290};

// CIE XYZ of linear sRGB, Y of white being 1, as a matrix for columns; computed from the above, so that it has all digits
// where the standard prints four. And its inverse.
mat3 xyzFromLinear();
mat3 linearFromXyz();

// How bright light is, 0.2126 r + 0.7152 g + 0.0722 b: the Y of xyzFromLinear(). Refused: what is not finite.
// Trap: it is of light, not of srgb components.
double luminance(const vec3& linear);

// The place (x, y) in the diagram of 1931: X and Y divided by X + Y + Z. Refused: a sum that is not above 0 (black has no
// chromaticity), what is not finite.
vec2 chromaticity(const vec3& xyz);

// The place (u', v') of (x, y) in the diagram of 1976, whose distances are nearer to those seen: 4x and 9y divided by
// 12y - 2x + 3. Straight lines stay straight. Refused: a divisor that is not above 0, what is not finite.
vec2 uvFromXy(const vec2& xy);

// How much the standard observer of 1931 (2 degrees) sees of light of one wavelength, as X, Y and Z.
struct SpectralLight {
    int nanometres;
    vec3 xyz;
};
// From 380 to 780 nm by 5 nm. From 700 nm on the chromaticity is that of 700 nm, nearly.
// Source: CIE 15:2004, table T.4, and CIE 018:2019, table 6.
std::span<const SpectralLight> colorMatching();

// The chromaticities (x, y) of light of one wavelength, from 380 to 700 nm by 5 nm, round what is seen: inside of them, and
// of the line from the last to the first, which no single wavelength has. As a polygon its area is
// short by about 0.3 %: it is 0.9 % larger than by steps of 10 nm.
std::vector<vec2> spectralLocus();

}  // namespace mv
