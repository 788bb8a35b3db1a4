// Integration of y' = f(t, y) by steps that follow a tolerance.
#pragma once
#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "mv/motion/ode.h"
#include "mv/motion/ode_method.h"

namespace mv {

// A step that was accepted, with the solution anywhere in it: of order 4 by Dormand-Prince, 3 by RODAS and Radau.
// The step is valid while the observer that got it runs.
class AcceptedStep {
  public:
    AcceptedStep(double from, double to, std::span<const double> before, std::span<const double> after,
                 const std::array<std::vector<double>, 3>& vectors)
        : from_(from), to_(to), before_(before), after_(after), vectors_(&vectors) {}

    double from() const { return from_; }
    double to() const { return to_; }
    std::span<const double> state() const { return after_; }  // at `to`

    // y at time t of the step. Refused: t outside it; a result of another size than the state.
    void at(double t, std::span<double> y) const;

  private:
    double from_, to_;
    std::span<const double> before_, after_;
    const std::array<std::vector<double>, 3>* vectors_;
};

struct AdaptiveOptions {
    // The estimated error of a step stays below absolute + relative |y_i| for each component i. The error at the end is
    // often some times that, and more where the problem itself spreads errors. Radau's estimate is of a much lower order
    // than its step: it stays below 0.1 relative^(2/3), and the absolute one in proportion, which makes the same error at
    // the end.
    double relative = 1e-6;  // 1e-13 to 0.1: below, roundings take over
    double absolute = 1e-9;  // above 0: from which size on a component matters
    // 0: chosen from f. Else tried first.
    double firstStep = 0;
    // Tried steps, accepted or not, after which it gives up.
    std::int64_t mostSteps = 100000;
    // Times at which steps end, ascending, at most the end: OdeResult::atStops has the states there.
    std::vector<double> stops = {};
    // Called after each accepted step, in order.
    std::function<void(const AcceptedStep&)> observe = {};
};

// From `start` to `end` by Dormand-Prince, RODAS or Radau, whose steps a controller chooses: a PI controller, and of
// Radau a predictive one. Gives up in words where a step would be shorter than 16 ulp of t (the solution ends, or the
// tolerance asks for more than doubles have), or after mostSteps (mostly an explicit method on a stiff problem). Each
// reason names the step that failed last.
// Trap: only errors of single steps are estimated. A coarse answer may be wrong altogether without a word where the
// problem itself spreads them: see confirmAdaptive. Trap: a sum that the problem keeps, a mass say, drifts by the
// roundings of the linear systems, times the step; Radau, whose Newton's method corrects itself, has less than a
// thousandth of RODAS' drift. A component that has become as small as that is wrong, and neither a step's error nor
// confirmAdaptive shows it: so it is in the reaction E5, from 1e-3 down to 1e-22. Refused: what requireProblem refuses,
// other methods, end <= start, options outside their ranges. Source of the control: Gustafsson; Hairer and Wanner II,
// IV.2. Of the first step: Hairer, Norsett and Wanner I, II.4.
OdeResult integrateAdaptive(const OdeProblem& problem, OdeMethod method, double start, double end,
                            std::vector<double> y, const AdaptiveOptions& options = {});

struct Confirmation {
    double difference = 0;   // the largest of a component, as a part of its size
    std::string doubt = {};  // why the result is not to be believed; "" where it is
    OdeCounts counts = {};   // what it cost to know
};
// Whether what integrateAdaptive answered to the same arguments can be believed: it integrates once more, by a tenth of both
// tolerances, and compares y at the stops and at the end. There is a doubt where a component differs by more than `allowed`
// of its size, which is at least absolute / relative, or where the second run gives up.
// Trap: two wrong answers that are alike raise none; nor does what is below absolute / relative.
// Refused: a result that did not reach the end, a relative tolerance below 1e-12, `allowed` not above 0.
// Source of the rule: Shampine, "Tolerance proportionality in ODE codes" (1989).
Confirmation confirmAdaptive(const OdeProblem& problem, OdeMethod method, double start, double end,
                             std::vector<double> y, const AdaptiveOptions& options, const OdeResult& result,
                             double allowed = 0.5);

}  // namespace mv
