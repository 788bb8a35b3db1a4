// The energy-momentum method for masses on springs: what the exact motion keeps its steps keep, however stiff it is.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mv/motion/implicit_stage.h"
#include "mv/motion/ode_fixed.h"
#include "mv/motion/springs.h"

namespace mv {

// Steps of a discrete gradient method of order 2: positions move by the mean of the two velocities, and each spring
// pulls along the mean of its two vectors by stiffness * (mean of its two lengths - restLength) + damping * (change
// of length)/step. So energy, plus what damping has taken, plus both momenta (without gravity and fixed points) are
// kept but for what Newton's method leaves and rounding. With rest lengths 0 it is the implicit midpoint rule; with
// others that rule keeps the momenta alone, and its energy runs away where steps are long. Keeping energy does not
// make it exact: a vibration much faster than the steps has the wrong phase. Springs that cannot go on stay where they
// are, with a failure in words, as in FixedStepper; so do halved steps and time. Source: Simo and Tarnow, "The discrete
// energy-momentum method", ZAMP 43 (1992); Gonzalez, "Time integration and discrete Hamiltonian systems", J. Nonlinear
// Sci. 6 (1996).
class EnergyMomentumStepper {
  public:
    // Refused: what requireSprings refuses, a step <= 0 or so short that start + step is start, options outside their
    // ranges.
    EnergyMomentumStepper(SpringSystem system, double start, double step, std::vector<double> state,
                          const FixedOptions& options = {.newtonTolerance = 1e-13});

    // One step further. False where it gave up, now or before: nothing has changed then.
    bool step();

    std::int64_t index() const { return index_; }
    double time() const { return start_ + static_cast<double>(index_) * step_; }
    std::span<const double> state() const { return state_; }
    double dissipated() const { return dissipated_; }  // energy that damping has taken since the start: 0 or more
    const OdeCounts& counts() const { return counts_; }
    const std::string& failure() const { return failure_; }

  private:
    std::string whole(double h, std::vector<double>& state, double& dissipated);
    std::string halved(double h, std::vector<double>& state, double& dissipated, int depth);

    SpringSystem system_;
    double start_, step_;
    std::vector<double> state_;
    int mostHalvings_;
    ImplicitStage stage_;
    std::int64_t index_ = 0;
    double dissipated_ = 0;
    OdeCounts counts_;
    std::string failure_;
};

}  // namespace mv
