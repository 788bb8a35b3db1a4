#pragma once
#include <optional>
#include <vector>

#include "mv/demo/cached.h"
#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/drawing.h"
#include "mv/gl/functions.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"

namespace mv::cube_cull {

enum class Cull { none, back, front, both };
enum class Winding { ccw, cw };
enum class Body { cube, teapot, openTeapot };

struct Settings {
    Body body = Body::cube;
    int divisions = 12;  // along a side of each of the teapot's patches
    Cull cull = Cull::back;
    Winding winding = Winding::ccw;
    bool depth = true;
    double zDist = -4;              // of the eye on the z axis
    double spinX = 20, spinY = 30;  // degrees
    bool apart = true;              // the figure beside the picture
};

struct Gpu {
    Program program{"cube-cull"};
    Cached<Mesh, Body, int> body;
    Mesh axes{mv::axes(1.5), "axes"};
    std::optional<Program> distances;  // for the study alone
    Drawing drawing;                   // for the figure, as the next
    Cached<Mesh> apart;
};

void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawBody(Gpu& gpu, const Program& program, const Settings& s, const Frame& frame);
mat4 viewFromModel(const Settings& s);
mat4 clipFromView(double aspect);
GLenum glFaces(Cull cull);
GLenum glWinding(Winding winding);
void check(const Settings& s);

// body.cpp
MeshData bodyOf(const Settings& s);
std::vector<fvec4> clipCorners(const MeshData& mesh, const Settings& s, double aspect);

// figure.cpp
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);

// nearest_faces.cpp: of each pixel, the upper row first, how far along the gaze the first face is that its ray meets, from either
// side; -1 where there is none, or none between the near plane and the far one.
std::vector<double> nearestFaces(const Settings& s, const FrameInfo& frame);

// study.cpp
void drawDistances(Gpu& gpu, const Settings& s, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::cube_cull
