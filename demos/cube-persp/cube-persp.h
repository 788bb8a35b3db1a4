#pragma once
#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "mv/math/projection.h"
#include "shared/view_figure.h"

namespace mv::cube_persp {

struct Settings {
    double near = 0.3, far = 3;  // distances in front of the eye
    double fov = 65;             // degrees, the whole vertical angle
    double aspect = 1;
    double spinX = 30, spinY = 40;  // degrees
    double shift = 0;               // of the window on the near plane to the right, in its half widths
    bool volume = true;             // show the pyramid of view, from outside
};

struct Gpu {
    Program program{"cube-persp"};
    Mesh cube{colorCube(), "cube"};
    Drawing drawing;
};

void draw(Gpu& gpu, const Settings& s, const Frame& frame);
mat4 viewFromModel(const Settings& s);
mat4 clipFromView(const Settings& s);
FrustumBounds nearWindow(const Settings& s);
Pane paneOf(const Settings& s, const FrameInfo& frame);
ViewFigure figureOf(const Settings& s);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void check(const Settings& s);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::cube_persp
