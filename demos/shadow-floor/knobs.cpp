// The settings of shadow-floor: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "shadow-floor.h"

namespace mv::shadow_floor {
namespace {

constexpr Declaration about{
    .name = "shadow-floor",
    .sentence = "A planar shadow on a floor, with the light that throws it in the picture.",
    .lookFor = "Light, corner of the square and corner of the shadow are on one line, from wherever you look.",
    .chapter = "Shadows",
    .number = 10,
    .width = 600,
    .height = 600,
    .animated = true,
    .background = vec4(0.95, 1, 1, 1),
    .needs = {.depth = true},
    .waste = {{"outside-view", "draw of 'light'", "the light's ball is drawn sooner than asked for"},
              {"no-sample", "draw of 'square'", "that the floor hides it from below is the lesson"}},
};

std::optional<vec2> placeOfLight(const Settings& s, const FrameInfo& frame) {
    return pictureFromPane({0, 0, frame.width(), frame.height()}, clipFromViewOf(frame) * viewFromWorldOf(s),
                           lightOf(s, frame));
}

const Settings overTheEdge{.spinY = 60, .lightX = -1, .lightHeight = 1, .circle = false};

const Lesson<Settings, Gpu> lesson{
    .rows =
        {
            number("z-dist", &Settings::zDist, {-10, 10}, "z of the eye at (1, 1, z), which looks at the origin"),
            angle("spin-x", &Settings::spinX, "turn about the x axis"),
            angle("spin-y", &Settings::spinY, "turn about the y axis"),
            number("light-x", &Settings::lightX, {-2, 2}, "x of the light, or of the middle of its circle"),
            number("light-z", &Settings::lightZ, {-2, 2}, "z of the light, or of the middle of its circle"),
            number("light-height", &Settings::lightHeight, {-1, 4}, "height of the light above the floor"),
            toggle("circle", &Settings::circle, "let the light go round on a circle of radius 1"),
            toggle("crop", &Settings::crop, "let the shadow end where the floor ends"),
            toggle("rays", &Settings::rays, "show the light's rays through the corners of the square"),
        },
    .presets =
        {
            {"on-one-line", "Light, corner and the corner's shadow stay on one line while the light goes round."},
            {"original",
             "The page's first picture: the square, its shadow, and nothing between them.",
             {.rays = false}},
            {"over-the-edge", "The shadow ends where the floor ends.", overTheEdge},
            {"hanging", "The matrix knows a plane, which has no end: the shadow goes on in the air.",
             with(overTheEdge, [](Settings& s) { s.crop = false; })},
            {"from-above", "From above the whole shadow is seen.", {.spinX = -40}},
            {"from-below", "From below there is none: the floor hides it.", {.spinX = 40}},
        },
    .controls = {drag("spin-y", 1, "spin-x", -1), wheel("z-dist", 0.1), keys(Key::left, Key::right, "light-x", 0.05),
                 keys(Key::up, Key::down, "light-z", 0.05)},
    .handles = {{"light", {"light-x", "light-height", "light-z"}, placeOfLight}},
    .readouts = {{"shadow-area", "area of the whole shadow; the square's is 1"},
                 {"on-floor", "area of the part of it that falls on the floor, which is 9"}},
    .draw = draw,
    .figure = drawFigure,
    .readOut = readOut,
};

const bool added = addLesson(about, lesson);

}  // namespace
}  // namespace mv::shadow_floor
