// A camera's note of how it was held, and the picture turned by it.
#pragma once
#include <cstddef>
#include <span>

#include "mv/image/picture.h"

namespace mv {

// The orientation (tag 0x0112 of the first directory, 1..8) of EXIF data as they begin with "II" or "MM"; 1, which is
// upright, where there is none, or none that is one. Any bytes may be given.
// The one number of EXIF that a texture needs: libexif, which reads all of them, would be a library for its sake.
[[nodiscard]] int exifOrientation(std::span<const std::byte> exif);

// The picture turned and mirrored as that orientation says: 2 mirrored left to right, 3 turned by 180 degrees, 4 mirrored top
// to bottom, 5 rows and columns exchanged, 6 turned by 90 degrees clockwise, 7 exchanged about the other diagonal, 8 turned
// by 90 degrees counter-clockwise; 1 as it is. Source: EXIF 2.32, 4.6.4. Error: an orientation outside 1..8.
[[nodiscard]] Picture upright(Picture picture, int orientation);

}  // namespace mv
