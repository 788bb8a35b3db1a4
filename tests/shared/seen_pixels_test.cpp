#include "shared/seen_pixels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mv/error.h"

using namespace mv;

TEST(SeenPixels, regions_are_those_of_what_is_seen) {
    EXPECT_EQ(regionsOfSeen({0, 0.5, -1, 1}), (std::vector<int>{0, 0, -1, 0}));
}

TEST(SeenPixels, rms_is_over_pixels_that_both_have) {
    // Pixels that only one of them has would add 4 and 9 to the squares
    EXPECT_EQ(rmsBetween({0, 1, 1, -1}, {3, 5, -1, 2}), std::sqrt((9.0 + 16) / 2));
    EXPECT_EQ(rmsBetween({3, 5, -1, 2}, {0, 1, 1, -1}), std::sqrt((9.0 + 16) / 2)) << "in either order";
    EXPECT_EQ(rmsBetween({0.25, 1}, {0.25, 1}), 0);
}

TEST(SeenPixels, where_nothing_is_compared_there_is_no_number) {
    EXPECT_FALSE(rmsBetween({-1, 1}, {1, -1}));
    EXPECT_FALSE(rmsBetween({}, {}));
    EXPECT_TRUE(rmsOfShown({-1.0F, 1.0F}, {1, -1}).empty());
    EXPECT_EQ(rmsOfShown({0.5F, 1.0F}, {0.25, -1}), std::vector{0.25});
}

TEST(SeenPixels, pictures_of_two_sizes_are_refused) { EXPECT_THROW((void)rmsBetween({1, 2}, {1}), Error); }
