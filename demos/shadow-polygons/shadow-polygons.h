#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/scene.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "polygon_shadows.h"
#include "shared/orbit.h"

namespace mv::shadow_polygons {

enum class Which { papers, crossing };
enum class Method { none, allPairs, sphere };
enum class Show { scene, sphere, pairs };

struct Settings {
    Which scene = Which::papers;
    Method method = Method::sphere;
    int polygons = 24;  // the floor is one of them; at most 255, each a number in the stencil buffer
    double size = 1;    // of each paper; at 1 all papers together have about the same area, however many they are
    vec3 light{0.6, 3.1, 0.5};
    Show show = Show::sphere;
    Orbit orbit = {};
};

// A dark part, of one receiver behind one caster.
struct Shadow {
    CasterOn of;
    std::vector<vec3> corners;
};
struct Shadows {
    Pairs pairs;
    std::vector<Shadow> dark;
};

// What belongs to one polygon, among the vertices of a mesh.
struct Part {
    std::size_t polygon, first, count;
};
struct Parts {
    Mesh mesh;
    std::vector<Part> list;
};

struct Gpu {
    Program program{"shadow-polygons"};
    Drawing drawing;
    std::vector<FlatPolygon> polygons;
    std::vector<Cap> caps;
    Shadows shadows;
    Parts whole, dark;
    MadeFor<Which, Method, int, double, vec3> madeFor;
};

// The technique: shadow-polygons.cpp, with polygon_shadows.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void follow(Gpu& gpu, const Settings& s);
Shadows shadowsOf(Method method, const std::vector<FlatPolygon>& polygons, const vec3& light);
void drawParts(const Parts& parts, GLenum passes);
void addPolygon(MeshData& mesh, const FlatPolygon& polygon, const vec3& light);
Parts partsOf(const std::vector<FlatPolygon>& polygons, const vec3& light);
Parts partsOf(const std::vector<Shadow>& dark, const std::vector<FlatPolygon>& polygons);

// What is shown: papers.cpp.
std::vector<FlatPolygon> polygonsOf(const Settings& s);
Scene sceneOf(const Settings& s, const FrameInfo& frame);
Pane scenePane(const Settings& s, const FrameInfo& frame);
Pane drawnPane(const Settings& s, const Frame& frame);

// The sphere and the pairs beside the scene: figure.cpp.
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

// study.cpp: 1 where the light reaches a point of a polygon, 0 where it is dark.
std::vector<double> values(const Settings& s);
std::vector<std::pair<std::string, double>> valueCounts(const Settings& s);

}  // namespace mv::shadow_polygons
