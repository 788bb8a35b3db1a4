// The checks of a PNG file that stb_image leaves out.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace mv {

// Whether the bytes begin as every PNG file does.
[[nodiscard]] bool startsAsPng(std::span<const std::byte> bytes);

// Throws Error, with `name` as subject, unless the bytes are a whole and undamaged PNG file:
// chunks in one piece and with the right checksum, a header that the format allows and with sides of at most
// `maximumSide`, and compressed data which unpack, checksum included, to exactly the bytes that the header asks for.
// stb_image checks no checksum, so a flipped bit would show as wrong colours; and it unpacks without limit, so a small
// file could take all memory. What follows the last chunk is not looked at.
void checkPng(std::span<const std::byte> bytes, std::string_view name, int maximumSide);

}  // namespace mv
