// One implicit stage by Newton's method, which integrators share.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "mv/motion/iteration_matrix.h"
#include "mv/motion/ode.h"

namespace mv {

// Solves Y = constant + g f(t, Y) for Y by a simplified Newton's method, from the guess that y holds.
//
// Y is right when the last correction is at most `tolerance` of each component's size, and before it the residual at
// most what an error of that size makes of it: a small correction by a bad matrix is no root. Corrections must shrink
// to a half or less each time (to a tenth, or J is evaluated anew). So the iteration stays in a ball about the guess
// in which it contracts and that has one root only: it cannot land, without a word, on a far root of another branch,
// as Newton's method left to itself does on stiff problems with long steps.
// Source: Deuflhard, "Newton Methods for Nonlinear Problems" (2004), chapter 2; Hairer and Wanner II, IV.8.
class ImplicitStage {
  public:
    explicit ImplicitStage(double tolerance) : tolerance_(tolerance) {}

    // "" where y is the root now; else why not, in words after "because", and y is of no use.
    std::string solve(const OdeProblem& problem, double t, double g, std::span<const double> constant,
                      std::span<double> y, OdeCounts& counts);

  private:
    std::string attempt(const OdeProblem& problem, double t, double g, std::span<const double> constant,
                        std::span<double> y, OdeCounts& counts, bool& isOld);
    // J at y, where f is `slope`, and the factors of I/g - J.
    std::string makeMatrix(const OdeProblem& problem, double t, double g, std::span<const double> y,
                           std::span<const double> slope, OdeCounts& counts);

    double tolerance_;
    IterationMatrix matrix_;  // kept from step to step: a linear problem needs one
    double matrixG_ = 0;      // the g that it was made for
};

}  // namespace mv
