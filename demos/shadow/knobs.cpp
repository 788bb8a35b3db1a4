// The settings of shadow: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "shadow.h"

namespace mv::shadow {
namespace {

constexpr Declaration about{
    .name = "shadow",
    .sentence = "A planar shadow: the square drawn twice, the second time flattened by a matrix and in black.",
    .lookFor = "The shadow moves against the light, and grows as the light comes down towards the square.",
    .chapter = "Shadows",
    .number = 9,
    .width = 512,
    .height = 512,
    .animated = true,
    .background = vec4(1),
    .needs = {.depth = true},
};

std::optional<vec2> placeOfLight(const Settings& s, const FrameInfo& frame) {
    return pictureFromPane({0, 0, frame.width(), frame.height()}, clipFromViewOf(frame) * viewFromWorld,
                           vec3(lightOf(s, frame)));
}

const Lesson<Settings, Gpu> lesson{
    .rows =
        {
            number("light-height", &Settings::lightHeight, {-1, 4}, "height of the light above the plane y = 0"),
            number("square-height", &Settings::squareHeight, {-0.5, 1.5}, "height of the middle of the square"),
            angle("tilt", &Settings::tilt, "turn of the square about its middle, so that one side rises"),
            toggle("rays", &Settings::rays, "show the light, and its rays through the corners of the square"),
        },
    .presets =
        {
            {"on-one-line", "Each ray goes from the light through a corner to that corner of the shadow."},
            {"original", "The square once in red, and once more, flattened onto y = 0 and black.", {.rays = false}},
            {"low-light",
             "The light comes down, and the shadow grows to 5.06 times the square.",
             {.lightHeight = 0.9},
             {{"shadow-area", 5.055, 5.065}}},
            {"through-the-plane", "Only the part above the plane casts.", {.squareHeight = 0.2, .tilt = 60}},
            {"light-between",
             "The light stands between lower and upper side: what is below it casts a shadow without end.",
             {.lightHeight = 0.6, .tilt = 50}},
        },
    .controls = {keys(Key::down, Key::up, "light-height", 0.05)},
    .handles = {{"light", {"light-height"}, placeOfLight}},
    .readouts = {{"least-w", "smallest w of the shadow's corners: how far the highest corner is below the light"},
                 {"shadow-area", "area of the shadow; the square's is 1"}},
    .draw = draw,
    .figure = drawFigure,
    .readOut = readOut,
};

const bool added = addLesson(about, lesson);

}  // namespace
}  // namespace mv::shadow
