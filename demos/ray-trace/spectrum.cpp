#include "spectrum.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "mv/error.h"
#include "mv/math/color.h"

namespace mv {
namespace {

// The sensors' answers to one wavelength, as linear red, green and blue. Between the table's entries they are straight.
vec3 seen(double nanometres) {
    const auto table = colorMatching();
    const double place = std::clamp((nanometres - table.front().nanometres) / 5, 0.0, double(table.size() - 1));
    const auto below = std::min(static_cast<std::size_t>(place), table.size() - 2);
    return linearFromXyz() * glm::mix(table[below].xyz, table[below + 1].xyz, place - double(below));
}

// What of the scene's red, green and blue is of that wavelength.
vec3 given(double nanometres) {
    const double red = std::clamp((nanometres - 560) / 40, 0.0, 1.0),
                 blue = std::clamp((510 - nanometres) / 40, 0.0, 1.0);
    return {red, 1 - red - blue, blue};
}

}  // namespace

double indexAt(double nanometres, double index, double abbe) {
    constexpr double d = 587.5618, f = 486.1327, c = 656.2725;
    const double b = (index - 1) / abbe / (1 / (f * f) - 1 / (c * c));
    return index + b * (1 / (nanometres * nanometres) - 1 / (d * d));
}

std::vector<TracedWavelength> tracedWavelengths(int count) {
    if (count < 3 || count > 256) throw Error("wavelengths", "must be from 3 to 256", std::to_string(count));
    // The wavelengths of which the screen's primaries have the hue: where the line from white through them meets the spectrum
    std::vector<double> at{611.4, 549.1, 464.3};
    if (count > 3) {
        at.clear();
        for (int i = 0; i < count; ++i) at.push_back(400 + 300 * (i + 0.5) / count);
    }
    mat3 sum(0);
    std::vector<TracedWavelength> all;
    for (const double nanometres : at) {
        const mat3 share = glm::outerProduct(seen(nanometres), given(nanometres));
        sum += share;
        all.push_back({nanometres, share});
    }
    // The sensors are calibrated: what is given as white is seen as white, and red as red
    for (TracedWavelength& one : all) one.share = glm::inverse(sum) * one.share;
    return all;
}

}  // namespace mv
