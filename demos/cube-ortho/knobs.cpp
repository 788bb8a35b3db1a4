// The settings of cube-ortho: rows, presets, controls and declaration.
#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <optional>

#include "cube-ortho.h"
#include "mv/demo/lesson.h"
#include "mv/math/projection.h"

namespace mv::cube_ortho {
namespace {

// Whether all corners of the box are inside the cube: then the box shows none of the faces. A face seen edge on has no
// area and does not count: the cube might as well go on without end there.
bool seesNoFace(const Settings& s) {
    const mat4 m = viewFromModel(s);
    const auto corners = viewVolumeCorners(clipFromView(s) * m);
    return std::all_of(corners.begin(), corners.end(), [&](const vec3& corner) {
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis) {
            const bool edgeOn = std::abs(m[axis][2]) < 1e-9;  // the axis is perpendicular to the line of sight
            inside &= edgeOn || std::abs(corner[axis]) < 0.5;
        }
        return inside;
    });
}

}  // namespace

void check(const Settings& s) {
    if (seesNoFace(s))
        throw Error("--depth", "must reach a face of the cube that is not seen edge on", numberText(s.depth));
}

namespace {

constexpr Declaration about{
    .name = "cube-ortho",
    .sentence = "A parallel projection: a box of view, and the matrix that makes it the cube from -1 to 1.",
    .lookFor = "Edges that are parallel stay parallel, and no distance makes the cube smaller; only the box does.",
    .chapter = "Viewing and projection",
    .number = 2,
    .width = 512,
    .height = 512,
    .background = vec4(1),
    .needs = {.depth = true},
};

// Where a place of the cube from -1 to 1 is in the figure: the handle.
std::optional<vec2> placeOf(const Settings& s, const FrameInfo& frame, const vec3& at) {
    if (!s.volume) return {};
    const ViewFigure figure = figureOf(s);
    const Pane pane = volumePane(frame);
    return pictureFromPane(pane, outsideFromView(figure, pane) * glm::inverse(figure.clipFromView), at);
}

const Lesson<Settings, Gpu> lesson{
    .rows =
        {
            number("depth", &Settings::depth, {0.05, 3, Scale::logarithmic},
                   "how deep the box of view is, with the cube in its middle"),
            number("width", &Settings::width, {0.05, 10, Scale::logarithmic}, "how wide the box of view is"),
            number("height", &Settings::height, {0.05, 10, Scale::logarithmic}, "how high the box of view is"),
            number("distance", &Settings::distance, {0, 5}, "how far in front of the eye the cube and the box are"),
            toggle("mirror-depth", &Settings::mirrorDepth, "exchange near and far"),
            angle("spin-x", &Settings::spinX, "turn about the x axis"),
            angle("spin-y", &Settings::spinY, "turn about the y axis"),
            toggle("volume", &Settings::volume, "show the box of view from outside, and the cube that it becomes"),
        },
    .presets =
        {
            {"turned",
             "Edges that are parallel on the cube are parallel in the picture, and none is shorter for being farther "
             "away."},
            {"original",
             "The page's first picture: straight on one sees the red face alone.",
             {.spinX = 0, .spinY = 0, .volume = false}},
            {"hexagon",
             "A thin box cuts the cube open along its diagonal: a regular hexagon, one side from each face.",
             {.depth = 0.05, .spinX = 35.264, .spinY = 45}},
            {"wide-box", "A box twice as wide fills the same window, so the cube is half as wide.", {.width = 4}},
            {"mirrored",
             "Near and far exchanged make the identity of the canonical box, and the far faces hide the near ones.",
             {.mirrorDepth = true}},
        },
    .controls = {drag("spin-y", 1, "spin-x", 1)},
    .handles = {{"far plane",
                 {"depth"},
                 [](const Settings& s, const FrameInfo& frame) {
                     return placeOf(s, frame, vec3(0, 0, s.mirrorDepth ? -1 : 1));
                 }},
                {"right side",
                 {"width"},
                 [](const Settings& s, const FrameInfo& frame) { return placeOf(s, frame, vec3(1, 0, 0)); }},
                {"upper side",
                 {"height"},
                 [](const Settings& s, const FrameInfo& frame) { return placeOf(s, frame, vec3(0, 1, 0)); }}},
    .readouts = {{"near", "near, as ortho is told; negative is behind the eye"},
                 {"far", "far, as ortho is told"},
                 {"pixels-per-unit", "how many pixels a length of 1 across gets"}},
    .draw = draw,
    .figure = drawFigure,
    .readOut = readOut,
    .check = check,
};

const bool added = addLesson(about, lesson);

}  // namespace
}  // namespace mv::cube_ortho
