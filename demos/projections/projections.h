#pragma once
#include <array>
#include <string>

#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/edges.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "shared/scenes.h"
#include "vanishing.h"

namespace mv::projections {

enum class Show { cad, axonometric, oblique, vanishing };

// The view that is yours is set by these: turned, a perspective or an oblique one.
struct Settings {
    Show show = Show::cad;
    double turn = 30, tilt = 20;       // degrees: how far the eye goes round and up
    double distance = 14;              // metres from the eye to the house
    double angle = 30, length = 0.75;  // oblique: direction and length of a metre of depth
    double shift = 0;                  // of the perspective's window, in its half heights
};

// The view of a pane, in metres. `half` is the distance from its middle to its upper edge.
struct View {
    std::string name;
    mat4 viewFromWorld;
    double half;
    vec3 shortening{0};   // of x, y and z by the formulas, in a parallel view
    double distance = 0;  // of the eye from the middle, in a perspective; a parallel view has 0
    double shift = 0;     // of a perspective's window, upwards, in its half heights
    bool isParallel() const { return distance == 0; }
};
using FourViews = std::array<View, 4>;

// The corners of the walls. Bits 0, 1, 2 of the number choose the high end of x, y, z.
std::array<vec3, 8> wallCorners();

struct Gpu {
    Program faces{"projections"}, lines{"projections", "lines"};
    Mesh house{meshOf(mv::house()), "house"};
    Mesh edges{edgesOf(meshOf(mv::house())), "edges"};
    Mesh rays{linesToInfinity(wallCorners()), "rays"};
    Mesh horizon{horizonLines(), "horizon"};
    Drawing drawing;
};

inline const std::array<vec4, 3> axisColors{vec4(0.80, 0.10, 0.10, 1), vec4(0.05, 0.50, 0.10, 1),
                                            vec4(0.10, 0.25, 0.90, 1)};

// The technique: projections.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void beginPane(const Pane& pane);
void drawToInfinity(const Gpu& gpu, const mat4& clipFromWorld, const Pane& pane);
FourViews views(const Settings& s);
FourViews cadViews(const Settings& s);
FourViews axonometricViews(const Settings& s);
FourViews obliqueViews(const Settings& s);
FourViews vanishingViews(const Settings& s);
mat4 clipFromWorld(const View& view, const Pane& pane);
double halfShown(const View& view, double aspect);  // half the height that a pane shows, metres
mat4 clipFromView(const View& view, double aspect);

// Measurements of a picture: study.cpp. `drawn` is the image of a metre along each axis, in pixels, and `length` the length of
// this image, in metres.
struct Axes {
    std::array<vec2, 3> drawn;
    vec3 length;
};
Axes measuredAxes(const View& view, const Pane& pane);
// The number of the axes' vanishing points, and the most by which an edge of the walls misses its own, in pixels.
struct Meeting {
    int points = 0;
    double miss = 0;
};
Meeting meetingIn(const View& view, const Pane& pane);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

// figure.cpp.
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);

}  // namespace mv::projections
