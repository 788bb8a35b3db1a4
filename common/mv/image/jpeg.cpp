#include "mv/image/jpeg.h"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <string>
#include <utility>

#include "mv/error.h"
#include "mv/image/exif.h"
#include "mv/image/load.h"
// After <cstdio>, which they need
#include <jerror.h>
#include <jpeglib.h>

#ifndef JCS_EXTENSIONS
#error "mvgl: libjpeg must be libjpeg-turbo (package libjpeg-dev of Debian), which gives four bytes a pixel"
#endif

namespace mv {
namespace {

constexpr const char* damaged = "must be an undamaged JPEG file; save or fetch it again";

// libjpeg's words when it gives up, and the place that it leaves for by longjmp, which runs no destructors.
struct Trouble : jpeg_error_mgr {
    std::jmp_buf leave{};
    std::array<char, JMSG_LENGTH_MAX> message{};
};

[[noreturn]] void giveUp(j_common_ptr decoder) {
    auto* trouble = static_cast<Trouble*>(decoder->err);
    trouble->format_message(decoder, trouble->message.data());
    std::longjmp(trouble->leave, 1);
}

// A file of which libjpeg only warns (a negative level), and goes on, is damaged.
void giveUpWhereItWarns(j_common_ptr decoder, int level) {
    if (level < 0) giveUp(decoder);
}

// No file of a few bytes a scan takes hours. libjpeg-turbo's own limit in TurboJPEG is the same.
void limitScans(j_common_ptr decoder) {
    constexpr int most = 500;
    auto* decompress = reinterpret_cast<j_decompress_ptr>(decoder);
    if (decompress->input_scan_number <= most) return;
    std::snprintf(static_cast<Trouble*>(decoder->err)->message.data(), JMSG_LENGTH_MAX, "more than %d scans", most);
    decoder->err->msg_code = 0;
    std::longjmp(static_cast<Trouble*>(decoder->err)->leave, 1);
}

// Whether libjpeg stopped because the file is of a kind it does not decode, however whole the file is.
bool isUnsupported(const jpeg_error_mgr& trouble) {
    switch (trouble.msg_code) {
        case JERR_ARITH_NOTIMPL:
        case JERR_BAD_J_COLORSPACE:
        case JERR_BAD_PRECISION:
        case JERR_CCIR601_NOTIMPL:
        case JERR_COMPONENT_COUNT:
        case JERR_CONVERSION_NOTIMPL:
        case JERR_EMPTY_IMAGE:  // of no rows: they would be told after the picture
        case JERR_FRACT_SAMPLE_NOTIMPL:
        case JERR_NOTIMPL:
        case JERR_NOT_COMPILED:
        case JERR_SOF_UNSUPPORTED:
            return true;
        case JERR_UNKNOWN_MARKER: {  // of hierarchical files (DHP, EXP) and of JPEG-LS
            const int marker = trouble.msg_parm.i[0];
            return marker == 0xDE || marker == 0xDF || marker == 0xF7;
        }
        default:
            return false;
    }
}

// One decoding. The object lives outside the functions that libjpeg may leave.
struct Decoding {
    jpeg_decompress_struct decoder{};
    Trouble trouble;
    jpeg_progress_mgr progress{};

    Decoding() {
        decoder.err = jpeg_std_error(&trouble);
        trouble.error_exit = giveUp;
        trouble.emit_message = giveUpWhereItWarns;
        progress.progress_monitor = limitScans;
    }
    ~Decoding() { jpeg_destroy_decompress(&decoder); }
    Decoding(const Decoding&) = delete;
    Decoding& operator=(const Decoding&) = delete;
};

enum class Read { picture, tables, failed };

// Plain values alone live in here and in the next one: longjmp would skip the destructor of anything else.
Read readHeader(Decoding& decoding, const unsigned char* bytes, unsigned long size) {
    if (setjmp(decoding.trouble.leave) != 0) return Read::failed;
    jpeg_create_decompress(&decoding.decoder);
    decoding.decoder.progress = &decoding.progress;
    jpeg_save_markers(&decoding.decoder, JPEG_APP0 + 1, 0xFFFF);
    jpeg_mem_src(&decoding.decoder, bytes, size);
    return jpeg_read_header(&decoding.decoder, FALSE) == JPEG_HEADER_OK ? Read::picture : Read::tables;
}

bool readPixels(Decoding& decoding, unsigned char* rgba) {
    if (setjmp(decoding.trouble.leave) != 0) return false;
    jpeg_decompress_struct& decoder = decoding.decoder;
    decoder.out_color_space = JCS_EXT_RGBA;
    decoder.dct_method = JDCT_ISLOW;  // exact arithmetic, the same on every processor
    jpeg_start_decompress(&decoder);
    while (decoder.output_scanline < decoder.output_height) {
        JSAMPROW row = rgba + std::size_t{4} * decoder.output_width * decoder.output_scanline;
        jpeg_read_scanlines(&decoder, &row, 1);
    }
    jpeg_finish_decompress(&decoder);
    return true;
}

int orientationOf(const jpeg_decompress_struct& decoder) {
    constexpr std::string_view begins("Exif\0\0", 6);
    for (const auto* marker = decoder.marker_list; marker != nullptr; marker = marker->next) {
        const std::span data(reinterpret_cast<const std::byte*>(marker->data), marker->data_length);
        if (data.size() >= begins.size() && std::memcmp(data.data(), begins.data(), begins.size()) == 0)
            return exifOrientation(data.subspan(begins.size()));
    }
    return 1;
}

}  // namespace

bool startsAsJpeg(std::span<const std::byte> bytes) {
    return bytes.size() >= 3 && bytes[0] == std::byte{0xFF} && bytes[1] == std::byte{0xD8} &&
           bytes[2] == std::byte{0xFF};
}

Picture decodeJpeg(std::span<const std::byte> bytes, std::string_view name) {
    Decoding decoding;
    const auto refusal = [&] {
        const char* rule =
            isUnsupported(decoding.trouble)
                ? "must be a kind of JPEG file that libjpeg decodes: baseline or progressive, 8 bits, grey "
                  "or RGB; save it again as that or as PNG"
                : damaged;
        return Error(name, rule, decoding.trouble.message.data());
    };

    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    const Read read = readHeader(decoding, data, static_cast<unsigned long>(bytes.size()));
    if (read == Read::failed) throw refusal();
    if (read == Read::tables) throw Error(name, damaged, "it holds no picture");
    const jpeg_decompress_struct& decoder = decoding.decoder;
    checkLoadedSides(decoder.image_width, decoder.image_height, name);
    if (decoder.jpeg_color_space == JCS_CMYK || decoder.jpeg_color_space == JCS_YCCK)
        throw Error(name, "must be a picture in grey or RGB; save it again as RGB", "it is in CMYK");

    const int orientation = orientationOf(decoder);  // which readPixels forgets at its end
    Picture picture(static_cast<int>(decoder.image_width), static_cast<int>(decoder.image_height));
    if (!readPixels(decoding, picture.rgba.data())) throw refusal();
    return upright(std::move(picture), orientation);
}

}  // namespace mv
