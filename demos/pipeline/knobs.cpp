// The settings of pipeline: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "pipeline.h"

namespace mv::pipeline {
namespace {

constexpr Declaration about{
    .name = "pipeline",
    .sentence = "One vertex of a cube through model, world, camera, clip and device space to its pixel, in numbers.",
    .lookFor = "Follow one number from product to product; then move the eye past the vertex and watch w.",
    .chapter = "Viewing and projection",
    .number = 24,
    .width = 1160,
    .height = 560,
    .background = vec4(1),
    .needs = {.depth = true},
    .waste = {{"no-sample", "draw of 'corners'", "corners that are clipped are the lesson"},
              {"outside-view", "draw of 'cube'", "what is clipped is the lesson"}},
};

std::vector<Row<Settings>> panelRows() {
    return {
        number("distance", &Settings::distance, {-3, 8},
               "from the cube's middle back to the eye; below 0 the eye is past it"),
        whole("vertex", &Settings::vertex, {0, 7}, "which corner: bits 0, 1, 2 choose the high end of x, y, z"),
        angle("spin-x", &Settings::spinX, "turn about the x axis"),
        angle("spin-y", &Settings::spinY, "turn about the y axis"),
        number("near", &Settings::near, {0.1, 2}, "where the view begins"),
        number("far", &Settings::far, {5, 100}, "where it ends"),
        number("offset", &Settings::offset, {1, 1e8, Scale::logarithmic, true},
               "how far along x cube and eye are from the origin of the world"),
        word("products", &Settings::products,
             {{"shader", "each vertex by three matrices"},
              {"single", "by one, multiplied in float"},
              {"once", "by one, multiplied in double and rounded once"}},
             "how a vertex comes to clip space"),
        word("matrices", &Settings::matrices,
             {{"right"},
              {"slide-model", "the position in the last row"},
              {"slide-projection", "for an eye that looks along +z"}},
             "the right ones, or one of them as on a slide"),
    };
}

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"one-vertex", "Follow one number down from step to step; the last column is what float costs."},
        {"behind",
         "The marked corner is behind the eye, so w is negative: divided all the same, it falls on the red cross.",
         {.distance = 0.2}},
        {"far-away",
         "Ten million from the origin floats are 1 apart, and three matrices in float tear the cube.",
         {.offset = 1e7}},
        {"once",
         "As far away, with one matrix multiplied in double: the cube is whole.",
         {.offset = 1e7, .products = Products::once}},
        {"slide-model",
         "The position in the last row is right for row vectors: on columns it distorts.",
         {.matrices = Matrices::slideModel}},
        {"slide-projection",
         "A projection for an eye that looks along +z: all of the cube has w below 0 and is clipped.",
         {.matrices = Matrices::slideProjection}},
    };
}

const bool added = addLesson(
    about, Lesson<Settings, Gpu>{
               .rows = panelRows(),
               .presets = presets(),
               .controls = {drag("spin-y", 1, "spin-x", 1), wheel("distance", 0.1),
                            keys(Key::left, Key::right, "vertex", 1), keys(Key::up, Key::down, "distance", 0.1)},
               .readouts = {{"w", "of the vertex in clip space: how far it is in front of the eye"},
                            {"pixel-x", "where it falls in the view, from the left", "px"},
                            {"pixel-y", "where it falls in the view, from below", "px"},
                            {"depth", "what the depth buffer gets"},
                            {"float-error", "how far off it falls by the roundings to float", "px"},
                            {"gpu-off",
                             "largest difference of transform feedback from the products shown, in 2^-24 sum |m v|"},
                            {"fused-differ", "numbers in the products that fused multiply-adds would make others"},
                            {"once-differ", "numbers in them that sums in double, rounded once, would make others"},
                            {"back-off", "how far from the vertex unProject comes out, by its pixel and its depth"},
                            {"depth-step", "what a step of a depth of 24 bits is there, back in the cube's space"},
                            {"ray-miss", "by how much the ray through that pixel passes the vertex by"}},
               .draw = draw,
               .figure = drawFigure,
               .readOut = readOut,
               .values = values,
           });

}  // namespace
}  // namespace mv::pipeline
