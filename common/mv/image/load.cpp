#include "mv/image/load.h"

#include <algorithm>
#include <memory>
#include <string>

#include "mv/error.h"
#include "mv/image/file.h"
#include "mv/image/png_check.h"

// Only two formats, and no flipping: stb_image's known holes lie in the others and in its flip.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 8192
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

bool startsAsJpeg(std::span<const std::byte> bytes) {
    return bytes.size() >= 3 && bytes[0] == std::byte{0xFF} && bytes[1] == std::byte{0xD8} &&
           bytes[2] == std::byte{0xFF};
}

}  // namespace

Picture decodePicture(std::span<const std::byte> bytes, std::string_view name) {
    if (bytes.size() > maximumPictureFileBytes) {
        throw Error(name, "must hold at most " + std::to_string(maximumPictureFileBytes) + " bytes",
                    std::to_string(bytes.size()));
    }
    if (startsAsPng(bytes)) {
        checkPng(bytes, name, maximumLoadedSide);
    } else if (!startsAsJpeg(bytes)) {
        throw Error(name, "must be a PNG or JPEG file; other formats have to be converted first",
                    bytes.empty() ? "it is empty" : "it begins as neither");
    }

    int width = 0;
    int height = 0;
    int channelsInFile = 0;
    const std::unique_ptr<stbi_uc, FreePixels> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()), &width,
                              &height, &channelsInFile, STBI_rgb_alpha));
    if (!pixels) {
        throw Error(name, "must be an undamaged picture of at most 8192 pixels a side; save or fetch it again",
                    stbi_failure_reason());
    }
    Picture picture(width, height);
    std::copy_n(pixels.get(), picture.rgba.size(), picture.rgba.begin());
    return picture;
}

Picture loadPicture(const std::filesystem::path& path) {
    return decodePicture(readFile(path, maximumPictureFileBytes), path.string());
}

}  // namespace mv
