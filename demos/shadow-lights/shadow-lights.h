#pragma once
#include <cstddef>
#include <vector>

#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/light_view.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/depth_map.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "mv/gl/scene_meshes.h"
#include "shared/caster_volumes.h"
#include "shared/orbit.h"

namespace mv::shadow_lights {

enum class Which { lamps, circle, placed };
enum class Method { maps, volumes };

struct Settings {
    Which scene = Which::lamps;
    int lights = 3;                                                  // on the circle
    std::vector<vec2> places{{-1.5, 0.8}, {0.6, -0.9}, {1.8, 0.9}};  // x and z, of the scene placed
    Method method = Method::volumes;
    int resolution = 1024;  // texels along a side of each map
    double reach = 20;      // distance at which a light ends
    bool keep = true;
    Orbit orbit = {};
};

// The shadow of one light, by either method.
struct Shadow {
    CasterVolumes volumes = {};
    DepthMap map = {};
    LightView view = {};
    MadeFor<int, mat4, std::vector<mat4>> mapFor = {};  // its size, the light's view, and where the casters stand
};

struct Gpu {
    Program program{"shadow-lights"}, plain{"shadow-lights", "plain"};
    OnDemand<Mesh> bulb{positionsOnly(sphere(0.05, 16, 8)), "bulb"};
    SceneMeshes meshes;
    std::vector<Shadow> shadows;         // one a light
    DepthMap noMap = DepthMap::empty();  // for the draws that read no map
    int remade = 0;                      // shadows remade in this frame
};

// The technique: shadow-lights.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawUnlit(Gpu& gpu, const Settings& s, const Scene& scene);
void addByMap(Gpu& gpu, const Scene& scene, std::size_t i);
void addByVolumes(Gpu& gpu, const Settings& s, const Scene& scene, std::size_t i);
void addLight(Gpu& gpu, const Scene& scene, std::size_t i);
void drawObjects(Gpu& gpu, const Scene& scene, const mat4& mapFromWorld);
void countVolumes(Gpu& gpu, const Settings& s, const Scene& scene, std::size_t i);
void drawMap(Gpu& gpu, const Settings& s, const Scene& scene, std::size_t i);
LightView viewOf(const Scene& scene, const SceneLight& light);
std::vector<std::size_t> lightsThatReach(const Settings& s, const Scene& scene);

// The scene, and the drawing over the picture: figure.cpp.
vec3 over(const vec2& place);
Scene sceneOf(const Settings& s, const FrameInfo& frame);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::shadow_lights
