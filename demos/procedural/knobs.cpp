// The settings of procedural: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "procedural.h"

namespace mv::procedural {
namespace {

constexpr Declaration about{
    .name = "procedural",
    .sentence = "Brick, wood, marble and noise as functions of the surface point.",
    .lookFor = "A pattern in space has no seams and no texels: zoom in, and only the floats' precision ends it.",
    .chapter = "Light, colour and texture",
    .number = 29,
    .width = 800,
    .height = 600,
    .background = vec4(0.75, 0.82, 0.90, 1),
    .needs = {.depth = true},
};

bool isWall(const Settings& s) { return s.view == View::wall; }
bool isSphere(const Settings& s) { return s.view == View::sphere; }
bool hasOctaves(const Settings& s) { return s.pattern != Pattern::brick; }
bool isBounded(const Settings& s) { return s.view != View::floor; }
bool isComputed(const Settings& s) { return !isFromTexture(s); }
bool addsOctaves(const Settings& s) { return isWall(s) && hasOctaves(s) && isComputed(s); }
bool takesSamples(const Settings& s) { return s.filter == Filter::samples && isComputed(s); }

std::vector<Row<Settings>> panelRows() {
    return {
        word("pattern", &Settings::pattern, {{"brick"}, {"wood"}, {"marble"}, {"noise"}}, "which"),
        word("view", &Settings::view,
             {{"wall", "straight on, to be zoomed"}, {"floor", "to the horizon"}, {"sphere", "cut out of it"}},
             "what has the pattern"),
        word("source", &Settings::source,
             {{"formula", "computed in each pixel"},
              {"texture", "computed once for each texel of a 3D texture, and looked up"}},
             "where a pixel has the pattern from")
            .when(isBounded, "the floor has no end, and a texture has"),
        oneOf("texels", &Settings::texels, {16, 32, 64, 128}, "along each of the three sides of the texture")
            .when(isFromTexture, "only a texture has texels"),
        whole("octaves", &Settings::octaves, {1, 8},
              "of noise, each half as large and half as strong as the one before")
            .when(hasOctaves, "bricks have no octaves"),
        number("zoom", &Settings::zoom, {1, 1e9, Scale::logarithmic},
               "how much of the wall one sees: 3 units high, by this")
            .when(isWall, "only the wall is zoomed"),
        toggle("endless", &Settings::endless,
               "octaves go on with the zoom: finer ones come for those that grow too large")
            .when(addsOctaves, "only a wall is zoomed, bricks have no octaves, and a texture gets no more of them"),
        number("distance", &Settings::distance, {0, 16'777'216}, "how far along x all of it is from the origin"),
        word("origin", &Settings::origin,
             {{"near", "of the floats, in the middle of the picture"},
              {"far", "of the floats, in the world's: each point is rounded to floats"}},
             "where the shader computes from")
            .when(isComputed, "a texture is computed beforehand, in double precision"),
        word("filter", &Settings::filter,
             {{"none", "the middle of each pixel"},
              {"samples", "the mean of several points of a pixel"},
              {"leave-out", "without what is smaller than a pixel"}},
             "what a pixel shows of a pattern that is finer than it")
            .when(isComputed, "a texture is looked up once a pixel"),
        whole("samples", &Settings::samples, {2, 8}, "a side of a pixel, with filter samples")
            .when(takesSamples, "each pixel is asked once"),
        angle("turn", &Settings::turn, "of the sphere").when(isSphere, "only the sphere turns"),
    };
}

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"marble", "A sphere cut out of marble: the layers go through it."},
        {"wood", "Rings about an axis, bent by noise.", {.pattern = Pattern::wood, .turn = 60}},
        {"bricks", "A wall of bricks, each with a shade of its own.", {.pattern = Pattern::brick, .view = View::wall}},
        {"a-million",
         "Zoomed in a million times, with finer octaves in the place of those that grew too large.",
         {.pattern = Pattern::noise, .view = View::wall, .zoom = 1e06}},
        {"broken",
         "As far in, with points rounded to floats first: their grid.",
         {.pattern = Pattern::noise, .view = View::wall, .zoom = 1e06, .origin = Origin::far}},
        {"texels",
         "Wood from a 3D texture, zoomed in: 64 texels a side, and between two of them a straight line.",
         {.pattern = Pattern::wood, .view = View::wall, .source = Source::texture, .zoom = 3}},
        {"horizon",
         "Bricks to the horizon, one point a pixel: what is finer than a pixel becomes another pattern.",
         {.pattern = Pattern::brick, .view = View::floor}},
    };
}

const bool added = addLesson(
    about, Lesson<Settings, Gpu>{
               .rows = panelRows(),
               .presets = presets(),
               .controls = {wheel("zoom", 0.1), keys(Key::down, Key::up, "zoom", 0.25),
                            keys(Key::left, Key::right, "turn", 5)},
               .readouts = {{"pixel", "how far apart neighbouring pixels' points are, in the middle", "units"},
                            {"float-step", "how far apart floats are there, with the origin far", "units"},
                            {"texel", "how far apart the texels of the 3D texture are", "units"},
                            {"texture-size", "of the 3D texture: a byte for each texel", "KiB"}},
               .draw = draw,
               .figure = drawFigure,
               .readOut = readOut,
               .scene = sceneOf,
           });

}  // namespace
}  // namespace mv::procedural
