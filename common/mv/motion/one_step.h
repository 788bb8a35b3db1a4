// One step of an explicit Runge-Kutta method and of RODAS, which integrators share.
#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "mv/motion/iteration_matrix.h"
#include "mv/motion/ode.h"
#include "mv/motion/ode_method.h"

namespace mv {

// Both have the same functions, so that what drives them is written once.
//     step      next = y after a step h from t; "", or why there is none, in words after "because"
//     error     of that step: what the embedded method has otherwise
//     accept    next becomes y: the following step starts there. Without it it starts where this one did
//     dense     the vectors c of the interpolation y + x (d + (1 - x) (c0 + x (c1 + (1 - x) c2))), where d = next - y
//               and x goes from 0 to 1; RODAS has c2 = 0
class RungeKuttaStep {
  public:
    RungeKuttaStep(const ButcherTableau& tableau, std::size_t dimension);
    std::string step(const OdeProblem& problem, double t, double h, std::span<const double> y, std::span<double> next,
                     OdeCounts& counts);
    std::span<const double> error() const { return error_; }
    void accept();
    void dense(double h, std::span<const double> y, std::span<const double> next,
               std::array<std::vector<double>, 3>& vectors) const;

  private:
    const ButcherTableau* tableau_;
    bool isFirstSameAsLast_;
    bool hasFirst_ = false;  // slopes_[0] is f(t, y)
    std::vector<std::vector<double>> slopes_;
    std::vector<double> stage_, error_;
};

class RosenbrockStep {
  public:
    RosenbrockStep(const RosenbrockCoefficients& coefficients, std::size_t dimension);
    std::string step(const OdeProblem& problem, double t, double h, std::span<const double> y, std::span<double> next,
                     OdeCounts& counts);
    std::span<const double> error() const { return u_.back(); }
    void accept() { hasFirst_ = false; }
    void dense(double h, std::span<const double> y, std::span<const double> next,
               std::array<std::vector<double>, 3>& vectors) const;

  private:
    // f, J and df/dt at (t, y).
    std::string start(const OdeProblem& problem, double t, double h, std::span<const double> y, OdeCounts& counts);

    const RosenbrockCoefficients* coefficients_;
    bool hasFirst_ = false;  // first_, timeSlope_ and J are those of (t, y)
    IterationMatrix matrix_;
    std::array<std::vector<double>, RosenbrockCoefficients::stages> u_;
    std::vector<double> first_, timeSlope_, stage_;
};

}  // namespace mv
