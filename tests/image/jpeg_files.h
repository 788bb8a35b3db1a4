// JPEG files of any sampling, and with EXIF notes, as no encoder of a camera or a page would write all of them.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "mv/image/picture.h"

namespace mv {

// How often luma, blue and red are sampled in a block, across and down: {{2, 2}, {1, 1}, {1, 1}} is 4:2:0.
using Sampling = std::array<std::array<int, 2>, 3>;

// The picture at quality 95; `exif`, where there are any, as its note.
std::vector<std::byte> sampledJpegFile(const Picture& picture, const Sampling& sampling,
                                       const std::vector<std::byte>& exif = {});
// EXIF data that say how the camera was held (1..8), in either order of bytes.
std::vector<std::byte> exifOf(int orientation, bool largeEndFirst);

}  // namespace mv
