#include "mv/image/png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>
#include <new>
#include <span>
#include <string_view>
#include <utility>

#include "mv/error.h"
#include "mv/image/file.h"
#include "mv/image/png_check.h"

namespace mv {
namespace {

constexpr const char* commandKeyword = "mvgl";

// The objects that one encoding needs. They live outside the function that libpng may leave by longjmp, which runs no
// destructors.
struct Encoding {
    const Picture& picture;
    bool opaque;
    const std::string& command;
    std::vector<std::byte> bytes{};
    std::array<char, 160> message{};
};

// libpng calls this when it cannot go on; it must not return. The exception is thrown after the way out of libpng,
// since C code need not be built to let exceptions through.
[[noreturn]] void leave(png_structp png, png_const_charp message) {
    auto* encoding = static_cast<Encoding*>(png_get_error_ptr(png));
    std::strncpy(encoding->message.data(), message, encoding->message.size() - 1);
    png_longjmp(png, 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

bool append(std::vector<std::byte>& bytes, png_const_bytep data, std::size_t length) noexcept {
    try {
        const auto* begin = reinterpret_cast<const std::byte*>(data);
        bytes.insert(bytes.end(), begin, begin + length);
        return true;
    } catch (const std::bad_alloc&) {
        return false;
    }
}

void takeBytes(png_structp png, png_bytep data, std::size_t length) {
    auto* encoding = static_cast<Encoding*>(png_get_io_ptr(png));
    if (!append(encoding->bytes, data, length)) png_error(png, "out of memory");
}

void nothingToFlush(png_structp) {}

// False if libpng gave up. Only plain values live in here: longjmp would skip the destructor of anything else.
bool writeImage(png_structp png, png_infop info, const Encoding& encoding) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    const Picture& picture = encoding.picture;
    png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.height), 8,
                 encoding.opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    // zlib's run-length strategy makes rendered pictures smaller still, but repeated textures ten times larger.
    png_set_compression_level(png, 1);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    if (!encoding.command.empty()) {
        const bool ascii =
            std::all_of(encoding.command.begin(), encoding.command.end(), [](unsigned char c) { return c < 0x80; });
        png_text text{};
        text.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        text.key = const_cast<char*>(commandKeyword);  // libpng reads them only
        text.text = const_cast<char*>(encoding.command.c_str());
        text.text_length = encoding.command.size();
        png_set_text(png, info, &text, 1);
    }
    png_write_info(png, info);
    if (encoding.opaque) png_set_filler(png, 0, PNG_FILLER_AFTER);  // four bytes in, three out

    const std::size_t rowBytes = static_cast<std::size_t>(picture.width) * 4;
    const png_byte* row = picture.rgba.data();
    for (int y = 0; y < picture.height; ++y, row += rowBytes) png_write_row(png, row);
    png_write_end(png, info);
    return true;
}

bool isOpaque(const Picture& picture) {
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) {
        if (picture.rgba[i] != 255) return false;
    }
    return true;
}

}  // namespace

std::vector<std::byte> encodePng(const Picture& picture, const std::string& command) {
    checkPicture(picture, "encodePng");
    Encoding encoding{picture, isOpaque(picture), command};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &encoding, leave, ignoreWarning);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    if (info == nullptr) {
        png_destroy_write_struct(&png, nullptr);
        throw Error("encodePng", "libpng must be able to start", "out of memory or another version than built with");
    }
    png_set_write_fn(png, &encoding, takeBytes, nothingToFlush);
    const bool written = writeImage(png, info, encoding);
    png_destroy_write_struct(&png, &info);
    if (!written) throw Error("encodePng", "libpng must be able to encode it", encoding.message.data());
    return std::move(encoding.bytes);
}

void writePng(const std::filesystem::path& path, const Picture& picture, const std::string& command) {
    writeFileAtomically(path, encodePng(picture, command));
}

std::string commandInPng(const std::filesystem::path& path) {
    const std::vector<std::byte> bytes = readFile(path, std::size_t{1} << 30U);
    const std::string keyword = commandKeyword + std::string(1, '\0');
    for (const std::span<const std::byte> chunk : checkPng(bytes, path.string()).texts) {
        std::string_view text(reinterpret_cast<const char*>(chunk.data()), chunk.size());
        if (!text.starts_with(keyword)) continue;
        text.remove_prefix(keyword.size());
        // Of an iTXt two bytes for its compression, none here, and two empty words, its language and its keyword there
        if (text.starts_with(std::string_view("\0\0\0\0", 4))) text.remove_prefix(4);
        return std::string(text);
    }
    return "";
}

}  // namespace mv
