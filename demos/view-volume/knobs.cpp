// The settings of view-volume: rows, presets, controls and declaration.
#include <cmath>
#include <glm/matrix.hpp>

#include "mv/demo/lesson.h"
#include "mv/formatted.h"
#include "mv/gl/text.h"
#include "view-volume.h"

namespace mv::view_volume {

void check(const Settings& s) {
    if (s.nearUsed() >= s.far)
        throw Error("--near", "must be less than --far " + numberText(s.far), numberText(s.near));
    try {
        cameraPlanes(s);
    } catch (const Error& error) {
        throw Error("--closer", std::string("must leave the matrix its planes; ") + error.what(),
                    formatted("1e%.0f", std::log10(s.closer)));
    }
}

namespace {

constexpr Declaration about{
    .name = "view-volume",
    .sentence = "A camera seen from outside, with its view volume, and the cube that its projection makes of it.",
    .lookFor = "What is between near and far fills the cube, large before and small behind; orange is cut off.",
    .chapter = "Viewing and projection",
    .number = 5,
    .width = 960,
    .height = 480,
    .background = vec4(0.5, 0.5, 0.5, 1),
    .needs = {.depth = true},
    .waste = {{"no-sample", "draw of 'tree', up to 6 times",
               "a tree that is in view may be hidden, or smaller than a pixel"}},
};

bool culls(const Settings& s) { return s.cull; }

std::vector<Row<Settings>> panelRows() {
    return {
        word("projection", &Settings::projection, {{"perspective"}, {"orthographic"}}, "of the camera"),
        number("near", &Settings::near, {0.5, 25, Scale::logarithmic}, "where it begins, in front of the camera", "m"),
        number("far", &Settings::far, {2, 60}, "where it ends", "m"),
        oneOf("closer", &Settings::closer, {1, 10, 100, 1000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000},
              "by what near is divided"),
        number("pan", &Settings::pan, {-90, 90}, "how far the camera looks to the left", "deg"),
        toggle("cull", &Settings::cull, "leave out each object that is whole outside one plane"),
        word("planes", &Settings::planes,
             {{"parameters", "from the field of view, near and far"},
              {"matrix", "sums of rows of the matrix, in double"},
              {"float-matrix", "the same in float"}},
             "where the six planes come from")
            .when(culls, "nothing is culled by them"),
        word("round", &Settings::round,
             {{"box", "the smallest along the object's axes"}, {"ball", "about the box's middle"}},
             "what is put round each object and compared with the planes")
            .when(culls, "nothing is culled by it"),
        angle("turn", &Settings::turn, "how far we go round, to the right"),
        number("tilt", &Settings::tilt, {-90, 90}, "how far we go up from there", "deg"),
        word("stage", &Settings::stage,
             {{"cube", "all of the projection"},
              {"sides", "its first half: the sides at 45 degrees, depth as it was"},
              {"plane", "the first projection of a lecture: onto z = -near, or z = 0"}},
             "what the right pane shows"),
        toggle("sight", &Settings::sight, "draw nine lines of sight, on either side"),
    };
}

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"garden", "What lies between the blue and the red plane becomes the cube on the right, bent with it."},
        {"near-plane",
         "With near at 0.5 the house is a thin slice at the far side of the cube: near is where depth is lost.",
         {.near = 0.5}},
        {"pan",
         "The camera looks past the house: what is cut off is orange, and what is whole outside was not drawn.",
         {.pan = 25}},
        {"box",
         "The box of a parallel projection becomes the cube without bending.",
         {.projection = Projection::orthographic}},
        {"float-planes",
         "Planes from a float matrix with near a million times closer: plane-error is 0.12, and trees beyond far come "
         "back.",
         {.closer = 1'000'000, .planes = Planes::floatMatrix},
         {{"plane-error", 0.115, 0.125}}},
        {"sight-lines",
         "Lines of sight that meet in the eye become parallel: the eye has gone to infinity.",
         {.sight = true}},
    };
}

// The pixel of the left pane for the middle of a plane across the view.
std::optional<vec2> middleAt(const Settings& s, const FrameInfo& frame, double distance) {
    const Pane pane = panesOf(frame)[0];
    return pictureFromPane(pane, outsideFromWorld(s, pane) * glm::inverse(cameraFromWorld(s)), {0, 0, -distance});
}
std::optional<vec2> middleOfNear(const Settings& s, const FrameInfo& frame) { return middleAt(s, frame, s.nearUsed()); }
std::optional<vec2> middleOfFar(const Settings& s, const FrameInfo& frame) { return middleAt(s, frame, s.far); }

const bool added =
    addLesson(about, Lesson<Settings, Gpu>{
                         .rows = panelRows(),
                         .presets = presets(),
                         .controls = {drag("turn", -0.5, "tilt", 0.5), wheel("far", 1),
                                      keys(Key::down, Key::up, "near", 0.1), keys(Key::right, Key::left, "pan", 5)},
                         .handles = {{"near plane", {"near"}, middleOfNear}, {"far plane", {"far"}, middleOfFar}},
                         .readouts = {{"drawn", "objects drawn"},
                                      {"culled", "objects left out"},
                                      {"clipped", "objects drawn of whose boxes or balls a part is outside"},
                                      {"far-over-near", "far/near, by which the planes of a matrix lose digits"}},
                         .draw = draw,
                         .figure = drawFigure,
                         .readOut = readOut,
                         .check = check,
                         .values = values,
                     });

}  // namespace
}  // namespace mv::view_volume
