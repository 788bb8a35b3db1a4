// The settings of robot-arm: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "robot-arm.h"
#include "shared/orbit_rows.h"

namespace mv::robot_arm {
namespace {

constexpr WordList methodWords{{"forward", "the angles are given"},
                               {"closed", "of two links, by the law of cosines"},
                               {"ccd", "cyclic coordinate descent: one joint after the other"},
                               {"transpose", "along the transposed Jacobian"},
                               {"dls", "damped least squares"}};

void check(const Settings& s) {
    if (isArm(s) && s.method == Method::closed)
        throw Error("--method", "must not be closed where the scene is the arm: the formula is for two links");
}

bool hasStart(const Settings& s) { return s.method != Method::closed; }
bool moves(const Settings& s) { return isLinks(s) && isForward(s); }
bool hasOthers(const Settings& s) { return isArm(s) && !isForward(s); }
bool isInSpace(const Settings& s) { return isArm(s) || isPerson(s); }
bool hasMethod(const Settings& s) { return !isPerson(s); }
bool hasTarget(const Settings& s) { return !isWalker(s) && !isForward(s); }

std::optional<vec2> placeOfTarget(const Settings& s, const FrameInfo& frame) {
    if (!hasTarget(s) || s.beyond > 0) return std::nullopt;
    const Pane pane = paneOf(s, frame);
    return pictureFromPane(pane, clipFromWorldOf(s, pane), targetOf(s));
}

std::vector<Row<Settings>> linksRows() {
    const Literal ofLinks = "two links have these angles", noStart = "the closed form asks for no start",
                  ofForward = "two links move so by forward kinematics";
    return {number("theta-1", within(&Settings::links, &Links::theta1), {-360, 360},
                   "angle of the first of two links, at the start", "deg")
                .when(isLinks, ofLinks)
                .when(hasStart, noStart),
            number("theta-2", within(&Settings::links, &Links::theta2), {-360, 360},
                   "angle of the second against the first", "deg")
                .when(isLinks, ofLinks)
                .when(hasStart, noStart),
            number("rate-1", within(&Settings::links, &Links::rate1), {-5, 5},
                   "what theta-1 grows by in a frame of 1/60 s", "deg")
                .when(moves, ofForward),
            number("rate-2", within(&Settings::links, &Links::rate2), {-5, 5}, "what theta-2 grows by", "deg")
                .when(moves, ofForward)};
}
std::vector<Row<Arm>> armRows() {
    return {number("turn", &Arm::turn, armTurn, "angle of the arm about the vertical, at the start", "deg"),
            number("shoulder", &Arm::shoulder, armShoulder, "of its upper arm against the horizontal", "deg"),
            number("elbow", &Arm::elbow, armElbow, "of its lower arm against the upper", "deg"),
            number("wrist", &Arm::wrist, armWrist, "of its hand against the lower arm", "deg"),
            toggle("limits", &Arm::limits, "joints of the arm stop where these four knobs end")};
}

std::vector<Row<Settings>> panelRows() {
    const Literal aimless = "forward there is no target, and the walker's feet have theirs";
    return together(
        word("scene", &Settings::which, {{"two-links"}, {"arm"}, {"walker"}, {"person", "trunk, head, arms and legs"}},
             "what is moved"),
        word("method", &Settings::method, methodWords, "how the angles are found")
            .when(hasMethod, "the person's angles are those of its poses"),
        linksRows(), part(&Settings::arm, armRows(), isArm, "the arm has these joints"),
        number("target-x", x(&Settings::target), {-3, 3}, "where the end is to be, from the shoulder", "m")
            .when(hasTarget, aimless),
        number("target-y", y(&Settings::target), {-3, 3}, "the same, upwards", "m").when(hasTarget, aimless),
        number("target-z", z(&Settings::target), {-3, 3}, "the same, to the front", "m")
            .when(hasTarget, aimless)
            .when(isArm, "only the arm's target leaves the plane"),
        number("beyond", &Settings::beyond, {1e-3, 100, Scale::logarithmic, true},
               "the target, in its direction, so far out of reach; 0: it stays", "m")
            .when(hasTarget, aimless),
        number("upper", &Settings::upper, {0.1, 2}, "length of the first link, the upper arm, the thigh", "m"),
        number("lower", &Settings::lower, {0.1, 2}, "length of the second link, the lower arm, the shank", "m"),
        whole("iterations", &Settings::iterations, {0, mostIterations}, "at most so many")
            .when(iterates, "this method has no iterations"),
        toggle("others", within(&Settings::arm, &Arm::others), "what the arm comes to from eight other starts, too")
            .when(hasOthers, "the arm has these by inverse kinematics"),
        oneOf("poses", &Settings::poses, {4, 8, 16, 32, 64}, "right ones in a cycle, between which angles go evenly")
            .when(isWalker, "only the walker goes from pose to pose"),
        toggle("matrices", &Settings::matrices, "show the product of matrices"),
        part(&Settings::person,
             {word("routine", &Person::routine,
                   {{"walk", "four poses, on the spot"},
                    {"hand-through", "the hand goes from before the belly to behind the back: two poses"},
                    {"hand-around", "the same with poses between them, in which the elbow is straight"}},
                   "what the person does"),
              word("between", &Person::between, {{"straight"}, {"spline", "closed, for each joint's angle"}},
                   "how its angles go from pose to pose")},
             isPerson, "only the person has poses of all of its joints"),
        part(&Settings::arm, part(&Arm::orbit, orbitRows({-3, 6})), isInSpace, "the others lie in a plane"));
}

constexpr Declaration about{
    .name = "robot-arm",
    .sentence = "From the angles of joints to the hand and back: two links, an arm, a walker's feet, a whole figure.",
    .lookFor = "The first angle stands in one matrix, and both links turn by it: the second one's is a product.",
    .chapter = "Motion",
    .number = 36,
    .width = 960,
    .height = 560,
    .animated = true,
    .background = vec4(1, 1, 1, 1),
    .needs = {.depth = true},
    .waste = {{"no-sample", "draw of 'cylinder', up to 8 times",
               "a joint within the limbs that it joins is drawn all the same"}},
};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"slide", "The slide's two links, from 60 and 250 degrees on by 1.2 and -0.1 a frame."},
        {"two-bends",
         "Drag the target: the elbow may bend to either side, until the arm is straight.",
         {.method = Method::closed},
         {{"solutions", 2, 2}}},
        {"any-way",
         "Equal links and the target at the shoulder: the folded arm may point anywhere.",
         {.method = Method::closed, .target = {0, 0, 0.6}, .upper = 1, .lower = 1}},
        {"stalled",
         "A straight arm, its target on its lower link: no method moves it. Bend it by a degree.",
         {.method = Method::dls, .links = {.theta1 = 0, .theta2 = 0}, .target = {1.6, 0, 0.6}},
         {{"iterations-used", 0, 0}}},
        {"arm",
         "Each pose on the way, the joints' limits, and how fast each method comes near. Drag the target.",
         {.which = Which::arm, .method = Method::dls}},
        {"feet",
         "Above, by angles between right poses, the foot slides; below, by inverse kinematics, it stands.",
         {.which = Which::walker, .method = Method::closed, .matrices = false}},
        {"person",
         "A whole figure: each of its twelve joints has a spline of its own through the angles of four poses.",
         {.which = Which::person, .matrices = false},
         {{"through-most", 0, 0}}},
        {"through",
         "Two right poses, and a way between them that is not: the forearm passes through the trunk.",
         {.which = Which::person, .person = {.routine = Routine::handThrough}, .matrices = false},
         {{"through", 1, 1}}},
    };
}

const bool added = addLesson(
    about,
    Lesson<Settings, Gpu>{
        .rows = panelRows(),
        .presets = presets(),
        .controls = {orbitDrag, orbitWheel},
        .handles = {{"target", {"target-x", "target-y", "target-z"}, placeOfTarget}},
        .readouts = {{"end-x", "where the end is", "m"},
                     {"end-y", "the same, upwards", "m"},
                     {"end-z", "the same, to the front", "m"},
                     {"to-target", "from the end to the target", "m"},
                     {"residual", "from the end to the goal: the target, or what stands for it in reach", "m"},
                     {"iterations-used", "until it was there, or came no nearer"},
                     {"solutions", "of two links; none is told where they are infinitely many"},
                     {"at-limit", "joints at one of their limits"},
                     {"slide", "how far the foot that stands is off, at most, forward", "m"},
                     {"slip", "the same by inverse kinematics", "m"},
                     {"turn-jump", "by how much a joint of the person changes its speed at a pose, at most", "deg/s"},
                     {"through", "pairs of the person's parts that are in each other"},
                     {"through-most", "the same, at most in a cycle"}},
        .draw = draw,
        .readOut = readOut,
        .check = check,
        .values = values,
    });

}  // namespace

bool isLinks(const Settings& s) { return s.which == Which::links; }
bool isArm(const Settings& s) { return s.which == Which::arm; }
bool isWalker(const Settings& s) { return s.which == Which::walker; }
bool isPerson(const Settings& s) { return s.which == Which::person; }
bool isForward(const Settings& s) { return isPerson(s) || s.method == Method::forward; }
bool iterates(const Settings& s) { return !isPerson(s) && s.method >= Method::ccd; }
double legOf(const Settings& s) { return s.upper + s.lower; }
std::string nameOf(Method method) { return wordOf(methodWords, method); }

}  // namespace mv::robot_arm
