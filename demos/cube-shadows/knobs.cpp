// The settings of cube-shadows: rows, presets, controls and declaration.
#include <optional>

#include "cube-shadows.h"
#include "mv/demo/lesson.h"
#include "mv/gl/beyond_es.h"

namespace mv::cube_shadows {
namespace {

constexpr Declaration about{
    .name = "cube-shadows",
    .sentence = "Planar shadows on any plane, from a lamp or a light at infinity, by one matrix.",
    .lookFor = "Move the light: the shadow runs over the floor and up the wall, and is never darkened twice.",
    .chapter = "Shadows",
    .number = 11,
    .width = 700,
    .height = 700,
    .background = vec4(1),
    .needs = {.depth = true,
              .stencil = true,
              .beyondEs = {{"clip distances", "the fragment shader discards by the same two distances"}}},
    .waste = {{"no-sample", "draw of 'cube'", "what is wholly hidden, or cut off, is known when it is drawn"},
              {"no-sample", "draw of 'sphere'", "what is wholly hidden, or cut off, is known when it is drawn"}},
};

// Discard by the same distances where the context has no clip distances.
Settings fallback(Settings s) {
    if (s.cut == Cut::clip && !has(beyond_es::clipDistances)) s.cut = Cut::discard;
    return s;
}

bool isLamp(const Settings& s) { return !s.atInfinity; }
bool isDark(const Settings& s) { return s.darkness > 0; }

std::vector<Row<Settings>> panelRows() {
    const Literal noShadow = "at darkness 0 there is no shadow";
    return together(
        word("scene", &Settings::scene,
             {{"plane", "a cube over the original's plane, which is not drawn"},
              {"room", "the cube before a floor and a wall"},
              {"still-life", "a pawn, a ring, a sphere and a box before a floor and a wall"}},
             "what casts, and on what"),
        angle("light-theta", &Settings::lightTheta,
              "where the light stands: its turn about the upright axis, 0 along x"),
        number("light-phi", &Settings::lightPhi, {0, 180}, "where the light stands: its angle from straight above",
               "deg"),
        number("light-distance", &Settings::lightDistance, {1.75, 20},
               "distance of the light from the middle of the scene")
            .when(isLamp, "a light at infinity has no distance"),
        toggle("at-infinity", &Settings::atInfinity, "a light in that direction, infinitely far away: w = 0"),
        number("lift", &Settings::lift, {-3, 12}, "how far what casts is lifted"),
        number("tilt", &Settings::tilt, {-30, 60},
               "how far the wall leans back; in scene plane, how far the plane rises", "deg"),
        number("darkness", &Settings::darkness, {0, 1}, "how much of the light a shadow takes away; 0: no shadow"),
        toggle("once", &Settings::once, "darken each pixel once, by the stencil buffer").when(isDark, noShadow),
        word("cut", &Settings::cut,
             {{"clip", "clip distances: GL cuts the triangles (ES has none: as discard)"},
              {"discard", "the fragment shader discards"},
              {"none", "not at all: false shadows are seen"}},
             "how the shadows of what is not between plane and light are cut off")
            .when(isDark, noShadow),
        word("formula", &Settings::formula,
             {{"general", "for any plane"},
              {"axis-aligned", "the slide's special case, for a plane across an axis"},
              {"transposed", "the general one as the slide prints it: wrong for columns"}},
             "which matrix flattens")
            .when(isDark, noShadow),
        number("plane-distance", &Settings::planeDistance, {0.01, 1e8, Scale::logarithmic, true},
               "distance of the floor below the world's origin"),
        word("space", &Settings::space,
             {{"plane-local", "relative to a point on the plane, in double"},
              {"world", "world coordinates in double"},
              {"world-float", "world coordinates in float"}},
             "where the matrix is computed; each is rounded to float when it is uploaded")
            .when(isDark, noShadow),
        angle("theta", &Settings::theta, "where the eye stands: its turn about the upright axis"),
        number("phi", &Settings::phi, {1, 179}, "where the eye stands: its angle from straight above", "deg"),
        number("distance", &Settings::distance, {2, 30}, "distance of the eye from the middle of the scene"),
        number("fov", &Settings::fov, {10, 120}, "the view's angle, upwards", "deg"),
        toggle("rays", &Settings::rays, "show the light's rays through the corners of cube or box"));
}

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"room", "Drag the light: the shadow runs over the floor and bends up the wall, by a matrix for each."},
        {"original",
         "The page's first picture: the eye stands where the light is, and sees no shadow.",
         {.scene = Which::plane,
          .lightTheta = 20,
          .lightPhi = 80,
          .lightDistance = 8.5,
          .darkness = 0.25,
          .theta = 20,
          .phi = 80,
          .distance = 8.5,
          .fov = 40,
          .rays = false}},
        {"sun",
         "A light at infinity and a wall that leans back: the shadow's edges stay parallel.",
         {.lightPhi = 70, .atInfinity = true, .tilt = 40}},
        {"twice",
         "Without the stencil buffer a pixel is darkened as often as something flattened falls on it.",
         {.scene = Which::stillLife,
          .lightTheta = 48,
          .lightPhi = 66,
          .lightDistance = 14,
          .once = false,
          .theta = 12,
          .fov = 40,
          .rays = false}},
        {"uncut",
         "A cube half under the floor: what is below it casts a false shadow, towards the light.",
         {.lift = -1, .cut = Cut::none}},
        {"transposed",
         "The matrix as a slide prints it, for row vectors: two patches that belong to nothing.",
         {.formula = Formula::transposed}},
    };
}

std::optional<vec2> placeOfLight(const Settings& s, const FrameInfo& frame) {
    if (s.atInfinity) return std::nullopt;
    return pictureFromPane({0, 0, frame.width(), frame.height()}, sceneOf(s, frame).clipFromWorld(), vec3(lightOf(s)));
}

const bool added = addLesson(
    about, Lesson<Settings, Gpu>{
               .rows = panelRows(),
               .presets = presets(),
               .controls = {drag("theta", -360.0 / 700, "phi", -360.0 / 700), wheel("distance", -0.5),
                            keys(Key::left, Key::right, "light-theta", 5), keys(Key::up, Key::down, "light-phi", 5)},
               .handles = {{"light", {"light-theta", "light-phi"}, placeOfLight}},
               .readouts = {{"light-height", "height of the light above the floor; at infinity the sine of its angle"}},
               .draw = draw,
               .figure = drawFigure,
               .readOut = readOut,
               .check = check,
               .fallback = fallback,
               .scene = sceneOf,
               .values = values,
           });

}  // namespace
}  // namespace mv::cube_shadows
