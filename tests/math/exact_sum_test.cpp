#include "mv/math/exact_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace mv;

namespace {

// Numbers of all sizes from 2^-300 to 2^300, with their negatives, in any order: their sum is 0, and with a number more that
// number's sign, though it is smaller than a bit of the others.
TEST(ExactSum, HasTheSignOfWhatIsLeftOfNumbersOfAllSizes) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> mantissa(1, 2);
    std::uniform_int_distribution<int> exponent(-300, 300);
    int lostInDouble = 0;
    for (int trial = 0; trial < 10000; ++trial) {
        std::vector<double> numbers;
        for (int i = 0; i < 8; ++i) {
            const double number = std::ldexp(mantissa(random), exponent(random));
            numbers.insert(numbers.end(), {number, -number});
        }
        const int left = trial % 3 - 1;
        numbers.push_back(left * 0x1p-400);
        std::shuffle(numbers.begin(), numbers.end(), random);
        ExactSum<17> sum;
        double rounded = 0;
        for (const double number : numbers) {
            sum.add(number);
            rounded += number;
        }
        ASSERT_EQ(sum.sign(), left) << "trial " << trial;
        lostInDouble += (rounded > 0) - (rounded < 0) == left ? 0 : 1;
    }
    EXPECT_GT(lostInDouble, 5000);  // or the numbers ask nothing
}

// (1 + e)(1 - e) = 1 - e^2, which a product rounds to 1 for e = 2^-40.
TEST(ExactSum, RoundsNoProduct) {
    const double e = 0x1p-40;
    for (const double unit : {1.0, 0x1p-400, 0x1p400}) {
        ExactSum<4> below, same;
        below.addProduct(unit * (1 + e), 1 - e);
        below.add(-unit);
        EXPECT_EQ(below.sign(), -1);
        same.addProduct(unit * (1 + e), 1 - e);
        same.add(-unit);
        same.add(unit * e * e);
        EXPECT_EQ(same.sign(), 0);
    }
    EXPECT_EQ((1 + e) * (1 - e), 1);
}

TEST(ExactSum, OfNothingIsZero) {
    EXPECT_EQ(ExactSum<1>().sign(), 0);
    ExactSum<2> zeros;
    zeros.addProduct(-0.0, 3);
    EXPECT_EQ(zeros.sign(), 0);
}

}  // namespace
