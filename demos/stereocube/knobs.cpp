// What can be set in stereocube, and what is said of it.
#include "mv/demo/lesson.h"
#include "mv/geometry/in_view.h"
#include "stereocube.h"

namespace mv::stereocube {

void check(const Settings& s) {
    for (const Eye& eye : {leftEye(s, 1), rightEye(s, 1)}) {
        const bool isOpen = s.eyes == Eyes::both || s.eyes == eye.which;
        if (isOpen && isInView(wireCube(), eye.clipFromEye * eye.eyeFromWorld * worldFromModelOf(s))) return;
    }
    throw Error("--z-dist", "must leave some of the cube in view of an eye", numberText(s.zDist));
}

namespace {

constexpr Declaration about{
    .name = "stereocube",
    .sentence = "Stereo with coloured glasses: two eyes, two pictures, one in red and one in cyan.",
    .lookFor = "With red glass left and cyan glass right the cube stands in the depth; without, a red and a cyan cube.",
    .chapter = "Stereo and hidden surfaces",
    .number = 6,
    .width = 600,
    .height = 600,
    .needs = {.depth = true},
};

const Lesson<Settings, Gpu> lesson{
    .rows =
        {
            number("eye-sep", &Settings::eyeSep, {0, 1}, "distance between the eyes"),
            number("z-dist", &Settings::zDist, {-10, 2}, "z of the eyes, which look along +z"),
            number("convergence", &Settings::convergence, {0.25, 10}, "how far ahead of the eyes the screen is"),
            angle("spin-x", &Settings::spinX, "turn about the x axis"),
            angle("spin-y", &Settings::spinY, "turn about the y axis"),
            word("stereo", &Settings::stereo,
                 {{"toe-in", "both eyes look at one point"}, {"off-axis", "parallel, through one window"}},
                 "how the two eyes are aimed"),
            word("colors", &Settings::colors,
                 {{"lines", "lines in red and in cyan"}, {"masks", "the red channel, then green and blue"}},
                 "how the two pictures become one"),
            word("background", &Settings::background, {{"white"}, {"black"}}, "what the lines are drawn on"),
            word("eyes", &Settings::eyes, {{"both"}, {"left"}, {"right"}}, "whose picture is drawn"),
        },
    .presets =
        {
            {"turned",
             "With red glass left and cyan glass right it stands behind the screen; its horizontal edges are not "
             "level."},
            {"original",
             "The page's first picture: the cube straight on, a small square in a large one, each twice.",
             {.spinX = 0, .spinY = 0}},
            {"off-axis",
             "Both eyes look straight ahead, so that no corner moves up or down: vertical-parallax is 0. Each channel "
             "is one picture.",
             {.stereo = Stereo::offAxis, .colors = Colors::masks},
             {{"vertical-parallax", 0, 1e-9}}},
            {"on-black",
             "On black each glass passes its own colour, so the two have changed places.",
             {.stereo = Stereo::offAxis, .background = Paper::black}},
            {"before-the-screen",
             "The screen is behind the cube, which comes out of it.",
             {.zDist = -2, .convergence = 6, .stereo = Stereo::offAxis}},
            {"squint",
             "Eyes far apart that meet near: the heights of the two pictures differ by many pixels.",
             {.eyeSep = 0.5, .convergence = 1}},
        },
    .controls = {drag("spin-y", 1, "spin-x", -1), keys(Key::down, Key::up, "z-dist", 0.1), wheel("z-dist", 0.1)},
    .readouts = {{"vertical-parallax", "largest difference in height between the two pictures of a corner", "px"},
                 {"parallax-min", "the right eye's picture of a corner is this much to the right, least", "px"},
                 {"parallax-max", "the same, most; positive is behind the screen, negative before it", "px"}},
    .draw = draw,
    .readOut = readOut,
    .check = check,
};

const bool added = addLesson(about, lesson);

}  // namespace
}  // namespace mv::stereocube
