#pragma once
#include <array>

#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "mv/math/shadow_caster.h"

namespace mv::shadow_floor {

struct Settings {
    double zDist = -4;              // of the eye at (1, 1, z)
    double spinX = 0, spinY = 0;    // degrees
    double lightX = 0, lightZ = 0;  // of the light, or of the middle of its circle
    double lightHeight = 2;         // above the floor
    bool circle = true;
    bool crop = true;
    bool rays = true;
};

struct Gpu {
    Program program{"shadow-floor"};
    Mesh plate{positionsOnly(square()), "square"};
    Mesh ball{positionsOnly(sphere(0.04, 16, 8)), "light"};
    Drawing drawing;
};

const vec4 planeOfShadow(0, 1, 0, 0);  // y = 0
constexpr double floorSide = 3;
const std::array<vec3, 4> corners{vec3(-0.5, 0.5, 0.5), vec3(0.5, 0.5, 0.5), vec3(0.5, 0.5, -0.5),
                                  vec3(-0.5, 0.5, -0.5)};  // of the square

// The technique: shadow-floor.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawShadow(Gpu& gpu, const Settings& s, const vec3& light, const mat4& worldFromSquare, const Frame& frame);
void drawMesh(const Program& program, const Mesh& mesh, const vec4& color, const mat4& viewFromModel);
vec3 lightOf(const Settings& s, const FrameInfo& frame);
mat4 viewFromWorldOf(const Settings& s);
mat4 clipFromViewOf(const FrameInfo& frame);

void tell(const Settings& s, const vec3& light, const CasterVerdict& verdict, const Frame& frame);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);

// Measurements: study.cpp. The area of the shadow's part on the floor.
double areaOnFloor(const mat4& shadowFromWorld);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::shadow_floor
