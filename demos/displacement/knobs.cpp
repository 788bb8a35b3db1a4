// The settings of displacement: rows, presets, controls and declaration.
#include "displacement.h"
#include "mv/demo/lesson.h"
#include "mv/gl/beyond_es.h"

namespace mv::displacement {
namespace {

bool hasLevels(const Settings& s) { return s.method != Method::prepared; }
bool hasOneLevel(const Settings& s) { return !isByDistance(s); }
bool isWall(const Settings& s) { return s.body == ReliefBody::wall; }
bool isOrange(const Settings& s) { return s.body == ReliefBody::orange; }

std::vector<Row<Settings>> panelRows() {
    return {
        word("body", &Settings::body, {{"wall", "bricks, along a street"}, {"orange", "a sphere with pores"}}, "what"),
        word("method", &Settings::method,
             {{"tessellated", "the tessellator makes vertices, its shader moves them by the height map"},
              {"prepared", "a mesh that the processor has cut and moved"},
              {"bumped", "tessellated and lit as if moved, but not moved"}},
             "who moves the vertices"),
        word("levels", &Settings::levels,
             {{"fixed", "one for all"}, {"distance", "each edge its own, by its distance from the eye"}},
             "how finely patches are cut")
            .when(hasLevels, "the prepared mesh has one level"),
        whole("level", &Settings::level, {1, 64}, "pieces of each edge, where that is fixed")
            .when(hasOneLevel, "the level comes from the distance"),
        number("fineness", &Settings::fineness, {2, 512, Scale::logarithmic},
               "pieces of an edge as long as it is far away")
            .when(isByDistance, "the level is fixed"),
        toggle("agree", &Settings::agree, "an edge's level comes from the edge, so that both its patches have the same")
            .when(isByDistance, "all patches have one level"),
        toggle("cull", &Settings::cull, "patches out of view get level 0, which leaves them out")
            .when(hasLevels, "the prepared mesh is drawn as a whole"),
        number("depth", &Settings::depth, {0, 0.25}, "of the relief; a brick is 1 long, the orange's radius is 1",
               "units"),
        oneOf("map-size", &Settings::mapSize, {32, 64, 128, 256, 512}, "rows of texels of the height map"),
        number("distance", &Settings::distance, {0.3, 10, Scale::logarithmic}, "of the eye from the smooth surface",
               "units"),
        number("angle", &Settings::angle, {0, 85}, "between the line of sight and the wall's normal", "deg")
            .when(isWall, "only the wall is seen at one angle"),
        toggle("wireframe", &Settings::wireframe, "edges of the triangles"),
        word("paint", &Settings::paint, {{"surface"}, {"levels", "of patches"}}, "what colours show"),
        number("lamp-turn", &Settings::lampTurn, {-89, 89},
               "the lamp's direction, to the right of the surface's normal", "deg"),
        number("lamp-height", &Settings::lampHeight, {-89, 89}, "and above it", "deg"),
        angle("spin-x", &Settings::spinX, "turn about the x axis").when(isOrange, "only the orange turns"),
        angle("spin-y", &Settings::spinY, "turn about the y axis").when(isOrange, "only the orange turns")};
}

constexpr Declaration about{
    .name = "displacement",
    .sentence = "A brick wall and an orange whose vertices are really moved, cut as finely as they are near.",
    .lookFor = "The upper edge of the wall has notches: bricks that pretend leave it straight.",
    .chapter = "Surfaces, mirrors and stages",
    .number = 21,
    .width = 960,
    .height = 600,
    .background = vec4(0.93, 0.94, 0.96, 1),
    .needs = {.depth = true,
              .beyondEs = {{"tessellation", "the prepared mesh is drawn"},
                           {"geometry shaders", "no edges of triangles are drawn"},
                           {"counting queries", "triangles are not counted"},
                           {"float targets", "holes are not counted"},
                           {"float filtering", "the height map has 16 bits a texel"}}},
};

// Draw the prepared mesh without a tessellator, and no edges without geometry shaders.
Settings fallback(Settings s) {
    if (s.method != Method::prepared) s.hasTessellator = has(beyond_es::tessellation);
    if (s.wireframe) s.wireframe = has(beyond_es::geometryShaders);
    return s;
}

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"street", "Bricks hide mortar, and the upper edge is notched: the vertices are really moved."},
        {"by-distance", "Near triangles are small, far ones large.", {.fineness = 24, .wireframe = true}},
        {"level-colours",
         "An edge between two patches has one level, and each patch that of its finest edge.",
         {.fineness = 24, .wireframe = true, .paint = Paint::levels}},
        {"orange", "The outline has pores, which no normal map can give it.", {.body = ReliefBody::orange}},
        {"pretends",
         "Lit as before, but not moved: the outline is a circle.",
         {.body = ReliefBody::orange, .method = Method::bumped}},
        {"cracks",
         "Each patch has a level of its own, and the background is seen between them.",
         {.fineness = 16, .agree = false, .depth = 0.15, .distance = 0.6, .angle = 50}},
    };
}

std::optional<vec2> placeOfLamp(const Settings& s, const FrameInfo& frame) {
    return lampDial(frame).at(towardsLamp(s));
}

const bool added = addLesson(
    about, Lesson<Settings, Gpu>{
               .rows = panelRows(),
               .presets = presets(),
               .controls = {drag("spin-y", 0.5, "spin-x", 0.5), wheel("distance", -0.1),
                            keys(Key::left, Key::right, "angle", 5), keys(Key::down, Key::up, "fineness", 0.25)},
               .handles = {{"lamp", {"lamp-turn", "lamp-height"}, placeOfLamp}},
               .readouts = {{"triangles", "that reach the rasterizer, by a query"},
                            {"patches", "that are cut"},
                            {"left-out", "patches that are not, since nothing is seen of them"}},
               .draw = draw,
               .measure = drawCoverage,
               .figure = drawFigure,
               .readOut = readOut,
               .fallback = fallback,
               .scene = sceneOf,
           });

}  // namespace
}  // namespace mv::displacement
