// X32 to X35: integrators on clocks, springs and stiff problems.
#include <array>
#include <cmath>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/motion/energy_momentum.h"
#include "mv/motion/ode_adaptive.h"
#include "mv/motion/ode_fixed.h"
#include "mv/motion/ode_problems.h"
#include "support/reaction_e5.h"

using namespace mv;
using namespace mv::test;

namespace {

using Values = std::vector<double>;

constexpr double frame = 1.0 / 60;

[[maybe_unused]] const bool x32stepper = addRow([] {
    constexpr int frames = 24 * 3600 * 60;
    const OdeProblem still{.dimension = 1,
                           .slope = [](double, std::span<const double>, std::span<double> dydt) { dydt[0] = 0; },
                           .isAutonomous = true};
    FixedStepper stepper(still, OdeMethod::explicitEuler, 0, frame, {1});
    float clock = 0;
    for (int i = 0; i < frames; ++i) {
        clock += 1.0f / 60;
        stepper.step();
    }
    return Row{.id = "X32 stepper",
               .input = "24 hours of an integrator's steps of 1/60 s",
               .measured = "part by which its time is off",
               .naive = "t += 1/60 in float",
               .naiveError = std::abs(static_cast<double>(clock) / 86400 - 1),
               .ours = "FixedStepper: start + i*step in double",
               .ourError = std::abs(stepper.time() / 86400 - 1),
               .tolerance = 1e-9,
               .reason = "a frame is 2e-7 of it; the roundings of 1/60 and of a product are 2e-16"};
});

// How far the energy of an undamped spring is from its first after ten seconds of frames, at w h = wh.
Row springRow(const char* id, const char* input, double wh, const char* naive, OdeMethod usual) {
    const double w = wh / frame;
    const auto off = [&](OdeMethod method) {
        FixedStepper stepper(springCase(w, 0).problem, method, 0, frame, {1, 0});
        for (int i = 0; i < 600; ++i) {
            if (!stepper.step()) return infinite;
        }
        const auto y = stepper.state();
        return std::abs(y[0] * y[0] + y[1] * y[1] / (w * w) - 1);
    };
    return Row{.id = id,
               .input = input,
               .measured = "part by which an undamped spring's energy is off after 600 steps; inf: beyond doubles",
               .naive = naive,
               .naiveError = off(usual),
               .ours = "FixedStepper, implicit midpoint",
               .ourError = off(OdeMethod::implicitMidpoint),
               .tolerance = 1e-9,
               .reason = "600 steps of a rotation, each with some roundings of a factor of up to 17 in its matrix"};
}

[[maybe_unused]] const bool x33slow =
    addRow([] { return springRow("X33 0.17", "w h = 0.17", 0.17, "explicit Euler", OdeMethod::explicitEuler); });
[[maybe_unused]] const bool x33limit =
    addRow([] { return springRow("X33 2.01", "w h = 2.01", 2.01, "velocity Verlet", OdeMethod::velocityVerlet); });
[[maybe_unused]] const bool x33stiff = addRow([] {
    return springRow("X33 16.7", "w h = 16.7", 1000 * frame, "implicit Euler, which falls asleep",
                     OdeMethod::implicitEuler);
});

[[maybe_unused]] const bool x33rest = addRow([] {
    SpringSystem system;
    system.points = {{.mass = 1}, {.mass = 2}, {.mass = 3}};
    for (std::size_t i = 0; i < 3; ++i) {
        system.springs.push_back({.a = i, .b = (i + 1) % 3, .stiffness = 1e6, .restLength = 1});
    }
    const Values thrown = springState(std::vector<vec3>{{0, 0, 0}, {1.1, 0, 0}, {0.4, 0.95, 0.1}},
                                      std::vector<vec3>{{0, 1, 0}, {0.5, 0, 1}, {-1, 0, 0.2}});
    const auto off = [&](auto stepper) {
        double worst = 0;
        for (int i = 0; i < 600; ++i) {
            if (!stepper.step()) return infinite;
            worst = worse(worst, std::abs(springEnergy(system, stepper.state()) / springEnergy(system, thrown) - 1));
        }
        return worst;
    };
    return Row{.id = "X33 rest lengths",
               .input = "three masses on springs with rest lengths, k = 1e6, in steps of 1/60 s",
               .measured = "largest part by which the energy is off in 600 steps; inf: it gave up",
               .naive = "implicit midpoint, whose Newton steps are not halved",
               .naiveError = off(FixedStepper(springProblem(system), OdeMethod::implicitMidpoint, 0, frame, thrown,
                                              {.mostHalvings = 0})),
               .ours = "EnergyMomentumStepper",
               .ourError = off(EnergyMomentumStepper(system, 0, frame, thrown)),
               .tolerance = 1e-9,
               .reason =
                   "600 steps, each with what Newton's method leaves, 1e-14 of a length in a move, 1e3 times that in a "
                   "velocity"};
});

double largestRelative(const Values& y, const Values& reference) {
    double worst = 0;
    for (std::size_t i = 0; i < y.size(); ++i) worst = worse(worst, std::abs(y[i] / reference[i] - 1));
    return worst;
}

// Of Robertson's concentrations at the end, and of van der Pol's y; infinity where it gave up.
double largestRelative(const OdeCase& ode, OdeMethod method) {
    const OdeResult ours =
        integrateAdaptive(ode.problem, method, 0, ode.end, ode.initial, {.relative = 1e-6, .absolute = ode.absolute});
    return ours.reachedEnd() ? largestRelative(ours.y, ode.reference) : infinite;
}

// The result of a method that is not for stiff problems, and whose steps follow its error.
double whereItGaveUp(const OdeCase& ode) {
    const OdeResult result = integrateAdaptive(ode.problem, OdeMethod::dormandPrince, 0, ode.end, ode.initial,
                                               {.relative = 1e-6, .absolute = ode.absolute});
    return result.reachedEnd() ? 0 : 1 - result.t / ode.end;
}

[[maybe_unused]] const bool x34 = addRow([] {
    const OdeCase ode = robertsonCase();
    // As it is usually written, until t = 40, which is 2.5e9 times nearer than the end.
    std::array<double, 3> y{1, 0, 0};
    const auto slope = [&](const std::array<double, 3>& at) {
        std::array<double, 3> result{};
        ode.problem.slope(0, at, result);
        return result;
    };
    const auto moved = [&](double h, const std::array<double, 3>& k) {
        return std::array<double, 3>{y[0] + h * k[0], y[1] + h * k[1], y[2] + h * k[2]};
    };
    for (int i = 0; i < 40000; ++i) {
        const double h = 1e-3;
        const auto k1 = slope(y), k2 = slope(moved(h / 2, k1)), k3 = slope(moved(h / 2, k2)), k4 = slope(moved(h, k3));
        for (std::size_t c = 0; c < 3; ++c) y[c] += h / 6 * (k1[c] + 2 * k2[c] + 2 * k3[c] + k4[c]);
    }
    const OdeResult ours = integrateAdaptive(ode.problem, OdeMethod::rodas, 0, ode.end, ode.initial,
                                             {.relative = 1e-6, .absolute = ode.absolute});
    return Row{.id = "X34",
               .input = "Robertson's reaction to t = 1e11, with rates from 0.04 to 3e7",
               .measured = "largest relative error of a concentration; inf: it is no number",
               .naive = "Runge-Kutta 4 by steps of 1e-3, to t = 40 only",
               .naiveError = std::isfinite(y[0]) ? largestRelative({y[0], y[1], y[2]}, ode.reference) : infinite,
               .ours = "integrateAdaptive, RODAS at 1e-6",
               .ourError = ours.reachedEnd() ? largestRelative(ours.y, ode.reference) : infinite,
               .tolerance = 1e-5,
               .reason = "ten times the tolerance"};
});

[[maybe_unused]] const bool x34radau = addRow([] {
    const OdeCase ode = robertsonCase();
    return Row{
        .id = "X34 radau",
        .input = "the same",
        .measured = "largest relative error of a concentration; of the usual form, what part of the time it leaves out",
        .naive = "Dormand-Prince 5(4) at 1e-6, which gives up after 100000 steps and says so",
        .naiveError = whereItGaveUp(ode),
        .ours = "integrateAdaptive, Radau IIA 5 at 1e-6",
        .ourError = largestRelative(ode, OdeMethod::radau),
        .tolerance = 1e-5,
        .reason = "ten times the tolerance"};
});

// The L-stable SDIRK method of order 2 by equal steps, as it is usually written: Newton's method from the last state
// until a correction is small, and nobody looks at the way there.
Values plainSdirk(const OdeProblem& problem, Values y, double h, int steps) {
    const double g = 1 - std::sqrt(0.5);
    const auto stage = [&](const Values& constant, Values guess) {
        for (int iteration = 0; iteration < 50; ++iteration) {
            Values f(2), j(4);
            problem.slope(0, guess, f);
            problem.jacobian(0, guess, j);
            const double a = 1 - h * g * j[0], b = -h * g * j[1], c = -h * g * j[2], d = 1 - h * g * j[3];
            const double r0 = constant[0] + h * g * f[0] - guess[0], r1 = constant[1] + h * g * f[1] - guess[1];
            const double determinant = a * d - b * c, x0 = (d * r0 - b * r1) / determinant,
                         x1 = (a * r1 - c * r0) / determinant;
            guess[0] += x0;
            guess[1] += x1;
            if (std::abs(x0) + std::abs(x1) < 1e-10 * (1 + std::abs(guess[0]) + std::abs(guess[1]))) break;
        }
        return guess;
    };
    for (int i = 0; i < steps; ++i) {
        const Values first = stage(y, y);
        Values constant = y;
        for (std::size_t c = 0; c < 2; ++c) constant[c] += (1 - g) / g * (first[c] - y[c]);
        y = stage(constant, first);
    }
    return y;
}

// The largest error of the second and third substance, of their size.
double e5Error(OdeMethod method) {
    const OdeCase e5 = e5Case();
    const OdeResult result = integrateAdaptive(e5.problem, method, e5.start, e5.end, e5.initial,
                                               {.relative = 1e-6, .absolute = e5.absolute});
    if (!result.reachedEnd()) return infinite;
    return worse(std::abs(result.y[1] / e5.reference[1] - 1), std::abs(result.y[2] / e5.reference[2] - 1));
}

[[maybe_unused]] const bool x34e5 = addRow([] {
    return Row{.id = "X34 E5",
               .input = "the chemical problem E5 until t = 1e13, relative tolerance 1e-6 and absolute 1e-24",
               .measured = "relative error of the second and third substance, 8.9e-23 each",
               .naive = "RODAS: roundings of its linear systems stay in y2 - y3 - y4, which ought to be 0",
               .naiveError = e5Error(OdeMethod::rodas),
               .ours = "Radau IIA 5",
               .ourError = e5Error(OdeMethod::radau),
               .tolerance = 0.01,
               .reason =
                   "the reference is printed by the Test Set for IVP Solvers, where the two, which ought to be equal, "
                   "are 0.0015 apart"};
});

[[maybe_unused]] const bool x35 = addRow([] {
    const OdeCase ode = vanDerPolCase(1e-6);
    const OdeResult ours =
        integrateAdaptive(ode.problem, OdeMethod::rodas, 0, ode.end, ode.initial, {.relative = 1e-6, .absolute = 1e-9});
    return Row{.id = "X35",
               .input = "van der Pol's oscillator with eps = 1e-6 at t = 2",
               .measured = "error of y, which is 1.706; inf: it gave up",
               .naive = "SDIRK of order 2 by 2000 equal steps, Newton's method from the last state",
               .naiveError = std::abs(plainSdirk(ode.problem, ode.initial, 1e-3, 2000)[0] - ode.reference[0]),
               .ours = "integrateAdaptive, RODAS at 1e-6",
               .ourError = ours.reachedEnd() ? std::abs(ours.y[0] - ode.reference[0]) : infinite,
               .tolerance = 1e-5,
               .reason = "ten times the tolerance"};
});

[[maybe_unused]] const bool x35radau = addRow([] {
    const OdeCase ode = vanDerPolCase(1e-6);
    return Row{.id = "X35 radau",
               .input = "the same",
               .measured = "largest relative error of y and y'; of the usual form, what part of the time it leaves out",
               .naive = "Dormand-Prince 5(4) at 1e-6, which gives up after 100000 steps and says so",
               .naiveError = whereItGaveUp(ode),
               .ours = "integrateAdaptive, Radau IIA 5 at 1e-6",
               .ourError = largestRelative(ode, OdeMethod::radau),
               .tolerance = 1e-5,
               .reason = "ten times the tolerance"};
});

[[maybe_unused]] const bool x35branch = addRow([] {
    const OdeCase ode = vanDerPolCase(1e-6);
    double naive = 0, ours = 0;
    for (const int steps : {200, 2000, 20000}) {
        const double y = plainSdirk(ode.problem, ode.initial, 2.0 / steps, steps)[0];
        naive = worse(naive, std::max(0.0, std::abs(y) - 2.02));
        FixedStepper stepper(ode.problem, OdeMethod::bdf2, 0, 2.0 / steps, ode.initial);
        while (stepper.index() < steps && stepper.step()) {
            ours = worse(ours, std::max(0.0, std::abs(stepper.state()[0]) - 2.02));
        }
    }
    return Row{.id = "X35 branch",
               .input = "the same by 200, 2000 and 20000 equal steps",
               .measured = "how far y comes outside -2.02 to 2.02, which it never leaves",
               .naive = "SDIRK of order 2, Newton's method from the last state, at the end",
               .naiveError = naive,
               .ours = "FixedStepper, BDF2, in all steps: Newton's method must contract, or the step is halved",
               .ourError = ours,
               .tolerance = 0,
               .reason = "on the branch or not"};
});

}  // namespace
