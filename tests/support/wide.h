// Vectors and matrices of numbers with 50 decimal digits: what reference values are computed in. The exponent has no
// practical end, so nothing overflows either. Each operation is the textbook's, since at this width that is enough.
#pragma once
#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <cstddef>

#include "mv/math/types.h"

namespace mv::test {

// Without expression templates, so that `auto` holds a number.
using Wide =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<50, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

template <std::size_t N>
struct WideVector {
    std::array<Wide, N> element;

    Wide& operator[](std::size_t i) { return element[i]; }
    const Wide& operator[](std::size_t i) const { return element[i]; }
};
using Wide3 = WideVector<3>;
using Wide4 = WideVector<4>;

// A double or float as it is: widening rounds nothing.
template <int N, typename T, glm::qualifier Q>
WideVector<static_cast<std::size_t>(N)> wide(const glm::vec<N, T, Q>& v) {
    WideVector<static_cast<std::size_t>(N)> result;
    for (int i = 0; i < N; ++i) result[static_cast<std::size_t>(i)] = v[i];
    return result;
}

template <std::size_t N>
WideVector<N> operator+(const WideVector<N>& a, const WideVector<N>& b) {
    WideVector<N> sum;
    for (std::size_t i = 0; i < N; ++i) sum[i] = a[i] + b[i];
    return sum;
}
template <std::size_t N>
WideVector<N> operator-(const WideVector<N>& a, const WideVector<N>& b) {
    WideVector<N> difference;
    for (std::size_t i = 0; i < N; ++i) difference[i] = a[i] - b[i];
    return difference;
}
template <std::size_t N>
WideVector<N> operator*(const Wide& factor, const WideVector<N>& v) {
    WideVector<N> product;
    for (std::size_t i = 0; i < N; ++i) product[i] = factor * v[i];
    return product;
}
template <std::size_t N>
WideVector<N> operator/(const WideVector<N>& v, const Wide& divisor) {
    WideVector<N> quotient;
    for (std::size_t i = 0; i < N; ++i) quotient[i] = v[i] / divisor;
    return quotient;
}
template <std::size_t N>
Wide dot(const WideVector<N>& a, const WideVector<N>& b) {
    Wide sum = 0;
    for (std::size_t i = 0; i < N; ++i) sum += a[i] * b[i];
    return sum;
}
template <std::size_t N>
Wide length(const WideVector<N>& v) {
    return sqrt(dot(v, v));
}
inline Wide3 cross(const Wide3& a, const Wide3& b) {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}
template <std::size_t N>
WideVector<N> normalized(const WideVector<N>& v) {
    return v / length(v);
}
// The point of homogeneous coordinates.
inline Wide3 divided(const Wide4& p) { return {{p[0] / p[3], p[1] / p[3], p[2] / p[3]}}; }
inline Wide4 homogeneous(const Wide3& p, const Wide& w) { return {{p[0], p[1], p[2], w}}; }
inline Wide3 firstThree(const Wide4& v) { return {{v[0], v[1], v[2]}}; }

// A 4x4 matrix by columns, as mat4.
struct WideMatrix {
    std::array<Wide4, 4> column;
};

template <typename T, glm::qualifier Q>
WideMatrix wide(const glm::mat<4, 4, T, Q>& m) {
    return {{wide(m[0]), wide(m[1]), wide(m[2]), wide(m[3])}};
}
inline Wide4 operator*(const WideMatrix& m, const Wide4& v) {
    return v[0] * m.column[0] + v[1] * m.column[1] + v[2] * m.column[2] + v[3] * m.column[3];
}

inline const Wide& widePi() {
    static const Wide pi = acos(Wide(-1));
    return pi;
}
inline Wide wideRadians(const Wide& degrees) { return degrees * widePi() / 180; }

}  // namespace mv::test
