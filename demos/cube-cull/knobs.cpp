// The settings of cube-cull: rows, presets, controls and declaration.
#include "cube-cull.h"
#include "mv/demo/lesson.h"

namespace mv::cube_cull {

void check(const Settings& s) {
    if (s.zDist == 0) throw Error("--z-dist", "must not be 0: the eye would stand on the point it looks at");
}

namespace {

constexpr Declaration about{
    .name = "cube-cull",
    .sentence = "Back-face culling: on a closed solid, what faces away is never seen.",
    .lookFor = "Turn the cube with back and with none: the same picture. Then front: you look into the far half.",
    .chapter = "Stereo and hidden surfaces",
    .number = 7,
    .width = 600,
    .height = 600,
    .background = vec4(0.9, 1.0, 1.0, 1.0),
    .needs = {.depth = true, .beyondEs = {{"float targets", "wrong-pixels is not measured"}}},
    .waste = {{"unused-buffer", "depth of 'cube-cull'", "the buffer stays when --depth-test switches the test off"},
              {"no-sample", "draw of 'body'", "that faces are left out, or all of them, is the lesson"}},
};

bool isTeapot(const Settings& s) { return s.body != Body::cube; }
bool oneSideIsCulled(const Settings& s) { return s.cull == Cull::back || s.cull == Cull::front; }

const Lesson<Settings, Gpu> lesson{
    .rows =
        {
            word("body", &Settings::body, {{"cube"}, {"teapot", "with its lid on"}, {"open-teapot", "without its lid"}},
                 "what is drawn"),
            oneOf("divisions", &Settings::divisions, {1, 2, 4, 8, 12, 16, 32, 64},
                  "cells along a side of each of the teapot's patches, two triangles a cell")
                .when(isTeapot, "only the teapot is made of patches"),
            word("cull", &Settings::cull, {{"none"}, {"back"}, {"front"}, {"both"}}, "which faces to discard"),
            word("winding", &Settings::winding, {{"ccw", "counter-clockwise on the screen"}, {"cw", "clockwise"}},
                 "which way round the corners of a front face run")
                .when(oneSideIsCulled, "front and back faces are treated alike"),
            toggle("depth", &Settings::depth, "let near faces hide far ones (depth test)"),
            number("z-dist", &Settings::zDist, {-10, 10}, "where the eye stands on the z axis, looking at the middle"),
            angle("spin-x", &Settings::spinX, "turn about the x axis"),
            angle("spin-y", &Settings::spinY, "turn about the y axis"),
            toggle(
                "apart", &Settings::apart,
                "name the axes, and show the cube's faces moved apart, from another side; the culled ones are dashed"),
        },
    .presets =
        {
            {"turned", "Back faces are gone, and nothing is missing."},
            {"original",
             "The page's first picture: straight on one sees the blue face alone.",
             {.spinX = 0, .spinY = 0, .apart = false}},
            {"front-culled", "Without front faces one looks into the far half of the box.", {.cull = Cull::front}},
            {"hidden-front",
             "No depth test: front faces hide front faces, and the spout, which comes last, is painted over the pot "
             "before it.",
             {.body = Body::teapot, .depth = false, .spinX = 15, .spinY = 60}},
            {"open",
             "An open mesh: without its back faces the pot has no inside, and one looks through its far wall.",
             {.body = Body::openTeapot, .spinX = 35, .spinY = 200}},
            {"eye-inside",
             "From inside no face shows its front: of twelve triangles 2 are culled, 10 are outside of the view, and 0 "
             "survive.",
             {.zDist = 0.3, .spinX = 0, .spinY = 0},
             {{"culled", 2, 2}, {"outside", 10, 10}, {"surviving", 0, 0}}},
        },
    .controls = {drag("spin-y", -1, "spin-x", 1), keys(Key::down, Key::up, "z-dist", 0.2), wheel("z-dist", -0.2)},
    .readouts = {{"facing", "faces of the cube turned towards the eye, of 6"},
                 {"culled", "triangles discarded by culling"},
                 {"outside", "triangles wholly outside the view"},
                 {"surviving", "triangles that go on to the rasterizer"}},
    .draw = draw,
    .measure = drawDistances,
    .figure = drawFigure,
    .readOut = readOut,
    .check = check,
};

const bool added = addLesson(about, lesson);

}  // namespace
}  // namespace mv::cube_cull
