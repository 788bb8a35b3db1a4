// The settings of color-models: rows, presets, controls and readouts.
#include "color-models.h"
#include "mv/demo/lesson.h"

namespace mv::color_models {
namespace {

bool isSolids(const Settings& s) { return s.shows == Shows::solids; }
bool isDiagram(const Settings& s) { return s.shows == Shows::diagram; }

std::vector<Row<Settings>> panelRows() {
    const Literal noSolids = "the diagram has neither solids nor strips";
    return together(
        word("scene", &Settings::shows,
             {{"solids", "the three solids, and strips below"}, {"diagram", "the chromaticity diagram"}},
             "what is shown"),
        number("red", x(&Settings::from), {0, 1}, "of the colour, as sRGB"),
        number("green", y(&Settings::from), {0, 1}, "of the colour"),
        number("blue", z(&Settings::from), {0, 1}, "of the colour"),
        number("to-red", x(&Settings::to), {0, 1}, "of the second colour, which it is mixed with"),
        number("to-green", y(&Settings::to), {0, 1}, "of the second colour"),
        number("to-blue", z(&Settings::to), {0, 1}, "of the second colour"),
        word("mix", &Settings::way,
             {{"srgb", "the components as the screen is given them"},
              {"linear", "light itself"},
              {"hsl", "hue, saturation and lightness, the shorter way round"},
              {"oklab", "evenly as seen"}},
             "whose way from colour to colour is drawn"),
        part(&Settings::solids,
             {whole("steps", &Solids::steps, {1, 1024}, "from one end of a strip to the other"),
              toggle("cut", &Solids::cut, "cut the solids open at the colour's height")},
             isSolids, noSolids),
        word("diagram", &Settings::diagram, {{"xy", "of 1931"}, {"uv", "u'v' of 1976, nearer to distances as seen"}},
             "which chromaticity diagram")
            .when(isDiagram, "no diagram is shown"),
        part(&Settings::solids,
             {angle("spin-x", &Solids::spinX, "turn about the x axis"),
              angle("spin-y", &Solids::spinY, "turn about the y axis"),
              word("written", &Solids::written,
                   {{"numbers", "from 0 to 1"}, {"hex", "as style sheets do, the second colour too"}},
                   "how the colour is written above the cube")},
             isSolids, noSolids));
}

constexpr Declaration about{
    .name = "color-models",
    .sentence = "RGB's cube, HSL's and HSV's cones, four ways to mix two colours, and the part of all colours in sRGB.",
    .lookFor =
        "Drag the mark in one solid: it moves in all. The strip that looks even is the one that is mixed in OKLab.",
    .chapter = "Light, colour and texture",
    .number = 19,
    .width = 960,
    .height = 640,
    .background = vec4(1, 1, 1, 1),
    .needs = {.depth = true},
    .waste = {{"unused-buffer", "depth of 'color-models'", "the diagram is flat, the solids are not"}},
};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"orange-to-blue",
         "In sRGB the middle is a dull grey, HSL goes round through red; the steps of the OKLab strip look even."},
        {"cut-open",
         "All three cut at the colour's height: of one intensity, one lightness and one value.",
         {.from{0.8, 0.3, 0.4}, .solids = {.cut = true}}},
        {"grey",
         "A grey has no hue: in HSL it takes that of the other colour, and is on the axis of all three solids.",
         {.from{0.5, 0.5, 0.5}, .way = Way::hsl}},
        {"yellow-to-blue",
         "The OKLab strip is even, but no sRGB screen shows those of its colours that are underlined.",
         {.from{1, 1, 0}, .to{0, 0, 1}, .way = Way::oklab},
         {{"uneven-oklab", 0, 1e-9}, {"beyond", 1, 12}}},
        {"diagram",
         "Nearly all colours that are seen? A third of the diagram; mixed light goes straight through it.",
         {.shows = Shows::diagram, .way = Way::linear},
         {{"part-of-diagram", 33, 34}}},
        {"diagram-of-1976",
         "Here green has less room and blue more, and the triangle's part is a third again.",
         {.shows = Shows::diagram, .way = Way::linear, .diagram = Diagram::uv},
         {{"part-of-diagram", 33, 34}}},
    };
}

template <Space space, vec3 Settings::*color>
std::optional<vec2> markOf(const Settings& s, const FrameInfo& frame) {
    return markIn(s, frame, space, s.*color);
}
template <Space space>
LessonHandle<Settings> first(Literal name) {
    return {name, {"red", "green", "blue"}, markOf<space, &Settings::from>};
}
template <Space space>
LessonHandle<Settings> second(Literal name) {
    return {name, {"to-red", "to-green", "to-blue"}, markOf<space, &Settings::to>};
}

const bool added = addLesson(
    about, Lesson<Settings, Gpu>{
               .rows = panelRows(),
               .presets = presets(),
               .controls = {drag("spin-y", 1, "spin-x", 1), keys(Key::left, Key::right, "steps", 1)},
               .handles = {first<cube>("color in the cube"), second<cube>("second color in the cube"),
                           first<doubleCone>("color in the double cone"),
                           second<doubleCone>("second color in the double cone"), first<cone>("color in the cone"),
                           second<cone>("second color in the cone"), first<inDiagram>("color in the diagram"),
                           second<inDiagram>("second color in the diagram")},
               .readouts = {{"hue", "of the colour; greys have none", "deg"},
                            {"lightness", "of the colour, as seen: L of OKLab"},
                            {"uneven-srgb", "steps' deviation from their mean (rms), of it", "%"},
                            {"uneven-linear", "the same, mixed as light", "%"},
                            {"uneven-hsl", "the same, mixed in HSL", "%"},
                            {"uneven-oklab", "the same, mixed in OKLab", "%"},
                            {"beyond", "colours of the OKLab strip that no sRGB screen shows"},
                            {"part-of-diagram", "of the diagram that sRGB holds", "%"},
                            {"uneven-ciede2000", "steps' deviation by CIEDE2000, mixed as drawn", "%"},
                            {"ciede2000", "how different the two colours are seen; 1 is the least that is noticed"},
                            {"contrast", "of letters of one colour on the other, 1 to 21; 4.5 is asked for"},
                            {"lab-l", "of the colour: lightness L* of CIELAB, 0 to 100"},
                            {"lab-a", "the same: a*, from green to red"},
                            {"lab-b", "the same: b*, from blue to yellow"}},
               .draw = draw,
               .readOut = readOut,
               .values = values,
           });

}  // namespace
}  // namespace mv::color_models
