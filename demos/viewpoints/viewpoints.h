#pragma once
#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"

namespace mv::viewpoints {

enum class View { distant, inside, outside, driver, house, behind, front, beside, above };
enum class Space { world, car };
enum class Outside { off, all, one };

struct Settings {
    View view = View::distant;
    double height = 0;              // added to that of the eye
    bool exact = false;             // of view 5
    double aim = 0;                 // of view 5: how high on the house
    Outside camera = Outside::all;  // what is shown from outside, above the picture
    bool lit = true;                // shaded boxes under a sky
};

struct Gpu {
    Program program{"viewpoints"};
    Mesh track{ringStrip(90, 110, 100), "track"};
    OnDemand<Mesh> ground{positionsOnly(square()), "ground"};  // where there is a sky
    MeshData plainCube = colorCube();
    Mesh cube;
    Drawing drawing;
    Gpu() {
        plainCube.colors.clear();  // each thing here has one colour, a uniform
        cube = Mesh(plainCube, "cube");
    }
};

// The car on its lap.
struct Car {
    double direction;  // degrees, clockwise from +y
    vec3 place;
    mat4 worldFromCar, carFromWorld;
};

// The arguments of lookAt, and the space of eye and at.
struct Gaze {
    vec3 eye, at;
    Space space;
    vec3 up{0, 0, 1};
};

struct Look {
    mat4 viewFromWorld, viewFromCar;
};

void draw(Gpu& gpu, const Settings& s, const Frame& frame);
Car carAt(int frame);
Gaze gazeOf(const Settings& s, const Car& car);
Look lookFrom(const Settings& s, const Car& car);
void drawSkyAndGround(Gpu& gpu, const mat4& viewFromWorld, const mat4& clipFromView);
void drawScenery(Gpu& gpu, const mat4& clipFromView, const mat4& viewFromWorld);
void drawCar(Gpu& gpu, const mat4& viewFromCar);
vec3 watchedPlace(const Settings& s);

// look.cpp: what lookAt computes. The axes of a camera are unit vectors to the right, up, and back from what it looks at.
struct Axes {
    vec3 u, v, w;
};
Axes axesOf(const Gaze& gaze);
mat4 turnInto(const Axes& axes);
mat4 viewByAxes(const Gaze& gaze);
vec3 eyeOf(const mat4& view);
void setSun(const Gpu& gpu, const Settings& s, const mat4& viewFromWorld);

// knobs.cpp, study.cpp, figure.cpp.
void check(const Settings& s);
Pane lowerPane(const Settings& s, const FrameInfo& frame);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::viewpoints
