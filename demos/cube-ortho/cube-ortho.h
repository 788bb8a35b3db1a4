#pragma once
#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "shared/view_figure.h"

namespace mv::cube_ortho {

struct Settings {
    double depth = 2, width = 2, height = 2;  // of the box of view
    double distance = 0;                      // from the eye to the middle of the cube and the box
    bool mirrorDepth = false;
    double spinX = 30, spinY = 40;  // degrees
    bool volume = true;             // show the box of view, from outside
};

struct Gpu {
    Program program{"cube-ortho"};
    Mesh cube{colorCube(), "cube"};
    Drawing drawing;
};

void draw(Gpu& gpu, const Settings& s, const Frame& frame);
mat4 viewFromModel(const Settings& s);
mat4 clipFromView(const Settings& s);
double nearDistance(const Settings& s);
double farDistance(const Settings& s);
Pane paneOf(const Settings& s, const FrameInfo& frame);
ViewFigure figureOf(const Settings& s);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
double halfDepth(const Settings& s);
void check(const Settings& s);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::cube_ortho
