#pragma once
#include <array>
#include <vector>

#include "lamp_light.h"
#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/scene.h"
#include "mv/gl/drawing.h"
#include "mv/gl/program.h"
#include "mv/gl/scene_meshes.h"

namespace mv::lights {

enum class Kind { off, ambient, directional, point, spot };
enum class Tint { own, white, red, green, blue };
enum class Ask { reaching, all };  // which lights the shader asks for each pixel
inline constexpr std::size_t lightCount = 8;

struct Settings {
    std::array<Kind, lightCount> kinds{Kind::ambient, Kind::directional, Kind::point, Kind::spot};
    std::array<vec2, lightCount> places{vec2(0, 0),       vec2(-0.75, 0.9), vec2(-0.35, 0.6), vec2(1.7, 0.6),
                                        vec2(-1.6, -0.9), vec2(2.2, -0.9),  vec2(-1.6, 1.2),  vec2(1.2, 1.5)};
    double height = 1.3;  // m
    double power = 1.5;   // at 1 m, by 1/d^2
    double constant = 0, linear = 0, quadratic = 1;
    double size = 0.05;  // radius of a lamp, m
    double cutOff = 0;
    double inner = 18, outer = 26;         // degrees
    vec2 aim{1.1, -0.2}, mark{-0.2, 1.1};  // x and z on the floor
    Ask ask = Ask::reaching;
    bool encode = true, logLog = false;
    Tint lightColor = Tint::own, surfaceColor = Tint::own;
};

inline const std::array<vec3, lightCount> hues{vec3(1, 1, 1),       vec3(1, 0.92, 0.75), vec3(1, 0.75, 0.5),
                                               vec3(0.55, 0.75, 1), vec3(1, 0.45, 0.4),  vec3(0.5, 1, 0.5),
                                               vec3(0.5, 0.6, 1),   vec3(1, 0.55, 0.9)};

struct Gpu {
    Program program{"lights"};
    SceneMeshes meshes;
    Drawing drawing;
};

// The technique: lights.cpp. A light is known by its index, from 0.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void setLights(const Program& program, const Settings& s, const std::vector<std::size_t>& sent);
vec3 strength(const Settings& s, std::size_t light);
vec3 tinted(Tint tint, const vec3& own);
vec3 ambient(const Settings& s);
Falloff falloff(const Settings& s);
double reach(const Settings& s);
vec3 placeOf(const Settings& s, std::size_t light);
vec3 towardsSun(const Settings& s, std::size_t light);
vec3 axisOf(const Settings& s, std::size_t light);
bool reaches(const Settings& s, const Scene& scene, std::size_t light);
std::vector<std::size_t> sentLights(const Settings& s, const Scene& scene);

// The scene, and the drawing over it: figure.cpp.
bool isLamp(Kind kind);
bool hasPlace(Kind kind);
bool isOn(const Settings& s, Kind kind);
vec3 aim(const Settings& s);
vec3 marked(const Settings& s);
Pane paneOf(const FrameInfo& frame);
Pane drawnPane(const Frame& frame);
Scene sceneOf(const Settings& s, const FrameInfo& frame);
void check(const Settings& s);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);

// knobs.cpp, study.cpp.
const char* nameOf(Kind kind);
vec3 arriving(const Settings& s, std::size_t light, const vec3& point, const vec3& normal);
double lightAtMark(const Settings& s);
double stored(double light);
void tell(const Settings& s, const Scene& scene, const std::vector<std::size_t>& sent, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::lights
