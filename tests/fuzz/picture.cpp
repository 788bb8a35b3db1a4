// libFuzzer: any bytes into the loader of pictures. A picture of its own size comes out, or an Error; nothing else.
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "mv/error.h"
#include "mv/image/load.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

namespace {

using Bytes = std::vector<std::uint8_t>;
using Span = std::span<const std::uint8_t>;

constexpr std::array<std::uint8_t, 8> pngSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

bool isPng(Span file) { return file.size() >= 8 && std::equal(pngSignature.begin(), pngSignature.end(), file.begin()); }

unsigned bigEndian(Span bytes, std::size_t length) {
    unsigned value = 0;
    for (const std::uint8_t byte : bytes.first(length)) value = value << 8 | byte;
    return value;
}

// A picture that claims large sides is allocated and filled, which takes a second and teaches nothing.
bool isLarge(Span file) {
    constexpr unsigned limit = 64;
    if (isPng(file))
        return file.size() >= 24 && std::max(bigEndian(file.subspan(16), 4), bigEndian(file.subspan(20), 4)) > limit;
    for (std::size_t i = 0; i + 9 <= file.size(); ++i) {
        const bool frame = file[i] == 0xFF && file[i + 1] >= 0xC0 && file[i + 1] <= 0xC2;
        if (frame && std::max(bigEndian(file.subspan(i + 5), 2), bigEndian(file.subspan(i + 7), 2)) > limit)
            return true;
    }
    return false;
}

void append(Bytes& to, unsigned value) {
    for (const int shift : {24, 16, 8, 0}) to.push_back(static_cast<std::uint8_t>(value >> shift));
}

void appendChunk(Bytes& file, Span type, Span data) {
    append(file, static_cast<unsigned>(data.size()));
    const std::size_t start = file.size();
    file.insert(file.end(), type.begin(), type.end());
    file.insert(file.end(), data.begin(), data.end());
    append(file, static_cast<unsigned>(crc32(0, file.data() + start, static_cast<uInt>(file.size() - start))));
}

// Unpacked as far as it can be, and packed again.
Bytes packedAgain(const Bytes& packed) {
    Bytes unpacked(std::size_t{1} << 16);
    z_stream stream{};
    inflateInit(&stream);
    stream.next_in = const_cast<Bytef*>(packed.data());
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = unpacked.data();
    stream.avail_out = static_cast<uInt>(unpacked.size());
    inflate(&stream, Z_FINISH);
    const uLong length = stream.total_out;
    inflateEnd(&stream);
    uLongf size = compressBound(length);
    Bytes result(size);
    compress2(result.data(), &size, unpacked.data(), length, 0);  // stored, so that mutations reach the pixels
    result.resize(size);
    return result;
}

// The PNG file with right lengths and checksums. Without, a mutation hardly ever comes past them.
Bytes repaired(Span file) {
    Bytes result(pngSignature.begin(), pngSignature.end()), pixels;
    bool placed = false;
    const auto place = [&] {
        static constexpr std::array<std::uint8_t, 4> name{'I', 'D', 'A', 'T'};
        if (!placed && !pixels.empty()) appendChunk(result, name, packedAgain(pixels));
        placed = placed || !pixels.empty();
    };
    for (Span rest = file.subspan(8); rest.size() >= 12;) {
        const std::size_t length = std::min<std::size_t>(bigEndian(rest, 4), rest.size() - 12);
        const Span type = rest.subspan(4, 4), data = rest.subspan(8, length);
        if (std::memcmp(type.data(), "IDAT", 4) == 0) {
            pixels.insert(pixels.end(), data.begin(), data.end());
        } else {
            place();
            appendChunk(result, type, data);
        }
        rest = rest.subspan(12 + length);
    }
    place();
    return result;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed) {
    const std::size_t mutated = LLVMFuzzerMutate(data, size, maxSize);
    if (seed % 4 == 0 || !isPng({data, mutated})) return mutated;
    const Bytes png = repaired({data, mutated});
    if (png.size() > maxSize) return mutated;
    std::copy(png.begin(), png.end(), data);
    return png.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (isLarge({data, size})) return 0;
    try {
        mv::checkPicture(mv::decodePicture(std::as_bytes(Span(data, size)), "input"), "decoded");
    } catch (const mv::Error& error) {
        if (std::strncmp(error.what(), "input: must", 11) != 0 &&
            std::strncmp(error.what(), "input: sides must", 17) != 0)
            throw;
    }
    return 0;
}
