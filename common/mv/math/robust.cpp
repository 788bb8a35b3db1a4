#include "mv/math/robust.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mv {

int scalingExponent(double size) {
    // Most calls end here: the power-of-two scaling itself would cost more than the rest of a lookAt.
    if (size == 0 || (size >= 0x1p-100 && size <= 0x1p100)) return 0;
    return std::ilogb(size);
}

double largestComponent(const vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

double largestComponent(const vec4& v) { return std::max(largestComponent(vec3(v)), std::abs(v.w)); }

vec3 timesPowerOfTwo(const vec3& v, int exponent) {
    if (exponent == 0) return v;
    // scalbn, not a product with 2^exponent: that factor itself overflows when v is subnormal.
    return {std::scalbn(v.x, exponent), std::scalbn(v.y, exponent), std::scalbn(v.z, exponent)};
}

vec4 timesPowerOfTwo(const vec4& v, int exponent) {
    if (exponent == 0) return v;
    return {timesPowerOfTwo(vec3(v), exponent), std::scalbn(v.w, exponent)};
}

vec3 scaledForSquares(const vec3& v) { return timesPowerOfTwo(v, -scalingExponent(largestComponent(v))); }

vec3 unit(const vec3& v) {
    const double squares = glm::dot(v, v);
    if (isOrdinary(squares)) return v / std::sqrt(squares);
    const vec3 scaled = scaledForSquares(v);
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
