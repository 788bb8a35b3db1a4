#pragma once
#include <string>
#include <vector>

#include "control_net.h"
#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/scene.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/object.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "mv/gl/programs.h"
#include "mv/gl/target.h"
#include "primitive_figure.h"
#include "regular_meshes.h"
#include "stage_table.h"

namespace mv::gpu_stages {

enum class Show { stages, primitives, meshes, compute };
enum class Domain { quads, triangles, isolines };
enum class Kernel { rings, caustics };
enum class Geometry { off, pass, wireframe, shapes, normals, explode };

// A patch on its way through the stages.
struct Stages {
    bool tessellation = true;
    int inner = 8;  // level of the patch's inside
    bool ownEdges = false;
    int outer = 4;  // level of the edges
    Geometry geometry = Geometry::wireframe;
    bool hidden = true;
    double amount = 0.25, bend = 0.1;
    bool fragments = true;
    int direct3d = 11;
    Domain domain = Domain::quads;  // what the tessellator cuts
};
struct Settings {
    Show show = Show::stages;
    Stages stages = {};
    int vertices = 8, cells = 12;
    double spinX = 20, spinY = -30;                        // degrees
    Kernel kernel = Kernel::rings;                         // of the compute shader
    bool counts = true, computes = true, hasWires = true;  // whether the context can: knobs.cpp
};

struct Gpu {
    Programs programs{"gpu-stages"};
    OnDemand<Mesh> patch{positionsOnly(controlPoints()), "patch"}, points{controlPoints(), "control points"};
    OnDemand<Mesh> net{controlNet(), "control net"}, square{positionsOnly(mv::square()), "square"};
    CountedPrimitives toGeometry, sent;  // primitives before and after the geometry stage
    MadeFor<bool, int, int, Geometry, Domain> countedFor;
    long passed = 0;  // fragments that reached the picture
    PrimitiveFigure types;
    RegularFigure bodies;
    Target image;
    TextureObject counts;  // of the rays that landed in each pixel
    MadeFor<int, int> countsFor;
    Drawing drawing;
};

// Each thing that is shown is a part, in a file of its own: stages.cpp, primitives.cpp, meshes.cpp, compute.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawStages(Gpu& gpu, const Settings& s, const Frame& frame);
void drawPrimitives(Gpu& gpu, const Settings& s, const Frame& frame);
void drawMeshes(Gpu& gpu, const Settings& s, const Frame& frame);
void drawCompute(Gpu& gpu, const Settings& s, const Frame& frame);
mat4 turnOf(const Settings& s);

// What goes through the stages: stages.cpp.
const Program& prepare(Gpu& gpu, const Settings& s, Geometry stage, const Frame& frame);
std::vector<std::string> filesOf(const Stages& s, Geometry stage);
const char* evaluationOf(const Stages& s);
const char* fragmentOf(Geometry stage);
vec3 colorOf(const Stages& s, Geometry stage);
void setWireframe(const Program& program, const Frame& frame);
void drawHiddenLines(Gpu& gpu, const Settings& s, const Program& program, const Frame& frame);
Geometry geometryStage(const Stages& s);
Domain domainOf(const Stages& s);
int outerLevel(const Stages& s);
GLenum mode(const Stages& s);
bool hasAmount(Geometry stage);

// Counts, and words beside the picture: figure.cpp.
void submit(Gpu& gpu, const Stages& s);
void drawCounted(Gpu& gpu, const Settings& s, Geometry stage, const Frame& frame);
void countPrimitives(Gpu& gpu, const Settings& s, const Frame& frame);
Scene sceneOf(const Settings& s, const FrameInfo& frame);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);

// knobs.cpp, study.cpp.
const char* nameOf(Geometry stage);
Settings fallback(Settings s);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::gpu_stages
