// A picture's mipmaps: the same picture in half as many texels a side, and so on to a single one.
#pragma once
#include <vector>

#include "mv/image/picture.h"

namespace mv {

// In max(1, n / 2) texels for each side of n, rounded down as GL does. Each result is the mean of exactly the area that
// it covers, parts of texels counted as parts, so that the mean of the whole is kept for odd sides, too. Averages are
// of the numbers as they are: for colours let them be linear light. Sums are in double, results rounded once.
[[nodiscard]] FloatPicture halved(const FloatPicture& picture);

// The picture itself, and its halves down to 1 x 1: the levels of a texture.
[[nodiscard]] std::vector<FloatPicture> mipmaps(const FloatPicture& picture);

}  // namespace mv
