// The readouts of springs, and its study: where the net is after half a second, by method and step, and how its
// energy is off.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mv/demo/lesson.h"
#include "mv/demo/read_number.h"
#include "mv/formatted.h"
#include "mv/motion/ode_adaptive.h"
#include "springs.h"

namespace mv::springs {

void readOut(Gpu& gpu, const Settings& s, const Memory& game, const Frame&, Numbers& numbers) {
    const auto set = [&](const char* name, double value) {
        if (std::isfinite(value)) numbers.set(name, value);
    };
    if (!isPlayed(s)) {
        if (gpu.solved->solution.error) numbers.set("end-error", *gpu.solved->solution.error);
        numbers.set("evaluations", double(gpu.solved->solution.result.counts.evaluations));
        return;
    }
    const std::vector<Dot> all = dots(gpu, s);
    set("drift", game.drift());
    set("largest-drift", game.largestDrift());
    set("energy", game.energy());
    set("dissipated", game.dissipated());
    set("work", game.work());
    numbers.set("steps-computed", game.stepsNow());
    numbers.set("halved", double(game.halved()));
    numbers.set("outside", double(std::ranges::count_if(all, &Dot::grows)));
    numbers.set("largest-z", all.empty() ? 0 : std::abs(all.front().z));
    if (sceneOf(s) != SpringScene::oneSpring) return;
    const Played& p = s.played;
    set("place", game.state()[3]);
    numbers.set("turn", game.turned());
    numbers.set("true-turn",
                std::sqrt(std::max(0.0, p.stiffness - p.damping * p.damping / 4)) * SpringGame::frameTime / p.substeps);
}

// Half a second of the game: where the masses are then, and what it took.
static SpringGame halfASecond(const Settings& s) {
    if (!isPlayed(s)) throw Error("--problem", "must be a game for a study of it", nameOf(s.problem));
    SpringGame now(ruleOf(s));
    for (int index = 1; index <= 30; ++index) now.advance(ruleOf(s), index);
    if (!now.failure().empty()) throw Error("springs", now.failure());
    if (!(now.largestDrift() < 1)) throw Error("springs", "blew up: energy was off by more than there was at first");
    return now;
}
std::vector<double> values(const Settings& s) {
    const SpringGame now = halfASecond(s);
    const std::vector<double>& y = now.state();
    return {y.begin(), y.begin() + static_cast<std::ptrdiff_t>(y.size() / 2)};
}
std::vector<std::pair<std::string, double>> valueCounts(const Settings& s) {
    const SpringGame now = halfASecond(s);
    const OdeCounts& counts = now.counts();
    // Less than 1e-11 is roundings and what Newton's method leaves, which another compiler has otherwise
    double off = 0;
    if (now.largestDrift() >= 1e-11) readNumber(formatted("%.2e", 1e6 * now.largestDrift()), off);
    return {{"energy off (ppm)", off},
            {"evaluations", double(counts.evaluations)},
            {"factorizations", double(counts.factorizations)},
            {"steps halved", double(counts.rejected)}};
}

namespace {

using namespace mv::claims;

// Dormand-Prince by its own steps, with a tolerance of 1e-12.
Reference fineSteps(const Demo& demo) {
    SpringSettings springs = ruleOf(settingsOf<Settings>(demo)).springs;
    springs.scene = SpringScene::net;
    const SpringSetup setup = makeSprings(springs);
    const OdeResult end = integrateAdaptive(springProblem(setup.system), OdeMethod::dormandPrince, 0, 0.5, setup.start,
                                            {.relative = 1e-12, .absolute = 1e-12, .mostSteps = 10'000'000});
    if (!end.reachedEnd()) throw Error("reference", end.failure);
    const auto half = static_cast<std::ptrdiff_t>(end.y.size() / 2);
    return {.values = {end.y.begin(), end.y.begin() + half}, .work = double(end.counts.evaluations)};
}

Study study() {
    Study study;
    study.quantity = "the places in metres of the net's masses after half a second";
    study.reference = "Dormand-Prince with a tolerance of 1e-12";
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) { return fineSteps(demo); };
    study.scenes = {{"5 x 5"}};
    for (const std::string stiffness : {"100", "10000", "1e6"}) {
        study.scenes.push_back({"k = " + stiffness, {{"masses", "3"}, {"stiffness", stiffness}}});
    }
    const auto add = [&](const std::string& method, const std::vector<std::string>& substeps,
                         const std::vector<std::string>& scenes = {}) {
        study.lines.push_back({.method = method,
                               .settings = {{"method", method}},
                               .knob = "substeps",
                               .values = substeps,
                               .scenes = scenes});
    };
    for (const std::string method : {"explicit-euler", "symplectic-euler", "velocity-verlet", "explicit-midpoint",
                                     "runge-kutta-4", "dormand-prince"}) {
        add(method, {"1", "2", "3", "5", "8", "16", "32", "64"});
    }
    for (const std::string method : {"implicit-midpoint", "rodas", "energy-momentum"}) add(method, {"1", "4", "16"});
    // These two halve their steps by thousands where springs are as stiff as can be: seconds for each row
    for (const std::string method : {"implicit-euler", "bdf2"}) {
        add(method, {"1", "4", "16"}, {"5 x 5", "k = 100", "k = 10000"});
        add(method + ", stiff", {"1", "4"}, {"k = 1e6"});
        study.lines.back().settings = {{"method", method}};
    }
    study.wrongBeyond = 0.01;
    const StudyNumber energyOff = of::count("energy off (ppm)");
    study.says = {
        claim("energy-momentum", "Energy-momentum keeps the energy to 1e-9 of it, at each stiffness and step.",
              {atMost(energyOff, rows("energy-momentum"), 1e-3)}),
        claim("energy-is-not-place",
              "And yet its places are off by more than a millimetre with one step a frame on the net as it opens: to "
              "keep "
              "the energy is not to be right.",
              {atLeast(of::rms, rows("energy-momentum").in("5 x 5").at(1), 1e-3)}),
        claim("half-the-step",
              "Where nothing is stiff (k = 100) Verlet's places err as the square of the step, Runge-Kutta 4's as the "
              "fourth "
              "power, and symplectic Euler's as the step.",
              {slope(of::rms, rows("velocity-verlet").in("k = 100").from(5), -2.3, -1.7),
               slope(of::rms, rows("runge-kutta-4").in("k = 100").from(5), -4.5, -3.7),
               slope(of::rms, rows("symplectic-euler").in("k = 100").from(5), -1.3, -0.8)}),
        claim("stiff-explicit-blows-up", "At k = 1e6 every explicit method blows up with up to 32 steps a frame.",
              {fails(rows("explicit-euler", "symplectic-euler", "velocity-verlet", "explicit-midpoint", "runge-kutta-4",
                          "dormand-prince")
                         .in("k = 1e6")
                         .upTo(32),
                     "springs")}),
        claim(
            "twice-as-fast",
            "As it opens, velocity Verlet with five steps a frame takes less than half the time of any implicit method "
            "with one.",
            {ratio(of::time, rows("rodas").in("5 x 5").at(1), rows("velocity-verlet").in("5 x 5").at(5), 2, 1e9),
             ratio(of::time, rows("energy-momentum").in("5 x 5").at(1), rows("velocity-verlet").in("5 x 5").at(5), 2,
                   1e9),
             ratio(of::time, rows("implicit-midpoint").in("5 x 5").at(1), rows("velocity-verlet").in("5 x 5").at(5), 2,
                   1e9),
             ratio(of::time, rows("implicit-euler").in("5 x 5").at(1), rows("velocity-verlet").in("5 x 5").at(5), 2,
                   1e9),
             ratio(of::time, rows("bdf2").in("5 x 5").at(1), rows("velocity-verlet").in("5 x 5").at(5), 2, 1e9)}),
        claim("stiff-places",
              "At k = 1e6 energy-momentum has the places right to a millimetre with any of these steps, and so has "
              "velocity Verlet with 64 a frame.",
              {atMost(of::rms, rows("energy-momentum").in("k = 1e6"), 1e-3),
               atMost(of::rms, rows("velocity-verlet").in("k = 1e6").at(64), 1e-3)}),
        note("Energy off is the largest part by which energy + dissipated - work left its first value in that half "
             "second, "
             "in millionths; 0 is less than 1e-11. A row that says it blew up is off by more than all the energy there "
             "was."),
        note("Implicit Euler and BDF2 halve their steps where Newton's method does not contract: at k = 1e6 thousands "
             "of "
             "times, and with one step a frame even that does not help, and they stop in words.")};
    study.reads = {"masses", "stiffness", "damping", "gravity", "grip", "hand-x", "hand-y"};
    study.ofValues = true;
    return study;
}

const bool studied = addStudy("springs", study());

}  // namespace
}  // namespace mv::springs
