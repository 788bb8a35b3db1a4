// The chemical problem E5, whose values fall through twenty powers of ten: none of those that docs/work-precision.md measures.
#pragma once
#include <algorithm>
#include <array>
#include <span>

#include "mv/motion/ode_problems.h"

namespace mv::test {

// Four substances until t = 1e13; y2 - y3 - y4 stays 0. Source: "Test Set for Initial Value Problem Solvers" (Mazzia and
// Magherini, 2008), with the reference, whose y2 and y3 are 0.0015 apart though they ought to be equal but for y4.
inline OdeCase e5Case() {
    static constexpr double a = 7.89e-10, b = 1.1e7, c = 1.13e3, mc = 1e6 * c;
    OdeCase e5{.name = "E5",
               .problem = {},
               .start = 0,
               .end = 1e13,
               .initial = {1.76e-3, 0, 0, 0},
               .reference = {0.1152903278711829e-290, 0.8867655517642120e-22, 0.8854814626268838e-22, 0},
               .absolute = 1e-24};
    e5.problem.dimension = 4;
    // The third as a difference of the others, as that source's own program has it: so f keeps y2 - y3 - y4 to a rounding.
    e5.problem.slope = [](double, std::span<const double> y, std::span<double> dydt) {
        dydt[0] = -a * y[0] - b * y[0] * y[2];
        dydt[1] = a * y[0] - mc * y[1] * y[2];
        dydt[3] = b * y[0] * y[2] - c * y[3];
        dydt[2] = dydt[1] - dydt[3];
    };
    e5.problem.jacobian = [](double, std::span<const double> y, std::span<double> matrix) {
        std::array<std::array<double, 4>, 4> rows{
            {{-a - b * y[2], 0, -b * y[0], 0}, {a, -mc * y[2], -mc * y[1], 0}, {}, {b * y[2], 0, b * y[0], -c}}};
        for (std::size_t i = 0; i < 4; ++i) rows[2][i] = rows[1][i] - rows[3][i];
        for (std::size_t i = 0; i < 4; ++i) std::ranges::copy(rows[i], matrix.begin() + std::ptrdiff_t(4 * i));
    };
    e5.problem.isAutonomous = true;
    return e5;
}

}  // namespace mv::test
