// X42: a damaged or hostile picture file is an Error, never a crash and never a wrong picture in silence.
#include "mv/image/load.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <utility>

#include "image/jpeg_files.h"
#include "image/messages.h"
#include "image/png_files.h"
#include "mv/image/compare.h"
#include "mv/image/file.h"
#include "mv/image/png.h"
#include "support/temporary_folder.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace mv {
namespace {

Picture smoothPicture(int width, int height) {
    Picture picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            picture.set(
                x, y,
                {static_cast<std::uint8_t>(255 * x / width), static_cast<std::uint8_t>(255 * y / height), 100, 255});
        }
    }
    return picture;
}

Bytes jpegFile(const Picture& picture) {
    Bytes bytes;
    const auto append = [](void* context, void* data, int size) {
        const auto* begin = static_cast<const std::byte*>(data);
        auto* target = static_cast<Bytes*>(context);
        target->insert(target->end(), begin, begin + size);
    };
    if (stbi_write_jpg_to_func(append, &bytes, picture.width, picture.height, 4, picture.rgba.data(), 95) == 0)
        throw Error("stbi_write_jpg_to_func", "must be able to encode the picture");
    return bytes;
}

// The bytes that a PNG has before compression, from the definition of the passes, pixel by pixel.
std::size_t unpackedSize(const PngHeader& header) {
    const unsigned channels[] = {1, 0, 3, 1, 2, 0, 4};
    const unsigned bits = channels[header.colour] * header.depth;
    const char* passOf =
        "16462646"
        "77777777"
        "56565656"
        "77777777"
        "36463646"
        "77777777"
        "56565656"
        "77777777";
    std::size_t size = 0;
    for (char pass = '1'; pass <= '7'; ++pass) {
        for (std::uint32_t y = 0; y < header.height; ++y) {
            unsigned columns = 0;
            for (std::uint32_t x = 0; x < header.width; ++x) {
                const char owner = header.interlaced == 1 ? passOf[y % 8 * 8 + x % 8] : '1';
                if (owner == pass) ++columns;
            }
            if (columns > 0) size += 1 + (columns * bits + 7) / 8;
        }
    }
    return size;
}

// The unpacked bytes of a picture that is not interlaced or is, with filter 0 at the beginning of each row.
Bytes filteredRows(const PngHeader& header, Bytes unpacked) {
    const std::size_t before = unpackedSize({header.width, header.height, header.depth, header.colour});
    if (header.interlaced == 0) {
        const std::size_t row = before / header.height;
        for (std::size_t i = 0; i < unpacked.size(); i += row) unpacked[i] = std::byte{0};
        return unpacked;
    }
    std::size_t place = 0;
    constexpr std::array<std::array<std::uint32_t, 4>, 7> passes = {
        {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};
    for (const auto& [x, y, stepX, stepY] : passes) {
        const std::size_t row = 1 + ((header.width - x + stepX - 1) / stepX * header.depth + 7) / 8;
        for (std::uint32_t i = y; i < header.height; i += stepY, place += row) unpacked[place] = std::byte{0};
    }
    return unpacked;
}

std::vector<PngHeader> everyKind(std::uint32_t width, std::uint32_t height) {
    std::vector<PngHeader> headers;
    using Byte = std::uint8_t;
    for (const Byte interlaced : {Byte{0}, Byte{1}}) {
        for (const Byte depth : {Byte{1}, Byte{2}, Byte{4}, Byte{8}, Byte{16}}) {
            for (const Byte colour : {Byte{0}, Byte{2}, Byte{3}, Byte{4}, Byte{6}}) {
                const bool allowed = colour == 0 || (colour == 3 && depth <= 8) || depth >= 8;
                if (allowed && !(colour == 3 && depth == 16))
                    headers.push_back({width, height, depth, colour, 0, 0, interlaced});
            }
        }
    }
    return headers;
}

std::string text(const PngHeader& header) {
    return std::to_string(header.width) + " x " + std::to_string(header.height) + ", depth " +
           std::to_string(header.depth) + ", colour " + std::to_string(header.colour) + ", interlaced " +
           std::to_string(header.interlaced);
}

TEST(LoadPicture, NamesTheFileAndTheReason) {
    const TemporaryFolder folder;
    EXPECT_EQ(messageOf([] { (void)loadPicture("/missing.png"); }),
              "/missing.png: must be a file that exists and may be read, No such file or directory");
    const auto path = folder / "a.png";
    writeFileAtomically(path, "GIF89a");
    EXPECT_EQ(
        messageOf([&] { (void)loadPicture(path); }),
        path.string() + ": must be a PNG or JPEG file; other formats have to be converted first, it begins as neither");
    writeFileAtomically(path, "");
    EXPECT_TRUE(contains(messageOf([&] { (void)loadPicture(path); }), "it is empty"));
    EXPECT_TRUE(contains(messageOf([&] { (void)loadPicture(folder.path()); }), "Is a directory"));
}

TEST(LoadPicture, HoldsTheSizeLimit) {
    const TemporaryFolder folder;
    const auto path = folder / "large.png";
    writeFileAtomically(path, encodePng(Picture(1, 1)));
    std::filesystem::resize_file(path, maximumPictureFileBytes);
    EXPECT_EQ(loadPicture(path), Picture(1, 1));  // what follows the last chunk does not matter
    std::filesystem::resize_file(path, maximumPictureFileBytes + 1);
    EXPECT_TRUE(contains(messageOf([&] { (void)loadPicture(path); }), "must hold at most 67108864 bytes"));
    EXPECT_THROW((void)decodePicture(Bytes(maximumPictureFileBytes + 1), "memory"), Error);
}

// Whatever another program does with the file meanwhile: a whole picture, or an Error that says what is wrong.
TEST(LoadPicture, StandsAFileThatChangesAndVanishes) {
    const TemporaryFolder folder;
    const auto path = folder / "a.png";
    const Picture first = smoothPicture(120, 90), second = smoothPicture(90, 120);
    const Bytes whole = encodePng(first);
    std::atomic<bool> done = false;
    std::thread other([&] {
        for (int i = 0; i < 150; ++i) {
            writePng(path, i % 2 == 0 ? first : second);
            std::filesystem::remove(path);
            std::ofstream halves(path, std::ios::binary);  // in place, as one should not
            for (const std::size_t start : {std::size_t{0}, whole.size() / 2}) {
                const std::size_t end = start == 0 ? whole.size() / 2 : whole.size();
                halves.write(reinterpret_cast<const char*>(whole.data()) + start,
                             static_cast<std::streamsize>(end - start));
                halves.flush();
            }
        }
        done = true;
    });
    int loaded = 0, refused = 0;
    while (!done) {
        try {
            const Picture picture = loadPicture(path);
            EXPECT_TRUE(picture == first || picture == second);
            ++loaded;
        } catch (const Error& error) {
            EXPECT_TRUE(contains(error.what(), path.string() + ": must be ")) << error.what();
            ++refused;
        }
    }
    other.join();
    EXPECT_GT(loaded + refused, 0);
    EXPECT_EQ(loadPicture(path), first);
}

TEST(LoadPng, TopRowFirst) {
    // Two rows of one pixel, filter 0: red above blue.
    Bytes rows;
    for (const int value : {0, 255, 0, 0, 0, 0, 0, 255}) rows.push_back(std::byte(value));
    const Picture picture = decodePicture(pngFile({1, 2, 8, 2}, rows), "test");
    EXPECT_EQ(picture.at(0, 0), (Pixel{255, 0, 0}));
    EXPECT_EQ(picture.at(0, 1), (Pixel{0, 0, 255}));
}

TEST(LoadPng, GreyBecomesEqualChannels) {
    EXPECT_EQ(decodePicture(pngFile({1, 1, 8, 0}, {std::byte{0}, std::byte{77}}), "test").at(0, 0),
              (Pixel{77, 77, 77}));
    EXPECT_EQ(decodePicture(pngFile({1, 1, 8, 4}, {std::byte{0}, std::byte{77}, std::byte{9}}), "test").at(0, 0),
              (Pixel{77, 77, 77, 9}));
    EXPECT_EQ(decodePicture(pngFile({1, 1, 8, 3}, {std::byte{0}, std::byte{0}}), "test").at(0, 0), (Pixel{90, 90, 90}));
    // 16 bits keep the upper 8.
    EXPECT_EQ(decodePicture(pngFile({1, 1, 16, 0}, {std::byte{0}, std::byte{200}, std::byte{1}}), "test").at(0, 0),
              (Pixel{200, 200, 200}));
}

// Every kind, depth and interlacing, at the sizes where passes are empty or rows end within a byte.
TEST(LoadPng, AcceptsEveryKindAndExactlyItsAmountOfData) {
    for (std::uint32_t width = 1; width <= 9; ++width) {
        for (const std::uint32_t height : {1U, 2U, 3U, 5U, 9U}) {
            for (const PngHeader& header : everyKind(width, height)) {
                const Bytes unpacked(unpackedSize(header));
                const Picture picture = decodePicture(pngFile(header, unpacked), "test");
                EXPECT_EQ(picture.width, static_cast<int>(width)) << text(header);
                EXPECT_EQ(picture.height, static_cast<int>(height)) << text(header);
                const Bytes less(unpacked.size() - 1);
                EXPECT_TRUE(contains(messageOf([&] { (void)decodePicture(pngFile(header, less), "test"); }), "fewer"))
                    << text(header);
                const Bytes more(unpacked.size() + 1);
                EXPECT_TRUE(contains(messageOf([&] { (void)decodePicture(pngFile(header, more), "test"); }), "more"))
                    << text(header);
            }
        }
    }
}

TEST(LoadPng, RefusesEveryTruncation) {
    const Bytes whole = encodePng(smoothPicture(16, 16));
    for (std::size_t length = 0; length < whole.size(); ++length) {
        EXPECT_THROW((void)decodePicture(std::span(whole).first(length), "test"), Error)
            << length << " of " << whole.size();
    }
}

TEST(LoadPng, RefusesEveryFlippedBit) {
    const Bytes whole = encodePng(smoothPicture(16, 16));
    for (std::size_t i = 0; i < whole.size(); ++i) {
        for (unsigned bit = 0; bit < 8; ++bit) {
            Bytes damaged = whole;
            damaged[i] ^= std::byte(1U << bit);
            EXPECT_THROW((void)decodePicture(damaged, "test"), Error) << "byte " << i << ", bit " << bit;
        }
    }
}

// With the checksums mended the damage goes deeper, to the decompressor and to stb_image.
TEST(LoadPng, StandsDamageUnderRightChecksums) {
    const PngHeader header{16, 16, 8, 6, 0, 0, 0};
    Bytes unpacked(unpackedSize(header));
    for (std::size_t i = 0; i < unpacked.size(); ++i) unpacked[i] = std::byte(i % 65 == 0 ? i / 65 % 5 : i * 7 % 251);
    const Bytes pixels = compressed(unpacked);
    const auto fileOf = [](const Bytes& headerBytes, const Bytes& pixelBytes) {
        Bytes file = pngSignature();
        appendChunk(file, "IHDR", headerBytes);
        appendChunk(file, "IDAT", pixelBytes);
        appendChunk(file, "IEND", {});
        return file;
    };
    const Picture whole = decodePicture(fileOf(headerData(header), pixels), "test");
    for (std::size_t i = 0; i < 13; ++i) {
        for (int value = 0; value < 256; ++value) {
            Bytes damaged = headerData(header);
            if (damaged[i] == std::byte(value)) continue;
            damaged[i] = std::byte(value);
            EXPECT_THROW((void)decodePicture(fileOf(damaged, pixels), "test"), Error) << i << " " << value;
        }
    }
    int refused = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        for (unsigned bit = 0; bit < 8; ++bit) {
            Bytes damaged = pixels;
            damaged[i] ^= std::byte(1U << bit);
            try {
                // A few bits mean nothing: those that fill up the last byte, and the size of zlib's window.
                EXPECT_EQ(decodePicture(fileOf(headerData(header), damaged), "test"), whole) << i << " " << bit;
            } catch (const Error&) {
                ++refused;
            }
        }
    }
    EXPECT_GT(refused, static_cast<int>(pixels.size()) * 8 - 20);
}

TEST(LoadPng, RefusesFiltersThatDoNotExist) {
    EXPECT_TRUE(contains(messageOf([] {
                             (void)decodePicture(pngFile({1, 1, 8, 0}, {std::byte{5}, std::byte{0}}), "test");
                         }),
                         "filter"));
}

TEST(LoadPng, HoldsTheSideLimitBeforeItTakesMemory) {
    EXPECT_EQ(messageOf([] {
                  (void)decodePicture(pngFile({8193, 1}, {}), "test");
              }),
              "test: sides must lie in 1..8192 pixels; scale it down, 8193 x 1");
    for (const std::uint32_t side : {0U, 8193U, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU}) {
        EXPECT_THROW((void)decodePicture(pngFile({side, 1}, {}), "test"), Error) << side;
        EXPECT_THROW((void)decodePicture(pngFile({1, side}, {}), "test"), Error) << side;
    }
}

// Its pixels are counted, not its bytes: a file of 8 kB has 67 million of one bit, one of 0.5 MB as many of 64 bits. No such file
// need be made: one without pixels is refused by its header, or where that passes for the pixels that it has not.
TEST(LoadPng, HoldsTheLimitOfPixelsAndOfUnpackedBytesBeforeItTakesMemory) {
    const auto told = [](const PngHeader& header) {
        return messageOf([&] { (void)decodePicture(pngFile(header, {}), "test"); });
    };
    const std::string tooMany = "test: must have at most 33554432 pixels, 8192 x 4096; scale it down, ";
    EXPECT_EQ(told({8192, 8192, 16, 6}), tooMany + "8192 x 8192");
    EXPECT_EQ(told({8192, 4097, 1, 0}), tooMany + "8192 x 4097");
    for (const std::uint8_t interlaced : {std::uint8_t{0}, std::uint8_t{1}}) {
        for (const std::uint32_t width : {4096U, 8192U}) {  // as wide as high, and the most rows
            const PngHeader largest{width, maximumLoadedPixels / width, 8, 6, 0, 0, interlaced};
            EXPECT_TRUE(contains(told(largest), "fewer pixels")) << text(largest);
            const PngHeader deeper{width, maximumLoadedPixels / width, 16, 6, 0, 0, interlaced};
            EXPECT_TRUE(contains(told(deeper), "save it with 8 bits a channel, or scale it down")) << text(deeper);
            const PngHeader half{width, maximumLoadedPixels / width / 2, 16, 6, 0, 0, interlaced};
            EXPECT_TRUE(contains(told(half), "fewer pixels")) << text(half);
        }
    }
    EXPECT_TRUE(contains(told({5712, 4284, 8, 2}), "fewer pixels")) << "a telephone's photograph";
}

TEST(LoadPng, ASmallFileDoesNotUnpackToALargeOne) {
    // 64 MiB of zeros fit into 64 KiB; the header asks for one pixel.
    EXPECT_TRUE(
        contains(messageOf([] { (void)decodePicture(pngFile({}, Bytes(64U << 20U)), "test"); }), "more pixels"));
}

TEST(LoadPng, RefusesChunksOutOfOrder) {
    const Bytes header = headerData({});
    const Bytes pixel = compressed(Bytes(5));
    const auto fileOf = [&](std::initializer_list<std::string_view> types) {
        Bytes file = pngSignature();
        for (const std::string_view type : types)
            appendChunk(file, type, type == "IHDR" ? header : type == "IDAT" ? pixel : Bytes());
        return file;
    };
    EXPECT_NO_THROW((void)decodePicture(fileOf({"IHDR", "IDAT", "IEND"}), "test"));
    EXPECT_NO_THROW((void)decodePicture(fileOf({"IHDR", "teSt", "IDAT", "IEND"}), "test"));
    EXPECT_THROW((void)decodePicture(fileOf({"IDAT", "IHDR", "IEND"}), "test"), Error);
    EXPECT_THROW((void)decodePicture(fileOf({"IHDR", "IHDR", "IDAT", "IEND"}), "test"), Error);
    EXPECT_THROW((void)decodePicture(fileOf({"IHDR", "IEND"}), "test"), Error);
    EXPECT_THROW((void)decodePicture(fileOf({"IHDR", "TEST", "IDAT", "IEND"}), "test"), Error);
    EXPECT_THROW((void)decodePicture(fileOf({"IHDR", "IDAT"}), "test"), Error);
}

// A picture of 200 x 200 pixels, since small ones do not reach the memory that stb_image has not written.
TEST(LoadPng, ShowsOpaqueBlackForAColourBeyondThePalette) {
    for (const std::uint8_t interlaced : {std::uint8_t{0}, std::uint8_t{1}}) {
        for (const std::uint8_t depth : {std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{4}, std::uint8_t{8}}) {
            const PngHeader header{200, 200, depth, 3, 0, 0, interlaced};
            const Bytes largest(unpackedSize(header), std::byte{0xFF});  // every index as large as it can be
            const Picture picture = decodePicture(pngFile(header, filteredRows(header, largest)), "test");
            EXPECT_EQ(picture.at(0, 0), (Pixel{0, 0, 0, 255})) << text(header);
            EXPECT_EQ(std::count(picture.rgba.begin(), picture.rgba.end(), 0), 3 * 200 * 200) << text(header);
            EXPECT_EQ(std::count(picture.rgba.begin(), picture.rgba.end(), 255), 200 * 200) << text(header);
        }
    }
    // Those within it keep their colour, and their transparency.
    Bytes file = pngSignature();
    appendChunk(file, "IHDR", headerData({3, 1, 8, 3}));
    appendChunk(file, "PLTE",
                {std::byte{10}, std::byte{20}, std::byte{30}, std::byte{40}, std::byte{50}, std::byte{60}});
    appendChunk(file, "tRNS", {std::byte{9}});
    appendChunk(file, "IDAT", compressed({std::byte{0}, std::byte{0}, std::byte{1}, std::byte{5}}));
    appendChunk(file, "IEND", {});
    const Picture picture = decodePicture(file, "test");
    EXPECT_EQ(picture.at(0, 0), (Pixel{10, 20, 30, 9}));
    EXPECT_EQ(picture.at(1, 0), (Pixel{40, 50, 60}));
    EXPECT_EQ(picture.at(2, 0), (Pixel{0, 0, 0}));
}

TEST(LoadPng, RefusesPalettesThatAreNone) {
    const auto fileOf = [](const std::vector<std::pair<std::string_view, std::size_t>>& chunks) {
        Bytes file = pngSignature();
        appendChunk(file, "IHDR", headerData({1, 1, 8, 3}));
        for (const auto& [type, size] : chunks) appendChunk(file, type, Bytes(size));
        appendChunk(file, "IDAT", compressed(Bytes(2)));
        appendChunk(file, "IEND", {});
        return file;
    };
    const auto refusalOf = [&](const std::vector<std::pair<std::string_view, std::size_t>>& chunks) {
        return messageOf([&] { (void)decodePicture(fileOf(chunks), "test"); });
    };
    EXPECT_NO_THROW((void)decodePicture(fileOf({{"PLTE", 768}, {"tRNS", 256}}), "test"));
    EXPECT_TRUE(contains(refusalOf({}), "no palette"));
    for (const std::size_t size : {0U, 1U, 4U, 771U})
        EXPECT_TRUE(contains(refusalOf({{"PLTE", size}}), "palette of a wrong length")) << size;
    EXPECT_TRUE(contains(refusalOf({{"PLTE", 3}, {"PLTE", 3}}), "palette at a wrong place"));
    EXPECT_TRUE(contains(refusalOf({{"PLTE", 3}, {"tRNS", 2}}), "more transparencies than colours"));
    EXPECT_TRUE(contains(refusalOf({{"tRNS", 1}, {"PLTE", 3}}), "more transparencies than colours"));
}

TEST(LoadPng, RefusesPixelsInChunksThatDoNotFollowEachOther) {
    const Bytes pixels = compressed(Bytes(5));
    const Bytes first(pixels.begin(), pixels.begin() + 4), second(pixels.begin() + 4, pixels.end());
    const auto fileWith = [&](std::string_view between) {
        Bytes file = pngSignature();
        appendChunk(file, "IHDR", headerData({}));
        appendChunk(file, "IDAT", first);
        if (!between.empty()) appendChunk(file, between, between == "IDAT" ? Bytes() : Bytes(3));
        appendChunk(file, "IDAT", second);
        appendChunk(file, "IEND", {});
        return file;
    };
    const auto refusalWith = [&](std::string_view between) {
        return messageOf([&] { (void)decodePicture(fileWith(between), "test"); });
    };
    EXPECT_NO_THROW((void)decodePicture(fileWith(""), "test"));
    EXPECT_NO_THROW((void)decodePicture(fileWith("IDAT"), "test"));
    EXPECT_TRUE(contains(refusalWith("teSt"), "chunks of pixels that do not follow each other"));
    EXPECT_TRUE(contains(refusalWith("PLTE"), "palette at a wrong place"));
}

// stb_image takes Apple's CgBI for the sign of another format wherever it stands.
TEST(LoadPng, RefusesChunksThatMustBeUnderstood) {
    for (const std::string_view type : {"CgBI", "TEST", "IDOT"}) {
        Bytes file = pngSignature();
        appendChunk(file, "IHDR", headerData({}));
        appendChunk(file, type, Bytes(4));
        appendChunk(file, "IDAT", compressed(Bytes(5)));
        appendChunk(file, "IEND", {});
        EXPECT_TRUE(contains(messageOf([&] { (void)decodePicture(file, "test"); }), "must be understood")) << type;
    }
}

// Cameras and old programs write more samplings than the usual four. Smooth colours stay, whatever their sampling.
TEST(LoadJpeg, TakesEverySampling) {
    const Picture picture = smoothPicture(96, 64);
    for (const Sampling& sampling :
         {Sampling{{{1, 1}, {1, 1}, {1, 1}}}, Sampling{{{4, 2}, {1, 1}, {1, 1}}}, Sampling{{{4, 1}, {1, 1}, {1, 1}}},
          Sampling{{{1, 4}, {1, 1}, {1, 1}}}, Sampling{{{3, 1}, {1, 1}, {1, 1}}}, Sampling{{{1, 2}, {2, 1}, {2, 2}}},
          Sampling{{{2, 2}, {2, 1}, {1, 1}}}, Sampling{{{1, 1}, {2, 2}, {2, 2}}}, Sampling{{{4, 1}, {2, 1}, {1, 1}}}}) {
        const Difference d = compare(decodePicture(sampledJpegFile(picture, sampling), "test"), picture);
        // Blue and red of 4 x 4 pixels in one are off by half the change over them, 255 * 2 / 64 at most, and a few levels
        // of rounding; a channel at a wrong place would be off by a hundred.
        EXPECT_LT(d.mean, 4) << sampling[0][0] << "x" << sampling[0][1];
        EXPECT_LT(d.maximum, 24) << sampling[0][0] << "x" << sampling[0][1];
    }
}

// Whole files of kinds that libjpeg does not decode are not called damaged.
TEST(LoadJpeg, SaysWhatIsNotSupported) {
    const Bytes whole = jpegFile(smoothPicture(16, 16));
    const Bytes frame{std::byte{0xFF}, std::byte{0xC0}};
    const auto start = std::search(whole.begin(), whole.end(), frame.begin(), frame.end()) - whole.begin();
    const auto refusalWith = [&](std::ptrdiff_t place, unsigned value) {
        Bytes changed = whole;
        changed[static_cast<std::size_t>(start + place)] = std::byte(value);
        return messageOf([&] { (void)decodePicture(changed, "test"); });
    };
    // Hierarchical, lossless with arithmetic coding, JPEG-LS; of 12 bits; of two components
    for (const unsigned marker : {0xC5U, 0xCBU, 0xF7U})
        EXPECT_TRUE(contains(refusalWith(1, marker), "test: must be a kind of JPEG file that libjpeg decodes"))
            << marker;
    EXPECT_TRUE(contains(refusalWith(4, 12), "must be a kind of JPEG file that libjpeg decodes"));
    EXPECT_TRUE(contains(refusalWith(1, 0xC4), "must be an undamaged JPEG file"));
}

TEST(LoadJpeg, IsCloseToTheOriginal) {
    const Picture picture = smoothPicture(64, 48);
    const Difference d = compare(decodePicture(jpegFile(picture), "test"), picture);
    // Quality 95 quantises the frequencies of a smooth picture by a few levels; upside down, or with two channels
    // swapped, the mean would be above 40.
    EXPECT_LT(d.mean, 2);
    EXPECT_LT(d.maximum, 12);
}

TEST(LoadJpeg, RefusesEveryTruncation) {
    const Bytes whole = jpegFile(smoothPicture(40, 24));
    ASSERT_NO_THROW((void)decodePicture(whole, "test"));
    for (std::size_t length = 0; length < whole.size(); ++length) {
        EXPECT_THROW((void)decodePicture(std::span(whole).first(length), "test"), Error)
            << length << " of " << whole.size();
    }
}

TEST(LoadJpeg, HoldsTheSideLimit) {
    EXPECT_EQ(decodePicture(jpegFile(Picture(8192, 1)), "test").width, 8192);
    EXPECT_TRUE(contains(messageOf([] { (void)decodePicture(jpegFile(Picture(8193, 1)), "test"); }),
                         "sides must lie in 1..8192 pixels; scale it down, 8193 x 1"));
}

TEST(LoadJpeg, HoldsTheLimitOfPixelsBeforeItTakesMemory) {
    Bytes file = jpegFile(Picture(8, 8));
    const std::array frame{std::byte{0xFF}, std::byte{0xC0}};
    const auto sides = std::search(file.begin(), file.end(), frame.begin(), frame.end()) + 5;
    std::fill(sides, sides + 4, std::byte{0});
    sides[0] = sides[2] = std::byte{0x20};  // 8192, the higher byte
    EXPECT_EQ(messageOf([&] { (void)decodePicture(file, "test"); }),
              "test: must have at most 33554432 pixels, 8192 x 4096; scale it down, 8192 x 8192");
}

TEST(LoadJpeg, TakesWhatItCanShow) {
    const std::string jpegs = MVGL_SOURCE_DIR "/tests/fuzz/corpus/picture/jpeg-";
    EXPECT_EQ(messageOf([&] { (void)loadPicture(jpegs + "cmyk"); }),
              jpegs + "cmyk: must be a picture in grey or RGB; save it again as RGB, it is in CMYK");
    for (const char* name : {"grey", "progressive", "progressive-grey", "420", "444"})
        EXPECT_NO_THROW((void)loadPicture(jpegs + name));
    // Bits that a scan does not have: stb_image 2.27 shifts by 32 of them.
    EXPECT_TRUE(contains(messageOf([&] { (void)loadPicture(jpegs + "progressive-cut-off-in-a-scan"); }),
                         "must be an undamaged JPEG file; save or fetch it again"));
}

// A JPEG may hold tables alone, for other files.
TEST(LoadJpeg, RefusesTablesWithoutAPicture) {
    const Bytes whole = jpegFile(smoothPicture(16, 16));
    const Bytes frame{std::byte{0xFF}, std::byte{0xC0}};
    const auto cut = std::search(whole.begin(), whole.end(), frame.begin(), frame.end());
    ASSERT_NE(cut, whole.end());
    Bytes tables(whole.begin(), cut);
    tables.insert(tables.end(), {std::byte{0xFF}, std::byte{0xD9}});
    EXPECT_EQ(messageOf([&] { (void)decodePicture(tables, "test"); }),
              "test: must be an undamaged JPEG file; save or fetch it again, it holds no picture");
}

// stb_image 2.27 writes beyond its table for the first, and uses memory never written for the second.
TEST(LoadJpeg, RefusesImpossibleTables) {
    const Bytes whole = jpegFile(smoothPicture(16, 16));
    const auto segment = [&](unsigned marker) {
        std::size_t i = 0;
        while (whole[i] != std::byte{0xFF} || whole[i + 1] != std::byte(marker)) ++i;
        return i;
    };
    Bytes tooManyCodes = whole;
    const std::size_t counts = segment(0xC4) + 5;  // after marker, length and kind: how many codes of 1 to 16 bits
    std::fill_n(tooManyCodes.begin() + static_cast<std::ptrdiff_t>(counts), 16, std::byte{0});
    tooManyCodes[counts + 14] = std::byte{2};
    tooManyCodes[counts + 15] = std::byte{255};
    EXPECT_TRUE(contains(messageOf([&] { (void)decodePicture(tooManyCodes, "test"); }), "Bogus Huffman table"));
    Bytes tooShortCodes = whole;  // as many codes as before, but the five of 3 bits with 1 bit
    std::swap(tooShortCodes[counts], tooShortCodes[counts + 2]);
    EXPECT_TRUE(contains(messageOf([&] { (void)decodePicture(tooShortCodes, "test"); }), "Bogus Huffman table"));
    for (const int tables : {0x30, 0x03}) {
        Bytes undefinedTable = whole;
        undefinedTable[segment(0xDA) + 6] = std::byte(tables);  // after marker, length, count and component
        EXPECT_TRUE(
            contains(messageOf([&] { (void)decodePicture(undefinedTable, "test"); }), "Huffman table 0x03 was not"));
    }
    Bytes noQuantisation = whole;  // the segment turned into a comment
    noQuantisation[segment(0xDB) + 1] = std::byte{0xFE};
    EXPECT_TRUE(contains(messageOf([&] { (void)decodePicture(noQuantisation, "test"); }),
                         "Quantization table 0x00 was not defined"));
}

// A JPEG has no checksums: damage may pass, but only as a picture that is one.
TEST(LoadJpeg, StandsDamage) {
    const Bytes whole = jpegFile(smoothPicture(40, 24));
    std::mt19937 random(7);
    int refused = 0;
    int accepted = 0;
    for (int attempt = 0; attempt < 3000; ++attempt) {
        Bytes damaged = whole;
        for (auto flips = 1 + random() % 3; flips > 0; --flips)
            damaged[random() % damaged.size()] ^= std::byte(1U << random() % 8);
        try {
            checkPicture(decodePicture(damaged, "test"), "test");
            ++accepted;
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 100);
    EXPECT_GT(accepted, 100);
}

}  // namespace
}  // namespace mv
