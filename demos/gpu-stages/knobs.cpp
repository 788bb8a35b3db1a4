// The settings of gpu-stages: rows, presets, controls and readouts.
#include "gpu-stages.h"
#include "mv/demo/lesson.h"
#include "mv/gl/beyond_es.h"

namespace mv::gpu_stages {
namespace {

constexpr WordList geometryWords{{"off", "there is no such stage"},
                                 {"pass", "each triangle as it came"},
                                 {"wireframe", "each triangle, with the distances from its edges"},
                                 {"shapes", "of each point a hexagon"},
                                 {"normals", "of each triangle a line, beside the patch"},
                                 {"explode", "each triangle moved along its normal"}};

}  // namespace

const char* nameOf(Geometry stage) { return wordOf(geometryWords, stage); }

// Leave out the stages, the counts and the lines that the context does not have.
Settings fallback(Settings s) {
    switch (s.show) {
        case Show::stages:
            if (s.stages.tessellation) s.stages.tessellation = has(beyond_es::tessellation);
            if (geometryStage(s.stages) != Geometry::off && !has(beyond_es::geometryShaders))
                s.stages.geometry = Geometry::off;
            s.counts = has(beyond_es::countingQueries);
            break;
        case Show::primitives:
            s.counts = has(beyond_es::countingQueries);
            break;
        case Show::meshes:
            s.hasWires = has(beyond_es::geometryShaders);
            break;
        case Show::compute:
            s.computes = has(beyond_es::computeShaders);
            break;
    }
    return s;
}

namespace {

template <Show... shows>
bool is(const Settings& s) {
    return ((s.show == shows) || ...);
}
bool isTessellating(const Stages& s) { return s.tessellation; }
bool hasOwnEdges(const Stages& s) { return s.ownEdges; }
bool cutsNoLines(const Stages& s) { return !s.tessellation || s.domain != Domain::isolines; }
bool hasWires(const Stages& s) { return s.geometry == Geometry::wireframe && cutsNoLines(s); }
bool movesSomething(const Stages& s) { return hasAmount(s.geometry) && cutsNoLines(s); }
bool hasFragments(const Stages& s) { return s.fragments; }
bool isSolid(const Settings& s) { return s.show != Show::stages || s.stages.fragments; }

std::vector<Row<Settings>> panelRows() {
    const Literal notTessellated = "nothing is tessellated", notDrawn = "nothing is drawn",
                  flat = "the picture is flat";
    return together(
        word("show", &Settings::show,
             {{"stages", "a patch on its way through them"},
              {"primitives", "the ten types that vertices are joined by"},
              {"meshes", "which bodies can be cut regularly"},
              {"compute", "one picture by two kinds of shader"}},
             "what is shown"),
        part(
            &Settings::stages,
            {toggle("tessellation", &Stages::tessellation, "its two shaders, and the primitive generator between them"),
             whole("inner", &Stages::inner, {1, 64}, "the level of the patch's inside")
                 .when(isTessellating, notTessellated),
             toggle("own-edges", &Stages::ownEdges,
                    "its four edges have a level of their own, and not that of the inside")
                 .when(isTessellating, notTessellated),
             whole("outer", &Stages::outer, {1, 64}, "the edges' own level")
                 .when(isTessellating, notTessellated)
                 .when(hasOwnEdges, "the edges have the level of the inside"),
             word("geometry", &Stages::geometry, geometryWords, "what the geometry shader makes")
                 .when(cutsNoLines, "no geometry shader here takes lines"),
             toggle("hidden", &Stages::hidden, "lines of the wireframe that are behind faces are drawn, too, but paler")
                 .when(hasWires, "no wireframe is shown")
                 .when(hasFragments, notDrawn),
             number("amount", &Stages::amount, {0.05, 1},
                    "how far it moves, how long the lines are, how large the hexagons")
                 .when(movesSomething, "the geometry stage moves nothing")
                 .when(hasFragments, notDrawn),
             number("bend", &Stages::bend, {-0.3, 0.3},
                    "by how much the vertex shader bends the sheet; 0 leaves it as it is")
                 .when(hasFragments, notDrawn),
             toggle("fragments", &Stages::fragments, "rasterization, and the stages after it"),
             oneOf("direct3d", &Stages::direct3d, {9, 10, 11}, "whose names stand beside those of OpenGL")},
            is<Show::stages>, "no patch is shown"),
        whole("vertices", &Settings::vertices, {4, 8}, "vertices of each primitive type")
            .when(is<Show::primitives>, "no primitive types are shown"),
        whole("cells", &Settings::cells, {3, 32}, "cells along and around each body")
            .when(is<Show::meshes>, "no bodies are shown"),
        angle("spin-x", &Settings::spinX, "turn about the x axis")
            .when(isSolid, notDrawn)
            .when(is<Show::stages, Show::meshes>, flat),
        angle("spin-y", &Settings::spinY, "turn about the y axis")
            .when(isSolid, notDrawn)
            .when(is<Show::stages, Show::meshes>, flat),
        part(&Settings::stages,
             {word("domain", &Stages::domain,
                   {{"quads", "a square"}, {"triangles", "a triangle: half of the sheet"}, {"isolines", "lines"}},
                   "what the tessellator cuts")
                  .when(isTessellating, notTessellated)},
             is<Show::stages>, "no patch is shown"),
        word("kernel", &Settings::kernel,
             {{"rings", "the picture that the fragment shader draws"},
              {"caustics", "light through these rings, as through water; each ray adds 1 where it lands"}},
             "what the compute shader stores")
            .when(is<Show::compute>, "nothing is computed"));
}

constexpr Declaration about{
    .name = "gpu-stages",
    .sentence = "One patch through all stages of the pipeline, each on or off, with what goes in and what comes out.",
    .lookFor = "Sixteen vertices become a hundred and twenty-eight triangles, and no vertex buffer ever held them.",
    .chapter = "Surfaces, mirrors and stages",
    .number = 32,
    .width = 960,
    .height = 560,
    .background = vec4(0.95, 0.95, 0.96, 1),
    .needs = {.depth = true,
              .beyondEs = {{"geometry shaders", "that stage is off"},
                           {"tessellation", "the net of the control points is drawn"},
                           {"compute shaders", "only the fragment shader draws"},
                           {"counting queries", "nothing is counted"},
                           {"indexed feedback", "nothing is counted"},
                           {"expanded feedback", "nothing is counted"},
                           {"float targets", "the error is not measured"}}},
};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"wireframe",
         "All stages: 16 control points go in, 128 triangles come out; pale lines are behind faces.",
         {},
         {{"out-of-geometry", 128, 128}}},
        {"hexagons",
         "Of each point of the tessellator a hexagon.",
         {.stages = {.geometry = Geometry::shapes}, .spinX = 45}},
        {"exploded",
         "Geometry shaders know a triangle's normal.",
         {.stages = {.geometry = Geometry::explode}, .spinX = 45}},
        {"primitives", "Ten ways to join vertices; the red three left the core.", {.show = Show::primitives}},
        {"meshes", "A torus is regular everywhere; no sphere is.", {.show = Show::meshes, .spinX = 40}},
        {"compute", "The same rings by a fragment and by a compute shader.", {.show = Show::compute}},
    };
}

const bool added = addLesson(
    about, Lesson<Settings, Gpu>{
               .rows = panelRows(),
               .presets = presets(),
               .controls = {drag("spin-y", 1, "spin-x", 1), wheel("inner", 1), keys(Key::down, Key::up, "bend", 0.05)},
               .readouts = {{"into-geometry", "primitives that reach the geometry stage's place, by a query"},
                            {"out-of-geometry", "primitives that leave it, by a query"},
                            {"written", "of these, those that transform feedback wrote, by a query"},
                            {"found", "of these, those whose corners are in its buffer"},
                            {"fragments-passed", "fragments that reached the picture"},
                            {"primitives", "primitives of the seven types of the core, by queries"},
                            {"irregular", "inner vertices of the four bodies where not six edges meet"}},
               .draw = draw,
               .figure = drawFigure,
               .readOut = readOut,
               .fallback = fallback,
               .scene = sceneOf,
           });

}  // namespace
}  // namespace mv::gpu_stages
