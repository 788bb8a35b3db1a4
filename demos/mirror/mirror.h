#pragma once
#include <array>
#include <vector>

#include "mirror_room.h"
#include "mirrors.h"
#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/scene.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "mv/gl/scene_meshes.h"
#include "mv/gl/target.h"

namespace mv::mirror {

enum class Method { stencil, texture };
enum class Near { oblique, clipDistance, none };
enum class Count { one, two };

constexpr vec3 sky(0.80, 0.88, 0.95);

struct Settings {
    Method method = Method::stencil;
    Near near = Near::oblique;
    Count count = Count::one;
    int bounces = 8;
    double reflectance = 0.85;
    int coarser = 1;  // pixels of the picture along a texel
    bool keep = true;
    double turn = 0;  // degrees
    vec3 eye{0.9, 1.7, 2.9};
    vec2 ball{-0.35, -0.35};  // x and z
    bool winding = true, leaveOut = true;
    bool operator==(const Settings&) const = default;
};

// The scene of one picture, and the mirrors that are seen through one another.
struct Sight {
    Scene scene;
    std::vector<Mirror> mirrors;
    std::vector<std::vector<SeenMirror>>
        chains;                              // the mirrors by which light comes to the eye, the nearest to it first
    std::vector<std::array<vec4, 8>> boxes;  // round each object, in world space
    int length(std::size_t chain) const { return static_cast<int>(chains[chain].size()); }
};

// The view of the world after some reflections.
struct View {
    int bounce = 0;
    mat4 clipFromWorld{1};
    std::vector<vec4> edges = {};  // planes in clip space that bound what is seen
    vec4 before{0};                // half space in world space, before the last mirror
    ObjectId frame{0};             // of the last mirror, which hides it
};

struct Gpu {
    Program world{"mirror"};
    OnDemand<Program> plain{"mirror", "surface"}, textured{"mirror", "texture"};
    Mesh rectangle{positionsOnly(square()), "mirror"};
    SceneMeshes meshes;
    std::array<std::array<Target, 2>, 2> textures;  // of each chain of mirrors, for even and odd bounces
    MadeFor<Scene, Settings, int, int, bool> texturesFor;
    struct Work {
        int passes = 0, drawn = 0, leftOut = 0;
    } work;  // for all mirrors, when their images were last drawn
    Drawing drawing;
};

// The technique: mirror.cpp, and by textures texture.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawByStencil(Gpu& gpu, const Settings& s, const Sight& sight, const Frame& frame);
void drawBounce(Gpu& gpu, const Settings& s, const Sight& sight, std::size_t chain, int bounce);
void drawByTexture(Gpu& gpu, const Settings& s, const Sight& sight, const Frame& frame);
void drawTextures(Gpu& gpu, const Settings& s, const Sight& sight, const Frame& frame);
void drawTexture(Gpu& gpu, const Settings& s, const Sight& sight, std::size_t chain, int bounce, const Frame& frame);
void drawTextured(Gpu& gpu, const Settings& s, const Sight& sight, std::size_t chain, int bounce, const vec2& size);
Target& textureOf(Gpu& gpu, std::size_t chain, int bounce);
void drawEmpty(Gpu& gpu, const Settings& s, const Sight& sight, std::size_t chain, int bounce, double part);
void drawMirror(Gpu& gpu, const Program& surface, const Settings& s, const Sight& sight, std::size_t chain, int bounce);
void drawWorld(Gpu& gpu, const Settings& s, const Sight& sight, const View& view, double part);
View viewAfter(const Settings& s, const Sight& sight, std::size_t chain, int bounce);

// The scene, and the objects that are left out: sight.cpp.
MirrorRoom roomOf(const Settings& s);
Scene sceneOf(const Settings& s, const FrameInfo& frame);
Sight sightOf(const Settings& s, const Frame& frame);
std::vector<std::size_t> shownIn(Gpu& gpu, const Settings& s, const Sight& sight, const View& view);

// study.cpp.
void tell(const Settings& s, const Sight& sight, const Frame& frame);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::mirror
