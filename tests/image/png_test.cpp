#include "mv/image/png.h"

#include <gtest/gtest.h>
#include <png.h>

#include <string>

#include "image/nobody.h"
#include "image/random_picture.h"
#include "mv/error.h"
#include "mv/image/file.h"
#include "mv/image/load.h"
#include "support/temporary_folder.h"

namespace mv {
namespace {

using test::randomPicture;

Picture opaque(Picture picture) {
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
    return picture;
}

// libpng's own reader: another way in than decodePicture, and without its limit of 8192 pixels a side.
Picture readByLibpng(const std::vector<std::byte>& bytes) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) throw Error("libpng", image.message);
    image.format = PNG_FORMAT_RGBA;
    Picture picture(static_cast<int>(image.width), static_cast<int>(image.height));
    if (png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr) == 0)
        throw Error("libpng", image.message);
    return picture;
}

// The kind of colour stands at byte 25 of the file: 2 is RGB, 6 is RGBA.
int colourKind(const std::vector<std::byte>& bytes) { return std::to_integer<int>(bytes.at(25)); }

TEST(EncodePng, GivesThePictureBack) {
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 3}, {17, 13}, {8192, 1}, {1, 8192}, {300, 200}}) {
        const Picture picture = randomPicture(width, height, 1);
        EXPECT_EQ(decodePicture(encodePng(picture), "test"), picture) << width << " x " << height;
        EXPECT_EQ(decodePicture(encodePng(opaque(picture)), "test"), opaque(picture)) << width << " x " << height;
    }
}

TEST(EncodePng, TellsItsCommandLine) {
    const TemporaryFolder folder;
    const Picture picture = randomPicture(9, 7, 5);
    for (const std::string line : {"cube-cull", "texture-map --picture 'Würfel.png'"}) {
        const auto bytes = encodePng(picture, line);
        EXPECT_EQ(decodePicture(bytes, "test"), picture);
        EXPECT_EQ(readByLibpng(bytes), picture) << "another reader takes no offence";
        writePng(folder / "a.png", picture, line);
        EXPECT_EQ(commandInPng(folder / "a.png"), line);
    }
    EXPECT_NE(encodePng(picture, "cube-cull"), encodePng(picture));
    writePng(folder / "none.png", picture);
    EXPECT_EQ(commandInPng(folder / "none.png"), "");
    std::vector<std::byte> damaged = encodePng(picture, "cube-cull");
    damaged.at(50) ^= std::byte{1};
    writeFileAtomically(folder / "damaged.png", damaged);
    EXPECT_THROW((void)commandInPng(folder / "damaged.png"), Error);
    EXPECT_THROW((void)commandInPng(folder / "missing.png"), Error);
}

TEST(EncodePng, StandsTheLargestSides) {
    for (const auto& [width, height] : {std::pair{16384, 1}, {1, 16384}, {16384, 16}}) {
        const Picture picture = randomPicture(width, height, 2);
        EXPECT_EQ(readByLibpng(encodePng(picture)), picture) << width << " x " << height;
    }
}

TEST(EncodePng, LeavesOutAlphaOnlyIfAllIsOpaque) {
    Picture picture = opaque(randomPicture(5, 5, 3));
    EXPECT_EQ(colourKind(encodePng(picture)), PNG_COLOR_TYPE_RGB);
    picture.rgba.back() = 254;
    EXPECT_EQ(colourKind(encodePng(picture)), PNG_COLOR_TYPE_RGBA);
    EXPECT_EQ(decodePicture(encodePng(picture), "test"), picture);
}

TEST(EncodePng, KeepsColoursUnderFullTransparency) {
    Picture picture(1, 1);
    picture.set(0, 0, {1, 2, 3, 0});
    EXPECT_EQ(decodePicture(encodePng(picture), "test"), picture);
}

TEST(EncodePng, SamePictureSameBytes) {
    const Picture picture = randomPicture(64, 64, 4);
    EXPECT_EQ(encodePng(picture), encodePng(picture));
}

TEST(EncodePng, RefusesPicturesThatAreNone) {
    EXPECT_THROW((void)encodePng(Picture()), Error);
    Picture tooFew(2, 2);
    tooFew.rgba.pop_back();
    EXPECT_THROW((void)encodePng(tooFew), Error);
    Picture tooWide(1, 1);
    tooWide.width = maximumPictureSide + 1;
    EXPECT_THROW((void)encodePng(tooWide), Error);
}

TEST(WritePng, WritesAFile) {
    const TemporaryFolder folder;
    const Picture picture = randomPicture(20, 10, 5);
    writePng(folder / "a.png", picture);
    EXPECT_EQ(loadPicture(folder / "a.png"), picture);
    EXPECT_EQ(folder.entries(), 1);
}

// X40. A small picture fits into every buffer on the way, so that only the last step can notice.
TEST(WritePng, AFullDiskIsAnError) {
    const auto writeToFullDisk = [](int side) {
        becomeNobody();
        try {
            writePng("/dev/full", randomPicture(side, side, 6));
        } catch (const Error& error) {
            _exit(error.what() == std::string("/dev/full: could not be written, No space left on device") ? 0 : 2);
        }
        _exit(1);
    };
    for (const int side : {1, 64, 1000}) EXPECT_EXIT(writeToFullDisk(side), testing::ExitedWithCode(0), "") << side;
}

TEST(WritePng, ARefusedPictureLeavesTheOldFile) {
    const TemporaryFolder folder;
    const Picture picture = randomPicture(2, 2, 7);
    writePng(folder / "a.png", picture);
    EXPECT_THROW(writePng(folder / "a.png", Picture()), Error);
    EXPECT_THROW(writePng(folder / "missing/a.png", picture), Error);
    EXPECT_EQ(loadPicture(folder / "a.png"), picture);
    EXPECT_EQ(folder.entries(), 1);
}

}  // namespace
}  // namespace mv
