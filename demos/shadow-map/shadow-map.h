#pragma once
#include "light_overlay.h"
#include "mv/demo/cached.h"
#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/geometry/light_view.h"
#include "mv/gl/depth_map.h"
#include "mv/gl/drawing.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "mv/gl/scene_meshes.h"
#include "mv/gl/texture.h"
#include "shared/orbit.h"

namespace mv::shadow_map {

enum class Which { sphereAndCube, cubeOnPlane, stillLife, overhead };
enum class Filter { none, hardware, pcf3, pcf5, pcf7 };
enum class Faces { front, back, both };
enum class Rays { spot, orthographic };
enum class Fit { set, fitted };
enum class Slide { none, thrown, alsoBehind };

struct Settings {
    Which scene = Which::sphereAndCube;
    int sides = 32;        // of the ball, round it
    double cord = 0.01;    // thickness
    int resolution = 512;  // texels along a side
    Filter filter = Filter::none;
    double bias = 0.006;   // a depth, 0..1
    double slopeBias = 0;  // texels
    Faces mapFaces = Faces::front;
    bool receiver = true;
    bool keep = true;
    Rays rays = Rays::spot;
    Fit frustum = Fit::set;
    vec3 light{2.5, 4.8, 4.3}, target{2.5, 1, 3.5};
    double fov = 120;  // degrees
    double windowWidth = 3, windowHeight = 2.4;
    Slide slide = Slide::none;  // a picture in the light's window
    bool showMap = true, showRays = false, showFrustum = true;
    Orbit orbit = {};
};

struct Gpu {
    Program depthProgram{"shadow-map", "depth"};
    OnDemand<Program> program{"shadow-map"};
    SceneMeshes meshes{SceneMeshes::Surface::textured};  // the floor has squares
    OnDemand<Program> slideProgram{"shadow-map", "slide"};
    Cached<Texture> slide;
    DepthMap map;
    MadeFor<mat4, Which, int, double, int, Faces, bool, double> mapFor;
    LightOverlay overlay;
    Drawing drawing;
    Gpu() { overlay.init(); }
};

// The technique: shadow-map.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawMap(Gpu& gpu, const Settings& s, const Scene& scene, const LightView& light);
void drawPicture(Gpu& gpu, const Settings& s, const Scene& scene, const LightView& light);
void setLookup(Gpu& gpu, const Settings& s, const Program& program);
void drawObjects(Gpu& gpu, const Program& program, const Scene& scene, const LightView& light);
LightView lightView(const Settings& s, const Scene& scene);
LightView spotView(const Settings& s);
LightView parallelView(const Settings& s);
vec4 lightOf(const Settings& s);
GLenum culledFor(Faces inMap);
DepthLookup lookupOf(Filter filter);
int looksAlong(Filter filter);

// A picture in the window of the light, as of a slide projector: slide.cpp.
void drawSlide(Gpu& gpu, const Settings& s, const Scene& scene, const LightView& light);
Picture slidePicture();

// The scene, and the drawing over the picture: figure.cpp.
Scene sceneOf(const Settings& s, const FrameInfo& frame);
Scene overhead(int sides, double cord, double aspect);
void check(const Settings& s);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void tell(const Settings& s, const Scene& scene, const LightView& light, const Frame& frame);

}  // namespace mv::shadow_map
