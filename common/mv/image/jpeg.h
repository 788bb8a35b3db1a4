// JPEG files as pictures, by libjpeg-turbo.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

#include "mv/image/picture.h"

namespace mv {

// Whether the bytes begin as every JPEG file does.
[[nodiscard]] bool startsAsJpeg(std::span<const std::byte> bytes);

// The picture in a JPEG file of any sampling, grey or in colours (not CMYK, which needs a printer's profile); upright, as its
// EXIF note says; top row first, alpha 255.
// Error, with `name` as subject, if checkLoadedSides refuses its sides, the file is of a kind that libjpeg does not decode (12
// bits, hierarchical, in older versions lossless), cut off or visibly damaged: what libjpeg only warns of, and fills with
// grey, is refused.
[[nodiscard]] Picture decodeJpeg(std::span<const std::byte> bytes, std::string_view name);

}  // namespace mv
