// Pictures from PNG and JPEG files.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "mv/image/picture.h"

namespace mv {

// The most that loadPicture accepts: pictures for textures, not whatever a hostile file says of itself.
inline constexpr std::size_t maximumPictureFileBytes = std::size_t{64} << 20U;
inline constexpr int maximumLoadedSide = 8192;
// A picture takes memory by its pixels, however small its file is: twice 128 MB while one of so many is read. The
// bounds are those of the photographs that telephones take (12 and 24 million).
inline constexpr std::uint32_t maximumLoadedPixels = 8192U * 4096;

// Error, with `name` as subject, unless both sides lie in 1..maximumLoadedSide and have at most maximumLoadedPixels together.
void checkLoadedSides(std::uint32_t width, std::uint32_t height, std::string_view name);

// The picture in a PNG or JPEG file, top row first, RGBA; alpha is 255 where the file has none, grey becomes
// red = green = blue, and 16 bits per channel become 8. For glTexImage2D turn the rows about (flipRows).
// Upright where the file has EXIF's note of how the camera was held. Colours come as stored (nearly always sRGB); profiles and
// gamma are not applied. A pixel that names a colour beyond its file's palette is opaque black, as libpng has it.
// stb_image reads PNG, behind checks of its own; JPEG is libjpeg's, since stb_image reads memory never written in damaged ones.
// Error, with the path and the reason, if the file cannot be read, is larger than maximumPictureFileBytes, has a side
// above maximumLoadedSide or more than maximumLoadedPixels, unpacks from PNG to more than four bytes for each of so many
// (16 bits a channel), is neither PNG nor JPEG, is a JPEG that libjpeg does not decode (CMYK, 12 bits ...), or is
// cut off or damaged.
// The trap: a JPEG has no checksums. One that is cut off is refused, but a flipped bit may show as a smear instead.
[[nodiscard]] Picture loadPicture(const std::filesystem::path& path);

// A text that becomes another one when the file is written anew: its time and its size. "" where there is no such file.
[[nodiscard]] std::string pictureStamp(const std::filesystem::path& path);

// As loadPicture, from bytes in memory; `name` stands for them in an Error.
[[nodiscard]] Picture decodePicture(std::span<const std::byte> bytes, std::string_view name);

}  // namespace mv
