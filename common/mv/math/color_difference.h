// Colours compared: CIELAB and the difference that is seen in it (CIEDE2000), the contrast of letters on a ground, and the
// colours of web pages.
#pragma once
#include <string>
#include <string_view>

#include "mv/math/types.h"

namespace mv {

// Linear sRGB as CIELAB for sRGB's own white: L* 0 for black to 100 for white, then a*, green to red, and b*, blue to yellow,
// about -110 to 110. A grey has a* = b* = 0 exactly. Light may be negative: below 0.9 % of white the curve is a straight line.
// Refused: what is not finite. Source: CIE 15:2004, section 8.2.1, with the exact fractions 216/24389 and 24389/27.
// Trap: printing uses the white D50, for which other numbers come out.
vec3 labFromLinear(const vec3& linear);

// How different two colours are seen, CIEDE2000 with factors of 1: about 1 is the least that is noticed side by side, and white and
// black are 100 apart. All digits are right for colours that are near each other: chroma and hue are compared by
// products, not by the differences of roots and angles. Traps: it is no distance: two ways between colours may be
// shorter than the straight one; and it jumps, by up to 1 % or so, where the hues are half a turn apart, and by up to 5e-6 of
// itself where the mean of the hues passes 360 degrees, which has a little of the weight of blue, and 0 none. For a* and b* 0
// or from 1e-100 in size. Refused: what is not finite, coordinates beyond 1e6. Source: Sharma, Wu and Dalal, "The
// CIEDE2000 color-difference formula: implementation notes, supplementary test data, and mathematical observations",
// Color Research and Application 30 (2005).
double colorDifference(const vec3& lab, const vec3& other);

// The contrast of two colours of linear sRGB: (brighter + 0.05)/(darker + 0.05) of their luminances, from 1 to 21. Letters ask for
// 4.5, large ones for 3. Refused: a luminance below 0 or above 1 by more than roundings, what is not finite.
// Source: Web Content Accessibility Guidelines 2.2 (2023), contrast ratio.
double contrast(const vec3& linear, const vec3& other);

// The srgb colour that style sheets write as #rgb or #rrggbb, in letters of either case. Refused: anything else.
vec3 srgbFromHex(std::string_view text);

// The same text, #rrggbb, of the nearest colour of 8 bits. Refused: components outside 0..1, NaN.
std::string hexFromSrgb(const vec3& srgb);

}  // namespace mv
