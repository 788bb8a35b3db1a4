// The settings of bump-map: rows, presets, controls and declaration.
#include "bump-map.h"
#include "mv/demo/lesson.h"

namespace mv::bump_map {
namespace {

bool isPretended(const Settings& s) { return s.method != Method::displaced; }
bool hasLayers(const Settings& s) { return s.method == Method::occlusion; }
bool isWall(const Settings& s) { return s.body == ReliefBody::wall; }
bool isOrange(const Settings& s) { return s.body == ReliefBody::orange; }
bool usesFrames(Method method) { return method != Method::smooth && method != Method::displaced; }
bool hasMirroredFrames(const Settings& s) { return isMirrored(s) && usesFrames(s.method); }

std::vector<Row<Settings>> panelRows() {
    return {word("body", &Settings::body, {{"wall", "bricks"}, {"orange", "a sphere with pores"}}, "what is bumped"),
            word("method", &Settings::method,
                 {{"smooth", "no bumps: painted only"},
                  {"height", "normals by differences of the height map"},
                  {"normal", "normals from the normal map"},
                  {"parallax", "and looked up where the height here would be met"},
                  {"occlusion", "and looked up where the line of sight meets the height map"},
                  {"displaced", "the real relief, as a mesh"}},
                 "what is shown on the left"),
            toggle("beside", &Settings::beside, "the really displaced surface on the right")
                .when(isPretended, "the method itself shows it"),
            number("angle", &Settings::angle, {0, 85},
                   "between the line of sight and the wall's normal; on the orange, a ring", "deg"),
            number("depth", &Settings::depth, {0, 0.25}, "of the relief; a brick is 1 long, the orange's radius is 1",
                   "units"),
            oneOf("map-size", &Settings::mapSize, {32, 64, 128, 256, 512}, "rows of texels of the maps"),
            word("texels", &Settings::texels, {{"float", "32 bits a channel"}, {"8-bit"}}, "how a texel is kept"),
            whole("layers", &Settings::layers, {2, 128}, "into which parallax occlusion divides the depth")
                .when(hasLayers, "only parallax occlusion goes down in layers"),
            file("picture", &Settings::picture, "assets/coin.png", "your own as a height map, in stone: white is high"),
            toggle("mirrored", &Settings::mirrored, "the left part of the wall has the texture turned about")
                .when(isWall, "only the wall is mirrored"),
            toggle("sign", &Settings::sign, "frames keep on which side they are mirrored")
                .when(hasMirroredFrames, "no frame is mirrored"),
            number("lamp-turn", &Settings::lampTurn, {-89, 89},
                   "the lamp's direction, to the right of the surface's normal", "deg"),
            number("lamp-height", &Settings::lampHeight, {-89, 89}, "and above it", "deg"),
            angle("spin-x", &Settings::spinX, "turn about the x axis").when(isOrange, "only the orange turns"),
            angle("spin-y", &Settings::spinY, "turn about the y axis").when(isOrange, "only the orange turns")};
}

constexpr Declaration about{
    .name = "bump-map",
    .sentence = "A brick wall and an orange by height map, normal map, parallax and parallax occlusion.",
    .lookFor = "Lit alike, but on the left no brick hides the mortar behind it: the surface is flat.",
    .chapter = "Surfaces, mirrors and stages",
    .number = 20,
    .width = 960,
    .height = 600,
    .background = vec4(0.93, 0.94, 0.96, 1),
    .needs = {.depth = true,
              .beyondEs = {{"float targets", "the error is not measured"},
                           {"float filtering", "float texels have 16 bits a channel"}}},
};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"normal-map", "The light is right, but the bricks hide no mortar: the surface is flat."},
        {"orange", "The lecture's case: a sphere, a map, an orange.", {.body = ReliefBody::orange, .depth = 0.04}},
        {"grazing", "At 80 degrees the trick is seen through.", {.angle = 80}},
        {"parallax-swims",
         "One guess from one height: at 70 degrees edges smear.",
         {.method = Method::parallax, .angle = 70}},
        {"occlusion",
         "Down the line of sight in layers: bricks hide mortar.",
         {.method = Method::occlusion, .angle = 70}},
        {"inside-out",
         "Mirrored texture, and frames without their sign: left of the middle the courses are lit from below.",
         {.angle = 0, .mirrored = true, .sign = false}},
    };
}

std::optional<vec2> placeOfLamp(const Settings& s, const FrameInfo& frame) {
    return lampDial(frame).at(towardsLamp(s));
}
std::optional<vec2> placeOfEye(const Settings& s, const FrameInfo& frame) { return sightFigure(frame).tip(s.angle); }

const bool added = addLesson(
    about,
    Lesson<Settings, Gpu>{
        .rows = panelRows(),
        .presets = presets(),
        .controls = {drag("spin-y", 0.5, "spin-x", 0.5), keys(Key::left, Key::right, "angle", 5), wheel("depth", 0.01)},
        .handles = {{"lamp", {"lamp-turn", "lamp-height"}, placeOfLamp}, {"eye", {"angle"}, placeOfEye}},
        .readouts = {{"lookups", "texture lookups of a pixel, at most"}, {"triangles", "of what the method draws"}},
        .draw = draw,
        .measure = drawBumped,
        .figure = drawFigure,
        .readOut = readOut,
        .scene = sceneOf,
    });

}  // namespace
}  // namespace mv::bump_map
