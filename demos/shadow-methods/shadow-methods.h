#pragma once
#include <optional>
#include <vector>

#include "lit_difference.h"
#include "mv/demo/cached.h"
#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/demo/numbers.h"
#include "mv/demo/word_list.h"
#include "mv/geometry/light_view.h"
#include "mv/gl/depth_map.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "mv/gl/scene_meshes.h"
#include "shared/caster_volumes.h"
#include "shared/orbit.h"

namespace mv::shadow_methods {

enum class Which { cube, stillLife, balls };
enum class Method { none, matrix, volume, map, mapHardware, pcf3, pcf5 };
enum class Against { off, none, matrix, volume, map, mapHardware, pcf3, pcf5 };
enum class Show { picture, difference };

inline constexpr WordList methodWords{{"none", "no shadow"},
                                      {"matrix", "what casts, flattened onto floor and wall"},
                                      {"volume", "shadow volumes, counted by z-fail"},
                                      {"map", "shadow map, one texel"},
                                      {"map-hardware", "four texels, weighted"},
                                      {"pcf3", "3 x 3 such looks"},
                                      {"pcf5", "5 x 5"}};

struct Settings {
    Which scene = Which::stillLife;
    Method method = Method::map;
    Against against = Against::volume;
    double split = 0.5;  // widths of the picture
    Show show = Show::picture;
    int resolution = 256;  // texels along a side of the map
    bool receiver = false;
    double slopeBias = 0;  // texels
    bool keep = true;
    double ballHeight = 0.9;  // metres, of the lifted balls
    Orbit orbit = {};
};

struct Gpu {
    OnDemand<Program> byLight{"shadow-methods"}, byMap{"shadow-methods", "map"}, flat{"shadow-methods", "flat"};
    SceneMeshes meshes;
    CasterVolumes volumes;
    DepthMap map;
    Cached<LightView, Which, double> lightView;
    MadeFor<Which, double, int, bool, double> mapFor;
    LitDifference difference;
    std::optional<LitDifference::Found> found;  // in this frame
};

// The technique: shadow-methods.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
Scene beginScene(Gpu& gpu, const Settings& s, Method beside, const Frame& frame);
void drawSplit(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame);
void drawScene(Gpu& gpu, const Scene& scene, Method by);
void drawLit(Gpu& gpu, const Scene& scene, Method by);
void drawByMatrix(Gpu& gpu, const Scene& scene, Method by);
void drawFlattened(Gpu& gpu, const Scene& scene);
void drawByVolumes(Gpu& gpu, const Scene& scene, Method by);
void drawByMap(Gpu& gpu, const Scene& scene, Method by);
bool makeMap(Gpu& gpu, const Settings& s, const Scene& scene);
const Program& useLight(Gpu& gpu, const Scene& scene);
bool usesMap(Method method);
int looksAlong(Method method);
Method secondOf(const Settings& s);
int middleOf(const Settings& s, const Frame& frame);

// The scene, the second picture and the words: figure.cpp.
Scene sceneOf(const Settings& s, const FrameInfo& frame);
void drawDifference(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void drawAlone(Gpu& gpu, const Settings& s, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::shadow_methods
