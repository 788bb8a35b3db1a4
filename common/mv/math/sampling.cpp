#include "mv/math/sampling.h"

#include <random>

#include "mv/math/require.h"

namespace mv {

std::vector<vec2> jitteredSquare(int side, std::uint32_t seed) {
    requireRange("jitteredSquare", "side", side, 1, 1024);
    std::mt19937 generator(seed);
    // Not std::uniform_real_distribution, whose numbers are each library's own.
    const auto random = [&] { return double(generator()) / 4294967296.0; };
    std::vector<vec2> points;
    points.reserve(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const double x = (column + random()) / side;  // one call after the other: the order of arguments is free
            const double y = (row + random()) / side;
            points.emplace_back(x, y);
        }
    }
    return points;
}

}  // namespace mv
