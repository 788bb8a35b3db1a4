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
#include "reflection.h"

namespace mv::shading {

enum class Shading { own, flat, gouraud, phong };
enum class Body { sphere, teapot };
enum class Kind { plastic, diffuse, mirrorLike, brushed, emitting };

struct Settings {
    Shading shading = Shading::gouraud;
    Lobe lobe = Lobe::phong;
    Kind material = Kind::plastic;
    double exponent = 20;
    Body body = Body::sphere;
    int edges = 16;  // round the body
    bool normals = false;
    double lampTurn = 35, lampHeight = 35;  // degrees
    double angle = 45, viewAngle = 20;      // degrees, of the figure's light and eye
    double spinX = 15, spinY = 0;           // degrees
};

// The parts of light that a surface scatters, mirrors and emits.
struct Material {
    double diffuse, highlight, emitted;
    bool isBrushed = false;
};

constexpr double sphereRadius = 1.5;
inline const vec3 eye(0, 0.5, 7);
inline const vec4 red(0.75, 0.15, 0.1, 1), blue(0.1, 0.3, 0.7, 1), grey(0.6, 0.6, 0.6, 1), ink(0.1, 0.1, 0.1, 1);

struct Gpu {
    OnDemand<Program> byPixel{"shading"}, byVertex{"shading", "gouraud"}, byFace{"shading", "flat"};
    OnDemand<Program> plain{"shading", "own"};
    Cached<Mesh, Body, int> body, needles;
    Drawing drawing;
    // The matching exponents: the one at the figure's angle, and the ratios over the angle
    Cached<double, double, double> matching;
    Cached<std::vector<vec2>, double> ratios;
};

// The technique: shading.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
const Program& programOf(Gpu& gpu, Shading shading);
void light(const Program& program, const Settings& s);
Material materialOf(Kind kind);
MeshData bodyOf(const Settings& s);
mat4 worldFromBody(const Settings& s);
vec3 lampOf(const Settings& s);

// The scene, and the drawing beside it: figure.cpp.
Scene sceneOf(const Settings& s, const FrameInfo& frame);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
double matchingAt(Gpu& gpu, const Settings& s);
// A direction in the figure's plane, by its angle from the normal in degrees. The eye's side is positive.
vec3 direction(double angle);
vec2 inFigure(const FrameInfo& frame, double angle, double part);

// study.cpp.
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::shading
