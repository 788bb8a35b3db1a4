// sRGB's curve: what a file and a screen keep of a channel, and the light that it stands for.
//
// Light adds up; the kept numbers do not. Whoever averages, blends or filters does so in linear light. Source: IEC
// 61966-2-1; both pieces of each function meet to 1e-8 at the corner.
#pragma once
#include <cmath>

namespace mv {

// From light 0..1 to the number kept, 0..1; equals the write of GL_FRAMEBUFFER_SRGB. Trap: 8 bits keep 255 times this.
inline double srgbFromLinear(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

// The way back; equals the read of a GL_SRGB8_ALPHA8 texture.
inline double linearFromSrgb(double kept) {
    return kept <= 0.04045 ? kept / 12.92 : std::pow((kept + 0.055) / 1.055, 2.4);
}

}  // namespace mv
