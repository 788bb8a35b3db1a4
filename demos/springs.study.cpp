// What measures springs: where the net is after half a second, by method and step, and how its energy is off.
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/motion/ode_adaptive.h"
#include "shared/spring_scenes.h"

using namespace mv;
using namespace mv::claims;

namespace {

// Dormand-Prince by its own steps, with a tolerance of 1e-12.
Reference fineSteps(const Demo& demo) {
    const SpringSetup setup = makeSprings({.scene = SpringScene::net,
                                           .masses = static_cast<int>(demo.number("masses")),
                                           .stiffness = demo.number("stiffness"),
                                           .damping = demo.number("damping"),
                                           .gravity = demo.number("gravity"),
                                           .grip = demo.number("grip"),
                                           .hand = vec2(demo.number("hand-x"), demo.number("hand-y"))});
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
    study.scenes = {{"as it opens"}};
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
        add(method, {"1", "4", "16"}, {"as it opens", "k = 100", "k = 10000"});
        add(method + ", stiff", {"1", "4"}, {"k = 1e6"});
        study.lines.back().settings = {{"method", method}};
    }
    study.wrongBeyond = 0.01;
    study.says = {note("To be written.")};
    study.ofValues = true;
    return study;
}

const bool studied = addStudy("springs", study());

}  // namespace
