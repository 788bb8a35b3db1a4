// The settings of deferred: rows, presets, controls and declaration.
#include "deferred.h"
#include "mv/demo/lesson.h"
#include "mv/gl/beyond_es.h"
#include "shared/orbit_rows.h"

namespace mv::deferred {
namespace {

constexpr Declaration about{
    .name = "deferred",
    .sentence = "Many lamps on surfaces that one pass has stored in several targets, and their sum beyond 1.",
    .lookFor = "Forty-eight lamps, and each pixel asks them once, however many balls lie behind each other.",
    .chapter = "Surfaces, mirrors and stages",
    .number = 38,
    .width = 800,
    .height = 480,
    .background = vec4(background, 1),
    .needs = {.beyondEs = {{"float targets", "the sum of light has eight bits, and its error is not measured"}}},
    .waste = {{"repeated-pass", "pass into 'surfaces'", "what storing costs in every frame is the lesson"},
              {"repeated-pass", "pass into 'sum of light'", "what many lamps cost in every frame is the lesson"}},
};

// Without targets of floats the sum has eight bits.
Settings fallback(Settings s) {
    if (s.sum == Sum::halfFloat && !has(beyond_es::floatTargets)) s.sum = Sum::bits8;
    return s;
}

bool stores(const Settings& s) { return s.way != Way::forward; }
bool showsPicture(const Settings& s) { return s.show == Show::picture || s.way == Way::forward; }

std::vector<Row<Settings>> panelRows() {
    return together(
        word("way", &Settings::way,
             {{"forward", "each fragment asks each lamp, when it is drawn"},
              {"deferred", "what is seen is stored first; then each pixel asks each lamp"},
              {"lamp-by-lamp", "the same, but a lamp is asked by the pixels that its reach covers"}},
             "how lamps and surfaces meet"),
        whole("lamps", &Settings::lamps, {0, mostLamps}, "how many lamps are on"),
        number("power", &Settings::power, {0.001, 4, Scale::logarithmic}, "of a lamp, as light at 1 m"),
        number("reach", &Settings::reach, {0.25, 8, Scale::logarithmic}, "how far a lamp's light goes", "m"),
        word("sum", &Settings::sum,
             {{"8-bit", "256 steps up to 1, and nothing above"}, {"half-float", "16 bits, up to 65504"}},
             "the target in which light is summed up"),
        word("tone", &Settings::tone, {{"clamp", "what is above 1 is 1"}, {"reinhard", "L becomes L/(1 + L)"}},
             "how the sum becomes a picture")
            .when(showsPicture, "the light is shown by L/(1 + L) beside what is stored"),
        oneOf("normal-bits", &Settings::normalBits, {8, 10}, "of each component of a stored normal")
            .when(stores, "nothing is stored"),
        word("show", &Settings::show, {{"picture"}, {"targets", "what is stored"}}, "what is shown")
            .when(stores, "nothing is stored"),
        part(&Settings::orbit, orbitRows({-4, 20})));
}

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"many-lamps",
         "Light is added without an upper end, and then pressed into 0 .. 1: near a lamp colours stay colours."},
        {"targets",
         "One pass has drawn three pictures: colours, normals and depths. The fourth is made of them.",
         {.show = Show::targets}},
        {"clamped",
         "The same sum cut off at 1: near the lamps the colours are gone, and faces end in flat spots.",
         {.sum = Sum::bits8, .tone = Tone::clamp}},
        {"too-dim-to-add",
         "96 dim lamps, added one by one in eight bits: what is less than half a step adds nothing, and the rest is "
         "rounded each time.",
         {.way = Way::lampByLamp,
          .lamps = mostLamps,
          .power = 0.006,
          .reach = 8,
          .sum = Sum::bits8,
          .tone = Tone::clamp}},
        {"short-reach",
         "Lamps that reach little more than a metre: asked by their own pixels only.",
         {.way = Way::lampByLamp, .lamps = mostLamps, .power = 1, .reach = 1.2}},
    };
}

const bool added = addLesson(about, Lesson<Settings, Gpu>{
                                        .rows = panelRows(),
                                        .presets = presets(),
                                        .controls = {orbitDrag, orbitWheel, keys(Key::left, Key::right, "lamps", 8)},
                                        .draw = draw,
                                        .figure = drawFigure,
                                        .fallback = fallback,
                                        .scene = sceneOf,
                                    });

}  // namespace
}  // namespace mv::deferred
