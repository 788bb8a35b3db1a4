// X51: mipmaps of odd sizes, and of a single row of texels.
#include <algorithm>
#include <cmath>
#include <vector>

#include "extremes/row.h"
#include "mv/image/mipmap.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

FloatPicture noise(int width, int height) {
    FloatPicture picture(width, height, 1);
    Random random(51);
    for (float& value : picture.values) value = static_cast<float>(random.number(0, 1));
    return picture;
}

double mean(const FloatPicture& picture) {
    double sum = 0;
    for (const float value : picture.values) sum += double(value);
    return sum / double(picture.values.size());
}

// The usual form: each texel the mean of 2 x 2. The last texel of an odd side falls out; of a side of 1 there is no second,
// and the size becomes 0.
FloatPicture halvedByFours(const FloatPicture& picture) {
    FloatPicture half;
    half.width = picture.width / 2;
    half.height = picture.height / 2;
    half.channels = 1;
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            float sum = 0;
            for (const int j : {0, 1}) {
                for (const int i : {0, 1}) sum += picture.values[pixelIndex(2 * x + i, 2 * y + j, picture.width)];
            }
            half.values.push_back(sum / 4);
        }
    }
    return half;
}

// The change of the mean down to the last level.
template <class Halve>
double changeOfMean(FloatPicture picture, int levels, Halve halve) {
    const double first = mean(picture);
    for (int level = 1; level < levels; ++level) picture = halve(picture);
    return std::abs(mean(picture) - first);  // 0/0 where no texel is left
}

[[maybe_unused]] const bool x51odd = addRow([] {
    const FloatPicture picture = noise(27, 13);
    constexpr int levels = 3;  // 27 x 13, 13 x 6, 6 x 3
    return Row{.id = "X51 odd mipmaps",
               .input = "noise of 27 x 13 texels",
               .measured = "change of the mean, of 0..1",
               .naive = "means of 2 x 2",
               .naiveError = changeOfMean(picture, levels, halvedByFours),
               .ours = "halved: parts of texels count as parts",
               .ourError = changeOfMean(picture, levels, halved),
               .tolerance = 3e-7,
               .reason = "each of the levels rounds to float once, by 6e-8 at most"};
});

[[maybe_unused]] const bool x51row = addRow([] {
    const FloatPicture picture = noise(16, 1);
    return Row{.id = "X51 row",
               .input = "noise of 16 x 1 texels, down to 1 x 1",
               .measured = "change of the mean, of 0..1",
               .naive = "means of 2 x 2",
               .naiveError = changeOfMean(picture, 5, halvedByFours),
               .ours = "halved: sides of max(1, n / 2)",
               .ourError = changeOfMean(picture, 5, halved),
               .tolerance = 3e-7,
               .reason = "each of the levels rounds to float once, by 6e-8 at most"};
});

}  // namespace
