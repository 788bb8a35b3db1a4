#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "circle.h"
#include "fill.h"
#include "line.h"
#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/mesh_data.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "mv/gl/target.h"
#include "mv/image/picture.h"
#include "shared/raster_triangle.h"

namespace mv::rasterizer {

enum class Subject { line, triangle, fill, star, circle };
enum class Shade { flat, picture, surface };
enum class Edges { hard, sampled };
enum class Flood { recursive, spans };

// The lower left corner of the grid is (0, 0), and it is 24 wide and 18 high however many pixels it has.
struct Line {
    LineMethod method = LineMethod::octants;
    int thickness = 1;  // pixels
    Thicken thicken = Thicken::columns;
    std::array<vec2, 2> ends{vec2(2, 3), vec2(20, 11)};
};
using Corners = std::array<vec2, 4>;  // of two triangles, 0 1 2 and 0 2 3, or of an outline
struct Triangles {
    FillMethod method = FillMethod::box;
    EdgeRule rule = EdgeRule::bottomLeft;
    bool neighbour = true;
    Shade shade = Shade::flat;
    Edges edges = Edges::hard;
    int places = 4;  // of a pixel that are asked where edges are sampled
};
struct Fill {
    Flood flood = Flood::spans;
    int neighbours = 4;
    vec2 seed{11, 9};
};
struct Star {
    Winding winding = Winding::evenOdd;
    std::vector<vec2> corners{{12, 17}, {17.25, 1.5}, {3.5, 11.25}, {20.5, 11.25}, {6.75, 1.5}};
};
struct Circle {
    CircleMethod method = CircleMethod::midpoint;
    vec2 middle{11, 8};
    double radius = 7;
};
inline constexpr int allSteps = 999;
struct Settings {
    Subject subject = Subject::line;
    Line line = {};
    Triangles triangles = {};
    Fill fill = {};
    Star star = {};
    Circle circle = {};
    Corners corners{vec2(2.25, 3.5), vec2(20.5, 1.5), vec2(21.5, 14.25), vec2(6.5, 16.5)};
    int cells = 24;  // pixels across
    int step = 10;   // pixels that are set; allSteps: all
};

struct Gpu {
    OnDemand<Program> program{"rasterizer"};
    Drawing drawing;
    // OpenGL's pixels, kept while the drawing stays the same
    Target small;
    Mesh mesh;
    MeshData drawn;
    GLuint drawnBy = 0;
    Picture glPicture;
};

// Each subject is a part of the lesson, in a file of its name: line.cpp, triangle.cpp, fill.cpp, star.cpp, circle.cpp.
struct Grid;
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawLine(Gpu& gpu, const Settings& s, const Grid& grid, const Frame& frame);
void drawTriangles(Gpu& gpu, const Settings& s, const Grid& grid, const Frame& frame);
void drawFill(Gpu& gpu, const Settings& s, const Grid& grid, const Frame& frame);
void drawStar(Gpu& gpu, const Settings& s, const Grid& grid, const Frame& frame);
void drawCircle(Gpu& gpu, const Settings& s, const Grid& grid, const Frame& frame);

// The readouts of each part.
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);
void readLine(const Gpu& gpu, const Line& line, const Grid& grid, Numbers& numbers);
void readTriangles(const Gpu& gpu, const Triangles& s, const Corners& corners, const Grid& grid, Numbers& numbers);
void readFill(const Fill& fill, const Corners& corners, const Grid& grid, Numbers& numbers);
void readStar(const Star& star, const Grid& grid, Numbers& numbers);
void readCircle(const Gpu& gpu, const Circle& circle, const Grid& grid, Numbers& numbers);

// The number of pixels that each part sets.
std::size_t countLine(const Line& line, const Grid& grid);
std::size_t countTriangles(const Triangles& s, const Corners& corners, const Grid& grid);
std::size_t countFill(const Fill& fill, const Corners& corners, const Grid& grid);
std::size_t countStar(const Star& star, const Grid& grid);
std::size_t countCircle(const Circle& circle, const Grid& grid);

// knobs.cpp, study.cpp.
const char* nameOf(LineMethod method);
const char* nameOf(FillMethod method);
const char* nameOf(EdgeRule rule);
const char* nameOf(Flood flood);
const char* nameOf(Winding winding);
const char* nameOf(CircleMethod method);
int mostSteps(const Settings& s);  // the number of all pixels to be set
std::vector<double> values(const Settings& s);
std::vector<std::pair<std::string, double>> valueCounts(const Settings& s);

}  // namespace mv::rasterizer
