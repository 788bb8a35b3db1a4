#include "image/jpeg_files.h"

#include <cstdio>
#include <cstdlib>
#include <string_view>

// After <cstdio>, which it needs
#include <jpeglib.h>

namespace mv {

std::vector<std::byte> sampledJpegFile(const Picture& picture, const Sampling& sampling,
                                       const std::vector<std::byte>& exif) {
    jpeg_compress_struct encoder{};
    jpeg_error_mgr errors{};
    encoder.err = jpeg_std_error(&errors);  // which ends the program
    jpeg_create_compress(&encoder);
    unsigned char* made = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&encoder, &made, &size);
    encoder.image_width = static_cast<JDIMENSION>(picture.width);
    encoder.image_height = static_cast<JDIMENSION>(picture.height);
    encoder.input_components = 4;
    encoder.in_color_space = JCS_EXT_RGBA;
    jpeg_set_defaults(&encoder);
    jpeg_set_quality(&encoder, 95, TRUE);
    for (std::size_t i = 0; i < 3; ++i) {
        encoder.comp_info[i].h_samp_factor = sampling[i][0];
        encoder.comp_info[i].v_samp_factor = sampling[i][1];
    }
    jpeg_start_compress(&encoder, TRUE);
    if (!exif.empty()) {
        constexpr std::string_view begins("Exif\0\0", 6);
        std::vector<JOCTET> note(begins.begin(), begins.end());
        for (const std::byte byte : exif) note.push_back(std::to_integer<JOCTET>(byte));
        jpeg_write_marker(&encoder, JPEG_APP0 + 1, note.data(), static_cast<unsigned>(note.size()));
    }
    for (int y = 0; y < picture.height; ++y) {
        auto* row = const_cast<JSAMPROW>(&picture.rgba[4 * pixelIndex(0, y, picture.width)]);  // which it reads only
        jpeg_write_scanlines(&encoder, &row, 1);
    }
    jpeg_finish_compress(&encoder);
    jpeg_destroy_compress(&encoder);
    const auto* bytes = reinterpret_cast<const std::byte*>(made);
    std::vector<std::byte> file(bytes, bytes + size);
    std::free(made);
    return file;
}

std::vector<std::byte> exifOf(int orientation, bool largeEndFirst) {
    std::vector<std::byte> exif(2, largeEndFirst ? std::byte{'M'} : std::byte{'I'});
    const auto append = [&](unsigned number, unsigned length) {
        for (unsigned i = 0; i < length; ++i)
            exif.push_back(static_cast<std::byte>(number >> 8U * (largeEndFirst ? length - 1 - i : i)));
    };
    append(42, 2);
    append(8, 4);  // where the directory is
    append(2, 2);  // entries
    const auto entry = [&](unsigned tag, unsigned kind, unsigned value) {
        append(tag, 2);
        append(kind, 2);
        append(1, 4);
        append(value, kind == 3 ? 2 : 4);
        if (kind == 3) append(0, 2);
    };
    entry(0x0100, 4, 640);  // the width, before it
    entry(0x0112, 3, static_cast<unsigned>(orientation));
    append(0, 4);
    return exif;
}

}  // namespace mv
