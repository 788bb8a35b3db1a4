// The checks of a JPEG file that stb_image leaves out.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace mv {

// Whether the bytes begin as every JPEG file does.
[[nodiscard]] bool startsAsJpeg(std::span<const std::byte> bytes);

// Throws Error, with `name` as subject, unless the bytes are a chain of whole JPEG segments from start to end marker,
// with Huffman tables that are possible, and scans that use only tables defined before them.
// stb_image 2.27 writes beyond its table when a damaged file announces more than 256 codes, and reads memory never
// written when a scan names a table that the file does not define. Pixels are not looked at: they have no checksum.
void checkJpeg(std::span<const std::byte> bytes, std::string_view name);

}  // namespace mv
