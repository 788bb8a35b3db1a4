#pragma once
#include <array>
#include <span>
#include <vector>

#include "depth_order.h"
#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/demo/numbers.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "mv/gl/target.h"
#include "plates.h"

namespace mv::z_buffer {

enum class Which { cycle, road, panes };
// The order of the plates, by the letters of their colours, or from far to near.
enum class Order { rgb, rbg, grb, gbr, brg, bgr, sorted };
enum class Shown { colors, depth, curve };
enum class Mapping { standard, infinite, reversed, flipped, logarithmic, zeroToOne };

inline const vec3 background(0.95, 1, 1);

struct Settings {
    Which scene = Which::cycle;
    Order order = Order::rgb;
    int pieces = 1;  // of a bar or pane
    bool depthTest = true;
    Shown shown = Shown::colors;
    DepthFormat format = DepthFormat::d24;
    Mapping mapping = Mapping::standard;
    double near = 0.1, far = 10000;
    double separation = 1e-5;  // as a part of the distance
    double opacity = 1;
    double spinX = 0, spinY = 0;  // degrees
    bool words = true;            // of the bars: numbers in the order of drawing, and what decides
};

// A run of cells of a plate, drawn by one call.
struct Part {
    std::size_t plate, first, count;
};

struct Gpu {
    Program byMatrix{"z-buffer"}, show{"z-buffer", "show"};
    OnDemand<Program> byLogarithm{"z-buffer", "logarithmic"};
    Target drawn;
    Mesh plate, cover{MeshData{.positions = {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}}}, "picture"};
    MadeFor<std::vector<double>> plateFor;  // cuts
    Drawing drawing;
};

// The technique: z-buffer.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawPlates(Gpu& gpu, const Settings& s, const mat4& clipFromView);
std::vector<Part> partsInOrder(Order order, const std::array<Plate, 3>& plates, std::span<const double> cuts);
mat4 clipFromView(const Settings& s, double aspect);
double fovyFor(double aspect);  // degrees
float depthOf(const Settings& s, const mat4& clipFromView, float distance);
bool hasZeroToOne(const Settings& s);  // clip space has depths from 0 to 1, by glClipControl
bool nearIsOne(const Settings& s);
std::array<Plate, 3> platesOf(const Settings& s);
std::vector<double> cutsOf(const Settings& s);

// figure.cpp, study.cpp.
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void tell(const Settings& s, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);
std::vector<double> values(const Settings& s);

}  // namespace mv::z_buffer
