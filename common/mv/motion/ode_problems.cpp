#include "mv/motion/ode_problems.h"

#include <array>
#include <cmath>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/types.h"

namespace mv {
namespace {

using State = std::span<const double>;
using Result = std::span<double>;

}  // namespace

OdeCase springCase(double w, double ratio) {
    requirePositive("springCase", "w", w);
    if (!(ratio >= 0 && ratio < 1)) throw Error("springCase", "the ratio must be 0 to below 1", numberText(ratio));
    const double damping = ratio * w, damped = w * std::sqrt(1 - ratio * ratio), end = 10 / w;
    const double shrunk = std::exp(-damping * end), c = std::cos(damped * end), s = std::sin(damped * end);
    return {.name = ratio == 0 ? "undamped spring" : "damped spring",
            .problem = {.dimension = 2,
                        .slope =
                            [=](double, State y, Result dydt) {
                                dydt[0] = y[1];
                                dydt[1] = -w * w * y[0] - 2 * damping * y[1];
                            },
                        .jacobian =
                            [=](double, State, Result j) {
                                j[1] = 1;
                                j[2] = -w * w;
                                j[3] = -2 * damping;
                            },
                        .isMechanical = true,
                        .isVelocityFree = ratio == 0,
                        .isAutonomous = true},
            .start = 0,
            .end = end,
            .initial = {1, 0},
            .reference = {shrunk * (c + damping / damped * s), -shrunk * w * w / damped * s},
            .absolute = 1e-9};
}

OdeCase chainCase() {
    constexpr std::size_t n = 100;
    constexpr double stiff = 1e6, soft = 1, damping = 1000;
    // Spring i joins mass i - 1 (or the wall) to mass i (or the wall); the odd ones are stiff.
    const auto stiffness = [](std::size_t i) { return i % 2 == 1 ? stiff : soft; };
    const auto dampingOf = [](std::size_t i) { return i % 2 == 1 ? damping : 0; };
    OdeCase chain{.name = "stiff chain",
                  .problem = {},
                  .start = 0,
                  .end = 10,
                  .initial = std::vector<double>(2 * n),
                  .reference = {},
                  .absolute = 1e-9};
    chain.problem.dimension = 2 * n;
    chain.problem.isMechanical = chain.problem.isAutonomous = true;
    chain.problem.slope = [=](double, State y, Result dydt) {
        double before = stiffness(0) * y[0];  // the pull of the spring at the left
        for (std::size_t i = 0; i < n; ++i) {
            const double q = i + 1 < n ? y[i + 1] : 0, v = i + 1 < n ? y[n + i + 1] : 0;
            const double after = stiffness(i + 1) * (q - y[i]) + dampingOf(i + 1) * (v - y[n + i]);
            dydt[i] = y[n + i];
            dydt[n + i] = after - before;
            before = after;
        }
    };
    chain.problem.sparseJacobian = [=](double, State, std::vector<MatrixEntry>& entries) {
        const int count = static_cast<int>(n);
        for (int i = 0; i < count; ++i) {
            const auto at = static_cast<std::size_t>(i);
            entries.push_back({i, count + i, 1});
            entries.push_back({count + i, i, -stiffness(at) - stiffness(at + 1)});
            entries.push_back({count + i, count + i, -dampingOf(at) - dampingOf(at + 1)});
            for (const auto& [other, spring] : {std::pair(i - 1, at), std::pair(i + 1, at + 1)}) {
                if (other < 0 || other == count) continue;
                entries.push_back({count + i, other, stiffness(spring)});
                if (dampingOf(spring) > 0) entries.push_back({count + i, count + other, dampingOf(spring)});
            }
        }
    };
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t pair = i / 2;
        chain.initial[i] = std::sin(pi * (static_cast<double>(pair) + 0.5) / (static_cast<double>(n) / 2));
    }
    return chain;
}

OdeCase robertsonCase() {
    return {.name = "Robertson",
            .problem = {.dimension = 3,
                        .slope =
                            [](double, State y, Result dydt) {
                                const double slow = 0.04 * y[0], fast = 1e4 * y[1] * y[2], fastest = 3e7 * y[1] * y[1];
                                dydt[0] = fast - slow;
                                dydt[1] = slow - fast - fastest;
                                dydt[2] = fastest;
                            },
                        .jacobian =
                            [](double, State y, Result j) {
                                const double by1 = 1e4 * y[2], by2 = 1e4 * y[1], square = 6e7 * y[1];
                                j[0] = -0.04, j[1] = by1, j[2] = by2;
                                j[3] = 0.04, j[4] = -by1 - square, j[5] = -by2;
                                j[7] = square;
                            },
                        .isAutonomous = true},
            .start = 0,
            .end = 1e11,
            .initial = {1, 0, 0},
            .reference = {0.2083340149701255e-7, 0.8333360770334713e-13, 0.9999999791665050},
            .absolute = 1e-19};
}

OdeCase vanDerPolCase(double eps) {
    requirePositive("vanDerPolCase", "eps", eps);
    OdeCase oscillator{.name = "van der Pol",
                       .problem = {.dimension = 2,
                                   .slope =
                                       [=](double, State y, Result dydt) {
                                           dydt[0] = y[1];
                                           dydt[1] = ((1 - y[0] * y[0]) * y[1] - y[0]) / eps;
                                       },
                                   .jacobian =
                                       [=](double, State y, Result j) {
                                           j[1] = 1;
                                           j[2] = (-2 * y[0] * y[1] - 1) / eps;
                                           j[3] = (1 - y[0] * y[0]) / eps;
                                       },
                                   .isAutonomous = true},
                       .start = 0,
                       .end = 2,
                       .initial = {2, 0},
                       .reference = {},
                       .absolute = 1e-9};
    if (eps == 1e-6) oscillator.reference = {1.706167732170469, -0.8928097010248125};
    return oscillator;
}

OdeCase hiresCase() {
    return {.name = "HIRES",
            .problem = {.dimension = 8,
                        .slope =
                            [](double, State y, Result dydt) {
                                const double bound = 280 * y[5] * y[7];
                                dydt[0] = -1.71 * y[0] + 0.43 * y[1] + 8.32 * y[2] + 0.0007;
                                dydt[1] = 1.71 * y[0] - 8.75 * y[1];
                                dydt[2] = -10.03 * y[2] + 0.43 * y[3] + 0.035 * y[4];
                                dydt[3] = 8.32 * y[1] + 1.71 * y[2] - 1.12 * y[3];
                                dydt[4] = -1.745 * y[4] + 0.43 * y[5] + 0.43 * y[6];
                                dydt[5] = -bound + 0.69 * y[3] + 1.71 * y[4] - 0.43 * y[5] + 0.69 * y[6];
                                dydt[6] = bound - 1.81 * y[6];
                                dydt[7] = -bound + 1.81 * y[6];
                            },
                        .jacobian =
                            [](double, State y, Result j) {
                                const auto set = [&](std::size_t row, std::size_t column, double value) {
                                    j[8 * row + column] = value;
                                };
                                set(0, 0, -1.71), set(0, 1, 0.43), set(0, 2, 8.32);
                                set(1, 0, 1.71), set(1, 1, -8.75);
                                set(2, 2, -10.03), set(2, 3, 0.43), set(2, 4, 0.035);
                                set(3, 1, 8.32), set(3, 2, 1.71), set(3, 3, -1.12);
                                set(4, 4, -1.745), set(4, 5, 0.43), set(4, 6, 0.43);
                                set(5, 3, 0.69), set(5, 4, 1.71), set(5, 5, -280 * y[7] - 0.43);
                                set(5, 6, 0.69), set(5, 7, -280 * y[5]);
                                set(6, 5, 280 * y[7]), set(6, 6, -1.81), set(6, 7, 280 * y[5]);
                                set(7, 5, -280 * y[7]), set(7, 6, 1.81), set(7, 7, -280 * y[5]);
                            },
                        .isAutonomous = true},
            .start = 0,
            .end = 321.8122,
            .initial = {1, 0, 0, 0, 0, 0, 0, 0.0057},
            .reference = {0.7371312573325668e-3, 0.1442485726316185e-3, 0.5888729740967575e-4, 0.1175651343283149e-2,
                          0.2386356198831331e-2, 0.6238968252742796e-2, 0.2849998395185769e-2, 0.2850001604814231e-2},
            .absolute = 1e-10};
}

OdeCase oregonatorCase() {
    return {.name = "Oregonator",
            .problem = {.dimension = 3,
                        .slope =
                            [](double, State y, Result dydt) {
                                dydt[0] = 77.27 * (y[1] + y[0] * (1 - 8.375e-6 * y[0] - y[1]));
                                dydt[1] = (y[2] - (1 + y[0]) * y[1]) / 77.27;
                                dydt[2] = 0.161 * (y[0] - y[2]);
                            },
                        .jacobian =
                            [](double, State y, Result j) {
                                j[0] = 77.27 * (1 - 2 * 8.375e-6 * y[0] - y[1]), j[1] = 77.27 * (1 - y[0]), j[2] = 0;
                                j[3] = -y[1] / 77.27, j[4] = -(1 + y[0]) / 77.27, j[5] = 1 / 77.27;
                                j[6] = 0.161, j[7] = 0, j[8] = -0.161;
                            },
                        .isAutonomous = true},
            .start = 0,
            .end = 360,
            .initial = {1, 2, 3},
            .reference = {0.1000814870318523e1, 0.1228178521549917e4, 0.1320554942846706e3},
            .absolute = 1e-9};
}

OdeCase pleiadesCase() {
    constexpr std::size_t n = 7;
    return {
        .name = "Pleiades",
        .problem = {.dimension = 4 * n,
                    .slope =
                        [](double, State y, Result dydt) {
                            // x and y of all stars, then their velocities; star i has the mass i + 1.
                            for (std::size_t i = 0; i < n; ++i) {
                                double ax = 0, ay = 0;
                                for (std::size_t j = 0; j < n; ++j) {
                                    if (j == i) continue;
                                    const double dx = y[j] - y[i], dy = y[n + j] - y[n + i], r2 = dx * dx + dy * dy;
                                    const double pull = static_cast<double>(j + 1) / (r2 * std::sqrt(r2));
                                    ax += pull * dx;
                                    ay += pull * dy;
                                }
                                dydt[i] = y[2 * n + i];
                                dydt[n + i] = y[3 * n + i];
                                dydt[2 * n + i] = ax;
                                dydt[3 * n + i] = ay;
                            }
                        },
                    .isMechanical = true,
                    .isVelocityFree = true,
                    .isAutonomous = true},
        .start = 0,
        .end = 3,
        .initial = {3, 3, -1, -3, 2, -2, 2, 3, -3, 2, 0, 0, -4, 4, 0, 0, 0, 0, 0, 1.75, -1.5, 0, 0, 0, -1.25, 1, 0, 0},
        .reference = {0.3706139143970502,    0.3237284092057233e1,  -0.3222559032418324e1, 0.6597091455775310,
                      0.3425581707156584,    0.1562172101400631e1,  -0.7003092922212495,   -0.3943437585517392e1,
                      -0.3271380973972550e1, 0.5225081843456543e1,  -0.2590612434977470e1, 0.1198213693392275e1,
                      -0.2429682344935824,   0.1091449240428980e1,  0.3417003806314313e1,  0.1354584501625501e1,
                      -0.2590065597810775e1, 0.2025053734714242e1,  -0.1155815100160448e1, -0.8072988170223021,
                      0.5952396354208710,    -0.3741244961234010e1, 0.3773459685750630,    0.9386858869551073,
                      0.3667922227200571,    -0.3474046353808490,   0.2344915448180937e1,  -0.1947020434263292e1},
        .absolute = 1e-9};
}

std::vector<OdeCase> odeCases() {
    return {springCase(1, 0),    springCase(1, 0.1), chainCase(),      robertsonCase(),
            vanDerPolCase(1e-6), hiresCase(),        oregonatorCase(), pleiadesCase()};
}

}  // namespace mv
