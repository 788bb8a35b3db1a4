#include "mv/geometry/clip_segment.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <optional>
#include <string>

#include "../math/support.h"

using namespace mv;
using namespace mv::test;

namespace {

using Fraction = boost::multiprecision::cpp_rational;

int exactSign(const vec2& a, const vec2& b, const vec2& c) {
    const Fraction turn = (Fraction(b.x) - Fraction(a.x)) * (Fraction(c.y) - Fraction(a.y)) -
                          (Fraction(b.y) - Fraction(a.y)) * (Fraction(c.x) - Fraction(a.x));
    return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

}  // namespace

TEST(Orientation, HasTheExactSignWhereCoordinatesAreNeighbours) {
    // c steps through the neighbours of a place on the line: Kettner's classroom example, at several sizes
    int zero = 0;
    for (const double size : {1e-90, 1e-3, 1.0, 1e8, 1e90}) {
        const vec2 a = size * vec2(12, 12), b = size * vec2(24, 24);
        vec2 c = size * vec2(0.5, 0.5);
        for (int i = 0; i < 30; ++i, c.x = std::nextafter(c.x, HUGE_VAL)) {
            vec2 at = c;
            for (int k = 0; k < 30; ++k, at.y = std::nextafter(at.y, HUGE_VAL)) {
                const int sign = orientation(a, b, at);
                ASSERT_EQ(sign, exactSign(a, b, at));
                ASSERT_EQ(orientation(b, a, at), -sign);
                ASSERT_EQ(orientation(b, at, a), sign);
                zero += sign == 0 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(zero, 50);
    Random random(3);
    for (int i = 0; i < 1500; ++i) {
        const auto point = [&] {
            const double x = random.sign() * random.logarithmic(1e-100, 1e100);
            return vec2(x, random.sign() * random.logarithmic(1e-100, 1e100));
        };
        const vec2 a = point(), b = point(), c = point();
        ASSERT_EQ(orientation(a, b, c), exactSign(a, b, c));
    }
}

TEST(ClipSegment, KeepsWhatIsInsideAndItsDirection) {
    const Box box{{-1, -2}, {3, 2}};
    const auto cut = [&](double ax, double ay, double bx, double by) { return clipSegment({{ax, ay}, {bx, by}}, box); };
    EXPECT_EQ(cut(0, 0, 1, 1), (Segment{{0, 0}, {1, 1}}));
    EXPECT_EQ(cut(-5, 0, 5, 0), (Segment{{-1, 0}, {3, 0}}));
    EXPECT_EQ(cut(5, 0, -5, 0), (Segment{{3, 0}, {-1, 0}}));
    EXPECT_EQ(cut(0, 0, 0, 9), (Segment{{0, 0}, {0, 2}}));
    EXPECT_EQ(cut(-2, 2, 4, 2), (Segment{{-1, 2}, {3, 2}})) << "along a side";
    EXPECT_EQ(cut(2, 3, 4, 1), (Segment{{3, 2}, {3, 2}})) << "at a corner";
    EXPECT_EQ(cut(3, 0, 3, 0), (Segment{{3, 0}, {3, 0}})) << "a point on a side";
    EXPECT_EQ(cut(4, 4, 4, 4), std::nullopt);
    EXPECT_EQ(cut(2, 3.001, 4, 1.001), std::nullopt) << "beside a corner";
    EXPECT_EQ(cut(-5, 3, 5, 3), std::nullopt);
    EXPECT_EQ(clipSegment({{0, 0}, {2, 2}}, {{1, 1}, {1, 1}}), (Segment{{1, 1}, {1, 1}})) << "a window that is a point";
    EXPECT_EQ(clipSegment({{0, 0}, {2, 2.5}}, {{1, 1}, {1, 1}}), std::nullopt);
}

TEST(ClipSegment, GivesTheSameBitsBothWaysAndStaysInside) {
    Random random(9);
    int kept = 0;
    for (int i = 0; i < 100000; ++i) {
        const double size = random.logarithmic(1e-60, 1e60);
        const auto point = [&] { return size * vec2(random.point(3)); };
        const Segment segment{point(), point()};
        const vec2 one = point(), other = point();
        const Box box{glm::min(one, other), glm::max(one, other)};
        const auto cut = clipSegment(segment, box), back = clipSegment({segment.b, segment.a}, box);
        ASSERT_EQ(cut.has_value(), back.has_value());
        if (!cut) continue;
        ASSERT_EQ(*cut, (Segment{back->b, back->a}));
        ASSERT_TRUE(box.holds(cut->a) && box.holds(cut->b));
        ++kept;
    }
    EXPECT_GT(kept, 10000);
}

TEST(ClipSegment, RefusalsSayWhatWouldHaveBeenRight) {
    const double nan = std::nan("");
    EXPECT_EQ(refusal([&] {
                  (void)clipSegment({{0, nan}, {1, 1}}, {{0, 0}, {1, 1}});
              }),
              "clipSegment: each point must be finite, (0, nan)");
    EXPECT_EQ(refusal([] {
                  (void)clipSegment({{0, 0}, {1, 1}}, {{2, 0}, {1, 1}});
              }),
              "clipSegment: the window's low corner must not be beyond its high one, 2, 0");
}
