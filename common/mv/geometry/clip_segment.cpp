#include "mv/geometry/clip_segment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mv/error.h"
#include "mv/math/exact_sum.h"
#include "mv/math/require.h"

namespace mv {
namespace {

int exactOrientation(const vec2& a, const vec2& b, const vec2& c) {
    ExactSum<12> sum;
    sum.addProduct(a.x, b.y);
    sum.addProduct(-a.y, b.x);
    sum.addProduct(b.x, c.y);
    sum.addProduct(-b.y, c.x);
    sum.addProduct(c.x, a.y);
    sum.addProduct(-c.y, a.x);
    return sum.sign();
}

// Which sides of the window a point is beyond, for each axis: -1 below, 1 above, 0 within.
struct Beyond {
    int x, y;
    bool inside() const { return x == 0 && y == 0; }
};
int beyond(double value, double low, double high) { return value < low ? -1 : value > high ? 1 : 0; }

// The other coordinate of the segment's point whose coordinate on `axis` is `value`: from the nearer end, so that what is
// rounded is the smaller part.
double alongTo(const Segment& segment, int axis, double value) {
    const int other = 1 - axis;
    vec2 from = segment.a, to = segment.b;
    const double ofA = std::abs(value - from[axis]), ofB = std::abs(value - to[axis]);
    if (ofB < ofA || (ofB == ofA && to[axis] < from[axis])) std::swap(from, to);
    return from[other] + (to[other] - from[other]) * ((value - from[axis]) / (to[axis] - from[axis]));
}

// The entry of a segment that meets the window, from an end beyond it.
vec2 entry(const Segment& segment, const Beyond& end, const Box& window) {
    const vec2 side(end.x < 0 ? window.low.x : window.high.x, end.y < 0 ? window.low.y : window.high.y);
    int axis = end.x != 0 ? 0 : 1;
    if (end.x != 0 && end.y != 0) {
        // The segment crosses both sides' lines, and enters at the later one; through the corner it crosses both at
        // once.
        const int turn = orientation(segment.a, segment.b, side);
        if (turn == 0) return side;
        const bool sameSigns = (segment.b.x > segment.a.x) == (segment.b.y > segment.a.y);
        axis = (turn < 0) == sameSigns ? 0 : 1;
    }
    const int other = 1 - axis;
    vec2 point = side;
    point[other] = std::clamp(alongTo(segment, axis, side[axis]), window.low[other], window.high[other]);
    return point;
}

}  // namespace

int orientation(const vec2& a, const vec2& b, const vec2& c) {
    const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x), turn = left - right;
    // The roundings of two differences, two products and their difference
    const double bound = (3 + 16 * 0x1p-53) * 0x1p-53 * (std::abs(left) + std::abs(right));
    if (std::abs(turn) > bound) return turn > 0 ? 1 : -1;
    return exactOrientation(a, b, c);
}

std::optional<Segment> clipSegment(const Segment& segment, const Box& window) {
    const auto& [a, b] = segment;
    for (const vec2& point : {a, b, window.low, window.high}) requireFinite("clipSegment", "each point", point);
    if (!(window.low.x <= window.high.x && window.low.y <= window.high.y)) {
        throw Error("clipSegment", "the window's low corner must not be beyond its high one",
                    numberText(window.low.x) + ", " + numberText(window.low.y));
    }
    const auto beyondWindow = [&](const vec2& point) {
        return Beyond{beyond(point.x, window.low.x, window.high.x), beyond(point.y, window.low.y, window.high.y)};
    };
    const Beyond ofA = beyondWindow(a), ofB = beyondWindow(b);
    if (ofA.inside() && ofB.inside()) return segment;
    if (ofA.x * ofB.x > 0 || ofA.y * ofB.y > 0) return {};
    // No edge of the window has it wholly on its outer side; so it meets the window unless its own line leaves all four
    // corners on one side (the theorem of the separating axis).
    int left = 0, right = 0;
    for (const vec2& corner :
         {window.low, window.high, vec2(window.low.x, window.high.y), vec2(window.high.x, window.low.y)}) {
        const int turn = orientation(a, b, corner);
        left += turn > 0 ? 1 : 0;
        right += turn < 0 ? 1 : 0;
    }
    if (left == 4 || right == 4) return {};
    return Segment{ofA.inside() ? a : entry(segment, ofA, window), ofB.inside() ? b : entry({b, a}, ofB, window)};
}

}  // namespace mv
