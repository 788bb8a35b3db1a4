#include "mv/motion/gait.h"

#include <cmath>
#include <string>
#include <string_view>

#include "mv/error.h"
#include "mv/math/require.h"

namespace mv {
namespace {

constexpr std::string_view gaitSubject = "footTarget";

void requireSize(std::string_view name, double value, double most) {
    requireFinite(gaitSubject, name, value);
    if (std::abs(value) <= most) return;
    throw Error(gaitSubject, std::string(name).append(" must be at most ").append(numberText(most)), numberText(value));
}

}  // namespace

FootTarget footTarget(const Gait& gait, double cycles) {
    requireSize("stride", gait.stride, 1e100);
    requireSize("lift", gait.lift, 1e100);
    requireSize("phase", gait.phase, 1e12);
    requireSize("cycles", cycles, 1e12);
    if (!(gait.stance > 0 && gait.stance < 1)) {
        throw Error(gaitSubject, "stance must be above 0 and below 1", numberText(gait.stance));
    }
    const double time = cycles + gait.phase, step = std::floor(time), part = time - step;
    // In the middle of this step's stance the body is here. Nothing in it depends on the part.
    const double standing = gait.stride * (step + (gait.stance / 2 - gait.phase));
    if (part < gait.stance) return {{standing, 0}, true};

    const double s = (part - gait.stance) / (1 - gait.stance), rest = 1 - s;
    const double along = s * s * s * (10 + s * (6 * s - 15));
    return {{standing + gait.stride * along, gait.lift * (64 * (s * s * s) * (rest * rest * rest))}, false};
}

}  // namespace mv
