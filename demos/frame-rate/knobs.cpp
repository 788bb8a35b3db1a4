// The settings of frame-rate: rows, presets, controls and declaration.
#include "frame-rate.h"
#include "mv/demo/lesson.h"

namespace mv::frame_rate {
namespace {

bool areWays(const Settings& s) { return s.beside == Beside::ways; }

std::vector<Row<Settings>> panelRows() {
    return together(
        word("beside", &Settings::beside,
             {{"displays", "the first way on three of them, and the second"}, {"ways", "four, on one display"}},
             "what stands beside each other")
            .beginsAnew(),
        word("display", &Settings::display, {{"60"}, {"59.94", "60000/1001, as television has it"}, {"144"}, {"240"}},
             "pictures a second that the simulated display can show")
            .beginsAnew(),
        number("speed", &Settings::speed, {0, 720}, "how fast the cube is to turn", "deg/s").beginsAnew(),
        number("hours", &Settings::hours, {0, 24}, "how long the program has been running at frame 0", "h")
            .beginsAnew(),
        number("load", &Settings::load, {0, 100}, "time to draw a picture", "ms"),
        number("jitter", &Settings::jitter, {0, 20}, "by how much more that differs at random", "ms"),
        number("hiccup", &Settings::hiccup, {0, 500}, "how much longer one picture in two seconds takes", "ms"),
        oneOf("steps", &Settings::steps, {15, 60, 240}, "steps a second of the fourth way").beginsAnew(),
        number("step-load", &Settings::stepLoad, {0, 40}, "time to compute one of these steps", "ms"),
        toggle("cap", &Settings::cap, "at most 5 steps for a picture; what is owed beyond is dropped"),
        toggle("between", &Settings::between, "show the steps' motion between two steps, not the last one")
            .when(areWays, "the fourth way is not shown"),
        word("sum", &Settings::sum,
             {{"double"},
              {"float"},
              {"compensated", "the roundings are added up, too"},
              {"product", "it does not: the number of the refresh times its length"}},
             "how the second way adds up its time")
            .beginsAnew(),
        word("hands", &Settings::hands,
             {{"clockwise"}, {"as-written", "by t/10 and t/120 degrees, as the slide has it"}},
             "which way the hands go"),
        word("ball", &Settings::ball,
             {{"as-written", "by |sin(wt + theta_0)| e^(-kt), as the slide has it"},
              {"falling", "freely, from bounce to bounce"}},
             "how the ball bounces"));
}

constexpr Declaration about{
    .name = "frame-rate",
    .sentence = "Motion per picture, per second, of the time and in steps, on a display that is simulated.",
    .lookFor = "Made for 60 Hz, after an hour at 144 Hz it is 84 minutes fast; by the seconds it is right everywhere.",
    .chapter = "Motion",
    .number = 33,
    .width = 960,
    .height = 560,
    .animated = true,
    .background = vec4(1, 1, 1, 1),
    .needs = {.depth = true},
};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"hour",
         "What was made for 60 Hz runs 2.4 times as fast at 144 and 4 times at 240: off by 5040 and 10800 s in an "
         "hour.",
         {},
         {{"per-picture-off", 5039.9, 5040.2}}},
        {"made-for-60",
         "At 60 Hz, and from the start, all agree: a mistake that its author cannot see.",
         {.beside = Beside::ways, .display = Display::hz60, .hours = 0}},
        {"backwards",
         "The slide's formulas, t/10 and t/120 degrees: positive angles turn the hands backwards.",
         {.beside = Beside::ways, .display = Display::hz60, .hands = Hands::asWritten}},
        {"stutter",
         "Pictures late at random, one of them very late: the first way is thrown off, and the fourth loses what "
         "the cap drops.",
         {.beside = Beside::ways, .hours = 0.01, .jitter = 12, .hiccup = 300}},
        {"spiral",
         "A step of 1/60 s takes 20 ms to compute: 5 are owed for each picture, and the cap drops the rest.",
         {.beside = Beside::ways, .hours = 0.01, .stepLoad = 20}},
        {"no-cap",
         "Without the cap each picture takes longer than the one before, and soon none comes any more.",
         {.beside = Beside::ways, .hours = 0.002, .stepLoad = 20, .cap = false}},
    };
}

const bool added = addLesson(
    about, Lesson<Settings, Gpu, Running>{
               .rows = panelRows(),
               .presets = presets(),
               .readouts = {{"per-picture-off", "how far the first way's time is off", "s"},
                            {"per-second-off", "how far the second way's time is off", "s"},
                            {"steps-off", "how far the fourth way's time is off", "s"},
                            {"lost", "time that the cap has dropped", "s"},
                            {"picture-lasts", "how long the picture that is shown lasts", "ms"},
                            {"turn-per-second", "the cube's turn by the second way, whole turns taken off", "deg"},
                            {"turn-of-time", "the cube's turn by the third way, whole turns taken off", "deg"}},
               .draw = draw,
               .readOut = readOut,
               .start = start,
               .step = step,
               .values = values,
           });

}  // namespace
}  // namespace mv::frame_rate
