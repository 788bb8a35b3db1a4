// Patterns as functions of the surface point: what shaders/include/procedural.glsl computes in float, here in double.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "mv/math/types.h"

namespace mv {

enum class Pattern { brick, wood, marble, noise };

// The place at which a pattern is looked at: points are centre + offset. Octaves have frequencies 2^k from `first` on;
// where that is no whole number (a zoom that goes on), the first fades out while one more fades in.
struct PatternPlace {
    Pattern pattern;
    int octaves;   // 1..8
    double first;  // of the octaves, as a power of two, 0..40
    vec3 centre;

    static constexpr std::size_t most = 9;
    // For each octave: the cell that the centre lies nearest to, and how far from its corner it is, -0.5..0.5 cells.
    // Both exact, since a double is a sum of powers of two.
    struct Octave {
        double frequency, weight;
        std::array<std::int64_t, 3> cell;
        vec3 inCell;
    };
    std::vector<Octave> octaveList() const;
    // The same at frequency 1, for what has no octaves: layers of marble, and bricks, whose y counts rows.
    Octave base() const;
};

// The middle of what the demo shows, so far along x from the origin: near the corner of a brick, and in no corner of noise.
inline vec3 patternCentre(double distance) { return {distance + 2 + 0x1p-20, 1.5, 0.3125}; }

// The pattern's number, 0..1, at centre + offset.
double patternAt(const PatternPlace& place, const vec3& offset);
// The same for many offsets: the octaves are found once.
std::vector<double> patternAt(const PatternPlace& place, const std::vector<vec3>& offsets);

}  // namespace mv
