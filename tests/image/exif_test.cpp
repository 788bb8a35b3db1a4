#include "mv/image/exif.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "image/jpeg_files.h"
#include "image/png_files.h"
#include "mv/error.h"
#include "mv/image/load.h"
#include "mv/image/png.h"

namespace mv {
namespace {

// Each pixel another colour.
Picture numbered(int width, int height) {
    Picture picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            picture.set(x, y, {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 7, 255});
    }
    return picture;
}

TEST(Exif, TellsTheOrientationInBothOrdersOfBytes) {
    for (int orientation = 1; orientation <= 8; ++orientation) {
        EXPECT_EQ(exifOrientation(exifOf(orientation, false)), orientation);
        EXPECT_EQ(exifOrientation(exifOf(orientation, true)), orientation);
    }
    for (const int none : {0, 9, 255}) EXPECT_EQ(exifOrientation(exifOf(none, false)), 1) << none;
}

TEST(Exif, StandsAnyBytes) {
    const std::vector<std::byte> whole = exifOf(6, true);
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const int told = exifOrientation(std::span(whole).first(length));
        EXPECT_TRUE(told == 1 || told == 6) << length;
    }
    std::mt19937 random(3);
    for (int attempt = 0; attempt < 20000; ++attempt) {
        std::vector<std::byte> damaged = whole;
        for (int i = 0; i < 3; ++i) damaged[random() % damaged.size()] = static_cast<std::byte>(random());
        const int told = exifOrientation(damaged);
        ASSERT_TRUE(told >= 1 && told <= 8);
    }
    // A directory at the end of the 32 bits
    std::vector<std::byte> far = whole;
    std::fill(far.begin() + 4, far.begin() + 8, std::byte{0xFF});
    EXPECT_EQ(exifOrientation(far), 1);
}

// EXIF 2.32, 4.6.4: at which edge of what is seen the stored first row lies, and at which the first column.
TEST(Exif, PutsTheFirstRowAndTheFirstColumnWhereTheyBelong) {
    const Picture stored = numbered(5, 3);
    struct Case {
        int orientation;
        int cornerX, cornerY;  // of what is seen: where the stored upper left pixel is, 1 for the far end
        int rightX, rightY;    // and which way the stored row goes on
    };
    for (const Case& c : {Case{1, 0, 0, 1, 0}, Case{2, 1, 0, -1, 0}, Case{3, 1, 1, -1, 0}, Case{4, 0, 1, 1, 0},
                          Case{5, 0, 0, 0, 1}, Case{6, 1, 0, 0, 1}, Case{7, 1, 1, 0, -1}, Case{8, 0, 1, 0, -1}}) {
        const Picture seen = upright(stored, c.orientation);
        ASSERT_EQ(seen.width, c.orientation < 5 ? 5 : 3) << c.orientation;
        ASSERT_EQ(seen.height, c.orientation < 5 ? 3 : 5) << c.orientation;
        const int x = c.cornerX * (seen.width - 1), y = c.cornerY * (seen.height - 1);
        for (int i = 0; i < 5; ++i)
            EXPECT_EQ(seen.at(x + i * c.rightX, y + i * c.rightY), stored.at(i, 0)) << c.orientation << ", " << i;
    }
}

TEST(Exif, HasForEachOrientationOneThatTurnsItBack) {
    const int back[] = {1, 2, 3, 4, 5, 8, 7, 6};
    const Picture picture = numbered(4, 7);
    for (int i = 1; i <= 8; ++i) EXPECT_EQ(upright(upright(picture, i), back[i - 1]), picture) << i;
    EXPECT_THROW((void)upright(picture, 0), Error);
    EXPECT_THROW((void)upright(picture, 9), Error);
}

// A turned file shows what the file without a note shows, turned. The same to the byte: nothing is decoded twice.
TEST(Exif, TurnsJpegAndPngAlike) {
    const Picture picture = numbered(40, 24);
    const Sampling full{{{1, 1}, {1, 1}, {1, 1}}};
    const Picture flat = decodePicture(sampledJpegFile(picture, full), "flat");
    for (int i = 1; i <= 8; ++i) {
        for (const bool largeEndFirst : {false, true}) {
            const std::vector<std::byte> exif = exifOf(i, largeEndFirst);
            EXPECT_EQ(decodePicture(sampledJpegFile(picture, full, exif), "jpeg"), upright(flat, i)) << i;
            const Bytes png = encodePng(picture);
            constexpr std::size_t header = 8 + 25;
            Bytes noted(png.begin(), png.begin() + header);
            appendChunk(noted, "eXIf", exif);
            noted.insert(noted.end(), png.begin() + header, png.end());
            EXPECT_EQ(decodePicture(noted, "png"), upright(picture, i)) << i;
        }
    }
}

}  // namespace
}  // namespace mv
