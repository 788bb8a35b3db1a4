#pragma once
#include <optional>
#include <vector>

#include "mv/demo/cached.h"
#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/mesh_data.h"
#include "mv/geometry/scene.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "mv/gl/scene_meshes.h"
#include "mv/gl/target.h"
#include "mv/math/stereo.h"

namespace mv::stereocube {

enum class Stereo { toeIn, offAxis };
enum class Colors { lines, masks };
enum class Paper { white, black };
enum class Eyes { both, left, right, sideBySide, crossed };
enum class Shape { cube, hypercube, stillLife };
enum class Mix { full, half, grey, leastSquares };

// A cube of four dimensions: its turns in the planes that spin-x and spin-y leave, and how it is projected to three.
struct Hypercube {
    double xy = 0, xw = 0, yw = 0, zw = 0;  // degrees
    double inner = 0.3;                     // side of the farthest cell, where the nearest has 1
    bool operator==(const Hypercube&) const = default;
};

struct Settings {
    double eyeSep = 0.2;
    double zDist = -3;              // of the eyes, which look along +z
    double convergence = 2;         // the distance from the eyes to the screen
    double spinX = 20, spinY = 30;  // degrees
    Stereo stereo = Stereo::toeIn;
    Colors colors = Colors::lines;
    int lineWidth = 3;  // px
    Paper background = Paper::white;
    Eyes eyes = Eyes::both;
    double screenWidth = 0;  // mm, of the whole picture; 0: not known
    bool plan = true;
    Shape shape = Shape::cube;
    Hypercube four = {};
    Mix mix = Mix::full;
};

struct Gpu {
    OnDemand<Program> program{"stereocube"};
    Cached<Mesh, Shape, Hypercube> wire;
    // Of a still life: its surfaces, a picture for each eye, and what makes one of both
    OnDemand<Program> surface{"stereocube", "surface"}, mix{"stereocube", "mix"};
    OnDemand<Mesh> cover{MeshData{.positions = {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}}}, "picture"};
    SceneMeshes things;
    Target ofLeft, ofRight;
    Drawing drawing;  // of the figure
};

constexpr double near = 0.2, far = 100;
constexpr double betweenPupils = 63.5;  // mm, on average

struct Lens {
    double fovy, aspect;
};

// The camera of one eye: its place and direction, and its window.
struct Eye {
    Eyes which;  // left or right
    mat4 eyeFromWorld, clipFromEye;
};

// The technique: stereocube.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawWires(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right, const Frame& frame);
void drawLines(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right, const FrameInfo& frame);
void drawMasked(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right, const FrameInfo& frame);
void drawBeside(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right, const Frame& frame);
void drawInked(Gpu& gpu, const Settings& s, const Eye& eye, const FrameInfo& frame);
void drawWire(Gpu& gpu, const Settings& s, const Eye& eye, const vec4& color, const FrameInfo& frame);
std::vector<vec2> penOf(int width);
Eye leftEye(const Settings& s, const Lens& lens);
Eye rightEye(const Settings& s, const Lens& lens);
Eye eyeAt(double x, Eyes which, const Settings& s, const Lens& lens);
Lens lensOf(const Settings& s, const FrameInfo& frame);
bool isBeside(const Settings& s);
bool isShaded(const Settings& s);
Pane paneOf(const Settings& s, const FrameInfo& frame, int column);
mat4 worldFromModelOf(const Settings& s);
MeshData wireOf(const Settings& s);

// An anaglyph of coloured surfaces: shaded.cpp.
void drawAnaglyph(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right, const Frame& frame);
void drawSurfaces(Gpu& gpu, const Settings& s, const Eye& eye, const FrameInfo& frame);
Scene stillLifeOf(const Settings& s);
std::vector<vec3> pointsOf(const Settings& s);

// How both eyes' colours become one, and what each glass lets through: glasses.cpp. All of it is of light, not of sRGB: the
// screen's red, green and blue, 0..1.
struct Mixing {
    mat3 fromLeft, fromRight;
};
Mixing mixingOf(Mix mix);
Mixing leastSquares();
vec3 mixed(const Mixing& mixing, const vec3& left, const vec3& right);
mat3 seenThrough(Eyes eyes);
vec3 brightnessThrough(Eyes eyes);
double crosstalk(Eyes eye);

// Four dimensions: hypercube.cpp.
mat4 turnOf(const Hypercube& four);
double divisorOf(const Hypercube& four, const vec4& turned);
MeshData wireHypercube(const Hypercube& four);
double leastDivisor(const Hypercube& four);

// A ruler and a plan over the picture: figure.cpp. Lengths on the screen, in mm, need its width.
struct OnScreen {
    double most;                       // the largest parallax behind the screen
    std::optional<double> atInfinity;  // off-axis: the parallax of what is infinitely far away
};
void figure(Gpu& gpu, const Settings& s, const Frame& frame);
void drawRuler(Gpu& gpu, const Settings& s, const FrameInfo& frame, const OnScreen& here);
void drawPlan(Gpu& gpu, const Settings& s, const FrameInfo& frame);
bool hasPlan(const Settings& s);
std::optional<Parallax> parallaxOf(const Settings& s, const FrameInfo& frame);
std::optional<OnScreen> onScreen(const Settings& s, const FrameInfo& frame);

void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::stereocube
