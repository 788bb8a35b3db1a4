#pragma once
#include <array>
#include <optional>
#include <vector>

#include "clip_figure.h"
#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "polygon_overlap.h"

namespace mv::clipping {

enum class Subject { point, segment, polygon, space };
enum class Method { cohenSutherland, liangBarsky, cyrusBeck, exact };
enum class PolygonMethod { sutherlandHodgman, overlap, sides };
enum class Where { view, clip, divided };

// A segment in the plane, whose first end serves as the point. Two opposite corners give the window.
struct InPlane {
    Method method = Method::cohenSutherland;
    int offset = 0;  // added to all coordinates
    std::array<vec2, 2> ends{vec2(-2.6, -1.55), vec2(2.1, 1.85)};
    std::array<vec2, 2> corners{vec2(-1.6, -1), vec2(1.5, 1.2)};
};
struct Polygons {
    PolygonMethod method = PolygonMethod::sutherlandHodgman;
    std::vector<vec2> polygon{{-2.4, -2},  {2.4, -2},    {2.4, 2},  {1.2, 2},
                              {1.2, -1.4}, {-1.2, -1.4}, {-1.2, 2}, {-2.4, 2}};
    std::vector<vec2> against{{-2, -0.6}, {2, -0.9}, {2.1, 0.9}, {0, 1.5}, {-1.9, 0.8}};
};
struct InSpace {
    Where where = Where::clip;
    std::array<vec2, 2> ends{vec2(-0.8, -2.4), vec2(0.9, 1.2)};  // x, z; the eye looks along -z
};
struct Settings {
    Subject subject = Subject::segment;
    InPlane plane = {};
    Polygons polygons = {};
    InSpace space = {};
    int round = 8;  // rounds, or edges of the window, that are shown
};
constexpr double gridStep = 0.01;  // all places are multiples of it

struct Gpu {
    ClipFigure figure;
};

// Each subject is a part of the lesson, in a file of its name: point.cpp, segment.cpp, polygon.cpp, space.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawPoint(ClipFigure& figure, const Settings& s, const Frame& frame);
void drawSegment(ClipFigure& figure, const Settings& s, const Frame& frame);
void drawPolygon(ClipFigure& figure, const Settings& s, const Frame& frame);
void drawSpace(ClipFigure& figure, const Settings& s, const Frame& frame);

// The window as shown, and the window moved by `offset`, at which the segment is clipped.
Box windowOf(const InPlane& s);
Box farWindowOf(const InPlane& s);
// The part of the segment in the window, by the chosen method.
std::optional<Segment> clipped(Method method, const Segment& whole, const Box& window);

using Pieces = std::vector<std::vector<vec2>>;
Pieces piecesOf(const Settings& s);
double areaOf(const Pieces& pieces);
GridPolygon onGrid(const std::vector<vec2>& corners);

// The largest distance, in the picture, of an end of the shown segment from the right one. The answer is 2, the
// picture's width, where only one of the two is there.
double missInSpace(const InSpace& s);

// knobs.cpp, study.cpp.
void check(const Settings& s);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);
std::vector<double> values(const Settings& s);
std::vector<std::pair<std::string, double>> valueCounts(const Settings& s);

}  // namespace mv::clipping
