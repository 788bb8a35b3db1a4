#include "pipeline/gpu_product.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.h"

using namespace mv;
using namespace mv::test;

TEST(GpuProduct, whole_numbers_are_exact) {
    const fmat4 m(fvec4(1, 2, 3, 4), fvec4(5, 6, 7, 8), fvec4(9, 10, 11, 12), fvec4(13, 14, 15, 16));
    const fvec4 v(1, -2, 3, 1), right(31, 34, 37, 40);
    EXPECT_EQ(gpuProduct(m, v), right);
    EXPECT_EQ(fusedProduct(m, v), right);
    EXPECT_EQ(productUnit(m, v), vec4(51, 58, 65, 72) * std::ldexp(1, -24));
}

// The order is ((x + y) + z) + w, and each operation is rounded.
TEST(GpuProduct, the_order_shows_in_the_roundings) {
    const float big = 16777216;  // 2^24: 1 is half of its last place
    fmat4 m(0);
    for (int k = 0; k < 4; ++k) m[k][0] = 1;
    EXPECT_EQ(gpuProduct(m, fvec4(1, 1, big, 0)).x, big + 2);
    EXPECT_EQ(gpuProduct(m, fvec4(big, 1, 1, 0)).x, big);   // each 1 is rounded away, to even
    EXPECT_EQ(gpuProduct(m, fvec4(big, 1, -big, 0)).x, 0);  // and does not come back
    // 1 - 2^-24 squared is 1 - 2^-23 + 2^-48: fused, the last term survives the difference to 1 - 2^-23.
    const float under = 1 - std::ldexp(1.0F, -24);
    fmat4 square(0);
    square[0][0] = -1;
    square[1][0] = under;
    const fvec4 v(1 - std::ldexp(1.0F, -23), under, 0, 0);
    EXPECT_EQ(gpuProduct(square, v).x, 0);
    EXPECT_EQ(fusedProduct(square, v).x, std::ldexp(1.0F, -48));
}

TEST(GpuProduct, many_last_bits_depend_on_the_way_and_all_are_within_four_units) {
    Random random(5);
    const int samples = 20000;
    double fusedDiffers = 0, onceDiffers = 0;
    for (int i = 0; i < samples; ++i) {
        fmat4 m;
        fvec4 v;
        for (int k = 0; k < 4; ++k) {
            v[k] = float(random.number(-1, 1));
            for (int row = 0; row < 4; ++row) m[k][row] = float(random.number(-1, 1));
        }
        const vec4 right = mat4(m) * vec4(v), unit = productUnit(m, v);
        const fvec4 plain = gpuProduct(m, v), fused = fusedProduct(m, v), once(right);
        for (int row = 0; row < 4; ++row) {
            ASSERT_LE(std::abs(plain[row] - right[row]), 4 * unit[row]);
            ASSERT_LE(std::abs(fused[row] - right[row]), 4 * unit[row]);
            fusedDiffers += fused[row] == plain[row] ? 0 : 1;
            onceDiffers += once[row] == plain[row] ? 0 : 1;
        }
    }
    // Percent of the numbers; three standard deviations of a share of 80 000 are 0.5 points.
    EXPECT_NEAR(25.0 * fusedDiffers / samples, 40.9, 0.6);
    EXPECT_NEAR(25.0 * onceDiffers / samples, 49.1, 0.6);
}
