#pragma once
#include <optional>
#include <string>
#include <vector>

#include "function_nodes.h"
#include "key_curve.h"
#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/plot.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "street.h"

namespace mv::keyframes {

enum class Which { ball, runge, camera, flight };
enum class Zoom { separate, computed };
enum class Moves { all, eye, center, up, aspect, fovy };

// The keys of a camera: near, far and near again.
struct DollyZoom {
    Zoom zoom = Zoom::separate;
    double nearest = 4, farthest = 30;  // m
    double fovy = 50;                   // degrees, when it is near
};
struct Settings {
    Which which = Which::ball;
    KeyCurve curve = {};
    std::vector<vec2> keys{{0.5, 2}, {1.5, 7.5}, {4, 9}, {5, 4.5}, {8, 1}, {9.5, 7}};  // m, of the ball, one a second
    FunctionNodes nodes = {};
    DollyZoom camera = {};
    Moves flight = Moves::all;  // which properties of the camera have keys
};

// Values at samples between -1 and 1.
struct Sampled {
    std::vector<double> right, polynomial, curve;
    std::optional<std::string> warning = {};
    double polynomialError() const;
    double curveError() const;
};
struct Street {
    Program program{"keyframes"};
    Mesh mesh{meshOf(figureInStreet()), "street"};
};
struct Gpu {
    OnDemand<Street> street;
    Drawing drawing;
    // The last samples, and what they were made for
    MadeFor<KeyCurve, FunctionNodes> sampledFor;
    Sampled sampled;
};

constexpr double rest = 0.5;   // seconds, before the first key and after the last
constexpr double lap = 6;      // seconds of the camera, away and back
constexpr int samples = 1000;  // of a function, and of the curves through its nodes

// A ball that moves through keys: keyframes.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawBall(Gpu& gpu, const Settings& s, const Frame& frame);
Motion<vec3> ballMotion(const Settings& s);
double momentOf(const Motion<vec3>& motion, double time);
std::vector<double> timesOf(std::size_t count);

// One polynomial through many nodes, and a curve: runge.cpp.
void drawRunge(Gpu& gpu, const Settings& s, const Frame& frame);
double sampleAt(std::size_t i);
std::vector<double> polynomialValues(const Settings& s);
std::vector<double> curveValues(const Settings& s);

// A camera whose distance and angle of view have keys: camera.cpp.
struct View {
    double distance, fovy;  // m, degrees
    // The part of the picture's height that a thing takes up at a distance `behind` the subject
    double sizeOf(double height, double behind = 0) const;
};
void drawCamera(Gpu& gpu, const Settings& s, const Frame& frame);
void drawStreet(Gpu& gpu, const Pane& pane, const mat4& clipFromWorld, const Frame& frame);
View viewAt(const DollyZoom& camera, const KeyCurve& curve, double time, Zoom zoomedBy);
double fovyFor(const DollyZoom& camera, double distance);

// A camera all of whose properties have keys: flight.cpp.
struct CameraAt {
    vec3 eye, center, up;
    double aspect, fovy;  // width by height, degrees
};
void drawFlight(Gpu& gpu, const Settings& s, const Frame& frame);
const std::vector<CameraAt>& cameraKeys();
CameraAt cameraAt(const Settings& s, double time);
Pane shapedPane(const Pane& pane, double aspect);

// Paths, graphs and words: ball_figure.cpp, runge_figure.cpp, camera_figure.cpp, flight_figure.cpp, and figure.cpp for all.
void showWay(Drawing& drawing, const Settings& s, const Motion<vec3>& motion, double now, const Pane& pane);
void showBall(Drawing& drawing, const Motion<vec3>& motion, double now, const Pane& pane);
void showGraphs(Drawing& drawing, const Settings& s, const Motion<vec3>& motion, double now, const FrameInfo& frame);
void showValues(Drawing& drawing, const Settings& s, const Sampled& shown, const FrameInfo& frame);
void tell(const Settings& s, const Frame& frame);
void showZoom(Drawing& drawing, const Settings& s, double now, const FrameInfo& frame);
void showFlight(Drawing& drawing, const Settings& s, double now, const Pane& seen, const FrameInfo& frame);
Pane leftPane(const FrameInfo& frame);
Plot easePlot(const FrameInfo& frame);
vec2 pixelOf(const Pane& pane, const vec2& place);

// knobs.cpp, study.cpp.
std::string nameOf(KeyCurve::Kind kind);
std::string nameOf(KeyCurve::Ease ease);
std::string nameOf(FunctionNodes::Spread spread);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);
std::vector<double> values(const Settings& s);

}  // namespace mv::keyframes
