// CVODE of SUNDIALS, for docs/work-precision.md; where the benchmark is built without it, isThere is false.
#pragma once
#include "work_precision/solver.h"

namespace mv::bench {

// "6.4.1"; "" where there is none.
std::string cvodeVersion();

// Backward differentiation of orders 1 to 5 with Newton's method, for stiff problems; Adams' methods of orders 1 to 12 with
// fixed points, for the others. Jacobians analytic where the problem has one; dense, and the chain's as a band in its best
// order. Its memory is made beforehand, and between stops it interpolates: both are in its favour.
std::vector<work_precision::Solver> cvodeSolvers();

}  // namespace mv::bench
