#include "image/png_files.h"

#include <zlib.h>

#include <stdexcept>

namespace mv {
namespace {

void appendNumber(Bytes& bytes, std::uint32_t number) {
    for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes.push_back(static_cast<std::byte>(number >> shift & 255U));
}

const Bytef* zlibBytes(const Bytes& bytes) { return reinterpret_cast<const Bytef*>(bytes.data()); }

}  // namespace

Bytes pngSignature() {
    Bytes bytes;
    for (const int value : {0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A}) bytes.push_back(std::byte(value));
    return bytes;
}

void appendChunk(Bytes& file, std::string_view type, const Bytes& data) {
    Bytes checked;
    for (const char letter : type) checked.push_back(static_cast<std::byte>(letter));
    checked.insert(checked.end(), data.begin(), data.end());
    appendNumber(file, static_cast<std::uint32_t>(data.size()));
    file.insert(file.end(), checked.begin(), checked.end());
    appendNumber(file, static_cast<std::uint32_t>(crc32(0, zlibBytes(checked), static_cast<uInt>(checked.size()))));
}

Bytes headerData(const PngHeader& header) {
    Bytes data;
    appendNumber(data, header.width);
    appendNumber(data, header.height);
    for (const std::uint8_t value : {header.depth, header.colour, header.compression, header.filter, header.interlaced})
        data.push_back(std::byte{value});
    return data;
}

Bytes compressed(const Bytes& bytes) {
    uLongf length = compressBound(static_cast<uLong>(bytes.size()));
    Bytes result(length);
    if (compress(reinterpret_cast<Bytef*>(result.data()), &length, zlibBytes(bytes),
                 static_cast<uLong>(bytes.size())) != Z_OK) {
        throw std::runtime_error("zlib cannot compress");
    }
    result.resize(length);
    return result;
}

Bytes pngFile(const PngHeader& header, const Bytes& unpacked) {
    Bytes file = pngSignature();
    appendChunk(file, "IHDR", headerData(header));
    if (header.colour == 3) appendChunk(file, "PLTE", Bytes(3, std::byte{90}));
    appendChunk(file, "IDAT", compressed(unpacked));
    appendChunk(file, "IEND", {});
    return file;
}

}  // namespace mv
