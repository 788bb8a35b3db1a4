// Pictures as PNG files.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "mv/image/picture.h"

namespace mv {

// The picture as the bytes of a PNG file; decodePicture gives back exactly the same picture.
// Without alpha channel if every pixel is opaque. The same picture gives the same bytes (there is no date in them),
// as long as the zlib library stays the same.
// Compressed at level 1 after the SUB filter (each byte minus that of the pixel to the left): in a headless frame the
// encoder is the cost, and this is several times faster than the usual settings for files hardly larger.
// `command`: the command line that makes it, which the file then tells (chunk tEXt, or iTXt where it is not ASCII, with the
// keyword "mvgl"); "": it tells none.
// Error if the picture has no pixels, or not the number of bytes that its sides ask for.
[[nodiscard]] std::vector<std::byte> encodePng(const Picture& picture, const std::string& command = "");

// encodePng, then writeFileAtomically with its promises and errors.
void writePng(const std::filesystem::path& path, const Picture& picture, const std::string& command = "");

// The command line that such a file tells; "" where it tells none. Error: no undamaged PNG file, or one that cannot be read.
[[nodiscard]] std::string commandInPng(const std::filesystem::path& path);

}  // namespace mv
