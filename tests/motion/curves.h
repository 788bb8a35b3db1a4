// Curves for tests of frames: sums of sines, of which every derivative is one.
#pragma once
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "mv/motion/path_frame.h"

namespace mv::test {

struct Wave {
    vec3 amplitude;
    double frequency, phase;
};

// The sum of the waves amplitude * sin(frequency t + phase), and of drift * t.
struct WaveCurve {
    std::vector<Wave> waves;
    vec3 drift{0};

    vec3 derivative(double t, int order) const {
        vec3 sum = order == 0 ? drift * t : order == 1 ? drift : vec3(0);
        for (const Wave& wave : waves) {
            sum += std::pow(wave.frequency, order) * std::sin(wave.frequency * t + wave.phase + order * pi / 2) *
                   wave.amplitude;
        }
        return sum;
    }
    // Torsion times speed: by how much Frenet's frame turns about the path, in radians for each unit of t.
    double torsionRate(double t) const {
        const vec3 velocity = derivative(t, 1), binormal = glm::cross(velocity, derivative(t, 2));
        return glm::dot(binormal, derivative(t, 3)) / glm::dot(binormal, binormal) * glm::length(velocity);
    }
    Path path() const {
        const auto nth = [curve = *this](int order) {
            return [curve, order](double t) { return curve.derivative(t, order); };
        };
        return {nth(0), nth(1), nth(2)};
    }
};

// In the plane y = 0, once round in 2 pi, to the left seen from above (the outside of the bend is on the right).
inline WaveCurve circle(double radius, double speed = 1) {
    return {{{{radius, 0, 0}, speed / radius, pi / 2}, {{0, 0, -radius}, speed / radius, 0}}};
}
// Round the y axis, to the left, rising by `rise` for each radian.
inline WaveCurve helix(double radius, double rise) {
    WaveCurve curve = circle(radius, radius);
    curve.drift = {0, rise, 0};
    return curve;
}
// A figure of eight in the plane z = 0, with inflections at 0 and pi. Gerono's lemniscate.
inline WaveCurve eight() { return {{{{1, 0, 0}, 1, 0}, {{0, 0.5, 0}, 2, 0}}}; }
// A closed curve in space without inflections, 2 pi long in t.
inline WaveCurve trefoil() {
    return {
        {{{1, 0, 0}, 1, 0}, {{2, 0, 0}, 2, 0}, {{0, 1, 0}, 1, pi / 2}, {{0, -2, 0}, 2, pi / 2}, {{0, 0, -1}, 3, 0}}};
}
// Viviani's: where a sphere of radius 2 meets a cylinder of radius 1. Closed, 4 pi long in t.
inline WaveCurve viviani() { return {{{{1, 0, 0}, 1, pi / 2}, {{0, 1, 0}, 1, 0}, {{0, 0, 2}, 0.5, 0}}}; }

}  // namespace mv::test
