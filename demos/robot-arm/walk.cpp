#include "walk.h"

#include <cmath>

#include "mv/motion/two_link.h"

namespace mv {
namespace {

// Knees bend forward, clockwise as seen from the near side.
TwoLinkAngles pose(const Walk& walk, int side, double cycles) {
    return twoLinkAngles(walk.upper, walk.lower, walk.foot(side, cycles).position - walk.hip(cycles)).angles[1];
}

double between(double from, double to, double part) { return from + part * std::remainder(to - from, 360); }

}  // namespace

vec2 Walk::hip(double cycles) const { return vec2(0.9 * cycles, 0.88) * (upper + lower); }

FootTarget Walk::foot(int side, double cycles) const {
    const double leg = upper + lower;
    return footTarget({.stride = 0.9 * leg, .lift = 0.1 * leg, .phase = side == 0 ? 0 : 0.5}, cycles);
}

std::vector<double> Walk::played(double cycles) const {
    const double last = std::floor(cycles * poses), part = cycles * poses - last;
    std::vector<double> degrees{0};  // of the body, which does not turn
    for (const int side : {0, 1}) {
        const TwoLinkAngles from = pose(*this, side, last / poses), to = pose(*this, side, (last + 1) / poses);
        degrees.push_back(between(from.shoulder, to.shoulder, part));
        degrees.push_back(between(from.elbow, to.elbow, part));
    }
    return degrees;
}

}  // namespace mv
