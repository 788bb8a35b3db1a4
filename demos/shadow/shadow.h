#pragma once
#include <array>

#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "mv/math/shadow_caster.h"
#include "mv/math/transform.h"

namespace mv::shadow {

struct Settings {
    double lightHeight = 2;     // above the plane y = 0
    double squareHeight = 0.5;  // of the square's middle
    double tilt = 0;            // degrees
    bool rays = true;
};

struct Gpu {
    Program program{"shadow"};
    Mesh square{positionsOnly(mv::square()), "square"};
    Drawing drawing;
};

const vec4 planeOfShadow(0, 1, 0, 0);  // y = 0
const mat4 viewFromWorld = lookAt(vec3(1, 1, 1), vec3(0, 0, 0), vec3(0, 1, 0));

// The technique: shadow.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawShadow(Gpu& gpu, const vec4& light, const mat4& worldFromModel, const Frame& frame);
vec4 lightOf(const Settings& s, const FrameInfo& frame);
mat4 worldFromModelOf(const Settings& s);
mat4 clipFromViewOf(const FrameInfo& frame);
std::array<vec3, 4> cornersOf(const mat4& worldFromModel);

void tell(const CasterVerdict& verdict, const Frame& frame);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::shadow
