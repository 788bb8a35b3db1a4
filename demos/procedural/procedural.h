#pragma once
#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/scene.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/object.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "shared/procedural.h"

namespace mv::procedural {

enum class View { wall, floor, sphere };
enum class Filter { none, samples, leaveOut };
enum class Origin { near, far };
enum class Source { formula, texture };

struct Settings {
    Pattern pattern = Pattern::marble;
    View view = View::sphere;
    Source source = Source::formula;
    int texels = 64;  // a side of the 3D texture
    int octaves = 5;
    double zoom = 1;
    bool endless = true;
    double distance = 0;  // along x
    Origin origin = Origin::near;
    Filter filter = Filter::none;
    int samples = 4;   // along a side of a pixel
    double turn = 25;  // degrees
};

// The colours of 0 and 1, in linear light.
struct Ramp {
    vec3 dark, light;
};

constexpr double sphereRadius = 1.3;

struct Gpu {
    OnDemand<Program> byFormula{"procedural"}, byTexture{"procedural", "solid"};
    TextureObject solid;
    MadeFor<Pattern, int, double, int, double> solidFor;
    OnDemand<Mesh> flat{withoutTexCoords(square()), "square"};
    OnDemand<Mesh> ball{withoutTexCoords(sphere(sphereRadius, 128, 64)), "sphere"};
    Drawing drawing;
};

// The technique: procedural.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void setCentre(const Program& program, const Settings& s);
vec3 lowOf(const PatternPlace::Octave& octave);
vec3 highOf(const PatternPlace::Octave& octave);
PatternPlace placeOf(const Settings& s);
struct BodyMatrices {
    mat4 clipFromBody, viewFromBody, offsetFromBody;
};
BodyMatrices bodyMatrices(const Settings& s, const FrameInfo& frame);
const Ramp& rampOf(Pattern pattern);
void drawBody(Gpu& gpu, const Settings& s);

// The pattern read from a 3D texture: solid.cpp. The floor has no end, and so no texture.
inline bool isFromTexture(const Settings& s) { return s.source == Source::texture && s.view != View::floor; }
void drawFromTexture(Gpu& gpu, const Settings& s, const Frame& frame);
double textureSide(const Settings& s, const FrameInfo& frame);
TextureObject solidTexture(const Settings& s, double side);

// Name and formula of the pattern, in the picture: figure.cpp.
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);

// The scene for measurements: study.cpp.
Scene sceneOf(const Settings& s, const FrameInfo& frame);
void nameFinerOctaves(const Settings& s, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::procedural
