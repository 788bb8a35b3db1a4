// The sample points in a pixel and on a lamp.
#include <cmath>

#include "whitted.h"

namespace mv {
namespace {

// A word that looks random for each that is given. Source: Steele, Lea, Flood, SplitMix (2014), cut to 32 bits.
std::uint32_t scattered(std::uint64_t number) {
    std::uint64_t z = number * 0x9E3779B97F4A7C15U + 0x632BE59BD9B4E019U;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return static_cast<std::uint32_t>((z ^ (z >> 31)) >> 32);
}
double part(std::uint32_t word) { return word * 0x1p-32; }

// The bits of the index in reverse order, and Sobol's second direction numbers.
vec2 sequencePoint(std::uint32_t index, std::uint32_t turnX, std::uint32_t turnY) {
    std::uint32_t x = 0, y = 0, direction = 1U << 31;
    for (std::uint32_t bits = index, bit = 1U << 31; bits != 0; bits >>= 1, bit >>= 1, direction ^= direction >> 1) {
        if ((bits & 1U) == 0) continue;
        x ^= bit;
        y ^= direction;
    }
    return {part(x ^ turnX), part(y ^ turnY)};
}

// The place of number i in an order of `count` numbers that looks random: a permutation, by walking a cycle.
// Source: Kensler, "Correlated multi-jittered sampling", Pixar 13-01 (2013).
std::uint32_t shuffled(std::uint32_t i, std::uint32_t count, std::uint32_t seed) {
    std::uint32_t mask = count - 1;
    for (const unsigned shift : {1U, 2U, 4U, 8U, 16U}) mask |= mask >> shift;
    do {
        // Each step can be undone within the mask: xor, odd product, shift down.
        i ^= seed & mask;
        i = (i * 0xE170893DU) & mask;
        i ^= (i & mask) >> 4;
        i ^= (seed >> 16) & mask;
        i = (i * 0x0929EB3FU) & mask;
        i ^= (i & mask) >> 1;
        i = (i * (1U | (seed >> 18))) & mask;
    } while (i >= count);
    return i;
}

}  // namespace

std::array<vec2, 2> samplePoints(SamplePattern pattern, int sample, int count, std::uint32_t pixel,
                                 std::uint32_t seed) {
    const auto word = [&](std::uint32_t which) {
        return scattered((std::uint64_t(seed) << 48) ^ (std::uint64_t(which) << 32) ^ pixel);
    };
    const auto perSample = [&](std::uint32_t which) {
        return part(scattered((std::uint64_t(word(which)) << 32) ^ static_cast<std::uint32_t>(sample)));
    };
    const auto index = static_cast<std::uint32_t>(sample), all = static_cast<std::uint32_t>(count);
    const int side = static_cast<int>(std::lround(std::sqrt(double(count))));
    const auto cell = [&](std::uint32_t which, const vec2& within) {
        const auto cells = static_cast<std::uint32_t>(side), row = which / cells;
        return (vec2(double(which % cells), double(row)) + within) / double(side);
    };
    switch (pattern) {
        case SamplePattern::regular:
            return {cell(index, vec2(0.5)), cell(shuffled(index, all, word(0)), vec2(0.5))};
        case SamplePattern::random:
            return {vec2(perSample(1), perSample(2)), vec2(perSample(3), perSample(4))};
        case SamplePattern::jittered:
            return {cell(index, {perSample(1), perSample(2)}),
                    cell(shuffled(index, all, word(0)), {perSample(3), perSample(4)})};
        case SamplePattern::sequence:
            return {sequencePoint(index, word(1), word(2)),
                    sequencePoint(shuffled(index, all, word(0)), word(3), word(4))};
    }
    return {};
}

}  // namespace mv
