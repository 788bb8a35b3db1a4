#pragma once
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "classic.h"
#include "game.h"
#include "mv/demo/cached.h"
#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "mv/motion/ode_method.h"

namespace mv::springs {

// The first five are played, in the order of SpringScene. The classics follow in the order of odeCases().
enum class Problem { chain, net, cloth, threeMasses, spring, classics, robertson = classics + 3 };
// The last method, for springs alone; the others are for all problems.
inline constexpr auto energyMomentum = static_cast<OdeMethod>(odeMethods.size());

// Settings of the game.
struct Played {
    int substeps = 5;         // steps in a frame of 1/60 s
    double stiffness = 1000;  // N/m
    double damping = 0.2;     // N s/m
    int masses = 5;
    double gravity = 9.81;  // m/s^2
    double grip = 50;       // N/m
    vec2 hand{1, -0.7};     // m
};
// Settings of the classics.
struct Solved {
    double tolerance = 1e-6;  // 0: equal steps
    bool confirm = false;
    int steps = 1000;
};
struct Settings {
    Problem problem = Problem::net;
    OdeMethod method = OdeMethod::velocityVerlet;
    Played played = {};
    Solved solved = {};
};

// Step times an eigenvalue of the springs at rest, and whether it grows.
struct Dot {
    std::complex<double> z;
    bool grows;
};

// A classic problem, and its solution by the method.
struct SolvedClassic {
    Classic known;
    ClassicSolution solution;
};

struct Gpu {
    OnDemand<Program> program{std::string("springs")};  // no classic needs it
    Cached<Mesh, OdeMethod, double, double> region;
    Cached<std::vector<std::complex<double>>, SpringSettings> eigenvaluesAtRest;
    Cached<SolvedClassic, Problem, OdeMethod, double, int, bool> solved;
    Drawing drawing;
};

// The state kept from frame to frame.
using Memory = SpringGame;

// The game: springs.cpp.
void draw(Gpu& gpu, const Settings& s, const Memory& game, const Frame& frame);
Memory start(const Settings& s);
void step(Memory& game, const Settings& s, int index);
void drawPlayed(Gpu& gpu, const Settings& s, const Memory& game, const Frame& frame);
std::vector<std::complex<double>> eigenvaluesAtRest(const SpringSettings& springs);
std::vector<Dot> dots(Gpu& gpu, const Settings& s);
void drawRegion(Gpu& gpu, const Settings& s, const std::vector<Dot>& all, const Frame& frame);
SpringRule ruleOf(const Settings& s);
bool isPlayed(const Settings& s);
SpringScene sceneOf(const Settings& s);
OdeMethod asOde(const Settings& s);

// A classic, the masses, the dots, and the places of the pictures: overlay.cpp.
void drawSolved(Gpu& gpu, const Settings& s, const Memory& game, const Frame& frame);
void drawMasses(Gpu& gpu, const Settings& s, const Memory& game, const Frame& frame);
void drawDots(Gpu& gpu, const Plot& plot, const Pane& pane, const std::vector<Dot>& all);
Pane leftOf(const FrameInfo& frame);
Pane rightOf(const FrameInfo& frame, bool isUpper);

// knobs.cpp, study.cpp.
void check(const Settings& s);
const char* nameOf(Problem problem);
const char* nameOf(OdeMethod method);
void readOut(Gpu& gpu, const Settings& s, const Memory& game, const Frame& frame, Numbers& numbers);
std::vector<double> values(const Settings& s);
std::vector<std::pair<std::string, double>> valueCounts(const Settings& s);
// The place of a classic in odeCases().
std::size_t whichClassic(const Settings& s);

}  // namespace mv::springs
