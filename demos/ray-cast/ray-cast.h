#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "cast_objects.h"
#include "cast_side.h"
#include "mv/demo/cached.h"
#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/ray.h"
#include "mv/geometry/scene.h"
#include "mv/gl/drawing.h"
#include "mv/gl/program.h"
#include "mv/gl/scene_meshes.h"
#include "mv/image/picture.h"
#include "shared/ray_structures.h"

namespace mv::ray_cast {

enum class Precision { single, twice };  // float and double
enum class Maker { rays, raster, gl };
// All formulas together, or one object alone, whose number is that of its kind and 1.
enum class Objects { all };
constexpr Objects only(CastKind kind) { return static_cast<Objects>(1 + static_cast<int>(kind)); }

constexpr vec4 sky(0.85, 0.9, 0.95, 1);
constexpr double opening = 0.53,
                 opens = 9;  // the tangent of half the angle of view, and the distance at which it holds

struct Settings {
    CastForm form = CastForm::stable;
    Precision precision = Precision::twice;
    int rows = 32;  // and columns
    Objects objects = Objects::all;
    int triangles = 4096;  // of the teapot
    PlaneForm plane = PlaneForm::implicit;
    int starts = 12;  // cells a side
    double distance = opens, size = 1;
    Maker by = Maker::rays;
    int threads = 2;
    double pixelX = 0.55, pixelY = 0.5;  // of the chosen pixel, in 0..1
    bool operator==(const Settings&) const = default;
};

// The first candidate of each pixel, the upper row first.
using Seen = std::vector<std::optional<CastCandidate>>;

struct Gpu {
    Program program{"ray-cast"};
    SceneMeshes meshes;
    Drawing drawing;
    Cached<Seen, Settings> seen;
    Cached<Picture, Settings, int> picture;
    Cached<int, Settings> unlike;
};

// The objects as triangles, at scale 1. The teapot has a tree of its own.
struct Triangles {
    std::vector<SceneTriangle> all;
    std::unique_ptr<const TriangleFinder> tree;
};

// The objects that rays may meet.
struct Shown {
    std::vector<CastKind> kinds;
    std::shared_ptr<const Triangles> teapot;
};

// The technique: ray-cast.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawCast(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame);
Seen castRays(const Settings& s);
CastEye eyeOf(const Settings& s);
Ray rayOf(const Settings& s, int column, int row);
std::vector<CastCandidate> candidates(const Settings& s, const Shown& shown, const Ray& ray);
Picture pictureOf(const Settings& s, const Seen& seen, int width);

// The other way, by triangles: triangles.cpp.
const Seen& keptSeen(Gpu& gpu, const Settings& s);
Seen seenBy(const Settings& s);
std::shared_ptr<const Triangles> trianglesOf(const Settings& s);
bool isThere(const Settings& s, CastKind kind);
std::vector<CastKind> kindsOf(const Settings& s);
Shown shownBy(const Settings& s);
vec3 normalOf(const SceneTriangle& triangle);
Scene sceneOf(const Settings& s, const FrameInfo& frame);
void beginTriangles(Gpu& gpu, const Scene& scene);
void drawFromSide(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame);
void drawByGl(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame);
void drawNumbers(Gpu& gpu, const Settings& s, const Frame& frame);
Settings withoutPixel(Settings s);

// The chosen pixel, and the scene from the side: figure.cpp.
Pane picturePane(const FrameInfo& frame);
Pane sidePane(const FrameInfo& frame);
CastSide fromSide(const Settings& s, const FrameInfo& frame);
int column(const Settings& s);
int row(const Settings& s);
std::vector<CastCandidate> chosen(const Settings& s);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);

// knobs.cpp, study.cpp.
const char* nameOf(CastForm form);
const char* nameOf(Precision precision);
bool hasForms(const Settings& s);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);
std::vector<double> values(const Settings& s);

}  // namespace mv::ray_cast
