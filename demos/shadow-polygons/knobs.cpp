// What can be set in shadow-polygons, and what is said of it.
#include "mv/demo/lesson.h"
#include "shadow-polygons.h"
#include "shared/orbit_rows.h"

namespace mv::shadow_polygons {
namespace {

constexpr Declaration about{
    .name = "shadow-polygons",
    .sentence = "Shadows of polygons on polygons, as polygons; a sphere round the light tells which pairs to try.",
    .lookFor = "A line on the sphere is a pair that is projected; polygons that do not overlap there have none.",
    .chapter = "Shadows",
    .number = 17,
    .width = 960,
    .height = 540,
    .background = vec4(0.70, 0.77, 0.85, 1),
    .needs = {.depth = true, .stencil = true, .beyondEs = {{"float targets", "wrong is not measured"}}},
    .waste = {{"no-sample", "draw of 'dark parts'", "which dark parts the eye sees is known when they are drawn"}},
};

bool arePapers(const Settings& s) { return s.scene == Which::papers; }

std::vector<Row<Settings>> panelRows() {
    return together(
        word("scene", &Settings::scene,
             {{"papers", "over a floor, turned and placed by chance"},
              {"crossing", "three squares that cut each other, over a floor"}},
             "what is shown"),
        word("method", &Settings::method,
             {{"none", "no shadow"},
              {"all-pairs", "each polygon is projected onto the plane of each other"},
              {"sphere", "only those whose bounds on a sphere round the light overlap, the nearer onto the farther"}},
             "how shadows are found"),
        whole("polygons", &Settings::polygons, {2, 255}, "how many there are, the floor among them")
            .when(arePapers, "only of papers there are as many as one likes"),
        number("paper-size", &Settings::size, {0.2, 3},
               "of each paper; at 1 all papers together have about the same area for any number"),
        number("light-x", x(&Settings::light), {-4, 4}, "x of the light"),
        number("light-y", y(&Settings::light), {0.1, 8}, "y of the light"),
        number("light-z", z(&Settings::light), {-4, 4}, "z of the light"),
        word("show", &Settings::show,
             {{"scene", "alone"},
              {"sphere", "and beside it the sphere laid flat, straight down in the middle, straight up along the rim"},
              {"pairs", "and beside it all pairs: a row for each receiver, a column for each caster"}},
             "the scene"),
        part(&Settings::orbit, orbitRows({-4, 10})));
}

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"sphere", "Outlines as the light sees them: only where caps overlap a pair is projected."},
        {"two",
         "One paper and a floor: the paper is projected onto the floor's plane, and cut off at the floor's edge.",
         {.polygons = 2, .size = 0.9, .light = {-0.6, 3.6, 0.9}}},
        {"all-pairs",
         "Each on each: of 552 projections 20 leave a shadow.",
         {.method = Method::allPairs, .show = Show::pairs},
         {{"projections", 552, 552}, {"shadows", 20, 20}}},
        {"hundred",
         "A hundred smaller papers: the more, the emptier the table.",
         {.polygons = 100, .show = Show::pairs}},
        {"crossing",
         "Squares that cut each other: of each, the part before the other's plane throws a shadow.",
         {.scene = Which::crossing, .light = {0.6, 4.5, 1.5}}},
    };
}

std::optional<vec2> placeOfLight(const Settings& s, const FrameInfo& frame) {
    const Pane pane = scenePane(s, frame);
    return pictureFromPane(pane, sceneOf(s, {frame.index(), pane.width, pane.height}).clipFromWorld(), s.light);
}

const bool added = addLesson(
    about, Lesson<Settings, Gpu>{
               .rows = panelRows(),
               .presets = presets(),
               .controls = {orbitDrag, orbitWheel, keys(Key::left, Key::right, "polygons", 1)},
               .handles = {{.name = "light", .knobs = {"light-x", "light-y", "light-z"}, .where = placeOfLight}},
               .readouts = {{"pairs-compared", "pairs of caps on the sphere that were compared"},
                            {"projections", "polygons projected onto another's plane"},
                            {"shadows", "of these the ones that left a shadow on the other"}},
               .draw = draw,
               .figure = drawFigure,
               .readOut = readOut,
               .scene = sceneOf,
               .values = values,
               .valueCounts = valueCounts,
           });

}  // namespace
}  // namespace mv::shadow_polygons
