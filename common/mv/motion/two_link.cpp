#include "mv/motion/two_link.h"

#include <algorithm>
#include <cmath>

#include "mv/error.h"
#include "mv/math/require.h"

namespace mv {
namespace {

// Lengths and coordinates up to this size have sums that are numbers.
constexpr double largestLength = 1e300;

void requireLength(std::string_view subject, std::string_view name, double length) {
    if (length >= 0 && length <= largestLength) return;  // false for NaN
    throw Error(subject, std::string(name).append(" must be 0 to 1e300"), numberText(length));
}

// How the target's distance compares with where the links end. Each is a difference of which one step is exact where it
// is near 0 (Sterbenz), so that its sign is right.
struct Gaps {
    double toReach;  // l1 + l2 - distance
    double toHole;   // distance - |l1 - l2|
};
Gaps gapsOf(double l1, double l2, double distance) {
    const double longer = std::max(l1, l2), shorter = std::min(l1, l2);
    const double toReach = shorter - (distance - longer);
    const double toHole = 2 * shorter >= longer ? distance - (longer - shorter) : shorter - (longer - distance);
    return {toReach, toHole};
}

// The two angles of a triangle that exists, in radians from 0 to pi: how far the elbow is bent, and how far the first
// link is off the way to the target. Each is twice the atan of a quotient of roots of sums and differences of the
// sides.
struct Bend {
    double elbow, shoulder;
};
Bend bendOf(double l1, double l2, double distance, const Gaps& gaps) {
    // Separate roots, whose products neither overflow nor vanish. Only the gaps are differences of near numbers.
    const double around = std::sqrt(l1 + l2 + distance), open = std::sqrt(gaps.toReach);
    const double hole = std::sqrt(gaps.toHole), other = std::sqrt(std::abs(l1 - l2) + distance);
    const double byFirst = l1 >= l2 ? other : hole;   // root of distance + l1 - l2
    const double bySecond = l1 >= l2 ? hole : other;  // root of distance - l1 + l2
    return {2 * std::atan2(around * open, byFirst * bySecond), 2 * std::atan2(bySecond * open, byFirst * around)};
}

// Whole turns taken off, which is exact.
double withinHalfTurn(double degrees) { return std::remainder(degrees, 360.0); }

}  // namespace

vec2 twoLinkEnd(double l1, double l2, const TwoLinkAngles& angles) {
    constexpr std::string_view subject = "twoLinkEnd";
    requireLength(subject, "l1", l1);
    requireLength(subject, "l2", l2);
    requireFinite(subject, "the shoulder's angle", angles.shoulder);
    requireFinite(subject, "the elbow's angle", angles.elbow);
    const double first = withinHalfTurn(angles.shoulder);
    const double a = radians(first), b = radians(withinHalfTurn(first + withinHalfTurn(angles.elbow)));
    return {l1 * std::cos(a) + l2 * std::cos(b), l1 * std::sin(a) + l2 * std::sin(b)};
}

TwoLinkAnswer twoLinkAngles(double l1, double l2, const vec2& target) {
    constexpr std::string_view subject = "twoLinkAngles";
    requireLength(subject, "l1", l1);
    requireLength(subject, "l2", l2);
    requireFinite(subject, "the target", target);
    const double distance = std::hypot(target.x, target.y);
    if (distance > largestLength) throw Error(subject, "the target must lie within 1e300", vectorText(target));

    const auto [toReach, toHole] = gapsOf(l1, l2, distance);
    const double direction = distance == 0 ? 0 : std::atan2(target.y, target.x);
    // A folded arm points to where its longer link does.
    const TwoLinkAngles straight{degrees(direction), 0};
    const TwoLinkAngles folded{l1 >= l2 ? degrees(direction) : withinHalfTurn(degrees(direction) + 180), 180};
    if (toReach < 0) {
        return {
            TwoLinkSolutions::none, "the target is farther away than both links reach", {straight, straight}, -toReach};
    }
    if (toHole < 0) {
        return {
            TwoLinkSolutions::none, "the target is nearer than the difference of the links", {folded, folded}, -toHole};
    }
    if (distance == 0) {  // and the links are equal
        return {TwoLinkSolutions::infinitelyMany,
                "the links are equal and the target is at the root: the folded arm may point anywhere",
                {TwoLinkAngles{0, 180}, TwoLinkAngles{0, 180}}};
    }
    if (l2 == 0 || l1 == 0) {
        const TwoLinkAngles any = l2 == 0 ? straight : TwoLinkAngles{0, degrees(direction)};
        return {TwoLinkSolutions::infinitelyMany, "a link has no length, and may point anywhere", {any, any}};
    }
    if (toReach == 0) {
        return {TwoLinkSolutions::one, "the arm is stretched straight", {straight, straight}};
    }
    if (toHole == 0) {
        return {TwoLinkSolutions::one, "the arm is folded back onto itself", {folded, folded}};
    }
    const Bend bend = bendOf(l1, l2, distance, {toReach, toHole});
    const double elbow = degrees(bend.elbow);
    return {TwoLinkSolutions::two,
            "the elbow may bend to either side",
            {TwoLinkAngles{withinHalfTurn(degrees(direction - bend.shoulder)), elbow},
             TwoLinkAngles{withinHalfTurn(degrees(direction + bend.shoulder)), -elbow}}};
}

}  // namespace mv
