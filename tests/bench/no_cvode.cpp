// The benchmark is built with this file where SUNDIALS is not installed.
#include "bench/cvode.h"

namespace mv::bench {

std::string cvodeVersion() { return ""; }
std::vector<work_precision::Solver> cvodeSolvers() { return {}; }

}  // namespace mv::bench
