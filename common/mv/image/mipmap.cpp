#include "mv/image/mipmap.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

namespace mv {
namespace {

// The texels, of n, that the i-th of max(1, n / 2) covers, and how much of each in units of 1 / max(1, n / 2): whole
// numbers, whose sum is n.
struct Cover {
    int first = 0, count = 0;
    std::array<double, 4> weights{};  // 2 where n is even, 3 where it is odd
};

Cover coverOf(int i, int from) {
    const int to = std::max(1, from / 2);
    const std::int64_t begin = std::int64_t{i} * from, end = begin + from;
    Cover cover{static_cast<int>(begin / to)};
    for (std::int64_t at = cover.first; at * to < end; ++at) {
        const std::int64_t overlap = std::min(end, (at + 1) * to) - std::max(begin, at * to);
        cover.weights.at(static_cast<std::size_t>(cover.count++)) = double(overlap);
    }
    return cover;
}

}  // namespace

FloatPicture halved(const FloatPicture& picture) {
    checkPicture(picture, "halved");
    FloatPicture half(std::max(1, picture.width / 2), std::max(1, picture.height / 2), picture.channels);
    const auto channels = static_cast<std::size_t>(picture.channels);
    const double whole = double(picture.width) * picture.height;
    for (int y = 0; y < half.height; ++y) {
        const Cover rows = coverOf(y, picture.height);
        for (int x = 0; x < half.width; ++x) {
            const Cover columns = coverOf(x, picture.width);
            std::array<double, 4> sums{};
            for (int j = 0; j < rows.count; ++j) {
                for (int i = 0; i < columns.count; ++i) {
                    const double weight =
                        rows.weights.at(static_cast<std::size_t>(j)) * columns.weights.at(static_cast<std::size_t>(i));
                    const std::size_t at = channels * pixelIndex(columns.first + i, rows.first + j, picture.width);
                    for (std::size_t c = 0; c < channels; ++c) sums.at(c) += weight * double(picture.values[at + c]);
                }
            }
            const std::size_t at = channels * pixelIndex(x, y, half.width);
            for (std::size_t c = 0; c < channels; ++c) half.values[at + c] = static_cast<float>(sums.at(c) / whole);
        }
    }
    return half;
}

std::vector<FloatPicture> mipmaps(const FloatPicture& picture) {
    checkPicture(picture, "mipmaps");
    std::vector<FloatPicture> levels{picture};
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(halved(levels.back()));
    return levels;
}

}  // namespace mv
