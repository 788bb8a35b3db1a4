// Integration of y' = f(t, y) by equal steps.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mv/motion/ode.h"
#include "mv/motion/ode_method.h"

namespace mv {

// For the implicit methods; RODAS has no iteration, and reads neither.
struct FixedOptions {
    // The part of a stage's error that is left when Newton's method ends, as a part of a component's size (see
    // OdeProblem::scale; without scales at least a thousandth of the largest component): 1e-13 to 1e-3.
    double newtonTolerance = 1e-12;
    // How often a step may be halved where Newton's method does not contract: 0 to 40. The halves are steps of their
    // own.
    int mostHalvings = 16;
};

// Throws Error(subject, ...) unless `step` is positive and finite and start + step is not start, and the options are in
// their ranges.
void requireSteps(std::string_view subject, double start, double step, const FixedOptions& options);

// Steps of length `step` from (start, y). The time after i steps is start + i * step, computed by one product: a sum
// t += step would be off by its roundings, in float by 2605 s after 24 hours of 1/60 s.
//
// A stepper that cannot go on stays at its last finite state, with a failure in words: an explicit method that has
// grown beyond all numbers, or a Newton's method that does not contract even in the shortest step.
// Trap: before that an explicit method with too long a step has long been wrong. stabilityLimit
// (mv/motion/ode_stability.h) tells the step; a fixed step has no error estimate. Copies go on independently, each
// with the same bits as the other.
class FixedStepper {
  public:
    // Refused: what requireProblem refuses, a step <= 0 or so short that start + step is start, a method for mechanical
    // problems where the problem is none, options outside their ranges.
    FixedStepper(OdeProblem problem, OdeMethod method, double start, double step, std::vector<double> y,
                 const FixedOptions& options = {});
    FixedStepper(const FixedStepper& other);
    FixedStepper& operator=(const FixedStepper& other);
    FixedStepper(FixedStepper&&) noexcept;
    FixedStepper& operator=(FixedStepper&&) noexcept;
    ~FixedStepper();

    // One step further. False where it gave up, now or before: nothing has changed then.
    bool step();

    std::int64_t index() const;  // how many steps were done
    double time() const;         // start + index * step
    std::span<const double> state() const;
    const OdeCounts& counts() const;
    const std::string& failure() const;  // "" while there is none

  private:
    struct State;
    std::unique_ptr<State> state_;
};

// All steps from `start` to `end`; how far it came, and what it cost. Refused: what FixedStepper refuses, end <= start,
// less than one step.
OdeResult integrateFixed(const OdeProblem& problem, OdeMethod method, double start, double end, std::int64_t steps,
                         std::vector<double> y, const FixedOptions& options = {});

}  // namespace mv
