// At which times a polynomial through keys is well behaved, and at which it is not.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mv {

// Times from low to high, both included exactly, at which the polynomial through keys comes near every smooth motion: the
// extrema of the Chebyshev polynomial of degree count - 1, denser towards the ends. Symmetrical to the middle.
// Refused: count outside 2..1000, low and high that are not finite or not in order, or so near that two times are one.
// Source: Berrut and Trefethen, "Barycentric Lagrange interpolation" (2004), "Chebyshev points of the second kind".
std::vector<double> chebyshevNodes(int count, double low, double high);

// The factor by which the polynomial through keys at these times can be more off between them than the keys are (its
// Lebesgue constant): below 5 for up to 200 Chebyshev nodes, about 2^n/(e n ln n) for n + 1 equispaced ones. The
// function returns the largest of the values halfway between each two times: a lower bound, two thirds of the constant
// for 21 equispaced ones, more for Chebyshev nodes. O(n^3): a millisecond for 100. Returns 1 for a single time.
// Refused: no times, and times that are not finite or do not increase.
double lebesgueConstant(std::span<const double> times);

// A sentence, where one polynomial through keys at these times would swing between them: where lebesgueConstant is above
// 50, as it is from 13 equispaced times on, and for fewer that are uneven. Says how much. Refused: as above.
std::optional<std::string> swingWarning(std::span<const double> times);

}  // namespace mv
