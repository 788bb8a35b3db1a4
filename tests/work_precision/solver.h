// The integrators that docs/work-precision.md compares: integrators, run through a problem's stops.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "mv/motion/ode.h"
#include "mv/motion/ode_method.h"
#include "work_precision/problem.h"

namespace mv::work_precision {

struct Outcome {
    std::string failure;  // "" where it reached the end
    States states;        // at the stops that were reached
    OdeCounts counts;
};

struct Solver {
    std::string name;
    // Tolerances, each relative and, times the problem's floor, absolute; or the numbers of equal steps between two stops.
    bool hasTolerance;
    std::vector<double> parameters;
    // Whether it can be tried at all; "" or why not.
    std::function<std::string(const Problem& problem, double parameter)> refusal;
    // A run: what is made before it costs no time.
    std::function<std::function<Outcome()>(const Problem& problem, double parameter)> prepare;
};

// 1e-2 to 1e-12, of which the last two let all curves reach an error of 1e-9; 10 to 10000.
std::vector<double> tolerances();
std::vector<double> stepNumbers();

// How many steps, accepted or not, each solver may try.
inline constexpr long mostSteps = 200000;

// Ours, one for each of odeMethods.
std::vector<Solver> ourSolvers();
// Boost.Odeint's rosenbrock4 with its own step control. Its matrices are dense, and eliminated by uBLAS.
Solver odeintRosenbrock();

}  // namespace mv::work_precision
