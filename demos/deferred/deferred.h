#pragma once
#include <vector>

#include "mv/demo/frame.h"
#include "mv/geometry/scene.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/programs.h"
#include "shared/orbit.h"
#include "targets.h"

namespace mv::deferred {

enum class Way { forward, deferred, lampByLamp };
enum class Sum { bits8, halfFloat };
enum class Tone { clamp, reinhard };
enum class Show { picture, targets };

inline constexpr int mostLamps = 96;  // as the shaders' arrays
inline constexpr vec3 background(0.09, 0.1, 0.12);

struct Settings {
    Way way = Way::deferred;
    int lamps = 48;
    double power = 1;  // of a lamp at 1 m, but for the end of its reach
    double reach = 2;  // m
    Sum sum = Sum::halfFloat;
    Tone tone = Tone::reinhard;
    int normalBits = 10;  // a component
    Show show = Show::picture;
    Orbit orbit = {};
};

struct Gpu {
    Programs programs{"deferred"};
    OnDemand<Mesh> world{worldOf(), "world"}, wholePicture{positionsOnly(square()), "whole picture"};
    OnDemand<Mesh> ball{positionsOnly(sphere(1, 12, 8)), "ball of a lamp"};
    Targets surfaces, sum;
    static MeshData worldOf();
};

// The lamps as the shaders take them: `mostLamps` of each, of which the first `count` are on.
struct Lamps {
    std::vector<vec3> place, power;
    int count;
};

// The technique: deferred.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void forward(Gpu& gpu, const Settings& s, const Frame& frame);
void deferred(Gpu& gpu, const Settings& s, const Frame& frame);
void lampByLamp(Gpu& gpu, const Settings& s, const Frame& frame);
void storeSurfaces(Gpu& gpu, const Settings& s, const Frame& frame);
void askLamps(Gpu& gpu, const Settings& s, const Frame& frame, const Lamps& lamps);
void showSum(Gpu& gpu, const Settings& s, const Frame& frame);

// The world, its camera and its lamps: world.cpp.
Scene cameraOf(const Settings& s, const FrameInfo& frame);
Scene sceneOf(const Settings& s, const FrameInfo& frame);
Lamps lampsOf(const Settings& s);
Lamps reaching(const Settings& s, const Scene& camera);
inline constexpr double ambient = 0.04, ballRadius = 0.42;

// figure.cpp, knobs.cpp.
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);

}  // namespace mv::deferred
