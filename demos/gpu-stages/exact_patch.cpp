#include "exact_patch.h"

#include <algorithm>
#include <cstddef>
#include <glm/common.hpp>
#include <utility>

#include "control_net.h"

namespace mv {
namespace {

// Polynomials on 0 .. 1 by their coefficients in Bernstein's form: between the smallest and the largest of these lie all
// values.
using Cubic = std::array<double, 4>;
using Sextic = std::array<double, 7>;

// A coefficient of the cubic on another stretch, from a to b: its blossom there.
double blossom(Cubic p, const std::array<double, 3>& at) {
    for (std::size_t left = 3; left > 0; --left) {
        const double t = at.at(left - 1);
        for (std::size_t i = 0; i < left; ++i) p.at(i) = (1 - t) * p.at(i) + t * p.at(i + 1);
    }
    return p[0];
}
Cubic between(const Cubic& p, double a, double b) {
    return {blossom(p, {a, a, a}), blossom(p, {a, a, b}), blossom(p, {a, b, b}), blossom(p, {b, b, b})};
}

void addProduct(Sextic& sum, const Cubic& p, const Cubic& q) {
    static constexpr Cubic ofThree{1, 3, 3, 1};
    static constexpr Sextic ofSix{1, 6, 15, 20, 15, 6, 1};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 4; ++k)
            sum.at(i + k) += ofThree.at(i) * ofThree.at(k) / ofSix.at(i + k) * p.at(i) * q.at(k);
    }
}

std::optional<double> firstZero(const Sextic& p, double low, double high) {
    const auto [least, most] = std::minmax_element(p.begin(), p.end());
    if (*least > 0 || *most < 0) return {};
    const double middle = 0.5 * (low + high);
    if (high - low < 1e-13) return middle;
    Sextic left{}, right = p;  // the halves, by de Casteljau
    for (std::size_t i = 0; i < p.size(); ++i) {
        left.at(i) = right[0];
        for (std::size_t k = 0; k + i + 1 < p.size(); ++k) right.at(k) = 0.5 * (right.at(k) + right.at(k + 1));
    }
    if (const auto first = firstZero(left, low, middle)) return first;
    return firstZero(right, middle, high);
}

}  // namespace

ExactPatch::ExactPatch(double bend) : patch_{} {
    const MeshData net = controlNet();
    for (std::size_t i = 0; i < patch_.points.size(); ++i) {
        vec3 point(net.positions[i]);
        point.y += bend * (point.x * point.x - point.z * point.z);
        patch_.points.at(i) = point;
    }
}

std::optional<double> ExactPatch::firstHit(const vec3& from, const vec3& to) const {
    // (u, v) along the way, and the stretch of it that is over the square
    const vec3 first = patch_.points.front(), last = patch_.points.back(), size = last - first;
    const vec2 start((from.x - first.x) / size.x, (from.z - first.z) / size.z);
    const vec2 step((to.x - from.x) / size.x, (to.z - from.z) / size.z);
    double low = 0, high = 1;
    for (int i = 0; i < 2; ++i) {
        if (step[i] == 0) {
            if (start[i] < 0 || start[i] > 1) return {};
            continue;
        }
        double enters = -start[i] / step[i], leaves = (1 - start[i]) / step[i];
        if (enters > leaves) std::swap(enters, leaves);
        low = std::max(low, enters);
        high = std::min(high, leaves);
    }
    if (low >= high) return {};
    const vec2 a = start + low * step, b = start + high * step;

    // The line's height less the surface's
    Sextic above{};
    for (std::size_t k = 0; k < above.size(); ++k)
        above.at(k) = glm::mix(from.y, to.y, glm::mix(low, high, double(k) / 6));
    for (std::size_t row = 0; row < 4; ++row) {
        Cubic heights{}, weight{};
        for (std::size_t i = 0; i < 4; ++i) heights.at(i) = -patch_.points.at(4 * row + i).y;
        weight.at(row) = 1;
        addProduct(above, between(heights, a.x, b.x), between(weight, a.y, b.y));
    }
    return firstZero(above, low, high);
}

}  // namespace mv
