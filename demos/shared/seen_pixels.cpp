#include "shared/seen_pixels.h"

#include <cmath>
#include <cstddef>

#include "mv/error.h"

namespace mv {

std::vector<int> regionsOfSeen(const std::vector<double>& values) {
    std::vector<int> regions;
    for (const double value : values) regions.push_back(value < 0 ? -1 : 0);
    return regions;
}

std::optional<double> rmsBetween(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size()) throw Error("rmsBetween", "must have as many pixels twice", numberText(double(b.size())));
    double squares = 0, count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] < 0 || b[i] < 0) continue;
        squares += (a[i] - b[i]) * (a[i] - b[i]);
        ++count;
    }
    if (count == 0) return {};
    return std::sqrt(squares / count);
}

std::vector<double> rmsOfShown(const std::vector<float>& shown, const std::vector<double>& exact) {
    const auto rms = rmsBetween({shown.begin(), shown.end()}, exact);
    return rms ? std::vector{*rms} : std::vector<double>();
}

}  // namespace mv
