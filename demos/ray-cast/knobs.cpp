// The settings of ray-cast: rows, presets, handle and readouts.
#include <algorithm>

#include "mv/demo/lesson.h"
#include "mv/threads.h"
#include "ray-cast.h"

namespace mv::ray_cast {
namespace {

constexpr WordList formWords{{"printed", "as the slides print it, slips and all"},
                             {"textbook", "the same, mended"},
                             {"stable", "the library's"}};
constexpr WordList precisionWords{{"float"}, {"double"}};

}  // namespace

const char* nameOf(CastForm form) { return wordOf(formWords, form); }
const char* nameOf(Precision precision) { return wordOf(precisionWords, precision); }
bool hasForms(const Settings& s) { return std::ranges::any_of(kindsOf(s), hasTextbookForm); }

namespace {

bool isTeapot(const Settings& s) { return isThere(s, CastKind::teapot); }
bool isFormula(const Settings& s) { return !isTeapot(s); }
bool isPlane(const Settings& s) { return isThere(s, CastKind::plane); }
bool hasGrid(const Settings& s) { return isThere(s, CastKind::surface) && s.form == CastForm::stable; }
bool hasThreads(const Settings&) { return haveThreads(); }

std::vector<Row<Settings>> panelRows() {
    return together(
        word("form", &Settings::form, formWords, "how rays and objects are intersected")
            .when(hasForms, "triangles in a tree, and bodies round an axis, are met by the stable form"),
        word("precision", &Settings::precision, precisionWords, "in which it is computed")
            .when(isFormula, "triangles are met in double"),
        whole("rows", &Settings::rows, {16, 512}, "rows and columns of pixels"),
        word("objects", &Settings::objects,
             {{"all"},
              {"plane"},
              {"sphere"},
              {"box", "by slabs"},
              {"triangle"},
              {"polygon", "a star"},
              {"transformed", "a sphere under a matrix"},
              {"surface", "a flag, by Newton's method"},
              {"teapot", "triangles, in a tree"},
              {"cylinder", "round an axis, with lids"},
              {"cone", "with its base"},
              {"disk", "a plane, and a distance"},
              {"torus", "the first of four roots"}},
             "what there is"),
        oneOf("triangles", &Settings::triangles, {1024, 4096, 16384, 65536, 262144, 1048576},
              "of the teapot, less those that have collapsed to an edge")
            .when(isTeapot, "there is no teapot"),
        word("plane", &Settings::plane,
             {{"implicit", "Ax + By + Cz + D = 0"},
              {"normal", "a point and the normal"},
              {"parametric", "a point and two vectors"}},
             "how the floor is given")
            .when(isPlane, "there is no plane"),
        whole("starts", &Settings::starts, {1, 16}, "cells a side of the grid that Newton's method starts from")
            .when(hasGrid, "Newton's method has no grid here"),
        number("distance", &Settings::distance, {opens, 1e6, Scale::logarithmic},
               "of the eye; the view is as much narrower"),
        number("scale", &Settings::size, {1e-6, 1e6, Scale::logarithmic}, "of all, with the eye's distance"),
        word("picture-by", &Settings::by,
             {{"rays"}, {"raster", "triangles, filled by the processor"}, {"gl", "triangles, by OpenGL"}},
             "who makes the left picture"),
        whole("threads", &Settings::threads, {1, 16}, "that share the picture's rows")
            .when(hasThreads, "a page in a browser has one thread"),
        number("pixel-x", &Settings::pixelX, {0, 1}, "where the chosen pixel is, across"),
        number("pixel-y", &Settings::pixelY, {0, 1}, "where the chosen pixel is, upwards"));
}

constexpr Declaration about{
    .name = "ray-cast",
    .sentence = "A picture made of rays, one for each pixel, and from the side what the ray of one pixel meets.",
    .lookFor =
        "Drag the red pixel: its ray is shown from the side, with all that it meets in order; the nearest gives "
        "the colour.",
    .chapter = "Rays, clipping and pixels",
    .number = 22,
    .width = 960,
    .height = 540,
    .background = sky,
    .needs = {.depth = true, .beyondEs = {{"float targets", "the picture is not compared with GL's"}}},
};

const Settings far{.precision = Precision::single,
                   .rows = 120,
                   .objects = only(CastKind::sphere),
                   .distance = 3000,
                   .pixelX = 0.3,
                   .pixelY = 0.47};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"one-ray-a-pixel", "Pixels large enough to count: each is the colour of the first object on its ray."},
        {"full", "The same with a ray for each pixel of the pane.", {.rows = 480}},
        {"far-in-float", "The textbook's sphere in float, 3000 away: its discriminant has hardly a digit left.",
         with(far, [](Settings& s) { s.form = CastForm::textbook; })},
        {"far-and-stable", "The library's sphere, from as far and in float.", far},
        {"teapot",
         "Triangles: rays ask a tree, a raster fills one after the other.",
         {.rows = 240, .objects = only(CastKind::teapot)}},
        {"one-start",
         "Newton's method from the flag's middle alone: it walks away from parts of it.",
         {.form = CastForm::textbook, .rows = 120, .objects = only(CastKind::surface), .pixelX = 0.6, .pixelY = 0.7}},
    };
}

std::optional<vec2> placeOfPixel(const Settings& s, const FrameInfo& frame) {
    const Pane pane = picturePane(frame);
    return vec2(pane.x, pane.y) + vec2(s.pixelX, s.pixelY) * double(pane.width);
}

const bool added =
    addLesson(about, Lesson<Settings, Gpu>{
                         .rows = panelRows(),
                         .presets = presets(),
                         .handles = {{"pixel", {"pixel-x", "pixel-y"}, placeOfPixel}},
                         .readouts = {{"t", "of the chosen pixel's ray, to the nearest object"},
                                      {"candidates", "objects that the chosen pixel's ray meets"},
                                      {"unlike",
                                       "pixels with another object than by the stable form in double, or a t off by "
                                       "0.05 of the scale",
                                       "px"}},
                         .draw = draw,
                         .measure = drawNumbers,
                         .figure = drawFigure,
                         .readOut = readOut,
                         .scene = sceneOf,
                         .values = values,
                     });

}  // namespace
}  // namespace mv::ray_cast
