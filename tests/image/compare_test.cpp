#include "mv/image/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/messages.h"
#include "image/random_picture.h"

namespace mv {
namespace {

using test::randomPicture;

constexpr double infinity = std::numeric_limits<double>::infinity();

FloatPicture floats(int channels, std::vector<float> values) {
    FloatPicture picture(static_cast<int>(values.size()) / channels, 1, channels);
    picture.values = std::move(values);
    return picture;
}

void expectNone(const Difference& d) { EXPECT_EQ(d, (Difference{0, 0, 0, infinity, 0, 0})); }

TEST(Compare, APictureIsEqualToItself) {
    for (const auto& [width, height] : {std::pair{1, 1}, {16384, 1}, {1, 16384}, {17, 13}}) {
        const Picture picture = randomPicture(width, height, 1);
        expectNone(compare(picture, picture));
    }
}

TEST(Compare, IsSymmetric) {
    const Picture a = randomPicture(17, 13, 1);
    const Picture b = randomPicture(17, 13, 2);
    for (const int threshold : {0, 1, 200, 255}) EXPECT_EQ(compare(a, b, threshold), compare(b, a, threshold));
}

TEST(Compare, FiguresAreInOrder) {
    for (unsigned seed = 1; seed < 20; ++seed) {
        const Difference d = compare(randomPicture(9, 9, seed), randomPicture(9, 9, seed + 100), 100);
        EXPECT_LE(d.mean, d.rmse);  // the mean of squares is at least the square of the mean
        EXPECT_LE(d.rmse, d.maximum);
        EXPECT_GE(d.fraction, 0);
        EXPECT_LE(d.fraction, 1);
    }
}

TEST(Compare, MoreIsBeyondASmallerThreshold) {
    const Picture a = randomPicture(17, 13, 1);
    const Picture b = randomPicture(17, 13, 2);
    long before = std::numeric_limits<long>::max();
    for (int threshold = 0; threshold <= 255; ++threshold) {
        const long beyond = compare(a, b, threshold).beyond;
        EXPECT_LE(beyond, before);
        before = beyond;
    }
    EXPECT_EQ(before, 0);  // nothing is further apart than 255
}

TEST(Compare, BlackAndWhiteAreAllTheWayApart) {
    Picture black(3, 2);
    Picture white(3, 2);
    std::fill(white.rgba.begin(), white.rgba.end(), std::uint8_t{255});
    EXPECT_EQ(compare(black, white), (Difference{255, 255, 255, 0, 1, 6}));
}

TEST(Compare, KnownFigures) {
    Picture a(2, 2);
    Picture b(2, 2);
    b.set(1, 0, {3, 4, 0, 0});
    const Difference d = compare(a, b);
    EXPECT_EQ(d.maximum, 4);
    EXPECT_EQ(d.mean, 7.0 / 16);  // exact in binary
    EXPECT_EQ(d.rmse, 5.0 / 4);   // sqrt(25 / 16)
    EXPECT_DOUBLE_EQ(d.psnr, 20 * std::log10(204.0));
    EXPECT_EQ(d.beyond, 1);
    EXPECT_EQ(d.fraction, 0.25);
}

TEST(Compare, TheThresholdItselfIsAllowed) {
    Picture a(1, 1);
    Picture b(1, 1);
    b.set(0, 0, {0, 7, 0, 0});
    EXPECT_EQ(compare(a, b, 6).beyond, 1);
    EXPECT_EQ(compare(a, b, 7).beyond, 0);
    EXPECT_EQ(compare(a, b, 7).maximum, 7);
}

TEST(Compare, FindsOneLevelInAnyValue) {
    // Alpha included, first and last pixel included.
    const Picture a = randomPicture(5, 4, 3);
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        Picture b = a;
        b.rgba[i] ^= 1U;
        const Difference d = compare(a, b);
        EXPECT_EQ(d.maximum, 1) << i;
        EXPECT_EQ(d.beyond, 1) << i;
        EXPECT_EQ(d.mean, 1.0 / 80) << i;
        EXPECT_NEAR(d.psnr, 20 * std::log10(255 * std::sqrt(80.0)), 1e-12 * 67) << i;  // a few roundings of about 67
    }
}

TEST(Compare, FindsOnePixelInTheLongestRow) {
    const Picture a(16384, 1);
    Picture b = a;
    b.set(16383, 0, {0, 0, 1, 0});
    EXPECT_EQ(compare(a, b).beyond, 1);
    EXPECT_EQ(compare(a, b).fraction, 1.0 / 16384);
}

TEST(Compare, RefusesDifferentSizes) {
    EXPECT_EQ(messageOf([] { (void)compare(Picture(3, 2), Picture(2, 3)); }),
              "compare: both pictures must have the same size, 3 x 2 and 2 x 3");
    EXPECT_THROW((void)compare(Picture(), Picture()), Error);
    EXPECT_THROW((void)differencePicture(Picture(3, 2), Picture(2, 3)), Error);
    EXPECT_THROW((void)compare(FloatPicture(1, 1, 1), FloatPicture(1, 1, 2)), Error);
    EXPECT_THROW((void)compare(FloatPicture(1, 2, 1), FloatPicture(2, 1, 1)), Error);
}

TEST(Compare, RefusesThresholdsOutOfRange) {
    const Picture picture(1, 1);
    EXPECT_THROW((void)compare(picture, picture, -1), Error);
    EXPECT_THROW((void)compare(picture, picture, 256), Error);
    const FloatPicture values(1, 1, 1);
    EXPECT_THROW((void)compare(values, values, -0.1), Error);
    EXPECT_THROW((void)compare(values, values, infinity), Error);
    EXPECT_THROW((void)compare(values, values, std::nan("")), Error);
    EXPECT_THROW((void)compare(values, values, 0, 0), Error);
    EXPECT_THROW((void)compare(values, values, 0, std::nan("")), Error);
}

TEST(CompareFloats, EqualAndSymmetric) {
    const FloatPicture a = floats(2, {1, 2, 3, 4});
    const FloatPicture b = floats(2, {1, 2.5F, 3, -4});
    expectNone(compare(a, a));
    EXPECT_EQ(compare(a, b), compare(b, a));
}

TEST(CompareFloats, KnownFigures) {
    const Difference d = compare(floats(2, {0, 0, 0, 0}), floats(2, {3, 4, 0, 0}), 3.5, 10);
    EXPECT_EQ(d.maximum, 4);
    EXPECT_EQ(d.mean, 1.75);
    EXPECT_EQ(d.rmse, 2.5);
    EXPECT_DOUBLE_EQ(d.psnr, 20 * std::log10(4.0));
    EXPECT_EQ(d.beyond, 1);
    EXPECT_EQ(d.fraction, 0.5);
}

TEST(CompareFloats, StandsTheLargestFloats) {
    const float largest = std::numeric_limits<float>::max();
    const Difference d = compare(floats(1, {largest}), floats(1, {-largest}));
    EXPECT_EQ(d.maximum, 2.0 * static_cast<double>(largest));
    EXPECT_EQ(d.rmse, d.maximum);  // the square, 4.6e77, is no trouble for a double
    EXPECT_TRUE(std::isfinite(d.psnr));
    const float smallest = std::numeric_limits<float>::denorm_min();
    EXPECT_GT(compare(floats(1, {smallest}), floats(1, {0})).rmse, 0);
}

TEST(CompareFloats, RefusesWhatIsNotFinite) {
    const FloatPicture good = floats(1, {0, 0, 0});
    for (const float bad : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
        const FloatPicture poisoned = floats(1, {0, bad, 0});
        EXPECT_THROW((void)compare(good, poisoned), Error);
        EXPECT_THROW((void)compare(poisoned, good), Error);
        EXPECT_THROW((void)compare(poisoned, poisoned), Error);
    }
    EXPECT_EQ(messageOf([&] {
                  (void)compare(good, floats(1, {0, 0, std::nanf("")}));
              }),
              "compare: every value must be finite, nan at column 2, row 0");
}

TEST(DifferencePicture, EqualPixelsAreDarkGrey) {
    Picture picture(3, 1);
    picture.set(0, 0, {255, 255, 255});
    picture.set(1, 0, {0, 0, 0, 0});
    picture.set(2, 0, {0, 255, 0});
    const Picture shown = differencePicture(picture, picture);
    EXPECT_EQ(shown.at(0, 0), (Pixel{76, 76, 76}));
    EXPECT_EQ(shown.at(1, 0), (Pixel{0, 0, 0}));
    EXPECT_EQ(shown.at(2, 0), (Pixel{54, 54, 54}));
}

TEST(DifferencePicture, DifferencesShineByTheirMagnitude) {
    for (int apart = 1; apart <= 255; ++apart) {
        Picture a(1, 1);
        Picture b(1, 1);
        b.set(0, 0, {0, 0, 0, static_cast<std::uint8_t>(apart)});
        const Pixel shown = differencePicture(a, b).at(0, 0);
        EXPECT_EQ(shown, differencePicture(b, a).at(0, 0));
        EXPECT_EQ(shown.red, 255);
        EXPECT_EQ(shown.green, 96 + 159 * apart / 255);
        EXPECT_EQ(shown.blue, 0);
        EXPECT_EQ(shown.alpha, 255);
    }
}

TEST(DifferencePicture, ShinesExactlyWhereCompareCounts) {
    const Picture a = randomPicture(20, 20, 5);
    Picture b = a;
    for (std::size_t i = 0; i < b.rgba.size(); i += 28) b.rgba[i] ^= 255U;
    const Picture shown = differencePicture(a, b);
    long shining = 0;
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 20; ++x) shining += shown.at(x, y).red == 255 ? 1 : 0;
    }
    EXPECT_EQ(shining, compare(a, b).beyond);
    EXPECT_GT(shining, 0);
}

// A square of 4 pixels in one of 12: its rim of so many pixels is yellow, so many around it are black, and all else is clear. At the
// picture's edge nothing lies without, and the yellow line runs along it.
TEST(DifferenceOutline, RunsRoundWhatDiffers) {
    for (const int width : {1, 2}) {
        for (const int from : {4, 0}) {
            Picture a(12, 12);
            for (std::size_t i = 0; i < a.rgba.size(); ++i) a.rgba[i] = i % 4 == 3 ? 255 : 10;
            Picture b = a;
            for (int y = from; y < from + 4; ++y)
                for (int x = from; x < from + 4; ++x) b.set(x, y, {11, 10, 10, 255});
            const Picture line = differenceOutline(a, b, width);
            for (int y = 0; y < 12; ++y) {
                for (int x = 0; x < 12; ++x) {
                    const auto isIn = [&](int low, int high) { return x >= low && y >= low && x < high && y < high; };
                    const bool isYellow = isIn(from, from + 4) && !isIn(from + width, from + 4 - width);
                    const bool isBlack = isIn(from - width, from + 4 + width) && !isIn(from, from + 4);
                    EXPECT_EQ(line.at(x, y), isYellow  ? (Pixel{255, 210, 0, 255})
                                             : isBlack ? (Pixel{0, 0, 0, 255})
                                                       : (Pixel{0, 0, 0, 0}))
                        << x << ", " << y << " of a line of " << width;
                }
            }
        }
    }
    EXPECT_EQ(differenceOutline(Picture(3, 2), Picture(3, 2)), Picture(3, 2));
    EXPECT_THROW((void)differenceOutline(Picture(3, 2), Picture(2, 3)), Error);
    EXPECT_THROW((void)differenceOutline(Picture(3, 2), Picture(3, 2), 0), Error);
}

}  // namespace
}  // namespace mv
