#pragma once
#include <utility>

#include "mv/demo/cached.h"
#include "mv/demo/frame.h"
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

// The smooth surface with its tangents; the displaced surface, of the wall one piece, and a mirrored piece.
struct SmoothSurface {
    Mesh mesh;
    Buffer tangents;
};
struct DisplacedSurface {
    Mesh mesh, turned;
};

struct Gpu {
    OnDemand<Program> smooth{"bump-map", "smooth"}, byHeight{"bump-map", "height"}, byNormal{"bump-map"},
        byParallax{"bump-map", "parallax"}, byOcclusion{"bump-map", "occlusion"}, mapProgram{"bump-map", "map"};
    OnDemand<Mesh> sheet{withoutNormals(square()), "map"};
    Cached<SmoothSurface, ReliefBody, bool> flat;
    Cached<DisplacedSurface, ReliefBody, int, int, double, bool> real;
    // The maps
    Cached<FloatPicture, ReliefBody, int, int> heights;
    Cached<Texture, ReliefBody, int, int, Texels> painted;
    Cached<Texture, ReliefBody, int, int, Texels, double> normals;
    Drawing drawing;
};

// The technique: bump-map.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawBumped(Gpu& gpu, const Settings& s, const Frame& frame);
void drawSmooth(Gpu& gpu, const Settings& s, const Pane& pane, const Frame& frame);
void drawByHeight(Gpu& gpu, const Settings& s, const Pane& pane, const Frame& frame);
void drawByNormal(Gpu& gpu, const Settings& s, const Pane& pane, const Frame& frame);
void drawByParallax(Gpu& gpu, const Settings& s, const Pane& pane, const Frame& frame);
void drawByOcclusion(Gpu& gpu, const Settings& s, const Pane& pane, const Frame& frame);
void drawDisplaced(Gpu& gpu, const Settings& s, const Pane& pane, const Frame& frame);
const Program& begin(const Program& program, const Settings& s, const Pane& pane, const Frame& frame);
void setFrames(const Program& program, const Settings& s);
void setRelief(const Program& program, const Settings& s);
void drawFlat(Gpu& gpu, const Program& program, const Settings& s, const Pane& pane);
SmoothSurface makeSmooth(const Relief& relief);
void drawReal(Gpu& gpu, const Program& program, const Settings& s, const Pane& pane);
DisplacedSurface makeDisplaced(const Relief& relief);

// The maps: maps.cpp.
void bindMaps(Gpu& gpu, const Settings& s);
Texture upload(const Settings& s, const FloatPicture& map, const char* label);
bool usesNormals(Method method);
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
