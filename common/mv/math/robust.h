// Vector arithmetic that keeps its accuracy where the textbook form loses it: lengths of 1e200 and 1e-200, and cross
// products of vectors that are nearly parallel.
#pragma once
#include "mv/math/types.h"

namespace mv {

// v times the power of two that brings its largest component into [1, 2); the zero vector stays zero.
// Multiplying by a power of two rounds nothing, so in the ordinary range v/|v| has the same bits before and after;
// what changes is that the squares in |v| can no longer overflow or vanish. v must be finite.
vec3 scaledNearOne(const vec3& v);

// v / |v|, for any finite v other than zero, however large or small. The zero vector is the caller's to refuse.
// Equals MV.js normalize(), which divides by the length (glm::normalize multiplies by a rounded reciprocal).
vec3 unit(const vec3& v);

// a*b - c*d with an error of at most 1.5 units in the last place, where the plain form can lose every digit.
// Source: Kahan; Jeannerod, Louvet and Muller, "Further analysis of Kahan's algorithm", Math. Comp. 82 (2013).
double differenceOfProducts(double a, double b, double c, double d);

// a x b with every component accurate in itself, so that the result stays perpendicular to both however small the
// angle between them. In ordinary cases glm::cross is as good, and has the bits of MV.js cross().
vec3 accurateCross(const vec3& a, const vec3& b);

}  // namespace mv
