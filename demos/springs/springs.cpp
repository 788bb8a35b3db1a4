// springs: masses on springs by twelve methods, with the energy that each makes or loses, and where it is stable.
#include "springs.h"

#include <algorithm>
#include <cmath>

#include "figure.h"
#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/motion/ode_stability.h"

namespace mv::springs {

void draw(Gpu& gpu, const Settings& s, const Memory& game, const Frame& frame) {
    const auto drawPart = isPlayed(s) ? drawPlayed : drawSolved;  // overlay.cpp has the classics, which are solved
    gpu.drawing.begin(frame);
    drawPart(gpu, s, game, frame);
    gpu.drawing.draw(frame);
}

// Draw the masses, the energy that the method makes or loses, and where the method is stable.
void drawPlayed(Gpu& gpu, const Settings& s, const Memory& game, const Frame& frame) {
    const Frame units = frame.inUnits();
    drawRegion(gpu, s, dots(gpu, s), frame);
    drawMasses(gpu, s, game, units);
    drawEnergy(gpu.drawing, rightOf(units, true), game);
}

// The masses start where the scene has them. The game steps from frame to frame (game.cpp).
Memory start(const Settings& s) { return isPlayed(s) ? SpringGame(ruleOf(s)) : SpringGame(); }
void step(Memory& game, const Settings& s, int index) {
    if (isPlayed(s)) game.advance(ruleOf(s), index);
}

// Near rest the springs are linear: y' = A y. A step of h multiplies the part along an eigenvector of A, with eigenvalue l, by a
// factor that depends on z = h l alone. Growth in the method and not in the springs is the method's fault.
std::vector<Dot> dots(Gpu& gpu, const Settings& s) {
    constexpr double unseen = 1e-6;  // growth by less than this part in a step does not count
    SpringSettings springs = ruleOf(s).springs;
    springs.hand = SpringSettings().hand;
    const std::vector<std::complex<double>>& atRest =
        gpu.eigenvaluesAtRest.of({springs}, [&] { return eigenvaluesAtRest(springs); });
    const double h = SpringGame::frameTime / s.played.substeps, ratio = s.played.damping / s.played.stiffness;
    std::vector<Dot> result;
    for (const std::complex<double>& eigenvalue : atRest) {
        const std::complex<double> z = h * eigenvalue;
        // A spring has two eigenvalues, whose product is the stiffness: conjugate ones, or, beyond critical damping, two that are
        // real. With symplectic Euler and Verlet the growth depends on both, so the fast one has the slow one as its partner
        const bool isFast = eigenvalue.imag() == 0 && ratio * eigenvalue.real() <= -2;
        const std::complex<double> partner = isFast ? -z / (1.0 + ratio * eigenvalue) : std::conj(z);
        result.push_back({z, amplification(asOde(s), z, partner) > 1 + unseen});
    }
    return result;
}

std::vector<std::complex<double>> eigenvaluesAtRest(const SpringSettings& springs) {
    const SpringSetup setup = makeSprings(springs);
    const std::vector<vec3> still(setup.slack.size(), vec3(0));
    return eigenvalues(springProblem(setup.system), 0, springState(setup.slack, still));
}

// Draw the region of numbers z for which a step of the method does not grow, and the dots on it.
void drawRegion(Gpu& gpu, const Settings& s, const std::vector<Dot>& all, const Frame& frame) {
    const Pane pane = rightOf(frame.inUnits(), false);
    std::vector<std::complex<double>> numbers;
    for (const Dot& dot : all) numbers.push_back(dot.z);
    const Plot plot = stabilityPlot(pane, numbers);
    const Mesh& region = gpu.region.of({asOde(s), plot.x.low, plot.y.low},
                                       [&] { return Mesh(stabilityGrid(asOde(s), plot), "region"); });

    const auto [x, y, width, height] =
        frame.inUnits().pixels({pane.x + int(plot.box.low.x), pane.y + int(plot.box.low.y),
                                std::max(1, int(plot.box.size().x)), std::max(1, int(plot.box.size().y))});
    glViewport(x, y, width, height);
    gpu.program->use();
    gpu.program->set("clipFromPlane", ortho(plot.x.low, plot.x.high, plot.y.low, plot.y.high, -1, 1));
    region.draw();
    glViewport(0, 0, frame.width(), frame.height());
    drawDots(gpu, plot, pane, all);
}

SpringRule ruleOf(const Settings& s) {
    const Played& p = s.played;
    SpringRule rule{.springs = {.scene = sceneOf(s),
                                .masses = p.masses,
                                .stiffness = p.stiffness,
                                .damping = p.damping,
                                .gravity = p.gravity,
                                .grip = p.grip,
                                .hand = p.hand},
                    .substeps = p.substeps};
    if (s.method != energyMomentum) rule.method = s.method;
    return rule;
}

bool isPlayed(const Settings& s) { return s.problem < Problem::classics; }
SpringScene sceneOf(const Settings& s) { return static_cast<SpringScene>(s.problem); }
// Near rest, where springs are linear, energy-momentum is the implicit midpoint rule.
OdeMethod asOde(const Settings& s) { return s.method == energyMomentum ? OdeMethod::implicitMidpoint : s.method; }

}  // namespace mv::springs
