// The settings of cube-persp: rows, presets, controls and declaration.
#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <optional>

#include "cube-persp.h"
#include "mv/demo/lesson.h"

namespace mv::cube_persp {
namespace {

// Whether all corners of the pyramid are inside the cube: then the pyramid shows none of the faces.
bool seesNoFace(const Settings& s) {
    const auto corners = viewVolumeCorners(clipFromView(s) * viewFromModel(s));
    return std::all_of(corners.begin(), corners.end(), [](const vec3& corner) {
        return std::max({std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)}) < 0.5;
    });
}

}  // namespace

void check(const Settings& s) {
    if (s.near >= s.far) throw Error("--near", "must be less than --far " + numberText(s.far), numberText(s.near));
    if (seesNoFace(s))
        throw Error("--near", "must leave a face of the cube in view, between it and --far " + numberText(s.far),
                    numberText(s.near));
}

namespace {

constexpr Declaration about{
    .name = "cube-persp",
    .sentence = "A perspective: a pyramid of view cut off at near and far, and the matrix that makes it a cube.",
    .lookFor =
        "Far edges are shorter than near ones. The field of view makes both smaller alike; near and far cut the "
        "cube open.",
    .chapter = "Viewing and projection",
    .number = 3,
    .width = 512,
    .height = 512,
    .background = vec4(1),
    .needs = {.depth = true},
};

// Where the middle of the near or far plane is in the figure: the handle.
std::optional<vec2> placeOf(const Settings& s, const FrameInfo& frame, double z) {
    if (!s.volume) return {};
    const ViewFigure figure = figureOf(s);
    const Pane pane = volumePane(frame);
    return pictureFromPane(pane, outsideFromView(figure, pane) * glm::inverse(figure.clipFromView), vec3(0, 0, z));
}

const Lesson<Settings, Gpu> lesson{
    .rows =
        {
            number("near", &Settings::near, {0.01, 2.4, Scale::logarithmic},
                   "where the pyramid of view begins, in front of the eye"),
            number("far", &Settings::far, {1.6, 5}, "where it ends"),
            number("fov", &Settings::fov, {10, 120}, "the field of view upwards, fovy: the whole angle", "deg"),
            number("aspect", &Settings::aspect, {0.5, 2}, "how many times as wide as high the pyramid is"),
            angle("spin-x", &Settings::spinX, "turn about the x axis"),
            angle("spin-y", &Settings::spinY, "turn about the y axis"),
            number("shift", &Settings::shift, {-1, 1},
                   "how far the window on the near plane is moved to the right, in its half widths"),
            toggle("volume", &Settings::volume, "show the pyramid of view from outside, and the cube that it becomes"),
        },
    .presets =
        {
            {"turned", "Far edges are shorter than near ones, and the upright ones draw together."},
            {"original",
             "The page's first picture: straight on one sees the red face alone.",
             {.spinX = 0, .spinY = 0, .volume = false}},
            {"cut-open",
             "The near plane cuts off a corner of the cube; through the hole one sees its far faces from within.",
             {.near = 1.5}},
            {"inside",
             "Without its front face: the back face is drawn smaller than the opening, by the ratio of their "
             "distances.",
             {.near = 1.6, .spinX = 0, .spinY = 0}},
            {"wide-angle",
             "A wide field of view makes all of it smaller and bends nothing: the shape is as before.",
             {.fov = 120}},
            {"aspect-2",
             "A pyramid twice as wide in a square window: the cube is half as wide, and fovx is 103.7 degrees, not "
             "130.",
             {.aspect = 2},
             {{"fovx", 103.65, 103.75}}},
        },
    .controls = {drag("spin-y", 1, "spin-x", 1)},
    .handles = {{"near plane",
                 {"near"},
                 [](const Settings& s, const FrameInfo& frame) { return placeOf(s, frame, -1); }},
                {"far plane", {"far"}, [](const Settings& s, const FrameInfo& frame) { return placeOf(s, frame, 1); }}},
    .readouts = {{"left", "the window on the near plane, as frustum is told"},
                 {"right", "the window on the near plane"},
                 {"bottom", "the window on the near plane"},
                 {"top", "the window on the near plane"},
                 {"fovx", "the field of view across: it follows from fov and aspect", "deg"},
                 {"difference", "largest difference between perspective's matrix and frustum's"},
                 {"depth-step", "the smallest step in depth at the cube's middle that 24 bits tell apart"}},
    .draw = draw,
    .figure = drawFigure,
    .readOut = readOut,
    .check = check,
};

const bool added = addLesson(about, lesson);

}  // namespace
}  // namespace mv::cube_persp
