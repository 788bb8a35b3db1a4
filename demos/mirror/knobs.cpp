// The settings of mirror: rows, presets, controls, handles and readouts.
#include <cmath>

#include "mirror.h"
#include "mv/demo/lesson.h"
#include "mv/gl/beyond_es.h"

namespace mv::mirror {
namespace {

void check(const Settings& s) {
    const vec3 beside = s.eye - MirrorRoom::lookedAt();
    if (std::hypot(beside.x, beside.z) < 0.01)
        throw Error("--eye-x", "must keep the eye from above the first mirror's middle, on which it looks",
                    numberText(s.eye.x));
}

// Lay the near plane into the mirror where the context has no clip distances.
Settings fallback(Settings s) {
    if (s.near == Near::clipDistance && !has(beyond_es::clipDistances)) s.near = Near::oblique;
    return s;
}

bool hasTwo(const Settings& s) { return s.count == Count::two; }
bool hasTexture(const Settings& s) { return s.method == Method::texture; }

std::vector<Row<Settings>> panelRows() {
    const Literal noTexture = "there is no texture";
    return together(
        word("method", &Settings::method,
             {{"stencil", "the mirrored world is drawn into the picture, where the mirror has marked it"},
              {"texture", "it is drawn into a texture, which the mirror shows"}},
             "how a mirror is drawn"),
        word("near", &Settings::near,
             {{"oblique", "the near plane is laid into the mirror"},
              {"clip-distance", "by gl_ClipDistance; depths stay as they were"},
              {"none", "by nothing: it gets in"}},
             "how what stands behind the mirror is kept out of it"),
        word("mirrors", &Settings::count, {{"one"}, {"two", "facing each other"}}, "how many there are"),
        whole("bounces", &Settings::bounces, {1, 16}, "reflections one after another, at most")
            .when(hasTwo, "a single mirror is not seen in itself"),
        number("reflectance", &Settings::reflectance, {0, 1}, "part of the light that a mirror sends on"),
        oneOf("coarser", &Settings::coarser, {1, 2, 4, 8, 16}, "pixels of the picture along a texel")
            .when(hasTexture, noTexture),
        toggle("keep", &Settings::keep, "keep the textures while eye and world rest").when(hasTexture, noTexture),
        angle("mirror-turn", &Settings::turn, "of the first mirror about its upright axis"),
        number("eye-x", x(&Settings::eye), {-3, 3}, "where the eye stands, which looks at the first mirror's middle"),
        number("eye-z", z(&Settings::eye), {-5, 5}, "the same; the first mirror stands at -2, the second at 3.4"),
        number("eye-height", y(&Settings::eye), {0.2, 3}, "the same, above the floor"),
        number("ball-x", x(&Settings::ball), {-3, 3}, "where the ball lies"),
        number("ball-z", y(&Settings::ball), {-5, 5}, "the same"),
        toggle("winding", &Settings::winding, "say which winding is the front, which each reflection turns over"),
        toggle("leave-out", &Settings::leaveOut, "draw nothing for a mirror that it does not show"));
}

constexpr Declaration about{
    .name = "mirror",
    .sentence = "A plane mirror by the stencil buffer or by a texture, and two that show each other many times.",
    .lookFor =
        "What is in the mirror is as far behind it as it is in front, and nothing there has come from behind it.",
    .chapter = "Surfaces, mirrors and stages",
    .number = 30,
    .width = 960,
    .height = 560,
    .background = vec4(sky, 1),
    .needs = {.depth = true,
              .stencil = true,
              .beyondEs = {{"clip distances", "the near plane is laid into the mirror instead"},
                           {"float targets", "what is wrong is not measured"}}},
    .waste = {{"no-sample", "draw of 'floor'", "what of the floor is seen is known when it is drawn"},
              {"unused-buffer", "stencil of 'mirror'", "a mirror by a texture does without"}},
};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"one", "The red line is the light's way: from the ball to the mirror, and from there to the eye."},
        {"behind",
         "Nothing keeps out what stands behind the mirror: the red column comes out of it.",
         {.near = Near::none}},
        {"facing",
         "Two mirrors show each other: every second image shows things from their other side.",
         {.count = Count::two}},
        {"inside-out",
         "A reflection turns the winding over; whoever forgets that draws the insides.",
         {.winding = false}},
        {"coarse", "By a texture whose texels are 8 pixels wide.", {.method = Method::texture, .coarser = 8}},
        {"turned", "Two mirrors that are not parallel: the images lie on a circle.", {.count = Count::two, .turn = 12}},
    };
}

std::optional<vec2> placeOfBall(const Settings& s, const FrameInfo& frame) {
    const Pane picture{0, 0, frame.width(), frame.height()};
    return pictureFromPane(picture, sceneOf(s, frame).clipFromWorld(), roomOf(s).ball);
}
std::optional<vec2> placeOfEye(const Settings& s, const FrameInfo& frame) {
    return planOfRoom(frame).pixel({s.eye.x, s.eye.z});
}

const bool added = addLesson(
    about, Lesson<Settings, Gpu>{
               .rows = panelRows(),
               .presets = presets(),
               .controls = {keys(Key::left, Key::right, "bounces", 1), drag("eye-x", -0.01, "eye-height", 0.01),
                            wheel("eye-z", -0.1)},
               .handles = {{"ball", {"ball-x", "ball-z"}, placeOfBall}, {"eye", {"eye-x", "eye-z"}, placeOfEye}},
               .readouts = {{"passes", "times that the world is drawn in a mirror"},
                            {"drawn", "objects drawn there, together"},
                            {"left-out", "objects that are not, since no mirror shows them"},
                            {"eye-distance", "of the eye from the first mirror's plane; below 0 behind it"},
                            {"depth-steps", "steps of 24 bits from the ball's front to its back, in the first mirror"}},
               .draw = draw,
               .figure = drawFigure,
               .readOut = readOut,
               .check = check,
               .fallback = fallback,
               .scene = sceneOf,
           });

}  // namespace
}  // namespace mv::mirror
