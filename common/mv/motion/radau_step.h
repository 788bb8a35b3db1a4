// One step of Radau IIA of order 5, which the integrators with equal and with chosen steps share.
#pragma once
#include <array>
#include <complex>
#include <span>
#include <string>
#include <vector>

#include "mv/motion/iteration_matrix.h"
#include "mv/motion/ode.h"

namespace mv {

// The bounds at which a step's Newton method ends, and by which its error is told.
struct RadauTolerance {
    double relative;
    double absolute;  // 0: by OdeProblem::scale, or else a thousandth of the largest component, instead
    double newton;    // which part of both may be left in the stages
    int mostIterations;
};

// The three stages are transformed so that a simplified Newton iteration solves one real and one complex system of the
// problem's own dimension, in place of one three times as large. The iteration must contract, and so fast that the
// iterations that are left reach the tolerance; else there is no step. J is kept from step to step while it contracts a
// thousandfold, its factors while h is kept, too. The functions are those of RungeKuttaStep in one_step.h; the
// interpolation is that of collocation, of order 3. Source: Hairer and Wanner, "Solving Ordinary Differential Equations
// II", 2nd ed., IV.8; their code RADAU5.
class RadauStep {
  public:
    RadauStep(const RadauTolerance& tolerance, std::size_t dimension);
    std::string step(const OdeProblem& problem, double t, double h, std::span<const double> y, std::span<double> next,
                     OdeCounts& counts);
    // That of an embedded formula of order 3, damped where it is stiff: so it does not fall like h^5.
    std::span<const double> error() const { return error_; }
    void accept();
    void dense(double h, std::span<const double> y, std::span<const double> next,
               std::array<std::vector<double>, 3>& vectors) const;

    // How hard the last step was, for who chooses the next one: iterations of Newton's method, and whether J is to be
    // kept.
    int iterations() const { return iterations_; }
    int mostIterations() const { return tolerance_.mostIterations; }
    bool keepsJacobian() const { return rate_ <= fastEnough; }

  private:
    static constexpr double fastEnough = 1e-3;

    void weigh(const OdeProblem& problem, std::span<const double> y);
    double weighted(std::span<const double> x) const;
    void guess(double h);
    std::string iterate(const OdeProblem& problem, double t, double h, std::span<const double> y, OdeCounts& counts);
    void estimate(const OdeProblem& problem, double t, double h, std::span<const double> y, OdeCounts& counts);

    RadauTolerance tolerance_;
    IterationMatrix matrix_;
    bool hasFirst_ = false;    // first_ is f(t, y)
    bool isCurrent_ = false;   // J is that of (t, y)
    bool isRepeated_ = false;  // the step before was not accepted
    bool isFirstStep_ = true;  // none has been accepted
    double rate_ = 1;          // by which the last iteration contracted
    double remaining_ = 1;     // what is left of an error after a correction, in units of it
    double lastStep_ = 0;      // the length of the one accepted last, whose polynomial foretells the stages
    double takenStep_ = 0;     // of the one tried last
    int iterations_ = 0;
    std::array<std::vector<double>, 3> stages_;       // less y
    std::array<std::vector<double>, 3> transformed_;  // of the stages
    std::array<std::vector<double>, 3> slopes_;
    std::array<std::vector<double>, 3> before_;  // divided differences of the last step's polynomial, from its end
    std::vector<double> first_, weights_, argument_, error_, filtered_;
    std::vector<std::complex<double>> pair_;
};

}  // namespace mv
