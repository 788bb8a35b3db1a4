#include "mv/geometry/quadric_ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>

#include "mv/math/require.h"

namespace mv {
namespace {

template <typename T>
constexpr T endless = std::numeric_limits<T>::infinity();

template <typename T>
bool isFiniteRay(const RayOf<T>& ray) {
    return isFinite(vec3(ray.origin)) && isFinite(vec3(ray.direction)) && ray.direction != glm::vec<3, T>(0);
}

// The t of a line, low <= high; empty where not.
struct Part {
    double low = -endless<double>, high = endless<double>;
};

Part common(const Part& a, const Part& b) { return {std::max(a.low, b.low), std::min(a.high, b.high)}; }

// The part of the ray where low <= from + t along <= high.
Part slab(double from, double along, double low, double high) {
    if (along == 0) return from >= low && from <= high ? Part{} : Part{0, -1};
    const double first = ((along > 0 ? low : high) - from) / along, last = ((along > 0 ? high : low) - from) / along;
    return {first, last};
}

// The two roots of a t^2 + 2 b t + c, of which discriminant = b^2 - a c >= 0 is known better than from these: one root adds
// numbers of one sign, the other follows from their product.
Part rootsOf(double a, double b, double c, double discriminant) {
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    const double first = q / a, second = q == 0 ? 0 : c / q;
    return {std::min(first, second), std::max(first, second)};
}

template <typename T>
std::optional<RayInterval<T>> ahead(const Part& part) {
    const double most = std::numeric_limits<T>::max();
    if (!(part.low <= part.high && part.high >= 0 && part.high <= most && part.low >= -most)) return {};
    return RayInterval<T>{static_cast<T>(part.low), static_cast<T>(part.high)};
}

// ---- polynomials c[0] + c[1] s + ... of a degree up to 4, between two places

using Coefficients = std::array<double, 5>;

double valueOf(const Coefficients& c, std::size_t degree, double s) {
    double value = c.at(degree);
    for (std::size_t i = degree; i-- > 0;) value = value * s + c.at(i);
    return value;
}

// The root between two places where the polynomial has different signs: Newton's steps, halving where one leaves the bracket.
double rootBetween(const Coefficients& c, const Coefficients& slope, std::size_t degree, double low, double high) {
    const bool rises = valueOf(c, degree, low) < 0;
    double s = low + (high - low) / 2;
    for (int step = 0; step < 200; ++step) {
        const double value = valueOf(c, degree, s);
        if (value == 0) return s;
        ((value < 0) == rises ? low : high) = s;
        const double newton = s - value / valueOf(slope, degree - 1, s);
        const double next = newton > low && newton < high ? newton : low + (high - low) / 2;
        if (next == s || !(next > low && next < high)) return s;
        s = next;
    }
    return s;
}

struct Roots {
    std::array<double, 4> at{};
    std::size_t count = 0;
};

// All roots in low..high where the sign changes, in order: between two roots of the derivative there is one at most.
Roots rootsWithin(const Coefficients& c, std::size_t degree, double low, double high) {
    Roots roots;
    if (degree == 0) return roots;
    Coefficients slope{};
    for (std::size_t i = 1; i <= degree; ++i) slope.at(i - 1) = double(i) * c.at(i);
    const Roots turns = rootsWithin(slope, degree - 1, low, high);
    double from = low, valueFrom = valueOf(c, degree, low);
    for (std::size_t i = 0; i <= turns.count; ++i) {
        const double to = i < turns.count ? turns.at.at(i) : high, valueTo = valueOf(c, degree, to);
        if (valueFrom != 0 && (valueTo == 0 || (valueFrom < 0) != (valueTo < 0))) {
            roots.at.at(roots.count++) = valueTo == 0 ? to : rootBetween(c, slope, degree, from, to);
        }
        from = to;
        valueFrom = valueTo;
    }
    return roots;
}

}  // namespace

template <typename T>
std::optional<RayInterval<T>> intersectCylinder(const RayOf<T>& ray, T radius, T low, T high) {
    if (!isFiniteRay(ray) || !(radius > 0) || !(low <= high)) return {};
    const glm::vec<3, T>&o = ray.origin, &d = ray.direction;
    const Part between = slab(o.y, d.y, low, high);
    const double dx = d.x, dz = d.z, a = dx * dx + dz * dz, from = std::hypot(double(o.x), double(o.z));
    if (a == 0) return from <= radius ? ahead<T>(between) : std::nullopt;
    // |f x d| in the plane of the disk is the line's distance from the axis, times |d|
    const double miss = signedDifference(o.x, d.z, o.z, d.x), r = radius;
    const double discriminant = (r * std::sqrt(a) - std::abs(miss)) * (r * std::sqrt(a) + std::abs(miss));
    if (!(discriminant >= 0)) return {};
    return ahead<T>(common(between, rootsOf(a, o.x * dx + o.z * dz, (from - r) * (from + r), discriminant)));
}

template <typename T>
std::optional<RayInterval<T>> intersectCone(const RayOf<T>& ray, T radius, T height) {
    if (!isFiniteRay(ray) || !(radius > 0) || !(height > 0)) return {};
    // q is counted down from the tip: inside is x^2 + z^2 <= (k q)^2, 0 <= q <= height
    const T down = height - ray.origin.y, downwards = -ray.direction.y;
    const glm::vec<3, T>&o = ray.origin, &d = ray.direction;
    const double k = double(radius) / double(height), dx = d.x, dz = d.z;
    const Part between = slab(down, downwards, 0, height);
    const double across = std::hypot(dx, dz), along = k * std::abs(double(downwards));
    const double a = (across - along) * (across + along);
    const double b = o.x * dx + o.z * dz - k * k * double(down) * double(downwards);
    const double from = std::hypot(double(o.x), double(o.z)), at = k * std::abs(double(down));
    const double c = (from - at) * (from + at);
    // b^2 - a c without cancellation, by the three minors of origin and direction
    const double byX = signedDifference(o.x, downwards, d.x, down), byZ = signedDifference(o.z, downwards, d.z, down);
    const double sides = k * std::hypot(byX, byZ), miss = std::abs(double(signedDifference(o.x, d.z, o.z, d.x)));
    const double discriminant = (sides - miss) * (sides + miss);
    if (a > 0) {
        if (!(discriminant >= 0)) return {};
        return ahead<T>(common(between, rootsOf(a, b, c, discriminant)));
    }
    // As steep as the side, or steeper: from one end of the line to its only root in the half below the tip
    if (downwards == 0) return {};
    double root = -c / (2 * b);
    if (a < 0) {
        const Part roots = rootsOf(a, b, c, std::max(discriminant, 0.0));
        root = downwards > 0 ? roots.high : roots.low;
    } else if (b == 0) {
        root = downwards > 0 ? -endless<double> : endless<double>;  // in the side itself
        if (c > 0) return {};
    }
    return ahead<T>(common(between, downwards > 0 ? Part{root, endless<double>} : Part{-endless<double>, root}));
}

template <typename T>
std::optional<T> intersectDisk(const RayOf<T>& ray, const glm::vec<3, T>& center, const glm::vec<3, T>& normal,
                               T radius) {
    if (!isFiniteRay(ray) || !(radius > 0)) return {};
    const glm::vec<3, T> from = ray.origin - center;
    const T along = glm::dot(normal, ray.direction), t = -glm::dot(normal, from) / along;
    if (along == 0 || !(t >= 0) || !isFinite(double(t))) return {};
    const vec3 place = vec3(from) + double(t) * vec3(ray.direction);
    if (!(glm::length(place) <= double(radius))) return {};
    return t;
}

template <typename T>
std::optional<T> intersectTorus(const RayOf<T>& ray, T major, T minor) {
    if (!isFiniteRay(ray) || !(minor > 0) || !(major >= minor)) return {};
    const vec3 origin(ray.origin), direction(ray.direction);
    const double length = glm::length(direction), R = major, r = minor;
    const vec3 d = direction / length;
    const double toMiddle = -glm::dot(origin, d);
    const vec3 m = origin + toMiddle * d;  // the nearest point to the torus' middle; s is counted from it
    const double reach = (R + r) * (R + r) - glm::dot(m, m);
    if (!(reach > 0)) return {};
    // (s^2 + k)^2 = 4 R^2 (x^2 + z^2), of which the last coefficient is a product of the two circles' distances
    const double k = glm::dot(m, m) + (R - r) * (R + r), out = std::hypot(m.x, m.z);
    const double inside = m.y * m.y + (out - R - r) * (out - R + r);
    const Coefficients c{inside * (k + 2 * R * out), -8 * R * R * (m.x * d.x + m.z * d.z),
                         2 * k - 4 * R * R * (d.x * d.x + d.z * d.z), 0, 1};
    const double ends = std::sqrt(reach) * (1 + 1e-9);
    const Roots roots = rootsWithin(c, 4, std::max(-ends, -toMiddle), ends);
    if (roots.count == 0) return {};
    const double t = (roots.at[0] + toMiddle) / length;
    if (!(t >= 0 && t <= double(std::numeric_limits<T>::max()))) return {};
    return static_cast<T>(t);
}

template std::optional<RayInterval<float>> intersectCylinder(const RayOf<float>&, float, float, float);
template std::optional<RayInterval<double>> intersectCylinder(const RayOf<double>&, double, double, double);
template std::optional<RayInterval<float>> intersectCone(const RayOf<float>&, float, float);
template std::optional<RayInterval<double>> intersectCone(const RayOf<double>&, double, double);
template std::optional<float> intersectDisk(const RayOf<float>&, const fvec3&, const fvec3&, float);
template std::optional<double> intersectDisk(const RayOf<double>&, const vec3&, const vec3&, double);
template std::optional<float> intersectTorus(const RayOf<float>&, float, float);
template std::optional<double> intersectTorus(const RayOf<double>&, double, double);

}  // namespace mv
