#include "shared/narrow_view.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace mv;

// The width that is seen is 2 tan(fovy/2) aspect at the distance 1.
TEST(NarrowView, shows_as_much_across) {
    for (const double fovy : {20.0, 50.0, 120.0}) {
        for (const double least : {0.8, 1.0, 1.3}) {
            const double across = std::tan(radians(fovy / 2)) * least;
            EXPECT_EQ(fovyAcross(fovy, least, least), fovy);
            EXPECT_EQ(fovyAcross(fovy, 3, least), fovy);
            for (const double aspect : {0.7, 0.1, 1e-3, 1e-6}) {
                const double narrow = fovyAcross(fovy, aspect, least);
                EXPECT_GT(narrow, fovy);
                EXPECT_LT(narrow, 180);
                // The tangent of nearly 90 degrees has the angle's roundings times its own square
                const double tangent = std::tan(radians(narrow / 2));
                EXPECT_NEAR(tangent * aspect / across, 1, 4e-16 * (1 + tangent))
                    << fovy << " " << aspect << " " << least;
            }
        }
    }
}
