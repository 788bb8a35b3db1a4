#include "mv/image/picture.h"

#include <gtest/gtest.h>

#include <limits>

#include "image/messages.h"
#include "image/random_picture.h"

namespace mv {
namespace {

using test::randomPicture;

Picture plainPicture(int width, int height, Pixel pixel) {
    Picture picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) picture.set(x, y, pixel);
    }
    return picture;
}

TEST(Picture, StartsTransparentBlack) {
    const Picture picture(3, 2);
    EXPECT_EQ(picture.rgba.size(), 24U);
    EXPECT_EQ(picture.at(2, 1), (Pixel{0, 0, 0, 0}));
}

TEST(Picture, KeepsWhatIsSet) {
    Picture picture(3, 2);
    picture.set(1, 1, {10, 20, 30, 40});
    EXPECT_EQ(picture.at(1, 1), (Pixel{10, 20, 30, 40}));
    EXPECT_EQ(picture.at(1, 0), (Pixel{0, 0, 0, 0}));
}

TEST(Picture, IsRowMajorFromTheTop) {
    Picture picture(3, 2);
    picture.set(1, 1, {10, 20, 30, 40});
    const std::size_t offset = 16;  // row 1, column 1, of 3 pixels of 4 bytes a row: (1 * 3 + 1) * 4
    EXPECT_EQ(picture.rgba[offset], 10);
    EXPECT_EQ(picture.rgba[offset + 3], 40);
}

TEST(Picture, PixelsAreOpaqueUnlessSaid) { EXPECT_EQ((Pixel{1, 2, 3}), (Pixel{1, 2, 3, 255})); }

TEST(Picture, EqualMeansSameSizeAndValues) {
    const Picture a = randomPicture(4, 3, 1);
    Picture b = a;
    EXPECT_EQ(a, b);
    b.rgba.back() ^= 1U;
    EXPECT_NE(a, b);
    EXPECT_NE(Picture(2, 3), Picture(3, 2));
}

TEST(Picture, RefusesSidesOutOfRange) {
    for (const int side :
         {0, -1, maximumPictureSide + 1, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}) {
        EXPECT_THROW(Picture(side, 1), Error) << side;
        EXPECT_THROW(Picture(1, side), Error) << side;
        EXPECT_THROW(FloatPicture(side, 1, 1), Error) << side;
        EXPECT_THROW(FloatPicture(1, side, 1), Error) << side;
    }
    EXPECT_EQ(messageOf([] { Picture(0, 1); }), "Picture: width must lie in 1..16384, 0");
    EXPECT_EQ(Picture(maximumPictureSide, 1).rgba.size(), 65536U);
    EXPECT_EQ(Picture(1, maximumPictureSide).rgba.size(), 65536U);
}

TEST(Picture, RefusesPixelsOutside) {
    Picture picture(3, 2);
    EXPECT_EQ(messageOf([&] { (void)picture.at(3, 0); }), "Picture: x must lie in 0..2, 3");
    EXPECT_EQ(messageOf([&] { (void)picture.at(0, 2); }), "Picture: y must lie in 0..1, 2");
    EXPECT_THROW(picture.set(-1, 0, {}), Error);
    EXPECT_THROW(picture.set(0, -1, {}), Error);
    EXPECT_THROW((void)Picture().at(0, 0), Error);
}

TEST(Picture, CheckFindsTheWrongNumberOfValues) {
    Picture picture(2, 2);
    EXPECT_NO_THROW(checkPicture(picture, "test"));
    picture.rgba.pop_back();
    EXPECT_EQ(messageOf([&] { checkPicture(picture, "test"); }),
              "test: must hold width * height * channels = 16 values, 15");
    FloatPicture floats(2, 2, 3);
    EXPECT_NO_THROW(checkPicture(floats, "test"));
    floats.values.push_back(0);
    EXPECT_THROW(checkPicture(floats, "test"), Error);
    EXPECT_THROW(checkPicture(Picture(), "test"), Error);
}

TEST(FloatPicture, RefusesChannelsOutOfRange) {
    EXPECT_THROW(FloatPicture(1, 1, 0), Error);
    EXPECT_THROW(FloatPicture(1, 1, 5), Error);
    EXPECT_EQ(FloatPicture(2, 3, 4).values.size(), 24U);
}

TEST(FlipRows, TwiceIsNothing) {
    for (const int height : {1, 2, 3, 8}) {
        const Picture original = randomPicture(5, height, 2);
        Picture picture = original;
        flipRows(picture);
        for (int y = 0; y < height; ++y) EXPECT_EQ(picture.at(3, y), original.at(3, height - 1 - y)) << height;
        flipRows(picture);
        EXPECT_EQ(picture, original) << height;
    }
}

TEST(FlipRows, TurnsFloatsToo) {
    FloatPicture picture(1, 2, 2);
    picture.values = {1, 2, 3, 4};
    flipRows(picture);
    EXPECT_EQ(picture.values, (std::vector<float>{3, 4, 1, 2}));
}

TEST(Shrink, OnlyShrinks) {
    const Picture picture = randomPicture(7, 5, 3);
    EXPECT_EQ(shrink(picture, 7, 5), picture);
    EXPECT_EQ(shrink(picture, 100, 100), picture);
}

TEST(Shrink, FitsAndKeepsProportions) {
    struct Case {
        int width, height, maximumWidth, maximumHeight, resultWidth, resultHeight;
    };
    for (const Case& c : {Case{1280, 720, 320, 320, 320, 180}, Case{720, 1280, 320, 320, 180, 320},
                          Case{100, 50, 10, 2, 4, 2}, Case{100, 50, 10, 200, 10, 5}, Case{3, 3, 2, 3, 2, 2},
                          Case{1000, 1, 10, 10, 10, 1}, Case{1, 1000, 10, 10, 1, 10}}) {
        const Picture result = shrink(Picture(c.width, c.height), c.maximumWidth, c.maximumHeight);
        EXPECT_EQ(result.width, c.resultWidth) << c.width << " x " << c.height;
        EXPECT_EQ(result.height, c.resultHeight) << c.width << " x " << c.height;
    }
}

TEST(Shrink, LeavesAPlainPicturePlain) {
    for (const Pixel pixel : {Pixel{255, 255, 255, 255}, Pixel{1, 127, 254, 255}, Pixel{200, 100, 50, 3}}) {
        const Picture picture = plainPicture(37, 23, pixel);
        for (int side = 1; side < 37; ++side) {
            const Picture result = shrink(picture, side, side);
            EXPECT_EQ(result, plainPicture(result.width, result.height, pixel)) << side;
        }
    }
}

TEST(Shrink, CountsPartsOfPixels) {
    // Three pixels on two: each result takes one whole and half of the middle one, (2 * 0 + 90) / 3 and
    // (90 + 2 * 255) / 3.
    Picture picture(3, 1);
    picture.set(0, 0, {0, 0, 0});
    picture.set(1, 0, {90, 90, 90});
    picture.set(2, 0, {255, 255, 255});
    const Picture result = shrink(picture, 2, 1);
    EXPECT_EQ(result.at(0, 0), (Pixel{30, 30, 30}));
    EXPECT_EQ(result.at(1, 0), (Pixel{200, 200, 200}));
}

TEST(Shrink, TakesTheMeanOfABlock) {
    Picture picture(2, 2);
    picture.set(0, 0, {0, 10, 255});
    picture.set(1, 0, {0, 20, 255});
    picture.set(0, 1, {0, 30, 255});
    picture.set(1, 1, {1, 42, 255});
    EXPECT_EQ(shrink(picture, 1, 1).at(0, 0), (Pixel{0, 26, 255}));  // 0.25 down, 25.5 up
}

TEST(Shrink, HiddenColoursDoNotSeepOut) {
    Picture picture(2, 1);
    picture.set(0, 0, {200, 100, 50, 255});
    picture.set(1, 0, {0, 255, 0, 0});
    EXPECT_EQ(shrink(picture, 1, 1).at(0, 0), (Pixel{200, 100, 50, 128}));
    EXPECT_EQ(shrink(plainPicture(2, 1, {9, 9, 9, 0}), 1, 1).at(0, 0), (Pixel{0, 0, 0, 0}));
}

TEST(Shrink, MirrorsWithThePicture) {
    const Picture picture = randomPicture(31, 29, 4);
    Picture flipped = picture;
    flipRows(flipped);
    Picture expected = shrink(picture, 12, 12);
    flipRows(expected);
    EXPECT_EQ(shrink(flipped, 12, 12), expected);
}

TEST(Shrink, StandsTheLargestSides) {
    const Pixel pixel{255, 254, 1, 255};
    EXPECT_EQ(shrink(plainPicture(maximumPictureSide, 1, pixel), 3, 3), plainPicture(3, 1, pixel));
    EXPECT_EQ(shrink(plainPicture(1, maximumPictureSide, pixel), maximumPictureSide, 16383),
              plainPicture(1, 16383, pixel));
    EXPECT_EQ(shrink(plainPicture(1, 1, pixel), 1, 1), plainPicture(1, 1, pixel));
}

TEST(Shrink, RefusesImpossibleSizes) {
    const Picture picture(4, 4);
    EXPECT_THROW((void)shrink(picture, 0, 1), Error);
    EXPECT_THROW((void)shrink(picture, 1, -1), Error);
    EXPECT_THROW((void)shrink(picture, maximumPictureSide + 1, 1), Error);
    EXPECT_THROW((void)shrink(Picture(), 1, 1), Error);
}

}  // namespace
}  // namespace mv
