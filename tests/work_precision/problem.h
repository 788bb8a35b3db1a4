// The problems of docs/work-precision.md, where their errors are measured, and the truth there.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "mv/motion/ode_problems.h"

namespace mv::work_precision {

struct Problem {
    OdeCase ode;
    // Where the errors are measured, ascending, the end last: each tenth power of ten before the end, down to the first
    // transient, and, where not all happens in its logarithm, the tenths of the time. Robertson's end alone tells
    // nothing: it is a state of rest.
    std::vector<double> stops;
    // From what size on a component counts by its size: below, errors count as parts of this.
    double floor;
};

// Those of odeCases().
std::vector<Problem> problems();

// y at the stops of each problem.
using States = std::vector<std::vector<double>>;

// By another method than all that is measured, in another arithmetic, from formulas written down a second time: the
// springs' solution, and of the others linearly implicit Euler steps extrapolated to order 12, in long double, with an
// error of 1e-16 a step. Source: Deuflhard; Hairer and Wanner, "Solving Ordinary Differential Equations II", IV.9.
States computedReference(const Problem& problem);

// tests/work_precision/references.csv holds them, so that nothing need compute them again; 17 digits.
std::string referencesText(const std::vector<std::pair<std::string, States>>& references);
States committedReference(const Problem& problem);

// The largest, and the root mean square, over stops and components, of |y - reference| / max(|reference|, floor).
struct Deviation {
    double largest = 0, rootMeanSquare = 0;
    long values = 0;
};
Deviation deviationOf(const Problem& problem, const States& states, const States& reference);

}  // namespace mv::work_precision
