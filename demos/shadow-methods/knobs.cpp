// The settings of shadow-methods: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "shadow-methods.h"
#include "shared/orbit_rows.h"

namespace mv::shadow_methods {
namespace {

constexpr Literal otherHalf = "each side of the line draws the whole scene, and some of it is on the other side";

constexpr Declaration about{
    .name = "shadow-methods",
    .sentence = "All methods on one scene: matrix, volumes and maps, side by side and against time.",
    .lookFor =
        "On one flat floor the matrix is exact; between bodies it has no shadow, and a map's are as coarse as "
        "its texels.",
    .chapter = "Shadows",
    .number = 16,
    .width = 640,
    .height = 480,
    .background = vec4(0.70, 0.77, 0.85, 1),
    .needs = {.depth = true,
              .stencil = true,
              .beyondEs = {{"float targets", "--show difference is refused, and wrong is not measured"}}},
    .waste = {{"no-sample", "draw of 'ball #'", otherHalf},
              {"no-sample", "draw of 'box'", otherHalf},
              {"no-sample", "draw of 'pawn'", otherHalf},
              {"no-sample", "draw of 'sphere'", otherHalf},
              {"repeated-pass", "pass into 'lit fraction'", "what each method costs in every frame is the lesson"},
              {"unused-buffer", "stencil of 'lit fraction'", "maps do without what volumes need"},
              {"unused-buffer", "stencil of 'shadow-methods'", "maps do without what volumes need"}},
};

bool isSplit(const Settings& s) { return s.against != Against::off && s.show == Show::picture; }
bool hasBalls(const Settings& s) { return s.scene == Which::balls; }
bool hasMap(const Settings& s) { return usesMap(s.method) || usesMap(secondOf(s)); }

std::vector<Row<Settings>> panelRows() {
    const Literal noMap = "no map is used";
    return together(
        word("scene", &Settings::scene,
             {{"cube-on-plane"},
              {"still-life"},
              {"balls", "two pairs, alike in the picture; the second of each is lifted"}},
             "what is shown"),
        word("method", &Settings::method, methodWords, "how shadows are found"),
        word("against", &Settings::against,
             {{"off"}, {"none"}, {"matrix"}, {"volume"}, {"map"}, {"map-hardware"}, {"pcf3"}, {"pcf5"}},
             "a second method, right of the split or subtracted; off: none, and subtracted is what rays show"),
        number("split", &Settings::split, {0, 1}, "where the second method begins, in widths of the picture")
            .when(isSplit, "there is no line between two methods"),
        word("show", &Settings::show, {{"picture"}, {"difference", "red: too dark; blue: too light"}},
             "the picture, or what the lit fractions differ by"),
        oneOf("resolution", &Settings::resolution, {256, 512, 1024, 2048, 4096}, "texels along a side of the map")
            .when(hasMap, noMap),
        toggle("receiver", &Settings::receiver,
               "fronts and floor in the map, which need a bias; off: the backs of what casts")
            .when(hasMap, noMap),
        number("slope-bias", &Settings::slopeBias, {0, 16}, "push the map back by its slope over this many texels")
            .when(hasMap, noMap),
        toggle("keep", &Settings::keep, "keep map and volumes while light and casters rest"),
        number("ball-height", &Settings::ballHeight, {0, 1.5},
               "height of the lifted balls above the floor, nearer to the eye and smaller, so that they look the same")
            .when(hasBalls, "only the scene balls has some"),
        part(&Settings::orbit, orbitRows({-3, 10})));
}

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"map-and-volumes", "Left of the line a coarse map, right of it volumes: follow a shadow's edge across."},
        {"matrix",
         "One flat floor and one matrix: for this scene there is nothing better.",
         {.scene = Which::cube, .method = Method::matrix, .against = Against::off, .resolution = 1024}},
        {"matrix-is-wrong",
         "What the matrix lacks, in blue: the shadows of bodies on bodies.",
         {.method = Method::matrix, .against = Against::off, .show = Show::difference, .resolution = 1024}},
        {"map-is-wrong",
         "What a coarse map gets wrong, along every edge.",
         {.against = Against::off, .show = Show::difference}},
        {"where-is-the-ball",
         "The same two balls left without shadows and right with them: which of the two lies on the floor?",
         {.scene = Which::balls, .method = Method::none}},
        {"acne",
         "The floor in the map, without a bias: it shades itself in stripes, and a filter does not help.",
         {.scene = Which::cube, .against = Against::pcf3, .resolution = 1024, .receiver = true}},
    };
}

const bool added =
    addLesson(about, Lesson<Settings, Gpu>{
                         .rows = panelRows(),
                         .presets = presets(),
                         .controls = {orbitDrag, orbitWheel, keys(Key::left, Key::right, "split", 0.02),
                                      keys(Key::down, Key::up, "ball-height", 0.05)},
                         .readouts = {{"different", "pixels whose lit fractions differ by more than half", "%"},
                                      {"difference-rms", "root mean square of the difference"}},
                         .draw = draw,
                         .measure = drawAlone,
                         .figure = drawFigure,
                         .readOut = readOut,
                         .scene = sceneOf,
                     });

}  // namespace
}  // namespace mv::shadow_methods
