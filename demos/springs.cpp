// springs: masses on springs by twelve methods, with the energy that each makes or loses, and where it is stable.
//
// Claims (each is a test in tests/claims/springs.cpp; rows X33 to X35 of docs/stability.md):
// - [limits] One spring grows where the region says so, and not within 1 % below it: damped or not, by each method.
// - [dots-tell] By velocity Verlet chain, net and cloth blow up where a dot is outside; with one substep more than leaves
//   none outside they do not.
// - [stops-in-words] What blows up stops at its last finite state, and the picture says at which step and why.
// - [falls-asleep] At w h = 16.7 implicit Euler has lost all but 0.4 % of the energy after a step, without damping.
// - [phase] There implicit midpoint keeps the energy to 1e-9, and turns by 2.9 rad a step instead of 16.7.
// - [rest-lengths] Three stiff masses with rest lengths: no dot is outside, and implicit midpoint loses half of the energy
//   although its steps are halved; energy-momentum keeps it to 1e-9.
// - [balance] Energy + dissipated - work stays level while somebody plays: by energy-momentum to 1e-9 of it, and by a
//   method of order 4 16 times better for half the step.
// - [default-is-cheapest] How it opens it keeps that to 1e-3 for five seconds, and no explicit method does by fewer
//   evaluations.
// - [rests] What rests is neither stepped nor uploaded.
// - [classics] On stiff problems RODAS ends at the published values, and an explicit method says that it cannot.
// - [confirmed] Where a tolerance of 1e-2 ends wrong, a second run by a tenth of it raises a doubt, and one is not
//   raised where each classic ends right.
// - [same-frame] A frame is the same whatever was drawn before it; a game played by hand, copied, gives the same bytes.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/made_for.h"
#include "mv/demo/number.h"
#include "mv/geometry/plot.h"
#include "mv/gl/drawing.h"
#include "mv/gl/gl.h"
#include "mv/gl/on_demand.h"
#include "mv/math/projection.h"
#include "mv/motion/ode_stability.h"
#include "shared/classic_curves.h"
#include "shared/spring_game.h"
#include "shared/spring_pictures.h"
#include "shared/spring_scenes.h"

using namespace mv;

namespace {

// The first five are played, in the order of SpringScene. From here on they are the classics, in that of odeCases().
enum class Problem { chain, net, cloth, threeMasses, spring, classics };
// The method behind those for all problems, which is for springs alone.
constexpr auto energyMomentum = static_cast<OdeMethod>(odeMethods.size());
static_assert(odeMethods.size() == 11, "the knob `method` names each of them");

constexpr double unseen = 1e-6;  // what grows by less than this part in a step is not called outside

using Complex = std::complex<double>;

struct Springs final : Demo {
    Choice<Problem> problem{this,
                            "problem",
                            Problem::net,
                            {{"chain"},
                             {"net"},
                             {"cloth"},
                             {"three-masses", "thrown, with rest lengths"},
                             {"spring", "one, and linear"},
                             {"undamped-spring", "from here on the classics: curves, not a game"},
                             {"damped-spring"},
                             {"stiff-chain", "100 masses, stiffnesses 1 and 1e6"},
                             {"robertson", "a reaction, to 1e11"},
                             {"van-der-pol", "with 1e-6"},
                             {"hires", "a plant's reactions"},
                             {"oregonator", "a reaction that oscillates"},
                             {"pleiades", "seven stars: not stiff"}},
                            "what moves"};
    Choice<OdeMethod> method{this,
                             "method",
                             OdeMethod::velocityVerlet,
                             {{"explicit-euler"},
                              {"symplectic-euler"},
                              {"velocity-verlet"},
                              {"explicit-midpoint"},
                              {"runge-kutta-4"},
                              {"dormand-prince", "of order 5"},
                              {"implicit-euler"},
                              {"implicit-midpoint"},
                              {"bdf2"},
                              {"rodas", "Rosenbrock, of order 4"},
                              {"radau", "Radau IIA, of order 5"},
                              {"energy-momentum", "for springs: keeps energy and momenta"}},
                             "how it is integrated"};
    Whole substeps{this, "substeps", 5, {1, 100}, "steps in a frame of 1/60 s"};
    Real stiffness{this, "stiffness", 1000, {1, 1e6, Scale::logarithmic}, "of each spring", "N/m"};
    Real damping{this, "damping", 0.2, {1e-3, 1e3, Scale::logarithmic, true}, "of each spring", "N s/m"};
    Whole masses{this, "masses", 5, {2, 6}, "of the chain, or along a side of net and cloth"};
    Real gravity{this, "gravity", 9.81, {0, 20}, "downwards", "m/s^2"};
    Real grip{this, "grip", 50, {0, 200}, "stiffness of the spring from the hand to the last mass; 0 lets go", "N/m"};
    Real handX{this, "hand-x", 1, {-1.4, 1.4}, "where the hand is", "m"};
    Real handY{this, "hand-y", -0.7, {-1.4, 1.4}, "where the hand is", "m"};
    Real tolerance{this,
                   "tolerance",
                   1e-6,
                   {1e-10, 1e-2, Scale::logarithmic, true},
                   "of the classics by Dormand-Prince and RODAS; 0: equal steps"};
    Toggle confirm{this, "confirm", false, "integrate a classic once more, by a tenth of the tolerance, and compare"};
    NumberChoice steps{this, "steps", 1000, {100, 1000, 10000}, "equal steps of the classics"};

    Readout drift{
        this, "drift",
        "how far energy + dissipated - work is from the first energy, as a part of that and the largest work"};
    Readout largestDrift{this, "largest-drift", "the largest so far"};
    Readout energy{this, "energy", "kinetic, of the springs, and of height above the picture's lower edge", "J"};
    Readout dissipated{this, "dissipated", "energy that damping has taken", "J"};
    Readout work{this, "work", "energy that the hand, and knobs that were moved, have put in", "J"};
    Readout stepsComputed{this, "steps-computed", "steps tried for this frame"};
    Readout halved{this, "halved", "steps that Newton's method could not do, and that were done in halves"};
    Readout outside{this, "outside", "eigenvalues of the resting springs that the step makes grow"};
    Readout largestZ{this, "largest-z", "step times the largest eigenvalue"};
    Readout place{this, "place", "of the one spring, from where it is at rest", "m"};
    Readout turn{this, "turn", "turn of the one spring in its last step, place against speed, of 0 to a turn", "rad"};
    Readout trueTurn{this, "true-turn", "how much that ought to be", "rad"};
    Readout endError{this, "end-error", "largest relative error at the end of a classic"};
    Readout evaluations{this, "evaluations", "of a classic's slope"};

    Memory<SpringGame> game{this};
    OnDemand<Program> program{std::string("springs")};  // no classic needs it
    Mesh region;
    Drawing drawing;
    MadeFor<OdeMethod, double, double> regionFor;
    MadeFor<SpringSettings> eigenvaluesFor;
    std::vector<Complex> eigenvaluesAtRest;
    MadeFor<Problem, OdeMethod, double, int, bool> solvedFor;
    std::optional<Classic> known;
    ClassicSolution solution;

    Springs() {
        for (Knob* knob : std::vector<Knob*>{&problem, &masses}) knob->beginsAnew();
        bindHandle("hand", {&handX, &handY}, [this](const FrameInfo& frame) -> std::optional<vec2> {
            if (!isPlayed() || !isHung(springScene()) || grip == 0) return std::nullopt;
            const Pane pane = leftOf(frame);
            return pictureFromPane(pane, springPixel(pane, vec3(handX, handY, 0)));
        });
        for (Knob* knob : std::vector<Knob*>{&substeps, &stiffness, &damping}) {
            knob->onlyWhen([this] { return isPlayed(); }, "the classics have their own");
        }
        for (Knob* knob : std::vector<Knob*>{&masses, &gravity, &grip, &handX, &handY}) {
            knob->onlyWhen([this] { return isPlayed() && isHung(springScene()); }, "only chain, net and cloth have it");
        }
        tolerance.onlyWhen([this] { return !isPlayed() && isAdaptive(asOde()); },
                           "it is for classics, by a method with an estimate");
        confirm.onlyWhen([this] { return !isPlayed() && isAdaptive(asOde()) && tolerance > 0; },
                         "there is no tolerance to be made smaller");
        steps.onlyWhen([this] { return !isPlayed() && !(isAdaptive(asOde()) && tolerance > 0); },
                       "only equal steps are counted");
    }

    void init() override {}

    // ---- The game: from frame to frame

    void reset() override { *game = isPlayed() ? SpringGame(rule()) : SpringGame(); }
    void step(int index) override {
        if (isPlayed()) game->advance(rule(), index);
    }

    std::size_t whichClassic() const {
        return static_cast<std::size_t>(Problem(problem)) - static_cast<std::size_t>(Problem::classics);
    }
    bool isPlayed() const { return problem < Problem::classics; }
    SpringScene springScene() const { return static_cast<SpringScene>(Problem(problem)); }
    SpringRule rule() const {
        SpringRule rule{.springs = {.scene = springScene(),
                                    .masses = masses,
                                    .stiffness = stiffness,
                                    .damping = damping,
                                    .gravity = gravity,
                                    .grip = grip,
                                    .hand = vec2(handX, handY)},
                        .substeps = substeps};
        if (method != energyMomentum) rule.method = method;
        return rule;
    }
    // At rest, where springs are linear, energy-momentum is the implicit midpoint rule.
    OdeMethod asOde() const { return method == energyMomentum ? OdeMethod::implicitMidpoint : OdeMethod(method); }

    // ---- Where the method is stable

    // Step times eigenvalues of the springs at rest, and whether they grow.
    struct Dot {
        Complex z;
        bool grows;
    };
    std::vector<Dot> dots() {
        SpringSettings springs = rule().springs;
        springs.hand = SpringSettings().hand;
        if (eigenvaluesFor.changed(springs)) {
            const SpringSetup setup = makeSprings(springs);
            const std::vector<vec3> still(setup.slack.size(), vec3(0));
            eigenvaluesAtRest = eigenvalues(springProblem(setup.system), 0, springState(setup.slack, still));
        }
        const double h = SpringGame::frameTime / substeps, ratio = damping / stiffness;
        std::vector<Dot> result;
        for (const Complex& eigenvalue : eigenvaluesAtRest) {
            const Complex z = h * eigenvalue;
            // Beyond critical damping a pair is real; symplectic Euler and Verlet do to it what depends on both. This is
            // the fast one of a pair, which has the slow one for its partner
            const bool isFast = eigenvalue.imag() == 0 && ratio * eigenvalue.real() <= -2;
            const Complex partner = isFast ? -z / (1.0 + ratio * eigenvalue) : std::conj(z);
            result.push_back({z, amplification(asOde(), z, partner) > 1 + unseen});
        }
        return result;
    }

    // ---- The picture

    void draw(const Frame& frame) override {
        drawing.begin(frame);
        if (isPlayed()) {
            const std::vector<Dot> all = dots();
            drawRegion(frame, all);
            drawMasses(frame);
            drawEnergy(drawing, rightOf(frame, true), *game);
            readOut(all);
        } else {
            drawCurves(frame);
        }
        drawing.draw(frame);
    }

    // The left half; the right one's upper and lower half.
    static Pane leftOf(const FrameInfo& frame) { return {0, 0, std::max(frame.width() / 2, 1), frame.height()}; }
    static Pane rightOf(const FrameInfo& frame, bool isUpper) {
        const int width = std::max(frame.width() / 2, 1), height = std::max(frame.height() / 2, 1);
        return {frame.width() / 2, isUpper ? frame.height() / 2 : 0, width, height};
    }

    // The region: for each number z what a step makes of it. On it the dots.
    void drawRegion(const Frame& frame, const std::vector<Dot>& all) {
        const Pane pane = rightOf(frame, false);
        std::vector<Complex> numbers;
        numbers.reserve(all.size());
        for (const Dot& dot : all) numbers.push_back(dot.z);
        const Plot plot = stabilityPlot(pane, numbers);
        if (regionFor.changed(asOde(), plot.x.low, plot.y.low)) region = Mesh(stabilityGrid(asOde(), plot), "region");
        glViewport(pane.x + int(plot.box.low.x), pane.y + int(plot.box.low.y), std::max(1, int(plot.box.size().x)),
                   std::max(1, int(plot.box.size().y)));
        program->use();
        program->set("clipFromPlane", ortho(plot.x.low, plot.x.high, plot.y.low, plot.y.high, -1, 1));
        region.draw();
        glViewport(0, 0, frame.width(), frame.height());

        drawing.in(pane);
        drawing.axes(plot);
        drawing.line(plot.pixel({plot.x.low, 0}), plot.pixel({plot.x.high, 0}), {springGrey, 1});
        for (const Dot& dot : all) {
            drawing.point(plot.pixel({dot.z.real(), dot.z.imag()}), 7, dot.grows ? springRed : springInk);
        }
        const long growing = std::ranges::count_if(all, &Dot::grows);
        const vec2 at(plot.box.low.x, pane.height);
        paneWords(drawing, pane, at - vec2(0, 1), "step x eigenvalues; blue: where this method does not grow",
                  springInk);
        paneWords(drawing, pane, at - vec2(0, 22),
                  growing > 0 ? std::to_string(growing) + " outside: they grow" : "none outside",
                  growing > 0 ? springRed : springInk);
    }

    void drawMasses(const Frame& frame) {
        const SpringGame& now = *game;
        const Pane pane = leftOf(frame);
        drawing.in(pane);
        const int lost = drawSprings(drawing, pane, now.setup(), now.state());
        if (springScene() == SpringScene::oneSpring) drawPhase(drawing, pane, now);
        double top = pane.height - 4.0;
        const auto say = [&](const std::string& text, const vec4& color = springInk) {
            paneWords(drawing, pane, {12, top}, text, color);
            top -= 18;
        };
        say(method.text() + ", " + (substeps == 1 ? "one step" : substeps.text() + " steps") + " a frame");
        if (now.rests()) say("at rest: no step is computed");
        if (lost > 0) say(std::to_string(lost) + " are more than 100 m away", springRed);
        if (!now.failure().empty()) {
            for (const std::string& line : wrapped(now.failure(), 56)) say(line, springRed);
            frame.say(now.failure());
        }
        paneWords(drawing, pane, {12, 26}, "springs: blue 10 % shorter than at rest, grey, red 10 % longer", springInk);
    }

    void readOut(const std::vector<Dot>& all) {
        const SpringGame& now = *game;
        const auto set = [](Readout& readout, double value) {
            if (std::isfinite(value))
                readout = value;
            else
                readout.clear();
        };
        set(drift, now.drift());
        set(largestDrift, now.largestDrift());
        set(energy, now.energy());
        set(dissipated, now.dissipated());
        set(work, now.work());
        stepsComputed = now.stepsNow();
        halved = double(now.halved());
        outside = double(std::ranges::count_if(all, &Dot::grows));
        largestZ = all.empty() ? 0 : std::abs(all.front().z);
        endError.clear();
        evaluations.clear();
        place.clear();
        turn.clear();
        trueTurn.clear();
        if (springScene() == SpringScene::oneSpring) {
            set(place, now.state()[3]);
            turn = now.turned();
            trueTurn = std::sqrt(std::max(0.0, stiffness - damping * damping / 4)) * SpringGame::frameTime / substeps;
        }
    }

    // ---- The classics

    void drawCurves(const Frame& frame) {
        const double asked = isAdaptive(asOde()) ? double(tolerance) : 0;
        if (solvedFor.changed(problem, asOde(), asked, steps, confirm)) {
            known = classic(whichClassic());
            solution = solveClassic(*known, asOde(), asked, steps, confirm);
        }
        const Pane pane{0, 0, frame.width(), frame.height()};
        const Box box{
            {std::min(70.0, pane.width / 6.0), std::min(52.0, pane.height / 5.0)},
            {std::max(pane.width - 30.0, pane.width / 6.0 + 1), std::max(pane.height - 112.0, pane.height / 5.0 + 1)}};
        drawing.in(pane);
        drawClassic(drawing, box, *known, solution);
        const OdeResult& result = solution.result;
        std::string told = known->ode.name + " by " + method.text() + ", " + std::to_string(result.counts.accepted) +
                           " steps, " + std::to_string(result.counts.evaluations) + " evaluations";
        if (solution.error) told += rounded("; off by %.1e at the end (rings: the published values)", *solution.error);
        drawing.text({12, pane.height - 8.0}, told, {15, springInk, vec4(0)});
        double top = pane.height - 26.0;
        const auto tell = [&](const std::string& words, const vec4& ink) {
            for (const std::string& line : wrapped(words, 105)) {
                drawing.text({12, top}, line, {15, ink, vec4(0)});
                top -= 18;
            }
        };
        const std::optional<Confirmation>& confirmed = solution.confirmation;
        if (const std::string why = confirmed ? confirmed->doubt : result.failure; !why.empty()) {
            tell(why, springRed);
            frame.say(why);
        } else if (confirmed) {
            tell(rounded("confirmed: by a tenth of the tolerance no component differs by more than %.1e of its size",
                         confirmed->difference),
                 springInk);
        }
        for (Readout* readout : {&drift, &largestDrift, &energy, &dissipated, &work, &stepsComputed, &halved, &outside,
                                 &largestZ, &place, &turn, &trueTurn, &endError}) {
            readout->clear();
        }
        if (solution.error) endError = *solution.error;
        evaluations = double(result.counts.evaluations);
    }

    void check() const override {
        if (isPlayed()) return;
        if (method == energyMomentum) {
            throw Error("--method", "must be another for the classics: energy-momentum knows of springs alone");
        }
        if (needsMechanical(method) && !classic(whichClassic()).ode.problem.isMechanical) {
            throw Error("--method", "must be another for a problem that has no positions and velocities",
                        method.text());
        }
    }

    // For the study: half a second of the game, where the masses are then, and what it took.
    SpringGame played() const {
        if (!isPlayed()) throw Error("--problem", "must be a game for a study of it", problem.text());
        SpringGame now(rule());
        for (int index = 1; index <= 30; ++index) now.advance(rule(), index);
        if (!now.failure().empty()) throw Error("springs", now.failure());
        if (!(now.largestDrift() < 1))
            throw Error("springs", "blew up: energy was off by more than there was at first");
        return now;
    }
    std::vector<double> values() const override {
        const SpringGame now = played();
        const std::vector<double>& y = now.state();
        return {y.begin(), y.begin() + static_cast<std::ptrdiff_t>(y.size() / 2)};
    }
    std::vector<std::pair<std::string, double>> valueCounts() const override {
        const SpringGame now = played();
        const OdeCounts& counts = now.counts();
        // Less than 1e-11 is roundings and what Newton's method leaves, which another compiler has otherwise
        double off = 0;
        if (now.largestDrift() >= 1e-11) readNumber(rounded("%.2e", 1e6 * now.largestDrift()), off);
        return {{"energy off (ppm)", off},
                {"evaluations", double(counts.evaluations)},
                {"factorizations", double(counts.factorizations)},
                {"steps halved", double(counts.rejected)}};
    }
};

constexpr Declaration declaration{
    .name = "springs",
    .sentence = "Masses on springs by twelve methods: energy made, energy lost, and the region that tells before.",
    .lookFor = "Drag the hand. Then fewer substeps: a dot leaves the blue region, and the net blows up.",
    .chapter = "Motion",
    .number = 37,
    .width = 960,
    .height = 560,
    .animated = true,
    .background = vec4(1, 1, 1, 1),
    .presets =
        {
            {"net", "A net pulled at one corner, by the cheapest method that keeps the energy to a thousandth."},
            {"explicit-blows-up",
             "Explicit Euler: what swings is outside of the region, here at any step, and the net is gone in a second.",
             {{"method", "explicit-euler"}}},
            {"falls-asleep",
             "Implicit Euler at w h = 16.7: nothing damps, and yet the energy is gone after a step.",
             {{"problem", "spring"},
              {"stiffness", "1e+06"},
              {"damping", "0"},
              {"method", "implicit-euler"},
              {"substeps", "1"}}},
            {"right-energy-wrong-phase",
             "Implicit midpoint on the same spring: the energy stays, and it turns by 2.9 rad a step instead of 16.7.",
             {{"problem", "spring"},
              {"stiffness", "1e+06"},
              {"damping", "0"},
              {"method", "implicit-midpoint"},
              {"substeps", "1"}},
             {{"turn", 2.85, 2.95}, {"true-turn", 16.65, 16.75}}},
            {"rest-lengths",
             "Three thrown masses, k = 1e6: no dot is outside, and implicit midpoint loses half of the energy.",
             {{"problem", "three-masses"},
              {"stiffness", "1e+06"},
              {"damping", "0"},
              {"method", "implicit-midpoint"},
              {"substeps", "1"}}},
            {"robertson",
             "A stiff reaction by RODAS, whose steps grow with it through sixteen decades of time.",
             {{"problem", "robertson"}, {"method", "rodas"}},
             {{"end-error", 0, 1e-6}}},
        },
};

const bool added = addDemo<Springs, declaration>();

}  // namespace
