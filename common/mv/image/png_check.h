// The checks of a PNG file that stb_image leaves out.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace mv {

// Whether the bytes begin as every PNG file does.
[[nodiscard]] bool startsAsPng(std::span<const std::byte> bytes);

// The parts of a PNG file that stb_image does not read: parts of its bytes, empty where it has none.
struct PngParts {
    std::span<const std::byte> palette;  // the whole chunk, of a picture whose pixels are indices into it
    std::span<const std::byte> exif;
    std::vector<std::span<const std::byte>> texts;  // of the chunks tEXt and iTXt
};

// Throws Error, with `name` as subject, unless the bytes are a whole and undamaged PNG file:
// chunks in one piece, with the right checksum and in order, none that must be understood and is not, a header that the
// format allows and with sides that checkLoadedSides passes, and compressed data which unpack, checksum included, to exactly
// the bytes that the header asks for, no more than the largest picture has in RGBA of 8 bits.
// stb_image checks no checksum, so a flipped bit would show as wrong colours; it joins compressed data that other chunks
// part; and it unpacks without limit, so a small file could take all memory. Bytes after the last chunk are not looked
// at.
PngParts checkPng(std::span<const std::byte> bytes, std::string_view name);

// The file with a palette of 256 colours: its own, and opaque black after these, which libpng shows where a pixel names a
// colour beyond the palette. stb_image shows there whatever is in memory. `palette` is checkPng's.
std::vector<std::byte> withWholePalette(std::span<const std::byte> bytes, std::span<const std::byte> palette);

}  // namespace mv
