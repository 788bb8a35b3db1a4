// Boost.Odeint's rosenbrock4 behind plain types: uBLAS of Boost 1.74, its matrices, does not compile as C++20.
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace mv::work_precision {

struct Rosenbrock4Problem {
    std::size_t dimension;
    std::function<void(double t, const double* y, double* slope)> slope;
    std::function<void(double t, const double* y, double* jacobian)> jacobian;  // row by row; zeros before the call
    std::vector<double> initial, stops;                                         // autonomous, from t = 0
};
struct Rosenbrock4Outcome {
    std::string failure;
    std::vector<std::vector<double>> states;
    long accepted = 0, rejected = 0;
};
Rosenbrock4Outcome rosenbrock4(const Rosenbrock4Problem& problem, double relative, double absolute, long mostSteps);

}  // namespace mv::work_precision
