#pragma once
#include <cstddef>
#include <vector>

#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/scene.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/gl.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "mv/gl/scene_meshes.h"
#include "shared/caster_volumes.h"
#include "shared/orbit.h"

namespace mv::shadow_volume {

enum class Which { cube, stillLife, nested };
enum class Method { zPass, zPassStarted, zFail };
enum class Show { shadow, volumes, count };
enum class Eye { outside, inVolume };
enum class By { processor, geometryShader };
using Caster = CasterVolumes::Caster;

struct Settings {
    Which scene = Which::stillLife;
    int shells = 12;  // of the nested scene
    Method method = Method::zFail;
    Show show = Show::volumes;
    bool silhouette = true;  // false: the edges of every triangle are drawn out
    By by = By::processor;   // finds the silhouette
    bool groups = true;
    Eye eye = Eye::outside;
    double far = 0;          // 0: the view has no end
    double lightTurn = 0;    // degrees
    double lightHeight = 1;  // in the light's first height
    bool atInfinity = false;
    Orbit orbit = {};
};

struct Gpu {
    Program program{"shadow-volume"}, volumeProgram{"shadow-volume", "volume"};
    OnDemand<Mesh> wholePicture{positionsOnly(square()), "whole picture"};
    SceneMeshes meshes;
    CasterVolumes volumes;
    std::vector<Mesh> silhouettes;  // one a caster, as lines
    MadeFor<Which, int, vec4> silhouettesFor;
    OnDemand<Program> sidesProgram{"shadow-volume", "sides"};
    std::vector<Mesh> neighbours;  // one a caster: its triangles with their neighbours
    MadeFor<Which, int> neighboursFor;
};

// The technique: shadow-volume.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void followVolumes(Gpu& gpu, const Settings& s, const Scene& scene);
void countInGroups(Gpu& gpu, const Settings& s, const Scene& scene);
void countVolumes(Gpu& gpu, const Settings& s, const Scene& scene, std::size_t first, std::size_t last);
void startCountAt(Gpu& gpu, int start);
void drawVolume(Gpu& gpu, const Scene& scene, const Caster& caster, std::size_t indices);
void drawObjects(Gpu& gpu, const Scene& scene, double lit);
void drawEverywhere(Gpu& gpu, const vec4& color);
bool needsGroups(const Settings& s, std::size_t casters);
std::size_t countedIndices(const Settings& s, const Caster& caster);
int volumesRoundEye(const Gpu& gpu, const Scene& scene, std::size_t first, std::size_t last);

// The same by a geometry shader: by_shader.cpp. It draws the sides that are shown, and those that are counted by a method without caps.
bool findsByShader(const Settings& s);
bool isByShader(const Settings& s);
void drawSidesByShader(Gpu& gpu, const Settings& s, const Scene& scene, std::size_t first, std::size_t last,
                       const vec4& color);

// The scene, and the drawing over the picture: figure.cpp.
Scene sceneOf(const Settings& s, const FrameInfo& frame);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void tell(const Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

// More casters than this may wrap a count of eight bits round to 0.
inline constexpr std::size_t mostInOneCount = 255;

}  // namespace mv::shadow_volume
