#include "mv/math/robust.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mv {

vec3 scaledNearOne(const vec3& v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (largest == 0) return v;
    // scalbn, not a product with 2^-exponent: that factor itself overflows when v is subnormal.
    const int exponent = std::ilogb(largest);
    return {std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)};
}

vec3 unit(const vec3& v) {
    const vec3 scaled = scaledNearOne(v);
    return scaled / std::sqrt(glm::dot(scaled, scaled));
}

double differenceOfProducts(double a, double b, double c, double d) {
    const double cd = c * d;
    const double roundingOfCd = std::fma(-c, d, cd);
    return std::fma(a, b, -cd) + roundingOfCd;
}

vec3 accurateCross(const vec3& a, const vec3& b) {
    return {differenceOfProducts(a.y, b.z, a.z, b.y), differenceOfProducts(a.z, b.x, a.x, b.z),
            differenceOfProducts(a.x, b.y, a.y, b.x)};
}

}  // namespace mv
