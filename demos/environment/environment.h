#pragma once
#include <optional>

#include "mv/demo/cached.h"
#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/demo/numbers.h"
#include "mv/demo/own_file.h"
#include "mv/geometry/scene.h"
#include "mv/geometry/shapes.h"
#include "mv/geometry/teapot.h"
#include "mv/gl/cube_map.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "shared/fresnel.h"
#include "shared/orbit.h"
#include "surroundings.h"

namespace mv::environment {

enum class Around { room, sky };
enum class Body { sphere, teapot };
enum class Material { mirror, gold, copper, glass };
enum class Curve { exact, schlick };
enum class Through { first, both, inside };
enum class Lookup { direction, walls, rays };

struct Settings {
    Around around = Around::room;
    Body body = Body::sphere;
    Material material = Material::mirror;
    double index = 1.5;  // of the glass, relative to its surroundings
    Curve fresnel = Curve::exact;
    Through refract = Through::both;
    Lookup lookup = Lookup::direction;
    bool split = true;
    double roomSize = 3;  // radii of the sphere
    int cubeSize = 256;   // texels along a side of each face
    bool seamless = true;
    double ball = -7;  // degrees
    bool moving = true;
    bool keep = true;
    OwnFile<Picture> picture = {};
    OwnFile<ObjMesh> model = {};
    Orbit orbit = {};
};

struct Gpu {
    Program program{"environment"};
    OnDemand<Program> roomProgram{"environment", "room"}, skyProgram{"environment", "sky"},
        crossProgram{"environment", "cross"};
    OnDemand<Mesh> round{withoutTexCoords(sphere(1, 128, 64)), "sphere"},
        teapotMesh{withoutTexCoords(tessellated(teapot(), 12)), "teapot"},
        box{withoutTexCoords(mv::box(vec3(-1), vec3(1))), "walls"},
        ballMesh{withoutTexCoords(sphere(1, 48, 24)), "ball"},
        pane{MeshData{.primitive = Primitive::triangleStrip,
                      .positions = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}}},
             "pane"};
    Cached<Mesh, int> model;
    Cached<CubeMap, int, int> skyMap;
    CubeMap roomMap;
    OnDemand<CubeMap> noCube{skyCube(1), "no cube"};  // the sampler must have a cube, even where rays look up none
    MadeFor<int, double> roomFor;
    double drawnRound = 0;  // degrees: the ball's place in the cube map
    int facesDrawn = 0;     // for this picture
    Drawing drawing;
};

// The technique: environment.cpp, and room.cpp for the surroundings.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawMirroring(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame);
void bindRoom(Gpu& gpu, const Settings& s, const Frame& frame);
void bindSky(Gpu& gpu, const Settings& s, const Frame& frame);
std::array<FloatPicture, cubeFaces> skyFaces(const Settings& s);
void drawBody(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame);
void setSurface(const Program& program, const Settings& s);
int waysOut(const Settings& s);
Coating coatingOf(const Settings& s);
const Mesh& bodyOf(Gpu& gpu, const Settings& s);
MeshData fitted(MeshData mesh);
double reachOf(const MeshData& mesh);
mat4 worldFromBody(const Settings& s);
bool isSphere(const Settings& s);
bool inRoom(const Settings& s);
bool looksUp(const Settings& s);
bool splits(const Settings& s);

int drawFaces(Gpu& gpu, const Settings& s, const Frame& frame);
void drawAround(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame);
void drawSky(Gpu& gpu, const Scene& scene);
void setRoom(const Program& program, const Room& room);
Room roomOf(const Settings& s, const FrameInfo& frame);
vec3 eyeOf(const Scene& scene);

// Beside the technique: knobs.cpp, figure.cpp, study.cpp.
const char* nameOf(Body body);
const char* nameOf(Material material);
const char* nameOf(Lookup lookup);
Scene sceneOf(const Settings& s, const FrameInfo& frame);
Pane viewPane(const FrameInfo& frame);
Pane paneOf(const Frame& frame);
void tell(const Settings& s, const Frame& frame);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void drawMeasured(Gpu& gpu, const Settings& s, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::environment
