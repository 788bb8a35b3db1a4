// The settings of shadow-lights: rows, presets, controls and declaration.
#include <algorithm>
#include <optional>

#include "mv/demo/lesson.h"
#include "mv/geometry/light_view.h"
#include "mv/math/transform.h"
#include "shadow-lights.h"
#include "shared/orbit_rows.h"
#include "shared/scenes.h"

namespace mv::shadow_lights {
namespace {

constexpr Literal inShadow = "what is wholly in one light's shadow is known when it is drawn";

constexpr Declaration about{
    .name = "shadow-lights",
    .sentence = "Several moving lights, each with its own shadows, by maps or by volumes.",
    .lookFor = "Where two shadows overlap it is darker than in either: a shadow is the lack of one light, not of all.",
    .chapter = "Shadows",
    .number = 14,
    .width = 640,
    .height = 480,
    .animated = true,
    .background = vec4(0.10, 0.11, 0.13, 1),
    .needs = {.depth = true, .stencil = true},
    .waste = {{"no-sample", "draw of 'foot'", inShadow},
              {"no-sample", "draw of 'lower arm'", inShadow},
              {"no-sample", "draw of 'upper arm'", inShadow},
              {"no-sample", "draw of 'bulb'", "whether a shade hides it is known when it is drawn"},
              {"outside-view", "draw of 'bulb'", "a bulb of 224 triangles is drawn sooner than asked for"},
              {"unused-buffer", "stencil of 'shadow-lights'", "maps do without what volumes need"}},
};

bool isCircle(const Settings& s) { return s.scene == Which::circle; }
bool isPlaced(const Settings& s) { return s.scene == Which::placed; }
bool isByMaps(const Settings& s) { return s.method == Method::maps; }

bool fitsInMap(const vec2& place) {
    static const std::vector<vec3> casters = casterPoints(stillLife(1));
    try {
        (void)fitLightView(vec4(over(place), 1), casters);
        return true;
    } catch (const Error&) {
        return false;
    }
}

// A map holds what casts only where that is in front of its light.
void check(const Settings& s) {
    if (!isPlaced(s) || !isByMaps(s)) return;
    const auto outside = std::find_if_not(s.places.begin(), s.places.end(), fitsInMap);
    if (outside != s.places.end())
        throw Error("--places", "must keep each light beside what casts, for --method maps",
                    numberText(outside->x) + "," + numberText(outside->y));
}

std::vector<Row<Settings>> panelRows() {
    return together(
        word("scene", &Settings::scene,
             {{"lamps"}, {"circle"}, {"placed", "as the circle, with the lights where --places says"}},
             "what is shown"),
        whole("lights", &Settings::lights, {1, 8}, "lights on the circle; the lamps always have three")
            .when(isCircle, "only the circle has as many as one likes"),
        points("places", &Settings::places,
               {.low = vec2(-2, -1.2), .high = vec2(2.5, 1.5), .least = 1, .most = 8, .grid = 0.05},
               "x and z of the lights of scene placed, dragged there")
            .when(isPlaced, "only the lights of scene placed stand there"),
        word("method", &Settings::method, {{"maps"}, {"volumes"}}, "how shadows are found"),
        oneOf("resolution", &Settings::resolution, {256, 512, 1024, 2048}, "texels along a side of each map")
            .when(isByMaps, "volumes have no texels"),
        number("reach", &Settings::reach, {0.5, 20}, "distance at which a light ends"),
        toggle("keep", &Settings::keep, "keep maps and volumes while light and casters rest"),
        part(&Settings::orbit, orbitRows({-3, 10})));
}

const Settings circle{.scene = Which::circle}, eight{.scene = Which::circle, .lights = 8};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"lamps", "The ball has three shadows, and none is black: in each the other lights shine."},
        {"circle", "Where all three hues shine it is white; each shadow has the colour that is left.", circle},
        {"eight", "Eight lights, eight shadows, at eight times the share of one.", eight},
        {"coarse-maps", "The eight by maps, coarse enough to see their texels.",
         with(eight,
              [](Settings& s) {
                  s.method = Method::maps;
                  s.resolution = 256;
              })},
        {"short-reach",
         "Each light ends at 4: the third, high above, reaches nothing here and costs no pass; its shadow is gone.",
         {.reach = 4},
         {{"lights-drawn", 2, 2}}},
        {"placed",
         "Drag the lights: where two colours are both kept away, the third is left.",
         {.scene = Which::placed}},
    };
}

std::optional<vec2> placeOfLight(const Settings& s, const FrameInfo& frame, const vec2& place) {
    if (!isPlaced(s)) return std::nullopt;
    return pictureFromPane({0, 0, frame.width(), frame.height()}, sceneOf(s, frame).clipFromWorld(), over(place));
}

const bool added =
    addLesson(about, Lesson<Settings, Gpu>{
                         .rows = panelRows(),
                         .presets = presets(),
                         .controls = {orbitDrag, orbitWheel, keys(Key::left, Key::right, "lights", 1)},
                         .handles = {{.name = "light", .knobs = {"places"}, .wherePoint = placeOfLight}},
                         .readouts = {{"lights-drawn", "lights that can reach the picture"},
                                      {"shadows-remade", "lights whose map or volumes were made anew for this frame"}},
                         .draw = draw,
                         .figure = drawFigure,
                         .readOut = readOut,
                         .check = check,
                         .scene = sceneOf,
                     });

}  // namespace
}  // namespace mv::shadow_lights
