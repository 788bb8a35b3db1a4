#include "path/lap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "../math/support.h"

using namespace mv;
using namespace mv::test;

namespace {

// Straight along -z, a tenth of a metre from sample to sample; rolled by what `roll` says of the metres.
template <class Roll>
Lap straight(int count, const Roll& roll) {
    std::vector<PathSample> samples;
    std::vector<PathFrame> frames;
    for (int i = 0; i < count; ++i) {
        samples.push_back({{0, 0, -0.1 * i}, {0, 0, -1}, {0, 0, 0}});
        frames.push_back(rolled(PathFrame{}, roll(0.1 * i)));
    }
    return lapOf(samples, frames, 4);
}

TEST(Lap, CountsTurnsByTheMetre) {
    const Lap lap = straight(101, [](double way) { return 7 * way; });
    EXPECT_NEAR(lap.ways.back(), 10, 1e-13);  // a hundred roundings of 10
    EXPECT_EQ(lap.turns.front(), 0);
    for (std::size_t i = 1; i < lap.turns.size(); ++i) EXPECT_NEAR(lap.turns[i], 7, 1e-10);
    EXPECT_TRUE(lap.flips.empty());
}

TEST(Lap, FindsFlipsAtOnceAndInAWhirl) {
    const auto atOnce = [](double way) { return way < 3.05 ? 0.0 : 180.0; };
    EXPECT_EQ(straight(101, atOnce).flips, std::vector<std::size_t>{31});
    // 180 degrees within a metre and a half, fastest in the middle, at 5 m; none of its steps turns by 90.
    const auto whirl = [](double way) { return 90 + degrees(std::atan(4 * (way - 5.05))); };
    EXPECT_EQ(straight(101, whirl).flips, std::vector<std::size_t>{51});
    // and as slow as a whole turn in twenty metres is none.
    EXPECT_TRUE(straight(201, [](double way) { return 18 * way; }).flips.empty());
    // Two of them, there and back, farther apart than the window
    const auto twice = [](double way) { return way > 2.05 && way < 8.05 ? 180.0 : 0.0; };
    EXPECT_EQ(straight(101, twice).flips, (std::vector<std::size_t>{21, 81}));
}

TEST(Lap, TurnsEvenlyBetweenSamples) {
    const Lap lap = straight(11, [](double way) { return 50 * way; });
    for (const double part : {0.0, 0.13, 0.5, 0.999, 1.0}) {
        const PathFrame there = frameAt(lap, part, {0, 0, -3});
        EXPECT_LT(glm::length(there.up - rolled(PathFrame{}, 50 * part).up), 1e-14) << part;
    }
    // A frame that turns over does so at the next sample.
    const Lap over = straight(11, [](double way) { return way < 0.45 ? 0.0 : 170.0; });
    EXPECT_LT(glm::length(frameAt(over, 0.49, {0, 0, -1}).up - vec3(0, 1, 0)), 1e-14);
}

TEST(Lap, RefusesWhatHasNoTurn) {
    const std::vector<PathSample> samples(2, {{1, 2, 3}, {0, 0, -1}, {0, 0, 0}});
    EXPECT_EQ(refusal([&] { lapOf(samples, {PathFrame{}}, 4); }),
              "lapOf: must have a frame for each sample, and two at least, 1");
    EXPECT_EQ(refusal([&] {
                  lapOf(samples, {PathFrame{}, PathFrame{}}, 4);
              }),
              "lapOf: must move from sample to sample, 1");
}

}  // namespace
