// The settings of texture-map: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "perspective_quad.h"
#include "texture-map.h"

namespace mv::texture_map {
namespace {

constexpr WordList shapeWords{
    {"quad", "a square in perspective"}, {"cylinder"}, {"sphere"}, {"triangle", "by its matrix"}};
constexpr WordList methodWords{{"affine", "u and v interpolated along the picture (noperspective)"},
                               {"correct", "u and v interpolated along the surface, by the driver"},
                               {"by-hand", "u/w, v/w and 1/w interpolated along the picture, and divided"},
                               {"undivided", "the same without the division, as on the slide"},
                               {"forward", "from the texture to the picture: each texel is drawn as a point"}};
constexpr WordList mapWords{{"edges", "from the way along the plane since a corner"},
                            {"matrix", "by the inverse of the 3 x 3 matrix of the lecture"}};

}  // namespace

const char* nameOf(Shape shape) { return wordOf(shapeWords, shape); }
const char* nameOf(Method method) { return wordOf(methodWords, method); }
const char* nameOf(Map map) { return wordOf(mapWords, map); }

namespace {

template <Shape... shapes>
bool is(const Settings& s) {
    return ((s.shape == shapes) || ...);
}
constexpr auto isRound = is<Shape::cylinder, Shape::sphere>;
bool isNoTriangle(const Settings& s) { return !isTriangle(s); }
bool hasCells(const Settings& s) { return !isForward(s); }
bool hasFaces(const Settings& s) { return !isCircle(s); }
bool goesBeyond(const Settings& s) { return s.reach > 1; }
bool hasTexels(const Settings& s) { return !s.picture.isSet() || isForward(s); }

std::vector<Row<Settings>> panelRows() {
    return together(
        word("shape", &Settings::shape, shapeWords, "what has the texture"),
        word("method", within(&Settings::surface, &Surface::method), methodWords,
             "how a pixel finds its texture coordinates")
            .when(isNoTriangle, "a triangle's texture coordinates are found from its points"),
        whole("divisions", within(&Settings::surface, &Surface::divisions), {1, 64},
              "cells along a side of the square, or a quarter of a turn")
            .when(isNoTriangle, "a triangle is a single one")
            .when(hasCells, "points have no faces to divide")
            .when(hasFaces, "the lecture's cylinder has no faces"),
        number("ratio", within(&Settings::surface, &Surface::ratio), {1, 20},
               "W: the w of the far edge, by that of the near one")
            .when(is<Shape::quad>, "only the square has it"),
        oneOf("texels", &Settings::texels, {16, 32, 64, 128, 256, 512}, "texels along a side of the texture")
            .when(hasFaces, "the lecture's cylinder has no faces")
            .when(hasTexels, "the picture has its own"),
        word("formula", within(&Settings::surface, &Surface::formula),
             {{"corrected", "(cos u, v, sin u)"}, {"lecture", "(cos u, h, sin u)"}}, "of the cylinder")
            .when(is<Shape::cylinder>, "it is the cylinder's"),
        word("seam", within(&Settings::surface, &Surface::seam),
             {{"doubled", "corners with u = 1 beside those with u = 0"}, {"shared", "only those with u = 0"}},
             "the corners where the texture's left and right edge meet")
            .when(isRound, "the shape has no seam")
            .when(hasCells, "points have no seam")
            .when(hasFaces, "the lecture's cylinder has no faces"),
        part(&Settings::triangle,
             {word("map", &Triangle::map, mapWords, "from a point of the triangle to its texture coordinates"),
              number("distance", &Triangle::distance, {1e-8, 1, Scale::logarithmic, true},
                     "of the triangle's plane from the origin")},
             isTriangle, "it is the triangle's"),
        angle("turn", within(&Settings::surface, &Surface::turn), "of the cylinder or the sphere about its axis")
            .when(isRound, "the shape does not turn"),
        file("picture", &Settings::picture, "assets/postcard.png",
             "your own on the surface, in at most 1024 x 1024 texels"),
        number("reach", &Settings::reach, {1, 8}, "of u and v: so many textures, with one in the middle")
            .when(hasFaces, "the lecture's cylinder has no faces"),
        word("wrap", &Settings::wrap,
             {{"clamp", "the texels at the edge go on (GL_CLAMP_TO_EDGE)"},
              {"repeat", "the texture begins anew (GL_REPEAT)"},
              {"mirror", "every other one is turned about (GL_MIRRORED_REPEAT)"}},
             "what a texture shows beyond 0..1")
            .when(goesBeyond, "u and v stay within 0..1"));
}

constexpr Declaration about{
    .name = "texture-map",
    .sentence =
        "Which point of a texture a pixel shows: on a square in perspective, a cylinder, a sphere and a triangle.",
    .lookFor =
        "The squares of the texture miss the black lines where they belong: the coordinates are interpolated along the "
        "picture.",
    .chapter = "Light, colour and texture",
    .number = 28,
    .width = 960,
    .height = 540,
    .background = vec4(0.76, 0.81, 0.87, 1),
    .needs = {.depth = true, .beyondEs = {{"float targets", "the slip is not measured, and holes are not counted"}}},
};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"affine", "Along the picture: the texture breaks at each diagonal."},
        {"correct", "Along the surface: each square fills its place.", {.surface = {.method = Method::correct}}},
        {"not-divided",
         "The slide's u/w without the division by 1/w: far away there is hardly any texture left.",
         {.surface = {.method = Method::undivided}}},
        {"holes",
         "Each texel drawn as a point: near the eye there are gaps.",
         {.surface = {.method = Method::forward}, .texels = 256}},
        {"seam",
         "Shared corners: one strip shows the whole texture backwards.",
         {.shape = Shape::sphere, .surface = {.method = Method::correct, .divisions = 4, .seam = Seam::shared}}},
        {"near-the-origin",
         "The triangle's plane passes the origin at a millionth: the inverse of P has lost the floats' digits.",
         {.shape = Shape::triangle, .triangle = {.map = Map::matrix, .distance = 1e-06}}},
    };
}

void check(const Settings& s) {
    if (isTriangle(s) && s.triangle.map == Map::matrix && s.triangle.distance == 0)
        throw Error("--distance", "must not be 0 with --map matrix: P is singular where the plane holds the origin");
}

std::optional<vec2> placeOfFarEdge(const Settings& s, const FrameInfo& frame) {
    if (s.shape != Shape::quad) return {};
    return projected(pixelFromQuad(s.surface.ratio, leftPane(frame)), {1, 1});
}

const bool added = addLesson(
    about,
    Lesson<Settings, Gpu>{
        .rows = panelRows(),
        .presets = presets(),
        .controls = {keys(Key::down, Key::up, "divisions", 1), keys(Key::left, Key::right, "turn", 5)},
        .handles = {{"far edge", {"ratio"}, placeOfFarEdge}},
        .readouts = {{"slip", "how far from its place the affine method shows a point of the texture, at most", "px"},
                     {"determinant", "of the lecture's matrix P"},
                     {"off", "texture coordinates of the corners in floats, by the chosen map: the largest error"}},
        .draw = draw,
        .figure = drawFigure,
        .readOut = readOut,
        .check = check,
        .scene = sceneOf,
    });

}  // namespace
}  // namespace mv::texture_map
