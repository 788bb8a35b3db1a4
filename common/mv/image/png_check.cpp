// After the PNG specification (ISO/IEC 15948): 5 (chunks and their order), 11.2.2 (header), 8.2 (passes), 10 (compression).
#include "mv/image/png_check.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>

#include "mv/error.h"
#include "mv/image/load.h"

namespace mv {
namespace {

constexpr std::array<unsigned char, 8> signature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

[[noreturn]] void refuse(std::string_view name, std::string_view reason) {
    throw Error(name, "must be an undamaged PNG file; save or fetch it again", reason);
}

const Bytef* zlibBytes(const std::byte* bytes) { return reinterpret_cast<const Bytef*>(bytes); }

std::uint32_t bigEndian(std::span<const std::byte> bytes) {
    std::uint32_t value = 0;
    for (const std::byte byte : bytes.first(4)) value = (value << 8U) | std::to_integer<std::uint32_t>(byte);
    return value;
}

struct Header {
    std::uint32_t width;
    std::uint32_t height;
    unsigned bitsPerPixel;
    bool interlaced;
    bool hasPalette;  // the pixels are indices into it
};

Header readHeader(std::span<const std::byte> data, std::string_view name) {
    if (data.size() != 13) refuse(name, "header of the wrong length");
    const auto field = [&](std::size_t index) { return std::to_integer<unsigned>(data[index]); };
    const Header sides{bigEndian(data), bigEndian(data.subspan(4)), 0, false, false};
    checkLoadedSides(sides.width, sides.height, name);

    // Which depths go with which kind of colour, table 11.1 of the specification.
    struct Kind {
        unsigned number;
        unsigned channels;
        std::array<unsigned, 5> depths;
    };
    constexpr std::array<Kind, 5> kinds = {
        {{0, 1, {1, 2, 4, 8, 16}}, {2, 3, {8, 16}}, {3, 1, {1, 2, 4, 8}}, {4, 2, {8, 16}}, {6, 4, {8, 16}}}};
    const unsigned depth = field(8);
    const auto* kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.number == field(9); });
    if (kind == kinds.end() || depth == 0 ||
        std::find(kind->depths.begin(), kind->depths.end(), depth) == kind->depths.end()) {
        refuse(name, "kind of colour or bit depth unknown");
    }
    if (field(10) != 0 || field(11) != 0 || field(12) > 1) refuse(name, "compression, filter or interlacing unknown");
    return {sides.width, sides.height, kind->channels * depth, field(12) == 1, field(9) == 3};
}

// The bytes that the largest picture has in RGBA of 8 bits, with a filter's byte for each row, of which interlacing has up
// to twice as many.
constexpr std::uint64_t maximumUnpackedBytes =
    std::uint64_t{4} * maximumLoadedPixels + std::uint64_t{2} * maximumLoadedSide;

// The number of bytes before compression: for each row a byte that names its filter, and the pixels.
std::uint64_t unpackedSize(const Header& header) {
    struct Pass {
        std::uint32_t x, y, stepX, stepY;
    };
    constexpr std::array<Pass, 7> adam7 = {
        {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};
    constexpr std::array<Pass, 1> whole = {{{0, 0, 1, 1}}};
    std::uint64_t size = 0;
    for (const Pass& pass : header.interlaced ? std::span<const Pass>(adam7) : std::span<const Pass>(whole)) {
        const std::uint64_t columns = (header.width + pass.stepX - 1 - pass.x) / pass.stepX;
        const std::uint64_t rows = (header.height + pass.stepY - 1 - pass.y) / pass.stepY;
        if (columns > 0) size += rows * (1 + (columns * header.bitsPerPixel + 7) / 8);
    }
    return size;
}

// Unpacks the compressed data only to count and to check them, through one small buffer.
class Counter {
  public:
    Counter(std::string_view name, std::uint64_t expected) : name_(name), left_(expected) {
        if (inflateInit(&stream_) != Z_OK) refuse(name_, "no memory to unpack it");
    }
    ~Counter() { inflateEnd(&stream_); }
    Counter(const Counter&) = delete;
    Counter& operator=(const Counter&) = delete;

    void feed(std::span<const std::byte> data) {
        stream_.next_in = const_cast<Bytef*>(zlibBytes(data.data()));  // zlib reads it only
        stream_.avail_in = static_cast<uInt>(data.size());
        // Bytes after the end of the compressed stream are allowed (10.1 lets decoders ignore them).
        while (!ended_) {
            stream_.next_out = buffer_.data();
            stream_.avail_out = static_cast<uInt>(buffer_.size());
            const int result = inflate(&stream_, Z_NO_FLUSH);
            const std::uint64_t made = buffer_.size() - stream_.avail_out;
            if (result == Z_BUF_ERROR && made == 0) return;  // it wants more data
            if (result != Z_OK && result != Z_STREAM_END) refuse(name_, "compressed data damaged");
            if (made > left_) refuse(name_, "more pixels than its header tells");
            left_ -= made;
            ended_ = result == Z_STREAM_END;
        }
    }

    void finish() const {
        if (!ended_) refuse(name_, "compressed data cut off");
        if (left_ > 0) refuse(name_, "fewer pixels than its header tells");
    }

  private:
    std::string_view name_;
    std::uint64_t left_;
    bool ended_ = false;
    z_stream stream_{};
    std::array<Bytef, 32768> buffer_{};
};

constexpr std::size_t chunkFrame = 12;  // bytes around the data: length, type, checksum

struct Chunk {
    std::string_view type;
    std::span<const std::byte> data;
};

// The chunk at the front of `rest`, checked, and removed from it: length, type, data, checksum of type and data.
Chunk takeChunk(std::span<const std::byte>& rest, std::string_view name) {
    if (rest.size() < chunkFrame) refuse(name, "cut off");
    const std::size_t length = bigEndian(rest);
    if (length > rest.size() - chunkFrame) refuse(name, "cut off");
    const auto typeAndData = rest.subspan(4, 4 + length);
    const uLong sum = crc32(crc32(0, nullptr, 0), zlibBytes(typeAndData.data()), static_cast<uInt>(typeAndData.size()));
    if (sum != bigEndian(rest.subspan(8 + length))) refuse(name, "checksum wrong");
    rest = rest.subspan(chunkFrame + length);
    return {{reinterpret_cast<const char*>(typeAndData.data()), 4}, typeAndData.subspan(4)};
}

}  // namespace

bool startsAsPng(std::span<const std::byte> bytes) {
    return bytes.size() >= signature.size() &&
           std::equal(signature.begin(), signature.end(), bytes.begin(),
                      [](unsigned char expected, std::byte byte) { return std::byte{expected} == byte; });
}

PngParts checkPng(std::span<const std::byte> bytes, std::string_view name) {
    if (!startsAsPng(bytes)) refuse(name, "it does not begin as a PNG file does");
    // zlib counts in 32 bits; callers cap files far below.
    if (bytes.size() > std::numeric_limits<std::uint32_t>::max()) refuse(name, "larger than 4 GiB");

    auto rest = bytes.subspan(signature.size());
    const Chunk first = takeChunk(rest, name);
    if (first.type != "IHDR") refuse(name, "its first chunk is not the header");
    const Header header = readHeader(first.data, name);
    const std::uint64_t unpacked = unpackedSize(header);
    if (unpacked > maximumUnpackedBytes) {
        throw Error(name,
                    "must unpack to at most " + std::to_string(maximumUnpackedBytes) +
                        " bytes; save it with 8 bits a channel, or scale it down",
                    std::to_string(unpacked));
    }
    Counter pixels(name, unpacked);
    PngParts parts;
    std::string_view before = first.type;
    std::size_t colours = 0;
    bool hasPixels = false, hasPalette = false;
    for (;;) {
        const auto place = rest;
        const Chunk chunk = takeChunk(rest, name);
        if (chunk.type == "IEND") break;
        if (chunk.type == "IDAT") {
            if (hasPixels && before != "IDAT") refuse(name, "chunks of pixels that do not follow each other");
            hasPixels = true;
            pixels.feed(chunk.data);
        } else if (chunk.type == "PLTE") {
            if (hasPalette || hasPixels) refuse(name, "palette at a wrong place");
            colours = chunk.data.size() / 3;
            if (chunk.data.size() % 3 != 0 || colours < 1 || colours > 256) refuse(name, "palette of a wrong length");
            hasPalette = true;
            if (header.hasPalette) parts.palette = place.first(place.size() - rest.size());
        } else if (chunk.type == "tRNS") {
            if (header.hasPalette && chunk.data.size() > colours) refuse(name, "more transparencies than colours");
        } else if (chunk.type == "eXIf") {
            parts.exif = chunk.data;
        } else if (chunk.type == "tEXt" || chunk.type == "iTXt") {
            parts.texts.push_back(chunk.data);
        } else if ((std::to_integer<unsigned>(std::byte(chunk.type[0])) & 0x20U) == 0) {
            refuse(name, "a chunk that must be understood, and is not");  // by 5.4, of a capital first letter
        }
        before = chunk.type;
    }
    pixels.finish();
    if (header.hasPalette && !hasPalette) refuse(name, "no palette");
    return parts;
}

std::vector<std::byte> withWholePalette(std::span<const std::byte> bytes, std::span<const std::byte> palette) {
    const auto start = static_cast<std::size_t>(palette.data() - bytes.data());
    const auto append = [](std::vector<std::byte>& to, std::span<const std::byte> more) {
        to.insert(to.end(), more.begin(), more.end());
    };
    constexpr std::size_t colours = 3 * std::size_t{256};
    std::vector<std::byte> whole;
    whole.reserve(bytes.size() + colours);
    append(whole, bytes.first(start));
    for (const std::size_t byte : {std::size_t{0}, std::size_t{0}, colours / 256, colours % 256})
        whole.push_back(static_cast<std::byte>(byte));
    append(whole, palette.subspan(4, palette.size() - 8));  // its name and its colours, without length and checksum
    whole.resize(start + 8 + colours);
    whole.resize(whole.size() + 4);  // a checksum, which stb_image does not look at
    append(whole, bytes.subspan(start + palette.size()));
    return whole;
}

}  // namespace mv
