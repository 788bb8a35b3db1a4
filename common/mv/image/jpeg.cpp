#include "mv/image/jpeg.h"

#include <turbojpeg.h>

#include <algorithm>
#include <memory>
#include <string>

#include "mv/error.h"

namespace mv {
namespace {

struct Destroy {
    void operator()(void* decoder) const { tjDestroy(decoder); }
};

// Exact arithmetic, the same on every processor; no warning passes; and no file of a few bytes a scan takes hours.
constexpr int flags = TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS;

}  // namespace

bool startsAsJpeg(std::span<const std::byte> bytes) {
    return bytes.size() >= 3 && bytes[0] == std::byte{0xFF} && bytes[1] == std::byte{0xD8} &&
           bytes[2] == std::byte{0xFF};
}

Picture decodeJpeg(std::span<const std::byte> bytes, std::string_view name, int maximumSide) {
    const std::unique_ptr<void, Destroy> decoder(tjInitDecompress());
    if (!decoder)
        throw Error(name, "must find memory for a JPEG decoder; close other programs", tjGetErrorStr2(nullptr));
    const auto requireRead = [&](int result) {
        if (result != 0) {
            throw Error(name, "must be an undamaged JPEG file; save or fetch it again", tjGetErrorStr2(decoder.get()));
        }
    };

    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    int width = 0;
    int height = 0;
    int sampling = 0;
    int colours = 0;
    requireRead(tjDecompressHeader3(decoder.get(), data, bytes.size(), &width, &height, &sampling, &colours));
    if (width < 1 || height < 1)  // as of a file of tables for other files
        throw Error(name, "must be an undamaged JPEG file; save or fetch it again", "it holds no picture");
    if (std::max(width, height) > maximumSide) {
        throw Error(name, "sides must be at most " + std::to_string(maximumSide) + " pixels; scale it down",
                    std::to_string(width) + " x " + std::to_string(height));
    }
    if (colours == TJCS_CMYK || colours == TJCS_YCCK)
        throw Error(name, "must be a picture in grey or RGB; save it again as RGB", "it is in CMYK");

    Picture picture(width, height);
    requireRead(tjDecompress2(decoder.get(), data, bytes.size(), picture.rgba.data(), width, 4 * width, height,
                              TJPF_RGBA, flags));
    return picture;
}

}  // namespace mv
