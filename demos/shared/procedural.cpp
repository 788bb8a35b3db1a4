#include "shared/procedural.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mv {
namespace {

using Cell = std::array<std::int64_t, 3>;
using Octave = PatternPlace::Octave;

std::array<std::uint32_t, 3> scattered(const Cell& cell) {
    std::array<std::uint32_t, 3> v{};
    for (std::size_t i = 0; i < 3; ++i) v[i] = static_cast<std::uint32_t>(cell[i]) * 1664525U + 1013904223U;
    const auto stir = [&] {
        v[0] += v[1] * v[2];
        v[1] += v[2] * v[0];
        v[2] += v[0] * v[1];
    };
    stir();
    for (std::uint32_t& one : v) one ^= one >> 16U;
    stir();
    return v;
}
double part(std::uint32_t bits) { return double(bits >> 8U) / 16777215.0; }

vec3 gradientAt(const Cell& cell) {
    const auto v = scattered(cell);
    return 2.0 * vec3(part(v[0]), part(v[1]), part(v[2])) - 1.0;
}

double noise(Cell cell, const vec3& p) {
    const vec3 whole = glm::floor(p), t = p - whole;
    for (int i = 0; i < 3; ++i) cell[std::size_t(i)] += static_cast<std::int64_t>(whole[i]);
    const vec3 s = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
        const std::array<int, 3> corner{i & 1, (i >> 1) & 1, i >> 2};
        double weight = 1;
        for (int axis = 0; axis < 3; ++axis) weight *= corner[std::size_t(axis)] == 1 ? s[axis] : 1 - s[axis];
        const Cell at{cell[0] + corner[0], cell[1] + corner[1], cell[2] + corner[2]};
        sum += weight * glm::dot(gradientAt(at), t - vec3(corner[0], corner[1], corner[2]));
    }
    return sum;
}

Octave octaveAt(const vec3& centre, double frequency, double weight) {
    Octave octave{frequency, weight, {}, vec3(0)};
    const vec3 scaled = frequency * centre;
    for (int i = 0; i < 3; ++i) {
        const double nearest = std::round(scaled[i]);
        octave.cell[std::size_t(i)] = static_cast<std::int64_t>(nearest);
        octave.inCell[i] = scaled[i] - nearest;
    }
    return octave;
}

double octaveSum(const std::vector<Octave>& octaves, const vec3& offset) {
    double sum = 0;
    for (const Octave& octave : octaves) {
        if (octave.weight > 0) sum += octave.weight * noise(octave.cell, octave.inCell + offset * octave.frequency);
    }
    return sum;
}

double fraction(double x) { return x - std::floor(x); }

double brick(const Octave& base, const vec3& offset) {
    const double px = base.inCell.x + offset.x, py = base.inCell.y + 2 * offset.y;
    const std::int64_t row = base.cell[1] + static_cast<std::int64_t>(std::floor(py));
    const double x = px + ((row & 1) != 0 ? 0.5 : 0);
    const double shade = part(scattered({base.cell[0] + static_cast<std::int64_t>(std::floor(x)), row, 0})[0]);
    // 0.06F and 0.12F: the shader's own numbers, so that an edge is the same edge
    return fraction(x) >= double(0.06F) && fraction(py) >= double(0.12F) ? 0.55 + 0.45 * shade : 0;
}

double value(const PatternPlace& place, const std::vector<Octave>& octaves, const vec3& offset) {
    switch (place.pattern) {
        case Pattern::brick:
            return brick(place.base(), offset);
        case Pattern::wood: {
            const vec2 at = vec2(place.centre) + vec2(offset);
            return 0.5 + 0.5 * std::cos(2 * pi * fraction(4 * std::hypot(at.x, at.y) + octaveSum(octaves, offset)));
        }
        case Pattern::marble:
            return 0.5 + 0.5 * std::cos(2 * pi *
                                        fraction(place.base().inCell.x + offset.x + 1.5 * octaveSum(octaves, offset)));
        case Pattern::noise:
            break;
    }
    return std::clamp(0.5 + 0.6 * octaveSum(octaves, offset), 0.0, 1.0);
}

}  // namespace

Octave PatternPlace::base() const {
    return octaveAt(pattern == Pattern::brick ? centre * vec3(1, 2, 1) : centre, 1, 1);
}

std::vector<Octave> PatternPlace::octaveList() const {
    std::vector<Octave> list;
    if (pattern == Pattern::brick) return list;
    const double whole = std::floor(first), rest = first - whole;
    for (int k = 0; k <= octaves; ++k) {
        // The first fades out while one behind the last fades in.
        const double fade = k == 0 ? 1 - rest : k == octaves ? rest : 1;
        list.push_back(octaveAt(centre, std::exp2(whole + k), std::exp2(rest - k) * fade));
    }
    return list;
}

double patternAt(const PatternPlace& place, const vec3& offset) { return value(place, place.octaveList(), offset); }

std::vector<double> patternAt(const PatternPlace& place, const std::vector<vec3>& offsets) {
    const auto octaves = place.octaveList();
    std::vector<double> values;
    values.reserve(offsets.size());
    for (const vec3& offset : offsets) values.push_back(value(place, octaves, offset));
    return values;
}

}  // namespace mv
