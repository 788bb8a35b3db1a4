#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/scene.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "shared/scenes.h"

namespace mv::view_volume {

enum class Projection { perspective, orthographic };
enum class Planes { parameters, matrix, floatMatrix };
enum class Round { box, ball };  // what stands for a thing where it is tested
enum class Stage { cube, sides, plane };

struct Settings {
    Projection projection = Projection::perspective;
    double near = 8, far = 30;  // metres before the camera
    int closer = 1;             // divisor of near
    double pan = 0;             // degrees, of the camera to the left
    bool cull = true;
    Planes planes = Planes::parameters;
    Round round = Round::box;
    double turn = 65, tilt = 32;  // degrees, of the view from outside
    Stage stage = Stage::cube;    // shown in the right pane
    bool sight = false;           // draw lines of sight
    double nearUsed() const { return near / closer; }
};

constexpr double fovy = 50, aspect = 1;  // of the camera
double boxHalf();                        // of the parallel projection's box, in metres
inline const vec4 nearColor(0.10, 0.25, 0.90, 1), farColor(0.80, 0.10, 0.10, 1);

struct Ball {
    vec3 center;
    double radius;
};
using Corners = std::array<vec3, 8>;

// The corners of a box round an object, and a ball about its middle, in world space.
Corners boxOf(const SceneObject& object);
Ball ballOf(const SceneObject& object);
MeshData groundLines();
MeshData outlineOf(const MeshData& mesh);

struct Gpu {
    Program faces{"view-volume"};
    std::vector<SceneObject> things = garden().objects;  // the house first, then trees
    Mesh house{things[0].mesh, "house"}, tree{things[1].mesh, "tree"}, ground{groundLines(), "ground"};
    OnDemand<Mesh> houseOutline{outlineOf(things[0].mesh), "house's edges"};
    OnDemand<Mesh> treeOutline{outlineOf(things[1].mesh), "tree's edges"};
    std::vector<Corners> boxes;
    std::vector<Ball> balls;
    Drawing drawing;
    Gpu() {
        for (const SceneObject& thing : things) {
            boxes.push_back(boxOf(thing));
            balls.push_back(ballOf(thing));
        }
    }
};

// The things that are drawn, and how many of them cross a plane.
struct Kept {
    std::vector<std::size_t> things;
    int crossing = 0;
};

// In camera space, each as (unit normal inwards, distance): left, right, bottom, top, near, far.
using SixPlanes = std::array<vec4, 6>;

// The technique: view-volume.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
Kept keptOf(const Gpu& gpu, const Settings& s);
SixPlanes cameraPlanes(const Settings& s);
SixPlanes planesInFloat(const mat4& clipFromCamera);
SixPlanes planesOfBox(const Settings& s);
mat4 clipFromCamera(const Settings& s);
mat4 cameraFromWorld(const Settings& s);
mat4 turned(const Settings& s);
std::vector<Pane> panesOf(const FrameInfo& frame);
mat4 outsideFromWorld(const Settings& s, const Pane& pane);
mat4 cubeFromClip(const Settings& s, const Pane& pane);
// With isCutOpen the shader leaves out what is outside the view volume.
void beginPane(const Gpu& gpu, const Pane& pane, const mat4& paneFromWorld, bool isCutOpen);
void drawThings(const Gpu& gpu, const Kept& kept, const Mesh& house, const Mesh& tree);

// stages.cpp: clipFromCamera is clipFromSides * sidesFromCamera.
mat4 stageFromCamera(const Settings& s);
mat4 planeFromCamera(const Settings& s);
mat4 sidesFromCamera(const Settings& s);
mat4 clipFromSides(const Settings& s);
mat4 paneFromStage(const Settings& s, const Pane& pane);

// figure.cpp, knobs.cpp, study.cpp.
std::vector<std::array<vec3, 2>> sightLines(const Settings& s);  // in the camera's space, from near to far
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void check(const Settings& s);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);
std::vector<double> values(const Settings& s);

}  // namespace mv::view_volume
