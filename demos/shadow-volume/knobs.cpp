// The settings of shadow-volume: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "mv/gl/beyond_es.h"
#include "shadow-volume.h"
#include "shared/orbit_rows.h"

namespace mv::shadow_volume {
namespace {

constexpr Declaration about{
    .name = "shadow-volume",
    .sentence = "Shadow volumes counted in the stencil buffer, by z-pass and z-fail.",
    .lookFor =
        "From the eye into a volume through a yellow side, out through a blue one: what lies between is in shadow.",
    .chapter = "Shadows",
    .number = 13,
    .width = 640,
    .height = 480,
    .background = vec4(0.70, 0.77, 0.85, 1),
    .needs = {.depth = true,
              .stencil = true,
              .beyondEs = {{"depth read-back", "shadow-pixels and stencil-max are not measured"},
                           {"stencil read-back", "shadow-pixels and stencil-max are not measured"},
                           {"float targets", "wrong is not measured"},
                           {"geometry shaders", "the processor finds the silhouettes"}}},
    .waste = {{"no-sample", "draw of 'shell #'", "what a volume counts is known when it is drawn"},
              {"no-sample", "draw of 'whole picture'", "what no volume covers is known when it is drawn"},
              {"no-sample", "draw of 'cube'", "what is wholly hidden is known when it is drawn"}},
};

bool isNested(const Settings& s) { return s.scene == Which::nested; }
bool mayWrap(const Settings& s) { return isNested(s) && s.shells > int(mostInOneCount); }
bool drawsSilhouette(const Settings& s) { return s.silhouette; }
bool drawsSidesAlone(const Settings& s) { return s.method != Method::zFail || s.show == Show::volumes; }
bool hidesCount(const Settings& s) { return s.show != Show::count; }

std::vector<Row<Settings>> panelRows() {
    return together(
        word("scene", &Settings::scene, {{"cube"}, {"still-life"}, {"nested"}}, "what is shown"),
        whole("shells", &Settings::shells, {1, 300}, "boxes in boxes, of the nested scene")
            .when(isNested, "only the nested scene has shells"),
        word("method", &Settings::method,
             {{"z-pass", "count what is before each pixel"},
              {"z-pass-started", "the same, starting with the volumes round the eye"},
              {"z-fail", "count what is behind each pixel"}},
             "how volumes are counted"),
        word("show", &Settings::show,
             {{"shadow"}, {"volumes", "and their surfaces, as glass"}, {"count", "and the stencil buffer"}},
             "what is drawn"),
        toggle("silhouette", &Settings::silhouette,
               "on: only the silhouette's edges are drawn out; off: the edges of every triangle"),
        word("by", &Settings::by,
             {{"processor", "when the light or a solid has moved"},
              {"geometry-shader", "in every frame, of triangles that know their neighbours"}},
             "what finds the silhouette, and draws it out")
            .when(drawsSilhouette, "every triangle is drawn out")
            .when(drawsSidesAlone, "the caps of z-fail are the processor's, and so is all that is counted with them"),
        toggle("groups", &Settings::groups, "count 127 casters at a time where more than 255 would wrap round")
            .when(mayWrap, "there are no more casters than eight bits count")
            .when(hidesCount, "what is shown is the stencil buffer, in one count"),
        word("eye", &Settings::eye, {{"outside"}, {"in-volume"}}, "where the eye is"),
        number("far", &Settings::far, {5, 100, Scale::logarithmic, true},
               "end the view this far away, and the volumes with it; 0: nowhere"),
        angle("light-turn", &Settings::lightTurn, "turn the light about the vertical"),
        number("light-height", &Settings::lightHeight, {0.1, 3}, "height of the light, in its first height"),
        toggle("at-infinity", &Settings::atInfinity, "a light at infinity, in the direction of this one"),
        part(&Settings::orbit, orbitRows({-3, 10})));
}

const Settings inVolume{.scene = Which::cube, .show = Show::shadow, .eye = Eye::inVolume};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"volumes",
         "A way from the eye goes into a volume through yellow and out through blue; more often in than out is "
         "shadow."},
        {"counts",
         "Boxes in boxes: each colour is how many volumes the point is in.",
         {.scene = Which::nested, .show = Show::count}},
        {"eye-in-volume", "The eye is in the shadow itself, and counting from the far end is right all the same.",
         inVolume},
        {"z-pass", "Counted from the eye, which is in a volume: light and shadow have changed places.",
         with(inVolume, [](Settings& s) { s.method = Method::zPass; })},
        {"wrapped",
         "256 boxes in boxes count as 0 in eight bits: a lit hole in the shadow.",
         {.scene = Which::nested, .shells = 256, .show = Show::shadow, .groups = false}},
        {"every-triangle",
         "Each triangle drawn out, instead of the silhouette: far more to fill, and no better.",
         {.silhouette = false}},
        {"by-geometry-shader",
         "Triangles that know their neighbours make the volume themselves: the light may move for nothing.",
         {.method = Method::zPassStarted, .by = By::geometryShader, .lightTurn = 60, .lightHeight = 0.7}},
    };
}

// Without geometry shaders the processor makes the same volumes.
Settings fallback(Settings s) {
    if (findsByShader(s) && !has(beyond_es::geometryShaders)) s.by = By::processor;
    return s;
}

const bool added = addLesson(
    about, Lesson<Settings, Gpu>{
               .rows = panelRows(),
               .presets = presets(),
               .controls = {orbitDrag, orbitWheel, keys(Key::left, Key::right, "light-turn", 5),
                            keys(Key::down, Key::up, "light-height", 0.1)},
               .readouts = {{"extruded-edges", "edges drawn out to infinity; of the silhouette, or of every triangle"},
                            {"volume-triangles", "triangles of the volumes that are counted"}},
               .draw = draw,
               .figure = drawFigure,
               .readOut = readOut,
               .fallback = fallback,
               .scene = sceneOf,
           });

}  // namespace
}  // namespace mv::shadow_volume
