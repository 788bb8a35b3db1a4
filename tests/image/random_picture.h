// Pictures in which any byte can be any.
#pragma once
#include <random>

#include "mv/image/picture.h"

namespace mv::test {

// The same picture for the same seed.
inline Picture randomPicture(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    Picture picture(width, height);
    for (std::uint8_t& value : picture.rgba) value = static_cast<std::uint8_t>(random() & 255U);
    return picture;
}

}  // namespace mv::test
