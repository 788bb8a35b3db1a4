#pragma once
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/scene.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
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
    bool agree = true, cull = true;
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
    std::map<std::pair<bool, bool>, Program> programs;  // with tessellation, with lines
    // The patches: several meshes for the tessellator, or one mesh that the processor has cut
    std::vector<ReliefPatch> patches;
    std::vector<Mesh> corners, prepared;
    PatchCount counted;
    MadeFor<ReliefBody> patchesFor;
    MadeFor<ReliefBody, int> cornersFor;
    MadeFor<ReliefBody, double, int, bool> preparedFor;
    Texture painted;
    MadeFor<ReliefBody, int> paintedFor;
    std::optional<double> rasterized;  // triangles of this picture, if a readout asks
    Drawing drawing;
};

// The technique: displacement.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void bindMap(Gpu& gpu, const Settings& s);
const Program& programOf(Gpu& gpu, const Settings& s, const Frame& frame);
void setLight(const Program& program, const Settings& s, const Frame& frame);
void drawPatches(Gpu& gpu, const Program& program, const Settings& s, const Frame& frame);
void makePatches(Gpu& gpu, const Settings& s, const LevelRule& rule, const Frame& frame);
void setTessellator(const Program& program, const Settings& s, const LevelRule& rule);
void drawPrepared(Gpu& gpu, const Program& program, const Settings& s, const Frame& frame);
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
void clearCoverage();
void drawCounted(Gpu& gpu, const std::vector<Mesh>& meshes, GLenum mode, const Frame& frame);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void tell(const PatchCount& counted, const Settings& s, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::displacement
