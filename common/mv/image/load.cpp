#include "mv/image/load.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "mv/error.h"
#include "mv/image/exif.h"
#include "mv/image/file.h"
#include "mv/image/jpeg.h"
#include "mv/image/png_check.h"

// stb_image reads PNG, and libjpeg-turbo JPEG: most of stb_image's known holes lie in its other formats and in its flip.
// Those in PNG are closed by checkPng, which looks at every file first.
#ifndef __clang_analyzer__  // which would report on stb_image's code, too
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#endif
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 8192
// Memory that a damaged file leaves unwritten is zero, not what some other picture left there.
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC(pointer, size) std::realloc(pointer, size)
#define STBI_FREE(pointer) std::free(pointer)
// Its assertions are about the file's content, which must not end the program.
#define STBI_ASSERT(condition) static_cast<void>(0)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace mv {
namespace {

static_assert(STBI_MAX_DIMENSIONS == maximumLoadedSide);

struct FreePixels {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

Picture decodePng(std::span<const std::byte> bytes, std::string_view name) {
    const PngParts parts = checkPng(bytes, name);
    std::vector<std::byte> whole;
    if (!parts.palette.empty()) {
        whole = withWholePalette(bytes, parts.palette);
        bytes = whole;
    }
    int width = 0;
    int height = 0;
    int channelsInFile = 0;
    const std::unique_ptr<stbi_uc, FreePixels> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()), &width,
                              &height, &channelsInFile, STBI_rgb_alpha));
    if (!pixels) throw Error(name, "must be an undamaged PNG file; save or fetch it again", stbi_failure_reason());
    Picture picture(width, height);
    std::copy_n(pixels.get(), picture.rgba.size(), picture.rgba.begin());
    return upright(std::move(picture), exifOrientation(parts.exif));
}

}  // namespace

void checkLoadedSides(std::uint32_t width, std::uint32_t height, std::string_view name) {
    const auto refuse = [&](const std::string& rule) {
        throw Error(name, rule + "; scale it down", std::to_string(width) + " x " + std::to_string(height));
    };
    constexpr auto side = static_cast<std::uint32_t>(maximumLoadedSide);
    if (width < 1 || height < 1 || width > side || height > side)
        refuse("sides must lie in 1.." + std::to_string(side) + " pixels");
    if (std::uint64_t{width} * height > maximumLoadedPixels)
        refuse("must have at most " + std::to_string(maximumLoadedPixels) + " pixels, 8192 x 4096");
}

Picture decodePicture(std::span<const std::byte> bytes, std::string_view name) {
    if (bytes.size() > maximumPictureFileBytes) {
        throw Error(name, "must hold at most " + std::to_string(maximumPictureFileBytes) + " bytes",
                    std::to_string(bytes.size()));
    }
    if (startsAsPng(bytes)) return decodePng(bytes, name);
    if (startsAsJpeg(bytes)) return decodeJpeg(bytes, name);
    throw Error(name, "must be a PNG or JPEG file; other formats have to be converted first",
                bytes.empty() ? "it is empty" : "it begins as neither");
}

std::string pictureStamp(const std::filesystem::path& path) {
    std::error_code failed;
    const auto written = std::filesystem::last_write_time(path, failed);
    if (failed) return {};
    const std::uintmax_t size = std::filesystem::file_size(path, failed);
    if (failed) return {};  // a folder, say
    return std::to_string(written.time_since_epoch().count()) + " " + std::to_string(size);
}

Picture loadPicture(const std::filesystem::path& path) {
    return decodePicture(readFile(path, maximumPictureFileBytes), path.string());
}

}  // namespace mv
