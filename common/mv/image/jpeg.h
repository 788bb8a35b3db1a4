// JPEG files as pictures, by libjpeg-turbo.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

#include "mv/image/picture.h"

namespace mv {

// Whether the bytes begin as every JPEG file does.
[[nodiscard]] bool startsAsJpeg(std::span<const std::byte> bytes);

// The picture in a JPEG file, grey or in colours (not CMYK, which needs a printer's profile); top row first, alpha 255.
// Error, with `name` as subject, if a side is above `maximumSide` or the file is cut off or visibly damaged: what
// libjpeg-turbo only warns of, and fills with grey, is refused.
[[nodiscard]] Picture decodeJpeg(std::span<const std::byte> bytes, std::string_view name, int maximumSide);

}  // namespace mv
