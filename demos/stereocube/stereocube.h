#pragma once
#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"

namespace mv::stereocube {

enum class Stereo { toeIn, offAxis };
enum class Colors { lines, masks };
enum class Paper { white, black };
enum class Eyes { both, left, right };

struct Settings {
    double eyeSep = 0.2;
    double zDist = -3;              // of the eyes, which look along +z
    double convergence = 2;         // the distance from the eyes to the screen
    double spinX = 20, spinY = 30;  // degrees
    Stereo stereo = Stereo::toeIn;
    Colors colors = Colors::lines;
    Paper background = Paper::white;
    Eyes eyes = Eyes::both;
};

struct Gpu {
    Program program{"stereocube"};
    Mesh cube{wireCube(), "cube"};
};

constexpr double fovy = 50, near = 0.2, far = 100;

// What one eye sees with: its place and direction, and its window.
struct Eye {
    Eyes which;  // left or right
    mat4 eyeFromWorld, clipFromEye;
};

// The technique: stereocube.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawLines(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right);
void drawMasked(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right);
void drawCube(Gpu& gpu, const Settings& s, const Eye& eye, const vec4& color);
Eye leftEye(const Settings& s, double aspect);
Eye rightEye(const Settings& s, double aspect);
Eye eyeAt(double x, Eyes which, const Settings& s, double aspect);
mat4 worldFromModelOf(const Settings& s);

void check(const Settings& s);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::stereocube
