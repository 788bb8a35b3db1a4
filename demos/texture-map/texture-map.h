#pragma once
#include <optional>
#include <string>

#include "mv/demo/cached.h"
#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/demo/own_file.h"
#include "mv/geometry/mesh_data.h"
#include "mv/geometry/scene.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "mv/gl/texture.h"
#include "triangle_map.h"

namespace mv::texture_map {

enum class Shape { quad, cylinder, sphere, triangle };
enum class Method { affine, correct, byHand, undivided, forward };
enum class Formula { corrected, lecture };
enum class Seam { doubled, shared };
enum class Map { edges, matrix };
enum class Wrap { clamp, repeat, mirror };

// A square, a cylinder or a sphere, which brings its texture coordinates along.
struct Surface {
    Method method = Method::affine;
    int divisions = 2;                     // cells along a side of the square, or a quarter of a turn
    double ratio = 4;                      // of the square: the w of the far edge by that of the near one
    Formula formula = Formula::corrected;  // of the cylinder
    Seam seam = Seam::doubled;
    double turn = -60;  // degrees
};
// A triangle, whose points are mapped to the texture.
struct Triangle {
    Map map = Map::edges;
    double distance = 0.5;  // of its plane from the origin
};
struct Settings {
    Shape shape = Shape::quad;
    Surface surface = {};
    Triangle triangle = {};
    int texels = 128;  // along a side of the texture
    OwnFile<Picture> picture = {};
    double reach = 1;  // of u and v: so many textures, with one in the middle
    Wrap wrap = Wrap::clamp;
};

struct Gpu {
    OnDemand<Program> correct{"texture-map"}, affine{"texture-map", "affine"}, byHand{"texture-map", "by-hand"},
        byPoint{"texture-map", "point"};
    Cached<Mesh, Shape, Method, int, int, Formula, Seam> surface;
    Cached<Mesh, double> triangle;
    Cached<Texture, int, int, Wrap> image;
    Drawing drawing;
};

// The technique: texture-map.cpp, surface.cpp, triangle.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawSurface(Gpu& gpu, const Settings& s, const Pane& pane);
void drawTriangle(Gpu& gpu, const Settings& s, const Pane& pane);
const Program& programOf(Gpu& gpu, Method method);
MeshData meshOf(const Settings& s);
void bindTexture(Gpu& gpu, const Settings& s);
GLint wrapping(Wrap wrap);
Picture imageOf(const Settings& s);
Picture chart(int side);
void setLookup(const Program& program, const Settings& s, const Pane& pane);

vec3 surfacePoint(Shape shape, Formula formula, double u, double v);
MeshData surfaceMesh(Shape shape, const Surface& surface);
MeshData texelPoints(Shape shape, const Surface& surface, int texels);
mat4 clipFromSurface(Shape shape, const Surface& surface, const Pane& pane);

TexturedTriangle cornersOf(const Triangle& triangle);
PlaneMap planeMap(const Triangle& triangle);
MeshData triangleMesh(const Triangle& triangle);
void setPlaneMap(const Program& program, const PlaneMap& map);
mat4 clipFromTriangle(const Triangle& triangle, const Pane& pane);

// Questions to the settings.
bool isTriangle(const Settings& s);
bool isForward(const Settings& s);
bool isByHand(const Settings& s);
bool isCircle(const Settings& s);  // the lecture's cylinder, which has no faces

// Beside the technique: knobs.cpp, figure.cpp, study.cpp.
const char* nameOf(Shape shape);
const char* nameOf(Method method);
const char* nameOf(Map map);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
Pane leftPane(const FrameInfo& frame);
Pane paneOf(const Frame& frame);
Scene sceneOf(const Settings& s, const FrameInfo& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::texture_map
