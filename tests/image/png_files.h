// PNG files made by hand, chunk by chunk, to try what no encoder would write.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace mv {

struct PngHeader {
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    std::uint8_t depth = 8;
    std::uint8_t colour = 6;  // 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
    std::uint8_t compression = 0;
    std::uint8_t filter = 0;
    std::uint8_t interlaced = 0;
};

using Bytes = std::vector<std::byte>;

Bytes pngSignature();
// Length, type, data and the right checksum.
void appendChunk(Bytes& file, std::string_view type, const Bytes& data);
Bytes headerData(const PngHeader& header);
// The bytes compressed by zlib.
Bytes compressed(const Bytes& bytes);
// A whole file: header, a palette of one grey entry where the header needs one, `unpacked` compressed, the end.
Bytes pngFile(const PngHeader& header, const Bytes& unpacked);

}  // namespace mv
