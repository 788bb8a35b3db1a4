// The settings of projections: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "projections.h"

namespace mv::projections {
namespace {

constexpr Declaration about{
    .name = "projections",
    .sentence = "One house in four views at once: orthographic, axonometric, oblique, and with vanishing points.",
    .lookFor = "Which lengths and angles a view keeps; and in the perspectives, where parallel edges would meet.",
    .chapter = "Viewing and projection",
    .number = 4,
    .width = 960,
    .height = 720,
    .background = vec4(0.5, 0.5, 0.5, 1),
    .needs = {.depth = true},
    .waste = {{"unused-object", "mesh 'horizon'", "made once, for the settings that show it"},
              {"unused-object", "mesh 'rays'", "made once, for the settings that show them"},
              {"no-sample", "draw of 'horizon'",
               "from afar it lies beyond the far plane's edge, as a line that no pixel has"}},
};

bool isOblique(const Settings& s) { return s.show == Show::oblique; }
bool isTurned(const Settings& s) { return !isOblique(s); }
bool hasPerspective(const Settings& s) { return s.show == Show::cad || s.show == Show::vanishing; }

std::vector<Row<Settings>> panelRows() {
    const Literal isFacing = "an oblique view has its front to the picture";
    const Literal noPerspective = "there is no perspective among these views";
    const Literal noOblique = "there is no oblique view among these";
    return {
        word("show", &Settings::show,
             {{"cad", "top, perspective, front and side"},
              {"axonometric", "isometric, dimetric, trimetric and yours"},
              {"oblique", "cavalier, cabinet, planometric and yours"},
              {"vanishing", "one, two, three vanishing points and yours"}},
             "which four views"),
        angle("turn", &Settings::turn, "yours: how far the eye goes round, to the right").when(isTurned, isFacing),
        number("tilt", &Settings::tilt, {-90, 90}, "yours: how far the eye goes up from there", "deg")
            .when(isTurned, isFacing),
        number("distance", &Settings::distance, {9, 1000, Scale::logarithmic},
               "yours, a perspective: from the eye to the house", "m")
            .when(hasPerspective, noPerspective),
        number("angle", &Settings::angle, {-180, 180}, "yours, oblique: where depth is drawn to, from the horizontal",
               "deg")
            .when(isOblique, noOblique),
        number("length", &Settings::length, {0, 2}, "yours, oblique: how long a metre of depth is drawn", "m")
            .when(isOblique, noOblique),
        number("shift", &Settings::shift, {-1, 1},
               "yours, a perspective: how far its window is moved up, in its half heights")
            .when(hasPerspective, noPerspective),
    };
}

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"cad",
         "Top stands over front and side beside it, each to be measured with a ruler; only the perspective looks like "
         "a house."},
        {"axonometric",
         "All three axes are seen, each shortened: all alike in the isometric view, two alike in the dimetric one.",
         {.show = Show::axonometric}},
        {"oblique",
         "All three keep a side as it is. Cavalier keeps the depth, too, and looks too deep; cabinet halves it.",
         {.show = Show::oblique}},
        {"vanishing",
         "Parallel edges that are not parallel to the picture meet, in one, two or three points.",
         {.show = Show::vanishing}},
        {"level",
         "Your perspective, looking level, has 2 vanishing points: the walls stay upright.",
         {.show = Show::vanishing, .tilt = 0},
         {{"vanishing-points", 2, 2}}},
        {"from-afar",
         "From 1000 m the perspective is nearly the parallel view of the same turn.",
         {.show = Show::vanishing, .distance = 1000}},
    };
}

const bool added = addLesson(
    about, Lesson<Settings, Gpu>{
               .rows = panelRows(),
               .presets = presets(),
               .controls = {drag("turn", -0.5, "tilt", 0.5)},
               .readouts = {{"shortening-x", "in your parallel view: how long a metre along x is drawn", "m"},
                            {"shortening-y", "the same along y", "m"},
                            {"shortening-z", "the same along z", "m"},
                            {"shortening-error", "largest difference from the formulas in the parallel views", "m"},
                            {"vanishing-points", "how many your perspective has"},
                            {"meeting-error",
                             "by how much an edge that is drawn longer misses its vanishing point, at most", "px"}},
               .draw = draw,
               .figure = drawFigure,
               .readOut = readOut,
           });

}  // namespace
}  // namespace mv::projections
