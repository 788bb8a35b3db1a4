#include "polygon_overlap.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "mv/error.h"

namespace mv {
namespace {

__extension__ using Wide = __int128;

GridPoint operator-(const GridPoint& a, const GridPoint& b) { return {a.x - b.x, a.y - b.y}; }
std::int64_t cross(const GridPoint& a, const GridPoint& b) { return a.x * b.y - a.y * b.x; }
std::int64_t dot(const GridPoint& a, const GridPoint& b) { return a.x * b.x + a.y * b.y; }
std::int64_t turn(const GridPoint& a, const GridPoint& b, const GridPoint& c) { return cross(b - a, c - a); }
int signOf(std::int64_t x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

GridPoint next(const GridPolygon& polygon, std::size_t i) { return polygon[(i + 1) % polygon.size()]; }

Wide commonDivisor(Wide a, Wide b) {
    a = a < 0 ? -a : a;
    b = b < 0 ? -b : b;
    while (b != 0) a = std::exchange(b, a % b);
    return a;
}

// A point x / below, y / below, in lowest terms: the same point has the same numbers.
struct ExactPoint {
    Wide x, y, below;
    auto key() const { return std::tuple(x, y, below); }
    bool operator<(const ExactPoint& other) const { return key() < other.key(); }
    bool operator==(const ExactPoint& other) const { return key() == other.key(); }
    vec2 rounded() const {
        const auto divided = [this](Wide above) {
            return static_cast<double>(static_cast<long double>(above) / static_cast<long double>(below));
        };
        return {divided(x), divided(y)};
    }
};

// a + t (b - a) for t = above / below.
struct Parameter {
    std::int64_t above, below;  // below > 0
    bool operator<(const Parameter& other) const { return Wide(above) * other.below < Wide(other.above) * below; }
};
ExactPoint pointAt(const GridPoint& a, const GridPoint& b, const Parameter& t) {
    ExactPoint point{Wide(a.x) * t.below + Wide(b.x - a.x) * t.above, Wide(a.y) * t.below + Wide(b.y - a.y) * t.above,
                     t.below};
    const Wide common = commonDivisor(commonDivisor(point.x, point.y), point.below);
    return {point.x / common, point.y / common, point.below / common};
}

// The parameters at which edge a b meets the edges of the other polygon, with the edge's own ends, in order.
std::vector<Parameter> meetings(const GridPoint& a, const GridPoint& b, const GridPolygon& other) {
    std::vector<Parameter> found{{0, 1}, {1, 1}};
    const GridPoint along = b - a;
    for (std::size_t i = 0; i < other.size(); ++i) {
        const GridPoint c = other[i], d = next(other, i);
        const std::int64_t sideOfC = turn(a, b, c), sideOfD = turn(a, b, d);
        if (sideOfC == 0) {  // a corner on the edge's line; also where both edges lie on one line
            const std::int64_t above = dot(c - a, along), below = dot(along, along);
            if (above > 0 && above < below) found.push_back({above, below});
        }
        if (signOf(sideOfC) * signOf(sideOfD) >= 0) continue;
        std::int64_t above = turn(c, d, a), below = above - turn(c, d, b);
        if (below < 0) above = -above, below = -below;
        if (above > 0 && above < below) found.push_back({above, below});
    }
    std::ranges::sort(found, std::less<Parameter>());
    return found;
}

// Twice the midpoint of two neighbouring meetings. The whole part between them lies on the same side as the midpoint.
struct Middle {
    Wide x, y, below;
};
EdgePart::Lies whereLies(const Middle& m, const GridPoint& direction, const GridPolygon& other) {
    bool inside = false;
    for (std::size_t i = 0; i < other.size(); ++i) {
        const GridPoint c = other[i], d = next(other, i);
        const Wide side = Wide(d.x - c.x) * (m.y - c.y * m.below) - Wide(d.y - c.y) * (m.x - c.x * m.below);
        const bool cAbove = c.y * m.below > m.y, dAbove = d.y * m.below > m.y;
        const auto between = [](Wide x, Wide one, Wide two) {
            return x >= std::min(one, two) && x <= std::max(one, two);
        };
        if (side == 0 && between(m.x, c.x * m.below, d.x * m.below) && between(m.y, c.y * m.below, d.y * m.below))
            return dot(direction, d - c) > 0 ? EdgePart::Lies::alongSame : EdgePart::Lies::alongOpposite;
        // Half-open in y: a ray to the right through a corner counts the edge above it.
        if (cAbove != dAbove && (side > 0) == dAbove) inside = !inside;
    }
    return inside ? EdgePart::Lies::inside : EdgePart::Lies::outside;
}

struct Directed {
    ExactPoint from, to;
    GridPoint direction;
    bool used = false;
};

void require(const GridPolygon& polygon) {
    if (isSimple(polygon)) return;
    throw Error("overlap", "each polygon must have an area, and edges that meet at common corners alone",
                std::to_string(polygon.size()) + " corners");
}

// The edge that continues from a place where several begin: the leftmost, so that polygons that touch there stay apart.
std::size_t leftmost(const std::vector<std::size_t>& begin, const std::vector<Directed>& edges,
                     const GridPoint& before) {
    const auto half = [&](const GridPoint& d) {  // 0: turns to the left or straight on, 1: to the right
        const std::int64_t sine = cross(before, d);
        return sine > 0 || (sine == 0 && dot(before, d) > 0) ? 0 : 1;
    };
    std::size_t best = edges.size();
    for (const std::size_t i : begin) {
        if (edges[i].used) continue;
        if (best == edges.size()) {
            best = i;
            continue;
        }
        const GridPoint one = edges[i].direction, other = edges[best].direction;
        if (half(one) != half(other) ? half(one) < half(other) : cross(other, one) > 0) best = i;
    }
    return best;
}

std::vector<std::vector<vec2>> joined(std::vector<Directed> edges) {
    std::map<ExactPoint, std::vector<std::size_t>> beginAt;
    for (std::size_t i = 0; i < edges.size(); ++i) beginAt[edges[i].from].push_back(i);
    std::vector<std::vector<vec2>> polygons;
    for (std::size_t start = 0; start < edges.size(); ++start) {
        if (edges[start].used) continue;
        std::vector<vec2> polygon;
        std::size_t now = start;
        do {
            edges[now].used = true;
            const std::size_t after = edges[now].to == edges[start].from
                                          ? edges.size()
                                          : leftmost(beginAt[edges[now].to], edges, edges[now].direction);
            // Leave out a corner between two parts of one edge.
            const GridPoint on = after == edges.size() ? edges[start].direction : edges[after].direction;
            if (cross(edges[now].direction, on) != 0) polygon.push_back(edges[now].to.rounded());
            now = after;
        } while (now != edges.size());
        polygons.push_back(std::move(polygon));
    }
    return polygons;
}

}  // namespace

std::int64_t doubleArea(const GridPolygon& polygon) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) sum += cross(polygon[i], next(polygon, i));
    return sum;
}

bool isSimple(const GridPolygon& polygon) {
    constexpr std::int64_t most = 1 << 16;  // then no product below has more than 110 bits
    for (const GridPoint& p : polygon) {
        if (std::max({p.x, -p.x, p.y, -p.y}) > most) return false;
    }
    if (polygon.size() < 3 || doubleArea(polygon) == 0) return false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const GridPoint a = polygon[i], b = next(polygon, i);
        if (a == b) return false;
        for (std::size_t k = 0; k < i; ++k) {
            const GridPoint c = polygon[k], d = next(polygon, k);
            const bool follows = k + 1 == i, precedes = (i + 1) % polygon.size() == k;
            if (follows || precedes) {  // neighbours may not fold back on each other
                const GridPoint& shared = follows ? a : b;
                const GridPoint &far = follows ? b : a, &otherFar = follows ? c : d;
                if (turn(shared, far, otherFar) == 0 && dot(far - shared, otherFar - shared) > 0) return false;
                continue;
            }
            const int ac = signOf(turn(a, b, c)), ad = signOf(turn(a, b, d));
            const int ca = signOf(turn(c, d, a)), cb = signOf(turn(c, d, b));
            const auto within = [](const GridPoint& p, const GridPoint& one, const GridPoint& other) {
                return p.x >= std::min(one.x, other.x) && p.x <= std::max(one.x, other.x) &&
                       p.y >= std::min(one.y, other.y) && p.y <= std::max(one.y, other.y);
            };
            if (ac * ad < 0 && ca * cb < 0) return false;
            if ((ac == 0 && within(c, a, b)) || (ad == 0 && within(d, a, b)) || (ca == 0 && within(a, c, d)) ||
                (cb == 0 && within(b, c, d))) {
                return false;
            }
        }
    }
    return true;
}

Overlap overlap(GridPolygon first, GridPolygon second) {
    require(first);
    require(second);
    if (doubleArea(first) < 0) std::reverse(first.begin(), first.end());
    if (doubleArea(second) < 0) std::reverse(second.begin(), second.end());
    Overlap result;
    std::vector<Directed> kept;
    for (const bool ofSecond : {false, true}) {
        const GridPolygon &own = ofSecond ? second : first, &other = ofSecond ? first : second;
        for (std::size_t i = 0; i < own.size(); ++i) {
            const GridPoint a = own[i], b = next(own, i);
            const std::vector<Parameter> at = meetings(a, b, other);
            for (std::size_t k = 1; k < at.size(); ++k) {
                const ExactPoint from = pointAt(a, b, at[k - 1]), to = pointAt(a, b, at[k]);
                if (from == to) continue;
                const Middle middle{from.x * to.below + to.x * from.below, from.y * to.below + to.y * from.below,
                                    2 * from.below * to.below};
                EdgePart part{from.rounded(), to.rounded(), whereLies(middle, b - a, other), ofSecond, false};
                part.kept =
                    part.lies == EdgePart::Lies::inside || (part.lies == EdgePart::Lies::alongSame && !ofSecond);
                if (part.kept) kept.push_back({from, to, b - a});
                result.parts.push_back(part);
            }
        }
    }
    result.polygons = joined(std::move(kept));
    return result;
}

}  // namespace mv
