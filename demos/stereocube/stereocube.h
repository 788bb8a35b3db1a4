#pragma once
#include <optional>

#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/mesh_data.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "mv/math/stereo.h"

namespace mv::stereocube {

enum class Stereo { toeIn, offAxis };
enum class Colors { lines, masks };
enum class Paper { white, black };
enum class Eyes { both, left, right, sideBySide, crossed };
enum class Shape { cube, hypercube };

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
    Paper background = Paper::white;
    Eyes eyes = Eyes::both;
    double screenWidth = 0;  // mm, of the whole picture; 0: not known
    Shape shape = Shape::cube;
    Hypercube four = {};
};

struct Gpu {
    Program program{"stereocube"};
    Mesh wire;
    MadeFor<Shape, Hypercube> wireFor;
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
void drawLines(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right, const FrameInfo& frame);
void drawMasked(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right, const FrameInfo& frame);
void drawBeside(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right, const FrameInfo& frame);
void drawWire(Gpu& gpu, const Settings& s, const Eye& eye, const vec4& color);
Eye leftEye(const Settings& s, const Lens& lens);
Eye rightEye(const Settings& s, const Lens& lens);
Eye eyeAt(double x, Eyes which, const Settings& s, const Lens& lens);
Lens lensOf(const Settings& s, const FrameInfo& frame);
bool isBeside(const Settings& s);
Pane paneOf(const Settings& s, const FrameInfo& frame, int column);
mat4 worldFromModelOf(const Settings& s);
MeshData wireOf(const Settings& s);

// Four dimensions: hypercube.cpp.
mat4 turnOf(const Hypercube& four);
double divisorOf(const Hypercube& four, const vec4& turned);
MeshData wireHypercube(const Hypercube& four);
double leastDivisor(const Hypercube& four);

// A ruler over the picture: figure.cpp. Lengths on the screen, in mm, need its width.
struct OnScreen {
    double most;                       // the largest parallax behind the screen
    std::optional<double> atInfinity;  // off-axis: the parallax of what is infinitely far away
};
void figure(Gpu& gpu, const Settings& s, const Frame& frame);
std::optional<Parallax> parallaxOf(const Settings& s, const FrameInfo& frame);
std::optional<OnScreen> onScreen(const Settings& s, const FrameInfo& frame);

void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::stereocube
