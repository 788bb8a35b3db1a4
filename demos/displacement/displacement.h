#pragma once
#include <array>
#include <optional>
#include <vector>

#include "mv/demo/cached.h"
#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/scene.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "mv/gl/programs.h"
#include "mv/gl/texture.h"
#include "relief_patches.h"
#include "shared/relief.h"
#include "shared/relief_figures.h"

namespace mv::displacement {

enum class Method { tessellated, prepared, bumped };
enum class Levels { fixed, distance };
enum class Paint { surface, levels };

struct Settings {
    ReliefBody body = ReliefBody::wall;
    Method method = Method::tessellated;
    Levels levels = Levels::distance;
    int level = 16;         // pieces of each edge, where the level is fixed
    double fineness = 100;  // pieces of an edge whose length is its distance
    bool agree = true;      // an edge's level comes from the edge, so that both its patches have the same
    bool cull = true;
    double depth = 0.08;    // units; a brick is 1 long
    int mapSize = 256;      // rows of texels
    double distance = 1.5;  // units
    double angle = 65;      // degrees
    bool wireframe = false;
    Paint paint = Paint::surface;
    double lampTurn = -50, lampHeight = 40;  // degrees
    double spinX = 20, spinY = 0;            // degrees
    bool hasTessellator = true;              // of the context: knobs.cpp
};

struct Gpu {
    Programs programs{"displacement"};
    // The patches: several meshes for the tessellator, or one mesh that the processor has cut
    Cached<std::vector<ReliefPatch>, ReliefBody> patches;
    Cached<std::vector<Mesh>, ReliefBody, int> corners;
    Cached<std::vector<Mesh>, ReliefBody, double, int, bool> prepared;
    PatchCount counted;
    Cached<Texture, ReliefBody, int> painted;
    std::optional<double> rasterized;  // triangles of this picture, if a readout asks
    Drawing drawing;
};

// The technique: displacement.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void bindMap(Gpu& gpu, const Settings& s);
const Program& programOf(Gpu& gpu, const Settings& s, const Frame& frame);
void setLight(const Program& program, const Settings& s, const Frame& frame);
void drawPatches(Gpu& gpu, const Program& program, const Settings& s, const Frame& frame);
const std::vector<Mesh>& makePatches(Gpu& gpu, const Settings& s, const LevelRule& rule, const Frame& frame);
void setTessellator(const Program& program, const Settings& s, const LevelRule& rule);
void drawPrepared(Gpu& gpu, const Program& program, const Settings& s, const Frame& frame);
MeshData preparedMesh(const Settings& s, bool isMoved);
LevelRule ruleOf(const Settings& s, const FrameInfo& frame);
bool isTessellated(const Settings& s);
bool isByDistance(const Settings& s);
bool hasLines(const Settings& s, const Frame& frame);

// The scene: scene.cpp. Its world space is the body's space.
Scene sceneOf(const Settings& s, const FrameInfo& frame);
mat4 worldFromBody(const Settings& s);
vec3 towardsLamp(const Settings& s);
vec3 towardsEye(const Settings& s);
vec3 eyeOf(const Settings& s, const FrameInfo& frame);

// Beside the technique: figure.cpp, study.cpp.
LampDial lampDial(const FrameInfo& frame);
void drawCoverage(Gpu& gpu, const Settings& s, const Frame& frame);
void drawCounted(Gpu& gpu, const std::vector<Mesh>& meshes, GLenum mode, const Frame& frame);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void tell(const PatchCount& counted, const Settings& s, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::displacement
