// The settings of soft-shadows: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "mv/gl/beyond_es.h"
#include "soft-shadows.h"

namespace mv::soft_shadows {
namespace {

constexpr Declaration about{
    .name = "soft-shadows",
    .sentence =
        "The soft shadow of a lamp that has a size: by many points, by a blur, and by a blur that asks how wide.",
    .lookFor = "Where caster and floor touch the shadow is sharp, and it grows softer with the distance between them.",
    .chapter = "Shadows",
    .number = 15,
    .width = 640,
    .height = 480,
    .background = vec4(0.9, 0.9, 0.9, 1),
    .needs = {.depth = true,
              .beyondEs = {{"float targets", "--accumulate float is refused; 8-bit does, up to 256 points"},
                           {"float blending", "--accumulate float is refused; 8-bit does, up to 256 points"}}},
    .waste = {{"repeated-pass", "pass into 'darkness'", "what a soft shadow costs in every frame is the lesson"},
              {"no-sample", "draw of 'leg 4'", "a leg that others hide from the lamp is known when it is drawn"}},
};

bool isByLooks(const Settings& s) { return !isByPoints(s); }
bool hasMap(const Settings& s) { return s.method != Method::matrix; }

// Add up in 8 bits where the context adds up no floats.
Settings fallback(Settings s) {
    if (s.accumulate == Sum::floats && !(has(beyond_es::floatTargets) && has(beyond_es::floatBlending)))
        s.accumulate = Sum::bytes;
    return s;
}

void check(const Settings& s) {
    // A light's view and a shadow's matrix need the whole lamp, at its largest, well above all that casts
    if (s.scene == Which::table && s.casterHeight > 0.65)
        throw Error("--caster-height", "must be at most 0.65 in scene table, to stay below the lamp",
                    numberText(s.casterHeight));
    if (isByPoints(s) && s.lights > 256 && fallback(s).accumulate != Sum::floats)
        throw Error("--lights",
                    "must be at most 256 where shadows are added up in 8 bits, whose step is 1/255: a share of less "
                    "than half a step rounds to nothing (--accumulate float has finer ones)",
                    std::to_string(s.lights));
}

std::vector<Row<Settings>> panelRows() {
    return together(
        word("scene", &Settings::scene, {{"cube"}, {"table"}}, "what stands under the lamp"),
        word("method", &Settings::method,
             {{"matrix", "points of the lamp, each with a shadow matrix: shadows on the floor alone"},
              {"maps", "points of the lamp, each with a shadow map"},
              {"pcf", "one map, its answers averaged over a square of fixed size"},
              {"pcss", "one map, averaged over a square as large as the casters found there ask for"},
              {"blur", "one map, one look; then the shadow is blurred in the picture, over taps x taps pixels"}},
             "how the shadow is made soft"),
        oneOf("lights", &Settings::lights, {1, 4, 16, 64, 256, 1024}, "points of the lamp")
            .when(isByPoints, "this method has one map, from the lamp's middle"),
        word("accumulate", &Settings::accumulate, {{"float"}, {"8-bit"}}, "what the points' shadows are added up in"),
        whole("taps", &Settings::taps, {1, 31},
              "pcf and pcss look at taps x taps places of the map, blur at as many pixels")
            .when(isByLooks, "only pcf, pcss and blur average looks"),
        oneOf("resolution", &Settings::resolution, {256, 512, 1024, 2048}, "texels a side of a map")
            .when(hasMap, "a shadow matrix has no texels"),
        word("lamp-shape", &Settings::lampShape,
             {{"square"}, {"disc", "lamp-size across"}, {"tube", "a twelfth as wide as it is long"}},
             "the lamp's outline"),
        number("lamp-size", &Settings::lampSize, {0.05, 2}, "side of the square lamp, or diameter, or length"),
        angle("lamp-turn", &Settings::lampTurn, "turn of the lamp about the vertical, from along the caster's sides"),
        number("caster-height", &Settings::casterHeight, {0, 1}, "how far what casts is lifted from the floor"),
        angle("spin-x", &Settings::spinX, "turn about the x axis"),
        angle("spin-y", &Settings::spinY, "turn about the y axis"),
        toggle("section", &Settings::section, "a section through lamp and caster, and the method's name"));
}

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"lifted",
         "The shadow is sharpest where the cube is nearest to the floor, and grows softer with the distance."},
        {"touching",
         "Where cube and floor touch the edge is sharp; 64 points of the lamp are nearly enough.",
         {.lights = 64, .casterHeight = 0}},
        {"tube",
         "A long tube: edges along it throw sharp shadows, edges across it soft ones.",
         {.lampShape = Shape::tube, .lampSize = 1.5}},
        {"blurred",
         "A blur of fixed size is as soft at the foot of a leg as at the far edge of the shadow.",
         {.scene = Which::table, .method = Method::pcf, .lampSize = 0.5, .casterHeight = 0}},
        {"blurred-in-the-picture",
         "The shadow's picture blurred: as wide everywhere, and smeared over the edges of what stands before it.",
         {.scene = Which::table, .method = Method::blur, .taps = 15, .lampSize = 0.5, .casterHeight = 0}},
        {"blurred-as-wide-as-needed",
         "A blur that asks how wide: sharp at the feet of the legs, soft at the far edge.",
         {.scene = Which::table, .method = Method::pcss, .taps = 15, .lampSize = 0.5, .casterHeight = 0}},
    };
}

const bool added = addLesson(about, Lesson<Settings, Gpu>{
                                        .rows = panelRows(),
                                        .presets = presets(),
                                        .controls = {drag("spin-y", 1, "spin-x", 1), wheel("caster-height", 0.05),
                                                     keys(Key::left, Key::right, "lamp-size", 0.05)},
                                        .draw = draw,
                                        .figure = drawFigure,
                                        .check = check,
                                        .fallback = fallback,
                                        .scene = sceneOf,
                                    });

}  // namespace
}  // namespace mv::soft_shadows
