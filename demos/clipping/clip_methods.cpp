#include "clip_methods.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "mv/error.h"

namespace mv {

unsigned regionCode(const Box& window, const vec2& point) {
    return (point.y > window.high.y ? above : 0U) | (point.y < window.low.y ? below : 0U) |
           (point.x > window.high.x ? rightOf : 0U) | (point.x < window.low.x ? leftOf : 0U);
}

std::string codeText(unsigned code) {
    std::string text;
    for (const unsigned side : {above, below, rightOf, leftOf}) text += (code & side) != 0 ? '1' : '0';
    return text;
}

std::vector<CodeRound> cohenSutherland(const Segment& segment, const Box& window) {
    std::vector<CodeRound> rounds;
    Segment now = segment;
    for (;;) {
        CodeRound round{now, regionCode(window, now.a), regionCode(window, now.b)};
        if ((round.codeA | round.codeB) == 0) round.does = CodeRound::Does::accept;
        if ((round.codeA & round.codeB) != 0) round.does = CodeRound::Does::reject;
        if (round.does != CodeRound::Does::cut) {
            rounds.push_back(round);
            return rounds;
        }
        // Cut the segment at a side that one of its ends is beyond, and judge the rest again.
        round.cutsA = round.codeA != 0;
        const unsigned code = round.cutsA ? round.codeA : round.codeB;
        round.side = (code & above) != 0     ? above
                     : (code & below) != 0   ? below
                     : (code & rightOf) != 0 ? rightOf
                                             : leftOf;
        const vec2 along = now.b - now.a;
        vec2& end = round.cutsA ? now.a : now.b;
        if (round.side == above || round.side == below) {
            const double y = round.side == above ? window.high.y : window.low.y;
            end = {now.a.x + (y - now.a.y) / along.y * along.x, y};
        } else {
            const double x = round.side == rightOf ? window.high.x : window.low.x;
            end = {x, now.a.y + (x - now.a.x) / along.x * along.y};
        }
        rounds.push_back(round);
    }
}

std::optional<Segment> liangBarsky(const Segment& segment, const Box& window) {
    const vec2 along = segment.b - segment.a;
    double from = 0, to = 1;
    for (int axis = 0; axis < 2; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const double out = side * along[axis];  // how fast the segment goes out
            const double room = side < 0 ? segment.a[axis] - window.low[axis] : window.high[axis] - segment.a[axis];
            if (out == 0 && room < 0) return {};
            if (out < 0) from = std::max(from, room / out);
            if (out > 0) to = std::min(to, room / out);
        }
    }
    if (from > to) return {};
    return Segment{from == 0 ? segment.a : segment.a + from * along, to == 1 ? segment.b : segment.a + to * along};
}

std::array<HalfPlane, 4> halfPlanes(const Box& window) {
    return {{{{1, 0}, -window.low.x}, {{-1, 0}, window.high.x}, {{0, 1}, -window.low.y}, {{0, -1}, window.high.y}}};
}

std::vector<HalfPlane> halfPlanes(const std::vector<vec2>& polygon) {
    std::vector<HalfPlane> edges;
    double turns = 0;  // counter-clockwise where positive
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        turns += a.x * b.y - a.y * b.x;
    }
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const vec2 &a = polygon[i], along = polygon[(i + 1) % polygon.size()] - a;
        const vec2 normal = (turns < 0 ? -1.0 : 1.0) * vec2(-along.y, along.x);
        edges.push_back({normal, -glm::dot(normal, a)});
    }
    return edges;
}

bool isConvex(const std::vector<vec2>& polygon) {
    for (const HalfPlane& half : halfPlanes(polygon)) {
        for (const vec2& corner : polygon) {
            if (half.of(corner) < -1e-9)
                return false;  // far more than rounding errors, far less than a step of the demo's grid
        }
    }
    return true;
}

double areaOf(const std::vector<vec2>& polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        sum += a.x * b.y - a.y * b.x;
    }
    return std::abs(sum) / 2;
}

std::optional<Segment> cyrusBeck(const Segment& segment, std::span<const HalfPlane> inside) {
    double from = 0, to = 1;
    for (const HalfPlane& half : inside) {
        const double atA = half.of(segment.a), atB = half.of(segment.b);
        if (atA < 0 && atB < 0) return {};
        if (atA >= 0 && atB >= 0) continue;
        const double t = atA / (atA - atB);
        (atA < 0 ? from : to) = atA < 0 ? std::max(from, t) : std::min(to, t);
    }
    if (from > to) return {};
    const vec2 along = segment.b - segment.a;
    return Segment{from == 0 ? segment.a : segment.a + from * along, to == 1 ? segment.b : segment.a + to * along};
}

// ---- exactly

namespace {

__extension__ using Wide = __int128;

std::int64_t whole(double value, int bits) {
    const double scaled = std::ldexp(value, bits);
    if (std::abs(scaled) <= 0x1p53 && scaled == std::nearbyint(scaled)) return static_cast<std::int64_t>(scaled);
    throw Error("clipExactly", "each coordinate must be a whole number of 2^-" + std::to_string(bits),
                numberText(value));
}

// above / below, the latter positive.
struct Fraction {
    Wide above, below;
    bool isBefore(const Fraction& other) const { return above * other.below < other.above * below; }
};

}  // namespace

ExactPart clipExactly(const Segment& segment, const Box& window, int bits) {
    const auto point = [&](const vec2& p) { return std::array<std::int64_t, 2>{whole(p.x, bits), whole(p.y, bits)}; };
    const auto a = point(segment.a), b = point(segment.b), low = point(window.low), high = point(window.high);
    Fraction from{0, 1}, to{1, 1};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::int64_t along = b[axis] - a[axis];
        for (const int side : {-1, 1}) {
            const std::int64_t out = side * along, room = side < 0 ? a[axis] - low[axis] : high[axis] - a[axis];
            if (out == 0 && room < 0) return {};
            if (out < 0 && from.isBefore({-room, -out})) from = {-room, -out};
            if (out > 0 && Fraction{room, out}.isBefore(to)) to = {room, out};
        }
    }
    if (to.isBefore(from)) return {};
    ExactPart part{true, {}};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto at = [&](const Fraction& t) {
            const Wide above = a[axis] * t.below + (b[axis] - a[axis]) * t.above;
            return std::ldexp(static_cast<long double>(above) / static_cast<long double>(t.below), -bits);
        };
        part.ends[axis] = at(from);
        part.ends[axis + 2] = at(to);
    }
    return part;
}

int exactBits(const Box& window) {
    // Segments end at most three sizes of the window away from the window.
    const double largest =
        std::max({std::abs(window.low.x), std::abs(window.low.y), std::abs(window.high.x), std::abs(window.high.y)}) +
        8 * std::max(window.high.x - window.low.x, window.high.y - window.low.y);
    return 51 - std::ilogb(largest);
}

namespace {

double onGrid(double x, int bits) { return std::ldexp(std::nearbyint(std::ldexp(x, bits)), -bits); }

}  // namespace

Box exactWindow(const Box& window) {
    const int bits = exactBits(window);
    const auto rounded = [bits](const vec2& p) { return vec2(onGrid(p.x, bits), onGrid(p.y, bits)); };
    return {rounded(window.low), rounded(window.high)};
}

std::vector<Segment> aimedAtCorners(const Box& window, int count) {
    std::mt19937_64 random(25);
    const auto number = [&](double low, double high) {  // std's distributions differ from library to library
        return low + (high - low) * std::ldexp(static_cast<double>(random() >> 11), -53);
    };
    const int bits = exactBits(window);
    const auto at = [bits](double x, double y) { return vec2(onGrid(x, bits), onGrid(y, bits)); };
    const vec2 size = window.high - window.low;
    std::vector<Segment> segments;
    segments.reserve(static_cast<std::size_t>(count));
    while (static_cast<int>(segments.size()) < count) {
        const auto which = random();
        const vec2 corner((which & 1U) != 0 ? window.high.x : window.low.x,
                          (which & 2U) != 0 ? window.high.y : window.low.y);
        // Start in a quarter plane beside that of the corner, beyond one side, so that the line just touches the corner.
        const double outX = (which & 1U) != 0 ? 1 : -1, outY = (which & 2U) != 0 ? 1 : -1;
        const double x = number(0.01, 2), y = number(0.01, 2), on = number(0.2, 1.5);
        const vec2 away = (which & 4U) != 0 ? vec2(outX * x, -outY * y) : vec2(-outX * x, outY * y);
        const vec2 from = at(corner.x + away.x * size.x, corner.y + away.y * size.y);
        const vec2 to = at(corner.x + on * (corner.x - from.x), corner.y + on * (corner.y - from.y));
        segments.push_back({from, to});
    }
    return segments;
}

Trial tryMethod(const ClipMethod& method, const std::vector<Segment>& segments, const Box& window) {
    const int bits = exactBits(window);
    const vec2 ofWindow = glm::max(glm::abs(window.low), glm::abs(window.high));
    int wrong = 0;
    Trial trial;
    for (const Segment& segment : segments) {
        const ExactPart right = clipExactly(segment, window, bits);
        const auto part = method(segment, window);
        if (part.has_value() != right.meets) ++wrong;
        if (!part || !right.meets) continue;
        const vec2 size = glm::max(glm::max(glm::abs(segment.a), glm::abs(segment.b)), ofWindow);
        const double ulp = std::ldexp(1, std::ilogb(std::max(size.x, size.y)) - 52);
        const std::array<double, 4> ends{part->a.x, part->a.y, part->b.x, part->b.y};
        for (std::size_t i = 0; i < 4; ++i)
            trial.ulps = std::max(trial.ulps, static_cast<double>(std::abs(ends.at(i) - right.ends.at(i))) / ulp);
    }
    trial.wrongPercent = 100.0 * wrong / static_cast<double>(segments.size());
    return trial;
}

}  // namespace mv
