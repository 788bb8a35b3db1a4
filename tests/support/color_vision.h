// Colours as they are seen with fewer kinds of cones.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "mv/math/color.h"
#include "mv/math/color_difference.h"

namespace mv::test {

// The least difference (CIEDE2000) of any two of the colours of sRGB for any of three observers: one with all cones, one without
// those of long waves, one without those of middle ones.
// Source: Machado, Oliveira and Fernandes, A Physiologically-based Model for Simulation of Color Vision Deficiency (2009), severity 1.
inline double leastDifference(std::span<const vec4> srgb) {
    // By columns
    static const std::array<mat3, 3> observers{
        mat3(1), mat3(0.152286, 0.114503, -0.003882, 1.052583, 0.786281, -0.048116, -0.204868, 0.099216, 1.051998),
        mat3(0.367322, 0.280085, -0.011820, 0.860646, 0.672501, 0.042940, -0.227968, 0.047413, 0.968881)};
    double least = HUGE_VAL;
    for (const mat3& seen : observers) {
        const auto lab = [&](const vec4& color) {
            return labFromLinear(clamp(seen * linearFromSrgb(vec3(color)), vec3(0), vec3(1)));
        };
        for (std::size_t i = 0; i < srgb.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) least = std::min(least, colorDifference(lab(srgb[i]), lab(srgb[j])));
        }
    }
    return least;
}

// What a difference must be for words and lines of a figure: ten times one that is just seen side by side on large fields.
inline constexpr double toldApart = 10;

}  // namespace mv::test
