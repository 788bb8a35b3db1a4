#pragma once
#include <string>
#include <vector>

#include "body.h"
#include "jointed.h"
#include "jointed_overlay.h"
#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "mv/motion/curve.h"
#include "mv/motion/gait.h"
#include "mv/motion/inverse_kinematics.h"
#include "shared/orbit.h"

namespace mv::robot_arm {

enum class Which { links, arm, walker, person };
enum class Method { forward, closed, ccd, transpose, dls };
enum class Between { straight, spline };

// Two links. Angles are degrees, rates degrees a frame.
struct Links {
    double theta1 = 60, theta2 = 250, rate1 = 1.2, rate2 = -0.1;
};
// The arm on its table, and the eye's orbit.
struct Arm {
    double turn = 25, shoulder = 80, elbow = -70, wrist = -40;  // degrees
    bool limits = true, others = false;
    Orbit orbit = {};
};
struct Person {
    Routine routine = Routine::walk;
    Between between = Between::spline;
};
struct Settings {
    Which which = Which::links;
    Method method = Method::forward;
    Links links = {};
    Arm arm = {};
    Person person = {};
    vec3 target{1.1, 0.7, 0.6};       // m; z is the arm's alone
    double beyond = 0;                // m, 0: the target stays
    double upper = 1.2, lower = 0.8;  // m
    int iterations = 32;
    int poses = 4;  // of the walker, in a cycle
    bool matrices = true;
};

struct Gpu {
    Program program{"robot-arm"};
    Mesh box{withoutTexCoords(mv::box({0, -0.5, -0.5}, {1, 0.5, 0.5})), "box"};
    Mesh cylinder{withoutTexCoords(lathe(std::vector<vec2>{{0, -0.5}, {1, -0.5}, {1, 0.5}, {0, 0.5}}, 32)), "cylinder"};
    JointedOverlay overlay;
};

using Angles = std::vector<double>;  // degrees, one a joint
constexpr int mostIterations = 64, cycleFrames = 84;
constexpr double table = -0.7;  // m, below the shoulder
inline const vec4 robotInk(0.1, 0.1, 0.1, 1), robotGrey(0.6, 0.6, 0.6, 1), robotRed(0.8, 0.15, 0.1, 1),
    robotEarth(0.80, 0.77, 0.70, 1);

// The technique: robot-arm.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawLinks(Gpu& gpu, const Settings& s, const Frame& frame);
std::vector<mat4> worldFromParts(const JointTree& tree, const Angles& angles);
IkResult find(const Settings& s, const Jointed& thing, int index);
Angles byFormula(const Settings& s, const vec2& to, std::size_t side);
IkResult byIteration(const Jointed& thing, const Angles& start, const vec3& to, int most, Method by);
Jointed thingOf(const Settings& s);
Angles anglesAt(const Settings& s, int index);
vec3 targetOf(const Settings& s);
vec3 beyondReach(const Settings& s, const vec3& target, double reach);
void beginParts(Gpu& gpu, const Frame& frame);
void drawParts(Gpu& gpu, const Pane& pane, const Jointed& thing, const std::vector<mat4>& worldFromPart);
mat4 clipFromWorldOf(const Settings& s, const Pane& pane);

// Two links and the arm: links.cpp, arm.cpp.
struct Limb {
    Jointed (*thing)(const Settings& s);
    Angles (*anglesAt)(const Settings& s, int index);
    vec3 (*target)(const Settings& s);
    mat4 (*clipFromWorld)(const Settings& s, const Pane& pane);
};
extern const Limb limbOfLinks, limbOfArm;
void drawTable(Gpu& gpu);

// The walker: walker.cpp. A step of its near foot: the place of the foot, and its target.
struct Step {
    vec3 foot;
    FootTarget wanted;
    bool isInReach;
};
void drawWalkers(Gpu& gpu, const Settings& s, const Frame& frame);
Angles walking(const Settings& s, double cycles, Method by);
std::vector<Step> trackOf(const Settings& s, double cycles, Method by);
double offOf(const std::vector<Step>& track);

// The whole figure: person.cpp.
void drawPerson(Gpu& gpu, const Settings& s, const Frame& frame);
Angles personAngles(const Settings& s, double cycles);
std::vector<Curve<double>> curvesOf(const Settings& s);
double cyclesAt(int index);

// Ghosts, curves and words over two links or the arm: figure.cpp.
void showLinks(JointedOverlay& overlay, const Settings& s, const Jointed& thing, const IkResult& found,
               const std::vector<mat4>& worldFromPart, const Frame& frame);
Pane paneOf(const Settings& s, const FrameInfo& frame);
Pane besideOf(const Settings& s, const FrameInfo& frame);

// knobs.cpp, study.cpp.
bool isLinks(const Settings& s);
bool isArm(const Settings& s);
bool isWalker(const Settings& s);
bool isPerson(const Settings& s);
bool isForward(const Settings& s);
bool iterates(const Settings& s);
double legOf(const Settings& s);  // m, both links
std::string nameOf(Method method);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);
std::vector<double> values(const Settings& s);

}  // namespace mv::robot_arm
