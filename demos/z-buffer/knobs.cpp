// The settings of z-buffer: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "mv/gl/beyond_es.h"
#include "z-buffer.h"

namespace mv::z_buffer {
namespace {

constexpr Declaration about{
    .name = "z-buffer",
    .sentence = "What hides what: the painter's order, and a depth for each pixel in several formats.",
    .lookFor = "Switch the depth test off: no order of the three bars is right, until each of them is cut in two.",
    .chapter = "Stereo and hidden surfaces",
    .number = 8,
    .width = 600,
    .height = 600,
    .needs = {.beyondEs = {{"clip control", "clip space has depths within -1..1, reversed as with --mapping flipped"}}},
    .waste = {{"repeated-pass", "pass into 'scene'", "what the depth test costs in every frame is the lesson"}},
};

// Keep the depths within -1..1 where the context has no other range.
Settings fallback(Settings s) {
    if (!hasZeroToOne(s) || has(beyond_es::clipControl)) return s;
    s.mapping = s.mapping == Mapping::reversed ? Mapping::flipped : Mapping::standard;
    return s;
}

bool turns(const Settings& s) { return s.scene != Which::road; }
bool isSeparated(const Settings& s) { return s.scene != Which::cycle; }
bool keepsDepth(const Settings& s) { return s.depthTest; }

bool showsBars(const Settings& s) { return s.shown == Shown::colors && s.scene == Which::cycle; }

std::vector<Row<Settings>> panelRows() {
    return {
        word("scene", &Settings::scene,
             {{"cycle", "three bars, each over the next one"},
              {"road", "a road on the ground, to the horizon, with a mark on it"},
              {"panes", "three panes, one close behind the other"}},
             "what is drawn: a red, a green and a blue thing"),
        word("order", &Settings::order,
             {{"rgb"}, {"rbg"}, {"grb"}, {"gbr"}, {"brg"}, {"bgr"}, {"sorted", "from far to near by middles"}},
             "the order of drawing, by the letters of the colours"),
        whole("pieces", &Settings::pieces, {1, 8}, "parts that a bar or pane is cut into (the road has its own cells)")
            .when(turns, "the road has its own cells"),
        toggle("depth-test", &Settings::depthTest, "let each pixel keep what is nearest"),
        word("show", &Settings::shown,
             {{"colors"},
              {"depth", "0 black, 1 white"},
              {"curve", "what depth each distance is given, over the colors"}},
             "which buffer"),
        word("format", &Settings::format, {{"d16", "16 bits"}, {"d24", "24 bits"}, {"d32f", "32 bits, floating point"}},
             "of the depth buffer")
            .when(keepsDepth, "without depth test no depth is kept"),
        word("mapping", &Settings::mapping,
             {{"standard", "0 at near, 1 at far"},
              {"infinite", "far at infinity"},
              {"reversed", "1 at near, 0 at far, with glClipControl"},
              {"flipped", "1 at near, 0 at far, as OpenGL has it without glClipControl"},
              {"logarithmic", "written by the fragment shader"},
              {"zero-to-one", "0 at near, 1 at far, with glClipControl, as Direct3D and Vulkan have it"}},
             "from distance to depth"),
        number("near", &Settings::near, {0.01, 2.5, Scale::logarithmic}, "where the view begins"),
        number("far", &Settings::far, {10, 1e6, Scale::logarithmic}, "where it ends"),
        number("separation", &Settings::separation, {1e-7, 0.1, Scale::logarithmic, true},
               "from a road or pane to the next, as a part of the distance")
            .when(isSeparated, "the bars have their own places"),
        number("opacity", &Settings::opacity, {0.2, 1}, "below 1 colours are blended"),
        angle("spin-x", &Settings::spinX, "turn about the x axis").when(turns, "only bars and panes are turned"),
        angle("spin-y", &Settings::spinY, "turn about the y axis").when(turns, "only bars and panes are turned"),
        toggle("words", &Settings::words, "number the bars in the order in which they are drawn, and say what decides")
            .when(showsBars, "only the colours of the bars have words"),
    };
}

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"cycle", "Each bar lies over one neighbour and under the other, in whatever order they are drawn."},
        {"painter",
         "Without the depth test what is drawn later covers what was drawn before: all orders are wrong somewhere.",
         {.depthTest = false}},
        {"greys",
         "The depth buffer itself, darker where it is nearer.",
         {.shown = Shown::depth, .near = 2.5, .far = 10}},
        {"road",
         "The mark lies on the road and the road on the ground; far away 24 bits cannot tell them apart.",
         {.scene = Which::road, .separation = 4e-06}},
        {"road-reversed",
         "The same road in a float buffer with reversed depth: its steps are as fine as the distances.",
         {.scene = Which::road, .format = DepthFormat::d32f, .mapping = Mapping::reversed, .separation = 4e-06}},
        {"glass",
         "Panes that let light through, drawn from far to near; in another order the one behind is cut off.",
         {.scene = Which::panes, .order = Order::bgr, .separation = 0.01, .opacity = 0.6}},
    };
}

const bool added = addLesson(
    about,
    Lesson<Settings, Gpu>{
        .rows = panelRows(),
        .presets = presets(),
        .controls = {drag("spin-y", 1, "spin-x", 1), keys(Key::left, Key::right, "order", 1),
                     keys(Key::down, Key::up, "depth-test", 1)},
        .readouts = {{"wrong-pixels", "pixels of another colour than rays find there, edges left out", "%"},
                     {"misordered", "pairs of points, separation apart, whose depths do not tell the nearer", "%"}},
        .draw = draw,
        .figure = drawFigure,
        .readOut = readOut,
        .fallback = fallback,
        .values = values,
    });

}  // namespace
}  // namespace mv::z_buffer
