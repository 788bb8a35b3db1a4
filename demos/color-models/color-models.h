#pragma once
#include <array>
#include <optional>
#include <vector>

#include "chromaticity_diagram.h"
#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/mesh_data.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"

namespace mv::color_models {

enum class Shows { solids, diagram };
enum class Way { srgb, linear, hsl, oklab };
enum class Written { numbers, hex };
// A colour has a place in each of three solids, or in the diagram.
enum Space { cube, doubleCone, cone, inDiagram };

struct Solids {
    int steps = 12;  // of a strip
    bool cut = false;
    double spinX = 0, spinY = -60;  // degrees
    Written written = Written::numbers;
};
struct Settings {
    Shows shows = Shows::solids;
    vec3 from{1, 0.55, 0}, to{0, 0.35, 1};  // sRGB
    Way way = Way::srgb;
    Solids solids = {};
    Diagram diagram = Diagram::xy;
};

// A solid in its own coordinates, where the axis of greys goes from the origin to (0, 1, 0). The mesh includes the square that
// covers the cut.
MeshData solidMesh(Space solid);
MeshData spectrumMesh();

struct Gpu {
    OnDemand<Program> program{"color-models"}, ofDiagram{"color-models", "diagram"};
    std::array<OnDemand<Mesh>, 3> solids{OnDemand<Mesh>(solidMesh(cube), "cube"),
                                         OnDemand<Mesh>(solidMesh(doubleCone), "double cone"),
                                         OnDemand<Mesh>(solidMesh(cone), "cone")};
    OnDemand<Mesh> spectrum{spectrumMesh(), "spectrum"};
    Drawing drawing;
};

// The technique: color-models.cpp. All colours are sRGB, 0..1, unless their names say otherwise.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawSolids(Gpu& gpu, const Settings& s, const Frame& frame);
void drawDiagram(Gpu& gpu, const Settings& s, const Frame& frame);
vec3 placeOf(Space solid, const vec3& rgb);
vec3 aroundAxis(double hue, double out, double height);
mat3 modelFromRgb();
mat4 clipFromModel(const Settings& s, const FrameInfo& frame);
vec3 mixed(Way way, const vec3& a, const vec3& b, double t);
std::vector<vec3> strip(const Settings& s, Way way);
std::vector<double> stepsOf(const std::vector<vec3>& colors);

// Lines, strips and words over the solids and below them: figure.cpp.
Pane paneOf(const FrameInfo& frame, Space solid);
std::optional<vec2> markIn(const Settings& s, const FrameInfo& frame, Space space, const vec3& color);
void drawOverSolids(Drawing& drawing, const Settings& s, const FrameInfo& frame);
// The ways to mix, sRGB, linear, HSL and OKLab, in colours that are told apart without cones of long or of middle waves, too.
inline const std::array<vec4, 4> wayColors{vec4(0.77, 0.32, 0, 1), vec4(0, 0.50, 0.40, 1), vec4(0.45, 0.10, 0.35, 1),
                                           vec4(0.10, 0.40, 0.85, 1)};
void drawStrips(Drawing& drawing, const Settings& s, const FrameInfo& frame);
void drawMixture(Drawing& drawing, const Settings& s, const FrameInfo& frame);
void drawMarks(Drawing& drawing, const Settings& s, const FrameInfo& frame);

// Numbers: study.cpp.
std::optional<double> unevenness(const std::vector<double>& lengths);
vec3 asSeen(const vec3& srgb);
vec3 shownAs(const vec3& srgb);
bool isBeyond(const vec3& srgb);
void tell(const Settings& s, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);
std::vector<double> values(const Settings& s);

}  // namespace mv::color_models
