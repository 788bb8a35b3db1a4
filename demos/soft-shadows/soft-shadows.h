#pragma once
#include <vector>

#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/geometry/light_view.h"
#include "mv/gl/depth_map.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "mv/gl/scene_meshes.h"
#include "mv/gl/target.h"

namespace mv::soft_shadows {

enum class Which { cube, table };
enum class Method { matrix, maps, pcf, pcss, blur };
enum class Sum { floats, bytes };
enum class Shape { square, disc, tube };

struct Settings {
    Which scene = Which::cube;
    Method method = Method::matrix;
    int lights = 256;  // points of the lamp
    Sum accumulate = Sum::floats;
    int taps = 9;           // along a side
    int resolution = 1024;  // texels along a side
    Shape lampShape = Shape::square;
    double lampSize = 1;  // its side, diameter or length
    double lampTurn = 0;  // degrees
    double casterHeight = 0.2;
    double spinX = 0, spinY = 0;  // degrees
    bool section = true;          // through lamp and caster, in a corner
};

struct Gpu {
    Program shading{"soft-shadows"}, plain{"soft-shadows", "plain"};
    OnDemand<Program> byMap{"soft-shadows", "map"}, byPcss{"soft-shadows", "pcss"};
    SceneMeshes meshes;
    Target darkness;  // of each pixel: 0 where it sees the whole lamp, 1 where it sees none
    DepthMap map;
    LightView lightOfMap;
    MadeFor<Which, int, mat4, std::vector<mat4>> mapFor;
    Drawing drawing;
};

// The technique: soft-shadows.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void clearDarkness(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame);
void addByMatrix(Gpu& gpu, const Scene& scene, const std::vector<vec3>& points);
void addByMaps(Gpu& gpu, const Settings& s, const Scene& scene, const std::vector<vec3>& points);
void addByMap(Gpu& gpu, const Scene& scene, const vec3& point, double share, int side);
void addByPcss(Gpu& gpu, const Settings& s, const Scene& scene);
void shade(Gpu& gpu, const Scene& scene, int side);
void keepMap(Gpu& gpu, const Settings& s, const Scene& scene);
void drawMap(Gpu& gpu, const Settings& s, const Scene& scene);
LightView viewFrom(const Scene& scene, const vec3& point);
bool isByPoints(const Settings& s);

// The method's name, and a section through the lamp: figure.cpp.
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);

// The lamp's points, or its middle: scene.cpp.
std::vector<vec3> pointsOf(const Settings& s, const SceneLight& lamp);
vec2 onDisc(const vec2& onSquare);
Scene sceneOf(const Settings& s, const FrameInfo& frame);

}  // namespace mv::soft_shadows
