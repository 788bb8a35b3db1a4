#include "shared/procedural.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace mv;

namespace {
PatternPlace place(Pattern pattern, double first, const vec3& centre) { return {pattern, 4, first, centre}; }
}  // namespace

// The pattern is the same function of the point, however that is told: as centre and offset, or the other way.
TEST(Procedural, is_a_function_of_the_point) {
    for (const Pattern pattern : {Pattern::brick, Pattern::wood, Pattern::marble, Pattern::noise}) {
        for (const vec3& at : {vec3(0.3, 0.2, 0.1), vec3(-5.7, 3.1, 2.9), vec3(1000.1, -7.3, 0.7)}) {
            const vec3 moved(0.25, -0.5, 0.125);  // exact in binary, so that both sums are the same point
            const double here = patternAt(place(pattern, 0, at), moved);
            EXPECT_NEAR(here, patternAt(place(pattern, 0, at + moved), vec3(0)), 1e-10) << int(pattern);
            EXPECT_TRUE(here >= 0 && here <= 1);
        }
    }
}

TEST(Procedural, octaves_come_and_go_without_a_jump) {
    for (const Pattern pattern : {Pattern::wood, Pattern::marble, Pattern::noise}) {
        const vec3 at(0.3, 0.7, 0.1), offset(0.01, 0.02, 0);
        const double before = patternAt(place(pattern, 3 - 1e-9, at), offset);
        EXPECT_NEAR(before, patternAt(place(pattern, 3, at), offset), 1e-7) << int(pattern);  // 1e-9 times slopes
        EXPECT_NEAR(before, patternAt(place(pattern, 3 + 1e-9, at), offset), 1e-7) << int(pattern);
    }
}

TEST(Procedural, noise_has_no_seam_at_its_cells) {
    // Value and slope are the same on both sides of a cell's border.
    const PatternPlace at{Pattern::noise, 1, 0, vec3(0)};
    for (const vec3& border : {vec3(1, 0.3, 0.6), vec3(0.2, -2, 0.4), vec3(0.7, 0.1, 5)}) {
        const vec3 across = border - glm::floor(border) == vec3(0) ? vec3(1, 0, 0)
                            : border.x == std::floor(border.x)     ? vec3(1, 0, 0)
                            : border.y == std::floor(border.y)     ? vec3(0, 1, 0)
                                                                   : vec3(0, 0, 1);
        const double h = 1e-5;
        const double before = patternAt(at, border - h * across), here = patternAt(at, border),
                     after = patternAt(at, border + h * across);
        EXPECT_NEAR((here - before) / h, (after - here) / h, 1e-2);  // h times a second derivative of some hundreds
    }
}

TEST(Procedural, lattice_points_of_noise_are_grey) {
    const PatternPlace at{Pattern::noise, 1, 0, vec3(0)};
    for (const vec3& corner : {vec3(0), vec3(3, -2, 7), vec3(-100, 50, 1)}) EXPECT_EQ(patternAt(at, corner), 0.5);
}
