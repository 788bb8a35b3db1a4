// A matrix times a vector in float, in the ways that GPUs compute it.
#pragma once
#include <cmath>

#include "mv/math/types.h"

namespace mv {

// Each row as ((x + y) + z) + w, with every product and sum rounded, as GLSL's operator says and llvmpipe computes.
inline fvec4 gpuProduct(const fmat4& m, const fvec4& v) {
    fvec4 sum(0);
    for (int row = 0; row < 4; ++row)
        sum[row] = ((m[0][row] * v.x + m[1][row] * v.y) + m[2][row] * v.z) + m[3][row] * v.w;
    return sum;
}

// The same order with fused multiply-adds, which round once instead of twice, as many GPUs compute.
inline fvec4 fusedProduct(const fmat4& m, const fvec4& v) {
    fvec4 sum(0);
    for (int row = 0; row < 4; ++row)
        sum[row] = std::fma(m[3][row], v.w, std::fma(m[2][row], v.z, std::fma(m[1][row], v.y, m[0][row] * v.x)));
    return sum;
}

// 2^-24 times the sum of |m v| of each row. Whatever the order, and fused or not, a row is within 4 of these of the true
// one: at most four roundings, 2^-24 of a partial sum each.
inline vec4 productUnit(const fmat4& m, const fvec4& v) {
    vec4 unit(0);
    for (int row = 0; row < 4; ++row) {
        double terms = 0;
        for (int k = 0; k < 4; ++k) terms += std::abs(double(m[k][row]) * v[k]);
        unit[row] = std::ldexp(terms, -24);
    }
    return unit;
}

}  // namespace mv
