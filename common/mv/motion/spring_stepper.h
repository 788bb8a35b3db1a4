// Masses on springs by any method, with what damping has taken from their energy.
#pragma once
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "mv/motion/energy_momentum.h"
#include "mv/motion/ode_fixed.h"
#include "mv/motion/springs.h"

namespace mv {

// Equal steps of one of the ten methods, as FixedStepper, or of the energy-momentum method, as EnergyMomentumStepper:
// what cannot go on stays at its last finite state, with a failure in words. Copies go on independently, with the same bits.
//
// The energy that damping has taken is one more unknown, d' = sum of damping * (rate of the length)^2, which the method
// integrates as it does the others. So energy + dissipated() is what the exact motion keeps, and what it drifts is the
// method's own error.
class SpringStepper {
  public:
    // Refused: what springProblem and FixedStepper refuse.
    SpringStepper(const SpringSystem& system, OdeMethod method, double start, double step, std::vector<double> state);
    // Steps by the energy-momentum method.
    SpringStepper(const SpringSystem& system, double start, double step, std::vector<double> state);

    // One step further. False where it gave up, now or before: nothing has changed then.
    bool step();

    std::int64_t index() const;  // how many steps were done
    double time() const;         // start + index * step
    const std::vector<double>& state() const { return state_; }
    double dissipated() const { return dissipated_; }  // since the start
    const OdeCounts& counts() const;
    const std::string& failure() const;  // "" while there is none

  private:
    std::variant<FixedStepper, EnergyMomentumStepper> stepper_;
    std::vector<double> state_;
    double dissipated_ = 0;
};

// springProblem(system) with two unknowns more, so that it stays mechanical: y is the positions, s, the velocities, d,
// where d is the energy that damping has taken and s' = d, which nobody reads. Refused: what springProblem refuses.
OdeProblem dissipatingProblem(const SpringSystem& system);

}  // namespace mv
