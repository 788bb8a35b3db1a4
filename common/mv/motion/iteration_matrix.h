// The matrix s I - J of implicit methods, J = df/dy, factorized, which integrators share.
#pragma once
#include <memory>
#include <span>

#include "mv/motion/ode.h"

namespace mv {

// Copies share what was factorized, which nobody changes: a copied integrator goes on with the same bits.
class IterationMatrix {
  public:
    // Evaluates J at (t, y), where f is `slope`; by differences that look `span` ahead where the problem has none.
    // False where it is not finite; there is then no matrix.
    bool evaluate(const OdeProblem& problem, double t, std::span<const double> y, std::span<const double> slope,
                  double span, OdeCounts& counts);
    // Factorizes s I - J, unless it is so already. False where it is singular; there is then no matrix.
    bool factorize(double s, OdeCounts& counts);
    // There is a matrix, whatever its s.
    bool exists() const { return parts_ != nullptr; }
    // x becomes (s I - J)^-1 x.
    void solve(std::span<double> x) const;
    // result_i = sum_j |s I - J|_ij w_j: how large row i is for a vector of the sizes w.
    void rowSizes(std::span<const double> w, std::span<double> result) const;

  private:
    struct Parts;
    std::shared_ptr<Parts> parts_;
};

}  // namespace mv
