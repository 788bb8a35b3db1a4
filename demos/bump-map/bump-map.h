#pragma once
#include <utility>

#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/demo/numbers.h"
#include "mv/demo/own_file.h"
#include "mv/geometry/mesh_data.h"
#include "mv/geometry/scene.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "mv/gl/tangent_buffer.h"
#include "mv/gl/texture.h"
#include "shared/relief.h"
#include "shared/relief_figures.h"

namespace mv::bump_map {

enum class Method { smooth, height, normal, parallax, occlusion, displaced };
enum class Kept { floats, bytes };

struct Settings {
    ReliefBody body = ReliefBody::wall;
    Method method = Method::normal;
    bool beside = true;
    double angle = 50;    // degrees
    double depth = 0.08;  // units; a brick is 1 long
    int mapSize = 256;    // rows of texels
    Kept texels = Kept::floats;
    int layers = 32;
    OwnFile<Picture> picture = {};
    bool mirrored = false, sign = true;
    double lampTurn = 50, lampHeight = 40;  // degrees
    double spinX = 20, spinY = 0;           // degrees
};

struct Gpu {
    OnDemand<Program> smooth{"bump-map", "smooth"}, byHeight{"bump-map", "height"}, byNormal{"bump-map"},
        byParallax{"bump-map", "parallax"}, byOcclusion{"bump-map", "occlusion"}, mapProgram{"bump-map", "map"};
    OnDemand<Mesh> sheet{withoutNormals(square()), "map"};
    // The smooth surface with its tangents, the displaced surface (one piece of the wall), and a mirrored piece
    Mesh flat, real, turned;
    Buffer tangents;
    MadeFor<ReliefBody, bool> flatFor;
    MadeFor<ReliefBody, int, int, double, bool> realFor;
    // The maps
    FloatPicture heights;
    Texture painted, normals;
    MadeFor<ReliefBody, int, int> heightsFor;
    MadeFor<ReliefBody, int, int, Texels> paintedFor;
    MadeFor<ReliefBody, int, int, Texels, double> normalsFor;
    Drawing drawing;
};

// The technique: bump-map.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
const Program& programOf(Gpu& gpu, const Settings& s);
void setLight(const Program& program, const Settings& s, const Frame& frame);
void makeSmooth(Gpu& gpu, const Settings& s);
void drawMapped(Gpu& gpu, const Program& program, const Settings& s, const Pane& pane);
void drawReal(Gpu& gpu, const Settings& s, const Pane& pane);
bool usesFrames(Method method);
bool usesNormals(Method method);

// The maps: maps.cpp.
void bindMaps(Gpu& gpu, const Settings& s);
FloatPicture heightMap(const Settings& s);
Texels formatOf(const Settings& s);

// The scene: scene.cpp. Its world space is the body's space.
constexpr double wallEnd = 64;  // units from the middle of the wall to its ends
Scene sceneAt(const Settings& s, double aspect);
Scene sceneOf(const Settings& s, const FrameInfo& frame);
Relief reliefOf(const Gpu& gpu, const Settings& s);
mat4 worldFromBody(const Settings& s);
vec3 towardsLamp(const Settings& s);
vec3 towardsEye(const Settings& s);
std::pair<int, int> piecesInView(const Settings& s, double aspect);
bool isMirrored(const Settings& s);
bool showsBoth(const Settings& s);
Pane leftPane(const Settings& s, const Frame& frame);
Pane rightPane(const FrameInfo& frame);

// Beside the technique: figure.cpp, study.cpp.
SightFigure sightFigure(const FrameInfo& frame);
LampDial lampDial(const FrameInfo& frame);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
vec2 measuredBand(const Settings& s);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::bump_map
