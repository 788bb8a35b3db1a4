// The matrix s I - J of implicit methods, J = df/dy, factorized, which integrators share.
#pragma once
#include <complex>
#include <memory>
#include <span>
#include <vector>

#include "mv/motion/ode.h"

namespace mv {

// Copies share what was factorized, which nobody changes: a copied integrator goes on with the same bits.
//
// The matrix is eliminated row by row (mv/motion/linear_factors.h): a dense one whole, n^3 products; a sparse one as a
// band, its rows and columns in the order of Cuthill and McKee, n w^2 products for w diagonals on each side (a chain of
// masses has 3).
class IterationMatrix {
  public:
    // Evaluates J at (t, y), where f is `slope`; by differences that look `span` ahead where the problem has none.
    // False where it is not finite; there is then no matrix.
    bool evaluate(const OdeProblem& problem, double t, std::span<const double> y, std::span<const double> slope,
                  double span, OdeCounts& counts);
    // Factorizes s I - J, unless it is so already. False where it is singular; there is then no matrix.
    bool factorize(double s, OdeCounts& counts);
    // The same with a complex s, beside the real one: each of the two stands until it is made anew or J is.
    bool factorize(std::complex<double> s, OdeCounts& counts);
    // There is a matrix, whatever its s.
    bool exists() const { return parts_ != nullptr; }
    // x becomes (s I - J)^-1 x.
    void solve(std::span<double> x) const;
    void solve(std::span<std::complex<double>> x) const;
    // result_i = sum_j |s I - J|_ij w_j: how large row i is for a vector of the sizes w.
    void rowSizes(std::span<const double> w, std::span<double> result) const;

  private:
    struct Parts;
    template <typename T>
    bool factorizeAt(T s, OdeCounts& counts);
    std::shared_ptr<Parts> parts_;
    // A right-hand side in the order of a band: each copy's own.
    mutable std::vector<double> ordered_;
    mutable std::vector<std::complex<double>> complexOrdered_;
};

}  // namespace mv
