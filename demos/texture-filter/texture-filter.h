#pragma once
#include <vector>

#include "floor_texture.h"
#include "mv/demo/cached.h"
#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/demo/own_file.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "mv/gl/texture.h"

namespace mv::texture_filter {

enum class Filter { nearest, bilinear, nearestMipNearest, linearMipNearest, trilinear, anisotropic };
enum class Average { linear, encoded };
enum class Kept { floats, bytes };
enum class MadeBy { program, driver };

struct Settings {
    Filter filter = Filter::trilinear;
    int anisotropy = 16;  // the most looks along the footprint
    double bias = 0;      // levels
    FloorPattern pattern = FloorPattern::checker;
    int size = 64;    // texels along a side of the texture
    double turn = 0;  // degrees
    Average average = Average::linear;
    Kept texels = Kept::floats;
    MadeBy mipmapsBy = MadeBy::program;
    bool showLevels = false;
    OwnFile<Picture> picture = {};
    double pixelX = 0.3, pixelY = 0.94;  // parts of the floor's width, and of the way up to the horizon
};

struct Gpu {
    OnDemand<Program> program{"texture-filter"}, alongProgram{"texture-filter", "along"},
        texelProgram{"texture-filter", "texels"};
    Mesh floor{{.primitive = Primitive::triangleStrip,
                .positions = {{-1000, 0, -1000}, {-1000, 0, 1000}, {1000, 0, -1000}, {1000, 0, 1000}}},
               "floor"};
    Mesh cover{{.primitive = Primitive::triangleStrip, .positions = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}}},
               "pane"};
    Cached<Texture, FloorPattern, int, int, Average, Texels, bool, bool, bool> image;
    Drawing drawing;
};

// The technique: texture-filter.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawByDriver(Gpu& gpu, const Settings& s, const FloorCamera& camera);
void drawAlong(Gpu& gpu, const Settings& s, const FloorCamera& camera);
void drawFloor(Gpu& gpu, const Program& program, const Settings& s, const FloorCamera& camera);
void bindTexture(Gpu& gpu, const Settings& s);
Texels formatOf(const Settings& s);
struct GlFilter {
    GLenum minify, magnify;
};
GlFilter glFilter(Filter filter);
bool isMipmapped(const Settings& s);
bool isByDriver(const Settings& s);
bool areColored(const Settings& s);
int looks(const Settings& s);

// The texture and its mipmaps: levels.cpp.
std::vector<FloatPicture> levelsOf(const Settings& s);

// A pixel's footprint in the texture, as OpenGL computes it: footprint.cpp.
struct Lookup {
    mat3 repeats{1};
    vec2 pixel{0};  // its lower left corner, in pixels of the floor's pane
    Footprint footprint{};
    double longer = 0, shorter = 0;  // how far it reaches for a pixel in x and in y of the picture, in texels
    double level = 0;                // from the longer one
};
Lookup lookupAt(const Settings& s, const FrameInfo& frame);
vec2 pixelShown(const Settings& s, const FrameInfo& frame);
Pane floorPane(const FrameInfo& frame);
Pane paneOf(const Frame& frame);

// Beside the technique: knobs.cpp, figure.cpp, study.cpp.
const char* nameOf(Filter filter);
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame);
void tell(const Settings& s, const Frame& frame);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);

}  // namespace mv::texture_filter
