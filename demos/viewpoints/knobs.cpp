// The settings of viewpoints: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "viewpoints.h"

namespace mv::viewpoints {

void check(const Settings& s) {
    // Below the roof these views can show nothing but the car's own blue.
    if ((s.view == View::driver || s.view == View::house) && s.height < -1)
        throw Error("--height", "must be at least -1 in views 4 and 5: the eye is under the car's roof",
                    numberText(s.height));
}

namespace {

constexpr Declaration about{
    .name = "viewpoints",
    .sentence = "One lookAt for each view: what it speaks of, and in which order the matrices are multiplied.",
    .lookFor = "In views 1 to 3 and 9 the car moves; in 4 to 8 the car stands still and the world moves around it.",
    .chapter = "Viewing and projection",
    .number = 1,
    .width = 700,
    .height = 700,
    .animated = true,
    .background = vec4(0.7, 1.0, 0.7, 1.0),
    .needs = {.depth = true},
    .waste = {{"no-sample", "draw of 'cube'", "what hides it is known when it is drawn"},
              {"outside-view", "draw of 'cube'", "a scene of a few cubes is drawn sooner than asked for"}},
};

bool looksAtHouse(const Settings& s) { return s.view == View::house; }

const Lesson<Settings, Gpu> lesson{
    .rows =
        {
            word("view", &Settings::view,
                 {{"1", "from a distance"},
                  {"2", "at the car from inside the ring"},
                  {"3", "at the car from outside the ring"},
                  {"4", "the driver's"},
                  {"5", "out of the car, always at one house"},
                  {"6", "from behind and above the car"},
                  {"7", "back from a car in front"},
                  {"8", "from beside the car"},
                  {"9", "straight down at the middle of the track"}},
                 "where the eye is"),
            number("height", &Settings::height, {-4, 100}, "how much higher the eye is than the view says"),
            toggle("exact", &Settings::exact, "view 5: one lookAt in world space instead of the slide's formula")
                .when(looksAtHouse, "only view 5 looks at a house"),
            number("aim", &Settings::aim, {0, 10}, "view 5: how high on the house to look; at height 0, 5 is level")
                .when(looksAtHouse, "only view 5 looks at a house"),
            word("camera", &Settings::camera,
                 {{"off"}, {"all", "nine, numbered"}, {"one", "its axes, and lookAt's matrix"}},
                 "cameras shown from outside, above the picture"),
            toggle("lit", &Settings::lit, "shaded boxes and a sky, instead of one colour a thing on green"),
        },
    .presets =
        {
            {"cameras", "Nine places to look from: above all of them, below what the chosen one sees."},
            {"original",
             "The page's first picture: the car goes round clockwise; track and houses stand still.",
             {.camera = Outside::off, .lit = false}},
            {"driver", "Now the car stands still, and the world turns around it.", {.view = View::driver}},
            {"camera",
             "From beside the car, and the camera from outside: its axes u, v, w are the rows of lookAt's matrix.",
             {.view = View::beside, .camera = Outside::one}},
            {"house-by-slide",
             "Looking at one house from the moving car, by the slide's formula: houses and track lean over.",
             {.view = View::house, .height = 40}},
            {"house-exact",
             "The same view with eye and house in one space: they stand upright; roll and miss are 0.",
             {.view = View::house, .height = 40, .exact = true},
             {{"roll", 0, 1e-9}, {"miss", 0, 1e-9}}},
            {"above",
             "Straight down. Up along the gaze says nothing, so +y is up here.",
             {.view = View::above, .height = 40}},
        },
    .controls = {keySets(key('1'), "view", "1"), keySets(key('2'), "view", "2"), keySets(key('3'), "view", "3"),
                 keySets(key('4'), "view", "4"), keySets(key('5'), "view", "5"), keySets(key('6'), "view", "6"),
                 keySets(key('7'), "view", "7"), keySets(key('8'), "view", "8"), keySets(key('9'), "view", "9"),
                 keys(Key::down, Key::up, "height", 2)},
    .readouts = {{"direction", "how far the car has come, clockwise from +y", "deg"},
                 {"eye-height", "how high the eye is above the ground"},
                 {"miss", "view 5: angle between the line of sight and the house", "deg"},
                 {"roll", "view 5: how far the horizon is tilted", "deg"}},
    .draw = draw,
    .figure = drawFigure,
    .readOut = readOut,
    .check = check,
};

const bool added = addLesson(about, lesson);

}  // namespace
}  // namespace mv::viewpoints
