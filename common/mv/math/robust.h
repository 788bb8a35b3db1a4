// Vector arithmetic that keeps its accuracy where the textbook form loses it: lengths of 1e200 and 1e-200, and cross
// products of vectors that are nearly parallel.
#pragma once
#include "mv/math/types.h"

namespace mv {

// The exponent e for which size * 2^-e is in [1, 2), or 0 where no scaling is needed: for a size of 0 or within
// 2^-100..2^100, of which fourth powers neither overflow nor vanish. Multiplying by 2^-e rounds nothing.
int scalingExponent(double size);

// The size of v's largest component, and v times 2^exponent.
double largestComponent(const vec3& v);
double largestComponent(const vec4& v);
vec3 timesPowerOfTwo(const vec3& v, int exponent);
vec4 timesPowerOfTwo(const vec4& v, int exponent);

// v times 2^-scalingExponent(its largest component): v itself in the ordinary range. v must be finite.
vec3 scaledForSquares(const vec3& v);

// True from 1e-40 to 1e40, and false for NaN. A vector whose dot product with itself is ordinary is finite and needs no
// scaling, neither for its length nor for products with others like it: the usual case, told by two comparisons.
inline bool isOrdinary(double x) { return x >= 1e-40 && x <= 1e40; }

// v / |v|, for any finite v other than zero, however large or small. The zero vector is the caller's to refuse.
// Equals MV.js normalize(), which divides by the length (glm::normalize multiplies by a rounded reciprocal).
vec3 unit(const vec3& v);

// a*b - c*d with an error of at most 1.5 units in the last place, where the plain form can lose every digit: for products
// that do not overflow and are 0 or at least 1e-290, so that their roundings are numbers, too.
// Source: Kahan; Jeannerod, Louvet and Muller, "Further analysis of Kahan's algorithm", Math. Comp. 82 (2013).
double differenceOfProducts(double a, double b, double c, double d);

// a x b with every component accurate in itself, so that the result stays perpendicular to both however small the
// angle between them, for products as of differenceOfProducts. In ordinary cases glm::cross is as good, and has the bits of MV.js cross().
vec3 accurateCross(const vec3& a, const vec3& b);

}  // namespace mv
