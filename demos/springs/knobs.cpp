// The settings of springs: rows, presets, controls and declaration.
#include "figure.h"
#include "mv/demo/lesson.h"
#include "mv/motion/ode_adaptive.h"
#include "springs.h"

namespace mv::springs {
namespace {

constexpr WordList problemWords{{"chain"},
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
                                {"pleiades", "seven stars: not stiff"}};
constexpr WordList methodWords{{"explicit-euler"},
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
                               {"energy-momentum", "for springs: keeps energy and momenta"}};
static_assert(odeMethods.size() + 1 == methodWords.size());

}  // namespace

const char* nameOf(Problem problem) { return wordOf(problemWords, problem); }
const char* nameOf(OdeMethod method) { return wordOf(methodWords, method); }

void check(const Settings& s) {
    if (isPlayed(s)) return;
    if (s.method == energyMomentum)
        throw Error("--method", "must be another for the classics: energy-momentum knows of springs alone");
    if (needsMechanical(s.method) && !classic(whichClassic(s)).ode.problem.isMechanical)
        throw Error("--method", "must be another for a problem that has no positions and velocities", nameOf(s.method));
}

namespace {

bool isHungNow(const Settings& s) { return isPlayed(s) && isHung(sceneOf(s)); }
bool hasTolerance(const Settings& s) { return !isPlayed(s) && isAdaptive(asOde(s)); }
bool usesTolerance(const Settings& s) { return hasTolerance(s) && s.solved.tolerance > 0; }
bool usesSteps(const Settings& s) { return !isPlayed(s) && !usesTolerance(s); }

std::optional<vec2> placeOfHand(const Settings& s, const FrameInfo& frame) {
    if (!isHungNow(s) || s.played.grip == 0) return std::nullopt;
    const Pane pane = leftOf(frame);
    return pictureFromPane(pane, springPixel(pane, vec3(s.played.hand, 0)));
}

std::vector<Row<Settings>> panelRows() {
    return together(
        word("problem", &Settings::problem, problemWords, "what moves").beginsAnew(),
        word("method", &Settings::method, methodWords, "how it is integrated"),
        part(&Settings::played,
             {whole("substeps", &Played::substeps, {1, 100}, "steps in a frame of 1/60 s"),
              number("stiffness", &Played::stiffness, {1, 1e6, Scale::logarithmic}, "of each spring", "N/m"),
              number("damping", &Played::damping, {1e-3, 1e3, Scale::logarithmic, true}, "of each spring", "N s/m")},
             isPlayed, "the classics have their own"),
        part(&Settings::played,
             {whole("masses", &Played::masses, {2, 6}, "of the chain, or along a side of net and cloth").beginsAnew(),
              number("gravity", &Played::gravity, {0, 20}, "downwards", "m/s^2"),
              number("grip", &Played::grip, {0, 200},
                     "stiffness of the spring from the hand to the last mass; 0 lets go", "N/m"),
              number("hand-x", x(&Played::hand), {-1.4, 1.4}, "where the hand is", "m"),
              number("hand-y", y(&Played::hand), {-1.4, 1.4}, "where the hand is", "m")},
             isHungNow, "only chain, net and cloth have it"),
        number("tolerance", within(&Settings::solved, &Solved::tolerance), {1e-10, 1e-2, Scale::logarithmic, true},
               "of the classics by Dormand-Prince and RODAS; 0: equal steps")
            .when(hasTolerance, "it is for classics, by a method with an estimate"),
        toggle("confirm", within(&Settings::solved, &Solved::confirm),
               "integrate a classic once more, by a tenth of the tolerance, and compare")
            .when(usesTolerance, "there is no tolerance to be made smaller"),
        oneOf("steps", within(&Settings::solved, &Solved::steps), {100, 1000, 10000}, "equal steps of the classics")
            .when(usesSteps, "only equal steps are counted"));
}

constexpr Declaration about{
    .name = "springs",
    .sentence = "Masses on springs by twelve methods: energy made, energy lost, and the region that tells before.",
    .lookFor = "Drag the hand. Then fewer substeps: a dot leaves the blue region, and the net blows up.",
    .chapter = "Motion",
    .number = 37,
    .width = 960,
    .height = 560,
    .animated = true,
    .background = vec4(1, 1, 1, 1),
};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"net", "A net pulled at one corner, by the cheapest method that keeps the energy to a thousandth."},
        {"explicit-blows-up",
         "Explicit Euler: what swings is outside of the region, here at any step, and the net is gone in a second.",
         {.method = OdeMethod::explicitEuler}},
        {"falls-asleep",
         "Implicit Euler at w h = 16.7: nothing damps, and yet the energy is gone after a step.",
         {.problem = Problem::spring,
          .method = OdeMethod::implicitEuler,
          .played = {.substeps = 1, .stiffness = 1e06, .damping = 0}}},
        {"right-energy-wrong-phase",
         "Implicit midpoint on the same spring: the energy stays, and it turns by 2.9 rad a step instead of 16.7.",
         {.problem = Problem::spring,
          .method = OdeMethod::implicitMidpoint,
          .played = {.substeps = 1, .stiffness = 1e06, .damping = 0}},
         {{"turn", 2.85, 2.95}, {"true-turn", 16.65, 16.75}}},
        {"rest-lengths",
         "Three thrown masses, k = 1e6: no dot is outside, and implicit midpoint loses half of the energy.",
         {.problem = Problem::threeMasses,
          .method = OdeMethod::implicitMidpoint,
          .played = {.substeps = 1, .stiffness = 1e06, .damping = 0}}},
        {"robertson",
         "A stiff reaction by RODAS, whose steps grow with it through sixteen decades of time.",
         {.problem = Problem::robertson, .method = OdeMethod::rodas},
         {{"end-error", 0, 1e-6}}},
    };
}

const bool added = addLesson(
    about,
    Lesson<Settings, Gpu, Memory>{
        .rows = panelRows(),
        .presets = presets(),
        .handles = {{"hand", {"hand-x", "hand-y"}, placeOfHand}},
        .readouts =
            {{"drift",
              "how far energy + dissipated - work is from the first energy, as a part of that and the largest work"},
             {"largest-drift", "the largest so far"},
             {"energy", "kinetic, of the springs, and of height above the picture's lower edge", "J"},
             {"dissipated", "energy that damping has taken", "J"},
             {"work", "energy that the hand, and knobs that were moved, have put in", "J"},
             {"steps-computed", "steps tried for this frame"},
             {"halved", "steps that Newton's method could not do, and that were done in halves"},
             {"outside", "eigenvalues of the resting springs that the step makes grow"},
             {"largest-z", "step times the largest eigenvalue"},
             {"place", "of the one spring, from where it is at rest", "m"},
             {"turn", "turn of the one spring in its last step, place against speed, of 0 to a turn", "rad"},
             {"true-turn", "how much that ought to be", "rad"},
             {"end-error", "largest relative error at the end of a classic"},
             {"evaluations", "of a classic's slope"}},
        .draw = draw,
        .readOut = readOut,
        .check = check,
        .start = start,
        .step = step,
        .values = values,
        .valueCounts = valueCounts,
    });

}  // namespace
}  // namespace mv::springs
