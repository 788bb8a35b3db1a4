// How long a step may be: what methods make of y' = lambda y, z = h lambda.
#pragma once
#include <complex>
#include <span>
#include <vector>

#include "mv/motion/ode.h"
#include "mv/motion/ode_method.h"

namespace mv {

// R(z): a step multiplies the solution of y' = lambda y by R(h lambda). For BDF2, whose two steps have two such
// factors, the larger one. Infinity (real) at a pole, and where R is beyond all doubles. Off by some roundings of the
// largest term of the sum, so near 1e-16 where R itself vanishes at infinity. Refused: NaN, infinity, symplectic Euler
// and velocity Verlet, which do different things to q and v: ask amplification. Source: Hairer and Wanner, "Solving
// Ordinary Differential Equations II", 2nd ed., IV.2, IV.3, IV.7, V.1.
std::complex<double> stabilityFunction(OdeMethod method, std::complex<double> z);

// The factor by which a step multiplies the solution in the long run: |R(z)|, or, of symplectic Euler and velocity
// Verlet, the largest absolute eigenvalue of the step on the oscillator q'' = -|lambda|^2 q + 2 Re(lambda) q' that has
// the eigenvalues lambda and its conjugate. The method is stable at z where it is at most 1. Refused: NaN, infinity.
// Trap: where such a step has a double eigenvalue, errors of 1e-16 in it show as 1e-8.
double amplification(OdeMethod method, std::complex<double> z);
// The same of an oscillator with those two eigenvalues, times the step: a conjugate pair, or two real ones, as it has where
// its damping is beyond critical. Symplectic Euler and velocity Verlet do to one what depends on the other, too. Refused:
// others, NaN, infinity.
double amplification(OdeMethod method, std::complex<double> z, std::complex<double> partner);

// The largest w h for which the undamped oscillation q'' = -w^2 q does not grow, nor for any shorter step: 2 for
// symplectic Euler and velocity Verlet, 2 sqrt 2 for Runge-Kutta 4, 0 for explicit Euler and midpoint, infinity for the
// A-stable ones. Exact to 1e-6 of it.
double stabilityLimit(OdeMethod method);

// The eigenvalues of the problem's Jacobian at (t, y), as many as it has dimensions, each as often as it is one; largest
// first. Times the step they are the z of above. Costs some 10 dimension^3 operations; what rows and columns of zeros take
// out of it (points that are fixed, directions in which nothing pulls) costs nothing. Off by some roundings of the largest
// for each dimension; but one that is defective, as the 0 of a free mass is, by some 1e-8 of it. Refused: what
// requireProblem refuses, and a Jacobian that is not finite.
std::vector<std::complex<double>> eigenvalues(const OdeProblem& problem, double t, std::span<const double> y);

}  // namespace mv
