#pragma once
#include <vector>

#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/scene.h"
#include "mv/gl/drawing.h"
#include "mv/gl/gl.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "mv/gl/scene_meshes.h"
#include "mv/math/shadow_caster.h"

namespace mv::cube_shadows {

enum class Which { plane, room, stillLife };
enum class Formula { general, axisAligned, transposed };
enum class Space { planeLocal, world, worldFloat };
enum class Cut { clip, discard, none };

inline constexpr double floorBelow = 1.0125;  // of the floor below the middle of the scene

struct Settings {
    Which scene = Which::room;
    double lightTheta = 50, lightPhi = 64, lightDistance = 6;  // degrees about the upright axis and from it; length
    bool atInfinity = false;
    double lift = 0;        // of all casters
    double tilt = 0;        // degrees
    double darkness = 0.6;  // the part of the light that a shadow takes away
    bool once = true;       // darken each pixel once, however many shadows fall on it
    Cut cut = Cut::clip;
    Formula formula = Formula::general;
    double planeDistance = floorBelow;  // of the floor from the world's origin
    Space space = Space::planeLocal;
    double theta = 15, phi = 70, distance = 13;  // of the eye, like those of the light
    double fov = 55;                             // degrees
    bool rays = true;
};

// A plane that receives shadows, given by its unit normal and a point on it. `local` is relative to that point.
struct Plane {
    vec3 normal, origin;
    vec4 inWorld() const;
    vec4 local() const { return {normal, 0}; }
    vec4 localOf(const vec4& light) const { return {vec3(light) - light.w * origin, light.w}; }
};

// An object of the scene that is such a plane. `tag` is its value in the stencil buffer.
struct Ground {
    ObjectId object;
    PlaneKind kind;
    Plane plane;
    GLint tag;
};

// A mesh in one colour, unlit.
MeshData painted(MeshData mesh, const vec3& color);
MeshData lampShape();
MeshData edgesOfCube();

struct Gpu {
    Program surfaces{"cube-shadows"}, shadows{"cube-shadows", "shadow"};
    SceneMeshes meshes;
    OnDemand<Mesh> lamp{lampShape(), "light"}, edges{edgesOfCube(), "edges"};
    Drawing drawing;
};

// The technique: cube-shadows.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawSurfaces(Gpu& gpu, const Settings& s, const Scene& scene);
void drawSurface(Gpu& gpu, const Scene& scene, const Mesh& mesh, const mat4& worldFromModel);
void drawShadows(Gpu& gpu, const Settings& s, const Scene& scene);
void drawShadow(Gpu& gpu, const Settings& s, const Scene& scene, const Plane& plane, const SceneObject& caster,
                const Mesh& mesh);
bool isLit(const Settings& s, const Plane& plane);
CasterVerdict judged(const Settings& s, const SceneObject& caster, const Ground& ground);
mat4 flattened(const Settings& s, const mat4& targetFromWorld, const Plane& plane, const mat4& worldFromModel);

// The scene, relative to its middle: scene.cpp.
Scene sceneOf(const Settings& s, const FrameInfo& frame);
std::vector<Ground> groundsOf(const Settings& s);  // the floor, and the wall where there is one
vec4 lightOf(const Settings& s);                   // homogeneous, in world space
vec3 middleOf(const Settings& s);
bool showsFront(const Settings& s, const Plane& plane);
void check(const Settings& s);

// The drawing over the picture, and the words beside it: figure.cpp.
void drawEdgesAndLamp(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void tell(const Settings& s, const Scene& scene, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);
std::vector<double> values(const Settings& s);

}  // namespace mv::cube_shadows
