#include "mv/math/clip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "mv/math/require.h"
#include "mv/math/robust.h"

namespace mv {
namespace {

// value * 2^exponent: a dot product none of whose products overflows or vanishes beside the largest.
struct ScaledDot {
    double value = 0;
    int exponent = 0;
};
ScaledDot scaledDot(const vec4& a, const vec4& b) {
    std::array<double, 4> mantissas{};
    std::array<int, 4> exponents{};
    int largest = std::numeric_limits<int>::min();
    for (int i = 0; i < 4; ++i) {
        const auto k = static_cast<std::size_t>(i);
        int ofA = 0, ofB = 0;
        mantissas[k] = std::frexp(a[i], &ofA) * std::frexp(b[i], &ofB);
        exponents[k] = ofA + ofB;
        if (mantissas[k] != 0) largest = std::max(largest, exponents[k]);
    }
    ScaledDot sum{0, largest};
    for (std::size_t k = 0; k < 4; ++k) {
        if (mantissas[k] != 0) sum.value += std::scalbn(mantissas[k], exponents[k] - largest);
    }
    return sum;
}

// The side of the half space that the point is on: positive inside, 0 on the bound.
double sideOf(const vec4& halfSpace, const vec4& point) {
    const double side = glm::dot(halfSpace, point);
    return isOrdinary(std::abs(side)) ? side : scaledDot(halfSpace, point).value;
}

// The exit from the half space of the segment from a point inside to one outside: always computed in this direction, so
// that the same segment walked the other way gives the same bits.
vec4 crossing(const vec4& inside, const vec4& outside, const vec4& halfSpace) {
    const double in = glm::dot(halfSpace, inside), out = glm::dot(halfSpace, outside);
    const vec4 along = outside - inside;
    if (isOrdinary(in - out) && isFinite(along)) return inside + (in / (in - out)) * along;

    const ScaledDot from = scaledDot(halfSpace, inside), to = scaledDot(halfSpace, outside);
    if (from.value == 0) return inside;
    const int exponent = std::max(from.exponent, to.exponent);
    const double fromSide = std::scalbn(from.value, from.exponent - exponent);
    const double part = fromSide / (fromSide - std::scalbn(to.value, to.exponent - exponent));
    return inside + 2.0 * (part * (0.5 * outside - 0.5 * inside));
}

// The area of corners of any size. Each cross product is that of edges brought to a size of about 1, so that the products
// of a long and a short edge do not vanish either.
[[gnu::cold, gnu::noinline]] double carefulArea(std::span<const vec3> corners) {
    // A quarter of each corner, so that no difference overflows.
    const auto edge = [&](std::size_t i) { return 0.25 * corners[i] - 0.25 * corners[0]; };
    struct Scaled {
        vec3 product;
        int exponent;
    };
    std::vector<Scaled> parts;
    int largest = std::numeric_limits<int>::min();
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const vec3 first = edge(i - 1), second = edge(i);
        const double sizes[] = {largestComponent(first), largestComponent(second)};
        if (sizes[0] == 0 || sizes[1] == 0) continue;
        const int exponents[] = {std::ilogb(sizes[0]), std::ilogb(sizes[1])};
        const vec3 product = glm::cross(timesPowerOfTwo(first, -exponents[0]), timesPowerOfTwo(second, -exponents[1]));
        if (product == vec3(0)) continue;
        parts.push_back({product, exponents[0] + exponents[1]});
        largest = std::max(largest, parts.back().exponent + std::ilogb(largestComponent(product)));
    }
    vec3 sum(0);
    for (const Scaled& part : parts) sum += timesPowerOfTwo(part.product, part.exponent - largest);
    const double area = parts.empty() ? 0 : std::scalbn(8 * glm::length(sum), largest);
    requireFinite("polygonArea", "the area", area);
    return area;
}

}  // namespace

std::vector<vec4> clipPolygon(std::vector<vec4> polygon, std::span<const vec4> halfSpaces) {
    for (const vec4& corner : polygon) requireFinite("clipPolygon", "each corner", corner);
    for (const vec4& halfSpace : halfSpaces) {
        requireFinite("clipPolygon", "each half space", halfSpace);
        std::vector<vec4> kept;
        const auto keep = [&](const vec4& corner) {
            if (kept.empty() || kept.back() != corner) kept.push_back(corner);
        };
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const vec4 &corner = polygon[i], &next = polygon[(i + 1) % polygon.size()];
            const bool in = sideOf(halfSpace, corner) >= 0, nextIn = sideOf(halfSpace, next) >= 0;
            if (in) keep(corner);
            if (in != nextIn) keep(in ? crossing(corner, next, halfSpace) : crossing(next, corner, halfSpace));
        }
        if (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
        polygon = std::move(kept);
    }
    return polygon;
}

const std::array<vec4, 6>& clipVolume() {
    static const std::array<vec4, 6> planes{vec4(1, 0, 0, 1),  vec4(-1, 0, 0, 1), vec4(0, 1, 0, 1),
                                            vec4(0, -1, 0, 1), vec4(0, 0, 1, 1),  vec4(0, 0, -1, 1)};
    return planes;
}

double polygonArea(std::span<const vec3> corners) {
    for (const vec3& corner : corners) requireFinite("polygonArea", "each corner", corner);
    vec3 sum(0);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        sum += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    }
    const double squares = glm::dot(sum, sum);
    return isOrdinary(squares) ? std::sqrt(squares) / 2 : carefulArea(corners);
}

}  // namespace mv
