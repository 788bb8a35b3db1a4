#pragma once
#include <string>
#include <vector>

#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/mesh_data.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"

namespace mv::pipeline {

// Each vertex by three matrices, or by one, multiplied in float or in double.
enum class Products { shader, single, once };
enum class Matrices { right, slideModel, slideProjection };

struct Settings {
    double distance = 3;             // from the cube's middle back to the eye
    int vertex = 7;                  // bits 0, 1, 2 choose the high end of x, y, z
    double spinX = 20, spinY = -15;  // degrees
    double near = 0.5, far = 10;
    double offset = 0;  // of cube and eye along x, from the origin of the world
    Products products = Products::shader;
    Matrices matrices = Matrices::right;
};

constexpr double half = 0.6;  // of the cube's edge
vec3 corner(int i);
MeshData cubeFaces();
MeshData cubeCorners();

struct Gpu {
    OnDemand<Program> byThree{"pipeline"}, byOne{"pipeline", "once"};
    Mesh cube{cubeFaces(), "cube"}, corners{cubeCorners(), "corners"};
    Drawing drawing;
};

// One product, for instance clip = clipFromCamera * camera.
struct Step {
    std::string to, from;
    mat4 uploaded;  // the GPU's matrix, before it is rounded to float
    mat4 exact;
};
std::string matrixName(const Step& step);

// The technique: pipeline.cpp. The view is on the left of the picture, the numbers on the right.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
Program& programOf(Gpu& gpu, const Settings& s);
std::vector<Step> steps(const Settings& s, double aspect);
mat4 worldFromModel(const Settings& s);
mat4 cameraFromWorld(const Settings& s);
mat4 clipFromCamera(const Settings& s, double aspect);
constexpr int numbersWidth = 600, numbersHeight = 500;  // units
bool numbersBeside(const FrameInfo& units);
double numbersScale(const FrameInfo& units);  // less than 1 where they would be cut off, 0 where there is no room
Pane viewIn(const FrameInfo& frame);

// OpenGL's steps after the vertex shader: it clips, divides by w, and maps to the pixels of the view.
bool isInView(const vec4& clip);
vec3 deviceFromClip(const vec4& clip);
vec3 pixelFromDevice(const vec3& device, const Pane& pane);  // z is the depth

// The vertex in clip space, as the GPU computes it and in double precision throughout.
struct Clip {
    vec4 gpu, exact;
};
Clip clipOf(const Settings& s, double aspect);

// figure.cpp, study.cpp.
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);
std::vector<double> values(const Settings& s);

}  // namespace mv::pipeline
