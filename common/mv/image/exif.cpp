// After EXIF 2.32 (4.6.2: directories of 12 bytes an entry, as in TIFF 6.0; 4.6.4: orientation).
#include "mv/image/exif.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "mv/error.h"

namespace mv {
namespace {

// Numbers of the order of bytes that the data begin with; none where the data end before.
struct Numbers {
    std::span<const std::byte> bytes;
    bool largeEndFirst;

    std::optional<std::uint32_t> at(std::size_t place, std::size_t length) const {
        if (place > bytes.size() || length > bytes.size() - place) return {};
        std::uint32_t number = 0;
        for (std::size_t i = 0; i < length; ++i)
            number = number << 8U | std::to_integer<std::uint32_t>(bytes[place + (largeEndFirst ? i : length - 1 - i)]);
        return number;
    }
};

}  // namespace

int exifOrientation(std::span<const std::byte> exif) {
    const Numbers numbers{exif, !exif.empty() && exif[0] == std::byte{'M'}};
    constexpr std::uint32_t littleEndian = 0x4949, bigEndian = 0x4D4D, magic = 42, orientation = 0x0112, isShort = 3;
    const std::optional<std::uint32_t> order = numbers.at(0, 2);
    if ((order != littleEndian && order != bigEndian) || numbers.at(2, 2) != magic) return 1;
    const std::size_t directory = numbers.at(4, 4).value_or(0);
    const std::size_t entries = numbers.at(directory, 2).value_or(0);
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + 12 * i;
        if (numbers.at(entry, 2) != orientation) continue;
        const std::uint32_t value = numbers.at(entry + 8, 2).value_or(1);
        return numbers.at(entry + 2, 2) == isShort && value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
    }
    return 1;
}

Picture upright(Picture picture, int orientation) {
    if (orientation < 1 || orientation > 8) throw Error("orientation", "must be in 1..8", std::to_string(orientation));
    checkPicture(picture, "upright");
    if (orientation == 1) return picture;
    // From 5 on rows become columns. The pixel at (x, y) of what is shown comes from (fromX, fromY) of what is stored.
    const bool exchanged = orientation >= 5;
    const bool mirroredX = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool mirroredY = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    Picture turned(exchanged ? picture.height : picture.width, exchanged ? picture.width : picture.height);
    for (int y = 0; y < turned.height; ++y) {
        for (int x = 0; x < turned.width; ++x) {
            int fromX = exchanged ? y : x, fromY = exchanged ? x : y;
            if (mirroredX) fromX = picture.width - 1 - fromX;
            if (mirroredY) fromY = picture.height - 1 - fromY;
            const std::size_t from = 4 * pixelIndex(fromX, fromY, picture.width);
            const std::size_t to = 4 * pixelIndex(x, y, turned.width);
            for (std::size_t channel = 0; channel < 4; ++channel)
                turned.rgba[to + channel] = picture.rgba[from + channel];
        }
    }
    return turned;
}

}  // namespace mv
