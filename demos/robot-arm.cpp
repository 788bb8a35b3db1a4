// robot-arm: from the angles of joints to where the hand is (forward kinematics) and back (inverse kinematics), for two
// links in a plane, for an arm on a table, and for a walker whose foot must stand still.
//
// Claims (each is a test in tests/claims/robot-arm.cpp; X36 in docs/stability.md has targets at and beyond the reach):
// - [product] Where a part is is the product of the matrices on the way to it; two links end where the slide's formula says.
// - [by-rates] The angles of a frame are those of the start plus its number times the rates: no sum, no drift.
// - [solutions] Two links have none, one, two or infinitely many solutions, each named, and each drawn ends at the target.
// - [all-arrive] All methods bring the two links, and the arm, within a millimetre of targets that are well within reach.
// - [never-farther] No iteration of any method leaves the end farther from its goal than it was.
// - [nearest] Out of reach damped least squares ends within a thousandth of the reach of the nearest point there is.
// - [straight-stalls] A straight arm with its target on its lower link does not move, by any method. Bent by a degree it
//   arrives, but for coordinate descent, which makes it straight again and stays.
// - [limits-hold] No joint of the arm leaves its limits; without them it reaches targets that it does not reach with them.
// - [foot-slides] By angles between right poses the foot that stands slides: the less the more poses, and never not.
// - [foot-stands] By inverse kinematics it stands: in closed form to rounding, by iteration to its tolerance.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/drawing.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "mv/motion/inverse_kinematics.h"
#include "mv/motion/two_link.h"
#include "shared/jointed.h"
#include "shared/jointed_overlay.h"
#include "shared/turntable.h"
#include "shared/walk.h"

using namespace mv;

namespace {

enum class Which { links, arm, walker };
enum class Method { forward, closed, ccd, transpose, dls };
using Angles = std::vector<double>;  // degrees, one a joint

constexpr int mostIterations = 64, cycleFrames = 84;
constexpr NumberRange beyondReach{1e-3, 100, Scale::logarithmic, true};
constexpr double table = -0.7;  // m, below the shoulder
const vec4 ink(0.1, 0.1, 0.1, 1), grey(0.6, 0.6, 0.6, 1), red(0.8, 0.15, 0.1, 1), pale(0.25, 0.42, 0.70, 0.3);
const vec4 earth(0.80, 0.77, 0.70, 1), other(0.10, 0.55, 0.40, 0.7);

struct RobotArm final : Demo {
    Choice<Which> which{this, "scene", Which::links, {{"two-links"}, {"arm"}, {"walker"}}, "what is moved"};
    Choice<Method> method{this,
                          "method",
                          Method::forward,
                          {{"forward", "the angles are given"},
                           {"closed", "of two links, by the law of cosines"},
                           {"ccd", "cyclic coordinate descent: one joint after the other"},
                           {"transpose", "along the transposed Jacobian"},
                           {"dls", "damped least squares"}},
                          "how the angles are found"};
    Real theta1{this, "theta-1", 60, {-360, 360}, "angle of the first of two links, at the start", "deg"};
    Real theta2{this, "theta-2", 250, {-360, 360}, "angle of the second against the first", "deg"};
    Real rate1{this, "rate-1", 1.2, {-5, 5}, "what theta-1 grows by in a frame of 1/60 s", "deg"};
    Real rate2{this, "rate-2", -0.1, {-5, 5}, "what theta-2 grows by", "deg"};
    Real turn{this, "turn", 25, armTurn, "angle of the arm about the vertical, at the start", "deg"};
    Real shoulder{this, "shoulder", 80, armShoulder, "of its upper arm against the horizontal", "deg"};
    Real elbow{this, "elbow", -70, armElbow, "of its lower arm against the upper", "deg"};
    Real wrist{this, "wrist", -40, armWrist, "of its hand against the lower arm", "deg"};
    Toggle limits{this, "limits", true, "joints of the arm stop where these four knobs end"};
    Real targetX{this, "target-x", 1.1, {-3, 3}, "where the end is to be, from the shoulder", "m"};
    Real targetY{this, "target-y", 0.7, {-3, 3}, "the same, upwards", "m"};
    Real targetZ{this, "target-z", 0.6, {-3, 3}, "the same, to the front", "m"};
    Real beyond{this, "beyond", 0, beyondReach, "the target, in its direction, so far out of reach; 0: it stays", "m"};
    Real upper{this, "upper", 1.2, {0.1, 2}, "length of the first link, the upper arm, the thigh", "m"};
    Real lower{this, "lower", 0.8, {0.1, 2}, "length of the second link, the lower arm, the shank", "m"};
    Whole iterations{this, "iterations", 32, {0, mostIterations}, "at most so many"};
    Toggle others{this, "others", false, "what the arm comes to from eight other starts, too"};
    NumberChoice poses{this, "poses", 4, {4, 8, 16, 32, 64}, "right ones in a cycle, between which angles go evenly"};
    Toggle matrices{this, "matrices", true, "show the product of matrices"};
    Turntable turntable{this, {-3, 6}};

    Readout endX{this, "end-x", "where the end is", "m"};
    Readout endY{this, "end-y", "the same, upwards", "m"};
    Readout endZ{this, "end-z", "the same, to the front", "m"};
    Readout toTarget{this, "to-target", "from the end to the target", "m"};
    Readout residual{this, "residual", "from the end to the goal: the target, or what stands for it in reach", "m"};
    Readout used{this, "iterations-used", "until it was there, or came no nearer"};
    Readout solutions{this, "solutions", "of two links; none is told where they are infinitely many"};
    Readout atLimit{this, "at-limit", "joints at one of their limits"};
    Readout slide{this, "slide", "how far the foot that stands is off, at most, forward", "m"};
    Readout slip{this, "slip", "the same by inverse kinematics", "m"};

    Program program;
    Mesh box, cylinder;
    JointedOverlay overlay;
    bool doesReach = true;  // whether the walker's leg comes to all of the foot's way

    RobotArm() {
        bindHandle("target", {&targetX, &targetY, &targetZ}, [this](const FrameInfo& frame) -> std::optional<vec2> {
            if (!hasTarget() || beyond > 0) return std::nullopt;
            return pictureFromPane(paneOf(frame), projection(paneOf(frame)), target());
        });
        const auto only = [](Literal reason, const std::function<bool()>& when, const std::vector<Knob*>& knobs) {
            for (Knob* knob : knobs) knob->onlyWhen(when, reason);
        };
        only("two links have these angles", [this] { return isLinks(); }, {&theta1, &theta2});
        only("the closed form asks for no start", [this] { return method != Method::closed; }, {&theta1, &theta2});
        only("two links move so by forward kinematics", [this] { return isLinks() && isForward(); }, {&rate1, &rate2});
        only("the arm has these joints", [this] { return isArm(); }, {&turn, &shoulder, &elbow, &wrist, &limits});
        only("the others lie in a plane", [this] { return isArm(); },
             {&turntable.spin.x, &turntable.spin.y, &turntable.distance});
        only("the arm has these by inverse kinematics", [this] { return isArm() && !isForward(); }, {&others});
        only("forward there is no target, and the walker's feet have theirs", [this] { return hasTarget(); },
             {&targetX, &targetY, &targetZ, &beyond});
        only("only the arm's target leaves the plane", [this] { return isArm(); }, {&targetZ});
        only("this method has no iterations", [this] { return iterates(); }, {&iterations});
        only("only the walker goes from pose to pose", [this] { return isWalker(); }, {&poses});
    }

    void init() override {
        program = Program("robot-arm");
        box = Mesh(withoutTexCoords(mv::box({0, -0.5, -0.5}, {1, 0.5, 0.5})), "box");
        cylinder =
            Mesh(withoutTexCoords(lathe(std::vector<vec2>{{0, -0.5}, {1, -0.5}, {1, 0.5}, {0, 0.5}}, 32)), "cylinder");
    }

    void check() const override {
        if (which == Which::arm && method == Method::closed)
            throw Error("--method", "must not be closed where the scene is the arm: the formula is for two links");
    }
    bool isLinks() const { return which == Which::links; }
    bool isArm() const { return which == Which::arm; }
    bool isWalker() const { return which == Which::walker; }
    bool isForward() const { return method == Method::forward; }
    bool hasTarget() const { return !isWalker() && !isForward(); }
    bool iterates() const { return method >= Method::ccd; }

    // ---- forward: from the angles to where everything is

    // The matrix of a part is its parent's times its own: a product along the tree.
    static std::vector<mat4> worldFromParts(const JointTree& tree, const Angles& angles) {
        std::vector<mat4> worldFromPart;
        for (std::size_t i = 0; i < angles.size(); ++i) {
            const auto parent = tree.joints()[i].parent;
            const mat4 parentFromPart = tree.parentFromTurned(i, angles[i]);
            worldFromPart.push_back(parent ? worldFromPart[*parent] * parentFromPart : parentFromPart);
        }
        return worldFromPart;
    }

    // ---- inverse: from where the end is to be to the angles

    // Two links: the elbow turned counter-clockwise (0), or clockwise.
    Angles byFormula(const vec2& to, std::size_t side) const {
        const TwoLinkAngles found = twoLinkAngles(upper, lower, to).angles.at(side);
        return {found.shoulder, found.elbow};
    }

    IkResult byIteration(const Jointed& thing, const Angles& start, const vec3& to, int most, Method by) const {
        static constexpr std::array<IkMethod, 3> methods{IkMethod::cyclicCoordinateDescent, IkMethod::jacobianTranspose,
                                                         IkMethod::dampedLeastSquares};
        const IkMethod ours = methods.at(index(by));
        return solveInverseKinematics(thing.tree, thing.end, to, start, {.method = ours, .mostIterations = most});
    }
    static std::size_t index(Method by) { return static_cast<std::size_t>(by) - static_cast<std::size_t>(Method::ccd); }

    // ---- the walker: where a foot has to be is told by its gait, whatever moves the leg

    double leg() const { return upper + lower; }
    Walk walk() const { return {.upper = upper, .lower = lower, .poses = poses}; }

    // Forward: a few right poses, and between them angles that go evenly from one to the next. Inverse: at any time anew,
    // from where the feet are to be.
    Angles walking(double cycles, Method by) const {
        Angles angles = walk().played(cycles);
        Jointed thing = legs(upper, lower, walk().hip(cycles));
        for (const int side : {0, 1}) {
            const vec2 foot = walk().foot(side, cycles).position;
            thing.end.joint = side == 0 ? 2 : 4;
            if (by == Method::closed)
                std::ranges::copy(byFormula(foot - walk().hip(cycles), 1), angles.begin() + 2 * side + 1);
            if (by >= Method::ccd)
                angles = byIteration(thing, angles, vec3(foot, side == 0 ? legSide : -legSide), iterations, by).degrees;
        }
        return angles;
    }

    // ---- the picture

    void draw(const Frame& frame) override {
        overlay.begin(frame);
        if (isWalker())
            drawWalkers(frame);
        else
            drawOne(frame);
        overlay.above.draw(frame);
    }

    // Left of the matrices and the plot, where these are shown.
    Pane paneOf(const FrameInfo& frame) const {
        const bool besides = matrices || (iterates() && !isWalker());
        return {0, 0, std::max(besides ? frame.width() * 3 / 5 : frame.width(), 1), frame.height()};
    }
    mat4 projection(const Pane& in) const {
        const double narrow = std::max(1.0, 1 / in.aspect()), half = 1.3 * leg() * narrow;
        if (isLinks()) return ortho(-half * in.aspect(), half * in.aspect(), -half, half, -5, 5);
        const mat4 viewFromWorld = lookAt(vec3(1.6, 2.4, 6.6), vec3(0, 0.55, 0), vec3(0, 1, 0));
        const double fovy = 2 * degrees(std::atan(0.325 * narrow));
        return perspective(fovy, in.aspect(), 0.5, 60) * turntable.seenBy(viewFromWorld);
    }

    // What is behind, and then all parts: each is a few boxes that go where its matrix says, and a cylinder for its joint.
    void beginThings(const Frame& frame) {
        overlay.below.draw(frame);
        glEnable(GL_DEPTH_TEST);
        program.use();
        program.set("clipFromWorld", overlay.clipFromWorld());
    }
    void drawThing(const Pane& pane, const Jointed& thing, const std::vector<mat4>& worldFromPart) {
        glViewport(pane.x, pane.y, pane.width, pane.height);
        for (std::size_t i = 0; i < thing.parts.size(); ++i) {
            const JointedPart& part = thing.parts[i];
            if (!part.jointFromBox.empty()) program.set("color", part.color);
            for (const mat4& jointFromBox : part.jointFromBox) {
                program.set("worldFromModel", worldFromPart[i] * jointFromBox);
                box.draw();
            }
            const Joint& joint = thing.tree.joints()[i];
            if (joint.kind == JointKind::fixed) continue;
            program.set("color", vec3(0.32));
            const mat4 jointFromCylinder = (joint.axis.y == 0 ? rotateX(90) : mat4(1)) * scale(0.11, 0.2, 0.11);
            program.set("worldFromModel", worldFromPart[i] * jointFromCylinder);
            cylinder.draw();
        }
    }
    void drawTable() {
        program.set("color", vec3(earth));
        program.set("worldFromModel", translate(-1.6, table - 0.05, 0) * scale(3.2, 0.1, 2.4));
        box.draw();
        program.set("worldFromModel", translate(0, table / 2 - 0.05, 0) * scale(0.2, -table - 0.1, 0.2));
        cylinder.draw();
    }

    // Two links, or the arm.
    void drawOne(const Frame& frame) {
        const Jointed thing = isArm() ? arm(upper, lower, limits) : twoLinks(upper, lower);
        Angles angles = isArm() ? Angles{turn, shoulder, elbow, wrist} : Angles{theta1, theta2};
        overlay.look(paneOf(frame), projection(paneOf(frame)));
        if (isLinks()) overlay.ring(std::abs(upper - lower), leg());
        std::vector<std::string> words{"forward: the angles are given"};
        if (method == Method::closed) angles = solve(thing, words);
        if (iterates()) angles = iterate(frame, thing, angles, words);
        if (isLinks() && isForward()) {
            std::vector<vec2> path;  // of the end, in the last 300 frames
            for (int i = std::max(0, frame.index() - 300); i <= frame.index(); ++i) {
                angles = {theta1 + i * rate1, theta2 + i * rate2};
                path.push_back(overlay.pixel(vec3(twoLinkEnd(upper, lower, {angles[0], angles[1]}), 0)));
            }
            overlay.above.line(path, {red, 1.5});
        }

        const std::vector<mat4> worldFromPart = worldFromParts(thing.tree, angles);
        beginThings(frame);
        drawThing(overlay.pane(), thing, worldFromPart);
        if (isArm()) drawTable();
        glViewport(0, 0, frame.width(), frame.height());
        const vec3 end = stickOf(thing, worldFromPart).back();
        overlay.above.point(overlay.clipFromWorld(), end, 7, ink);
        words.push_back("end at " + place(end));
        for (const std::string& each : words) overlay.say(each);
        overlay.angles(thing, worldFromPart, angles);
        if (matrices) overlay.product(frame, thing, worldFromPart, angles, overlay.pane().width, isLinks());
        endX = end.x;
        endY = end.y;
        endZ = end.z;
        if (!isForward()) toTarget = glm::distance(end, target());
    }

    vec3 target() const {
        const vec3 at(targetX, targetY, isArm() ? double(targetZ) : 0);
        if (beyond == 0) return at;
        const vec3 direction = glm::length(at) > 0 ? glm::normalize(at) : vec3(1, 0, 0);
        return (leg() + (isArm() ? armHand : 0) + beyond) * direction;
    }
    std::string place(const vec3& at) const {
        const std::string inPlane = shortNumber(at.x) + ", " + shortNumber(at.y);
        return "(" + inPlane + (isArm() ? ", " + shortNumber(at.z) : "") + ")";
    }
    void stick(const Jointed& thing, const Angles& angles, const Stroke& stroke) {
        overlay.stick(thing, worldFromParts(thing.tree, angles), stroke);
    }

    // How many solutions two links have for the target.
    std::string counted(const TwoLinkAnswer& answer) {
        static const std::array<std::string, 4> counts{"no solution", "one solution", "two solutions",
                                                       "infinitely many solutions"};
        if (answer.solutions != TwoLinkSolutions::infinitelyMany) solutions = double(answer.solutions);
        return counts.at(static_cast<std::size_t>(answer.solutions));
    }

    // In closed form: all solutions, or some of infinitely many, and why there are so many.
    Angles solve(const Jointed& thing, std::vector<std::string>& words) {
        const TwoLinkAnswer answer = twoLinkAngles(upper, lower, vec2(target()));
        const std::string why(answer.reason);
        const std::size_t colon = why.find(':');  // a long reason has two lines
        words = {counted(answer) + ":", why.substr(0, colon)};
        if (colon != std::string::npos) words.push_back(why.substr(colon + 2));
        if (answer.distance > 0) words.push_back(rounded("nearest point: %.3g m away", answer.distance));
        Angles angles = byFormula(vec2(target()), 1);
        if (answer.solutions == TwoLinkSolutions::infinitelyMany) {
            for (int degrees = 0; degrees < 360; degrees += 15) stick(thing, {double(degrees), angles[1]}, {pale, 3});
        } else {
            stick(thing, byFormula(vec2(target()), 0), {pale, 7});
        }
        overlay.target(target(), stickOf(thing, worldFromParts(thing.tree, angles)).back());
        return angles;
    }

    // By iteration: each pose from the start on, and how fast each of the methods comes near.
    Angles iterate(const Frame& frame, const Jointed& thing, const Angles& start, std::vector<std::string>& words) {
        static const std::array<std::string, 5> ends{"reached", "out of reach, its projection reached",
                                                     "out of reach, its projection not yet",
                                                     "stalled: no step comes nearer", "not yet there"};
        const IkResult result = byIteration(thing, start, target(), iterations, method);
        const int taken = static_cast<int>(result.history.size()) - 1;
        for (int k = 0; k < taken; ++k)  // a run of fewer iterations is the beginning of a longer one
            stick(thing, byIteration(thing, start, target(), k, method).degrees, {pale, 2.5});
        for (int k = 0; isArm() && others && k < 8; ++k)
            stick(thing, byIteration(thing, armStart(k), target(), mostIterations, method).degrees, {other, 2.5});
        overlay.target(target(), result.goal);
        if (isArm()) overlay.above.edge(overlay.clipFromWorld(), target(), {target().x, table, target().z}, {grey, 1});
        if (isArm() && std::abs(target().y) < leg() + armHand)  // where the ball of its reach is cut at that height
            overlay.circleAt(target().y, std::sqrt(std::pow(leg() + armHand, 2) - std::pow(target().y, 2)));
        const std::string armSolutions = result.goal == target()
                                             ? "4 angles for 3 coordinates: in general infinitely many solutions"
                                             : "no solution";
        words = {
            method.text() + ": " + ends.at(static_cast<std::size_t>(result.end)),
            rounded("iterations: %.0f", taken) + rounded(", joints at a limit: %.0f", double(result.atLimit.size())),
            isArm() ? armSolutions : counted(twoLinkAngles(upper, lower, vec2(target()))),
            "target at " + place(target())};
        if (result.goal != target()) {
            words.push_back("projected to " + place(result.goal));
            frame.say("The target is out of reach: the end goes for its projection, " + place(result.goal) + ".");
        }
        plotResiduals(frame, thing, start);
        residual = result.history.back().residual;
        used = taken;
        atLimit = double(result.atLimit.size());
        return result.degrees;
    }

    // For the study: how far the arm's end is from the target, from each of 60 starts; at the start where nothing iterates.
    std::vector<double> values() const override {
        const Jointed thing = arm(upper, lower, limits);
        const Method by = iterates() ? Method(method) : Method::dls;
        const int most = iterates() ? int(iterations) : 0;
        std::vector<double> distances(60);
        for (int k = 0; double& each : distances) each = byIteration(thing, armStart(k++), target(), most, by).distance;
        return distances;
    }

    // By angles that are played, and below on the same ground by inverse kinematics.
    void drawWalkers(const Frame& frame) {
        const double now = double(frame.index()) / cycleFrames, x = walk().hip(now).x;
        const int rows = isForward() ? 1 : 2, height = std::max(frame.height() / rows, 1);
        for (int row = 0; row < rows; ++row) {
            const Pane pane = paneOf(frame), part{0, pane.height - height * (row + 1), pane.width, height};
            const double wide = 1.6 * leg() * part.aspect();
            const mat4 clipFromView = ortho(-0.7 * wide, 0.3 * wide, -0.2 * leg(), 1.4 * leg(), -20, 20);
            overlay.look(part, clipFromView * rotateY(-18) * translate(-x, 0, 0));
            const double off = showTrack(now, row == 0 ? Method::forward : method);
            (row == 0 ? slide : slip) = off;
            overlay.say(row == 0 ? rounded("forward, %.0f right poses a cycle", poses) : "inverse: " + method.text());
            overlay.say(rounded("the foot that stands is off by up to %.2g m", off), off > 1e-3 ? red : ink);
            if (row == 1 && !doesReach) overlay.say("the leg does not reach all of the foot's way", red);
        }
        beginThings(frame);
        const Jointed thing = legs(upper, lower, walk().hip(now));
        for (int row = 0; row < rows; ++row) {
            const Angles angles = walking(now, row == 0 ? Method::forward : method);
            const std::vector<mat4> worldFromPart = worldFromParts(thing.tree, angles);
            drawThing({0, frame.height() - height * (row + 1), overlay.pane().width, height}, thing, worldFromPart);
            if (matrices && row == rows - 1)
                overlay.product(frame, thing, worldFromPart, angles, overlay.pane().width, true);
        }
        glViewport(0, 0, frame.width(), frame.height());
    }

    // The near foot in each frame of the last two cycles; returns how far it was off while it stood, at most.
    double showTrack(double now, Method by) {
        overlay.below.fill({{0, 0}, {double(overlay.pane().width), overlay.pixel(vec3(0)).y}}, earth);
        double most = 0;
        doesReach = true;
        std::vector<vec2> track;
        for (int i = -2 * cycleFrames; i <= 0; ++i) {
            const double cycles = now + double(i) / cycleFrames;
            const Jointed thing = legs(upper, lower, walk().hip(cycles));
            const vec3 foot = thing.tree.endPosition(walking(cycles, by), thing.end);
            track.push_back(overlay.pixel(foot));
            const FootTarget wanted = walk().foot(0, cycles);
            const vec2 way = wanted.position - walk().hip(cycles);
            doesReach = doesReach && twoLinkAngles(upper, lower, way).solutions != TwoLinkSolutions::none;
            if (!wanted.stands) continue;
            most = std::max(most, glm::distance(vec2(foot), wanted.position));
            const vec2 mark = overlay.pixel(vec3(wanted.position, legSide));
            overlay.below.line(mark - vec2(0, 14), mark, {ink, 1.5});
            overlay.above.point(track.back(), 5, red);
        }
        overlay.above.line(track, {grey, 1.5});
        return most;
    }

    void plotResiduals(const Frame& frame, const Jointed& thing, const Angles& start) {
        const std::vector<Option> names = method.options();
        std::vector<ResidualCurve> curves;
        for (const Method by : {Method::ccd, Method::transpose, Method::dls}) {
            const IkResult result = byIteration(thing, start, target(), mostIterations, by);
            curves.push_back({names[static_cast<std::size_t>(by)].word, result.history, by == method});
        }
        overlay.residuals(frame, curves, paneOf(frame).width, iterations, mostIterations);
    }
};

constexpr Declaration declaration{
    .name = "robot-arm",
    .sentence = "From the angles of joints to the hand and back: two links, an arm, and a walker's feet.",
    .lookFor = "The first angle stands in one matrix, and both links turn by it: the second one's is a product.",
    .chapter = "Motion",
    .number = 36,
    .width = 960,
    .height = 560,
    .animated = true,
    .background = vec4(1, 1, 1, 1),
    .needs = {.depth = true},
    .presets =
        {
            {"slide", "The slide's two links, from 60 and 250 degrees on by 1.2 and -0.1 a frame."},
            {"two-bends",
             "Drag the target: the elbow may bend to either side, until the arm is straight.",
             {{"method", "closed"}},
             {{"solutions", 2, 2}}},
            {"any-way",
             "Equal links and the target at the shoulder: the folded arm may point anywhere.",
             {{"method", "closed"}, {"upper", "1"}, {"lower", "1"}, {"target-x", "0"}, {"target-y", "0"}}},
            {"stalled",
             "A straight arm, its target on its lower link: no method moves it. Bend it by a degree.",
             {{"method", "dls"}, {"theta-1", "0"}, {"theta-2", "0"}, {"target-x", "1.6"}, {"target-y", "0"}},
             {{"iterations-used", 0, 0}}},
            {"arm",
             "Each pose on the way, the joints' limits, and how fast each method comes near. Drag the target.",
             {{"scene", "arm"}, {"method", "dls"}}},
            {"feet",
             "Above, by angles between right poses, the foot slides; below, by inverse kinematics, it stands.",
             {{"scene", "walker"}, {"method", "closed"}, {"matrices", "off"}}},
        },
};

const bool added = addDemo<RobotArm, declaration>();

}  // namespace
