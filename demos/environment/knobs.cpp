// The settings of environment: rows, presets, controls and declaration.
#include "environment.h"
#include "mv/demo/lesson.h"
#include "shared/orbit_rows.h"
#include "shared/own_picture.h"

namespace mv::environment {
namespace {

constexpr WordList bodyWords{{"sphere"}, {"teapot"}};
constexpr WordList materialWords{{"mirror", "all of the light"}, {"gold"}, {"copper"}, {"glass", "refracts, too"}};
constexpr WordList lookupWords{
    {"direction", "as if all were infinitely far"},
    {"walls", "the direction, from the cube's middle, to where the ray meets the room's walls"},
    {"rays", "no cube: each ray finds what it meets"}};

}  // namespace

const char* nameOf(Body body) { return wordOf(bodyWords, body); }
const char* nameOf(Material material) { return wordOf(materialWords, material); }
const char* nameOf(Lookup lookup) { return wordOf(lookupWords, lookup); }

namespace {

bool hasNoPicture(const Settings& s) { return !s.picture.isSet(); }
bool isGlass(const Settings& s) { return s.material == Material::glass; }
bool isNoMirror(const Settings& s) { return s.material != Material::mirror; }
bool hasNoModel(const Settings& s) { return !s.model.isSet(); }

std::vector<Row<Settings>> panelRows() {
    return together(
        word("around", &Settings::around, {{"room", "drawn into the cube"}, {"sky", "infinitely far"}},
             "what is mirrored")
            .when(hasNoPicture, "your picture is around"),
        word("body", &Settings::body, bodyWords, "what mirrors it").when(hasNoModel, "your model is the body"),
        word("material", &Settings::material, materialWords, "how much it reflects of which colour"),
        number("index", &Settings::index, {0.4, 3},
               "of the glass over that of what is around it; below 1 it is a bubble")
            .when(isGlass, "the material is no glass"),
        word("fresnel", &Settings::fresnel,
             {{"exact", "Fresnel's equations"}, {"schlick", "a fifth power in their place"}},
             "the part that is reflected, by the angle")
            .when(isNoMirror, "the mirror reflects all"),
        word("refract", &Settings::refract,
             {{"first", "where light enters the glass"},
              {"both", "where it leaves it, too"},
              {"inside", "and where it is reflected inside, up to four times"}},
             "at which surfaces of the glass sphere")
            .when(isGlass, "nothing shines through the material")
            .when(hasNoModel, "the way through a model is no formula")
            .when(isSphere, "the way through a teapot is no formula"),
        word("lookup", &Settings::lookup, lookupWords, "how the mirrored light is found")
            .when(inRoom, "the sky is infinitely far, and at rest"),
        toggle("split", &Settings::split, "the right half as exact as rays make it")
            .when(inRoom, "the sky is infinitely far, and at rest"),
        number("room", &Settings::roomSize, {2, 100, Scale::logarithmic},
               "half of the room's width, in radii of the sphere")
            .when(inRoom, "the sky is infinitely far, and at rest"),
        oneOf("cube-size", &Settings::cubeSize, {4, 16, 64, 256}, "texels along a side of each face")
            .when(looksUp, "rays ask no cube"),
        toggle("seamless", &Settings::seamless, "filter across the edges of the cube")
            .when(looksUp, "rays ask no cube"),
        angle("ball", &Settings::ball, "where the red ball is on its way round")
            .when(inRoom, "the sky is infinitely far, and at rest"),
        toggle("moving", &Settings::moving, "the red ball goes round, a degree a frame")
            .when(inRoom, "the sky is infinitely far, and at rest"),
        toggle("keep", &Settings::keep, "keep the faces in which nothing moves")
            .when(inRoom, "the sky is infinitely far, and at rest")
            .when(looksUp, "rays ask no cube"),
        file("picture", &Settings::picture, "assets/evening.png",
             "your own around the body: a panorama, twice as wide as high, or a cube cut open into 4 x 3 squares"),
        file("model", &Settings::model, "assets/knot.obj", "your own body, made as large as the sphere"),
        part(&Settings::orbit, orbitRows({-3, 20})));
}

constexpr Declaration about{
    .name = "environment",
    .sentence = "Mirror, gold, copper and glass, with what is around them looked up in a cube map.",
    .lookFor =
        "Left by the cube map, right by rays: tiles and balls do not meet, since the cube takes all for infinitely "
        "far.",
    .chapter = "Surfaces, mirrors and stages",
    .number = 31,
    .width = 960,
    .height = 560,
    .animated = true,
    .background = vec4(0.93, 0.94, 0.96, 1),
    .needs = {.depth = true, .beyondEs = {{"float targets", "the error is not measured"}}},
};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"room", "A mirror in a room drawn into a cube map: at the line, tiles and balls do not meet."},
        {"corrected",
         "The walls meet, since the lookup knows where they are; the balls do not.",
         {.lookup = Lookup::walls}},
        {"gold",
         "A golden teapot under a sky, which really is far away.",
         {.around = Around::sky,
          .body = Body::teapot,
          .material = Material::gold,
          .orbit = {.spinX = -8, .spinY = 25}}},
        {"glass", "A sphere of glass turns the room upside down.", {.material = Material::glass, .roomSize = 8}},
        {"bubble",
         "Air in water: beyond 48.6 degrees from the normal everything is reflected.",
         {.material = Material::glass, .index = 0.75, .lookup = Lookup::rays, .split = false},
         {{"limit", 48.55, 48.65}}},
        {"seams",
         "Sixteen texels a side, and each face filtered by itself: where they meet it jumps.",
         {.lookup = Lookup::walls,
          .split = false,
          .roomSize = 2,
          .cubeSize = 16,
          .seamless = false,
          .orbit = {.spinX = 20, .spinY = 30, .distance = -2.3}}},
    };
}

void check(const Settings& s) {
    if (s.picture.isSet()) surroundingOf(*s.picture.content(), "--picture");
    if (s.model.isSet() && !(reachOf(s.model.content()->mesh) > 0))
        throw Error("--model", "must have corners in more than one place", s.model.name);
}

std::optional<vec2> placeOfBall(const Settings& s, const FrameInfo& frame) {
    if (!inRoom(s)) return std::nullopt;
    return pictureFromPane(viewPane(frame), sceneOf(s, frame).clipFromWorld(), roomOf(s, frame).ballPlaces().front());
}

const bool added =
    addLesson(about, Lesson<Settings, Gpu>{
                         .rows = panelRows(),
                         .presets = presets(),
                         .controls = {orbitDrag, orbitWheel, keys(Key::left, Key::right, "ball", 5),
                                      keys(Key::down, Key::up, "room", 0.1)},
                         .handles = {{"ball", {"ball"}, placeOfBall}},
                         .readouts = {{"faces-drawn", "faces of the cube that were drawn for this picture"},
                                      {"head-on", "part of the light that is reflected head on, as luminance"},
                                      {"limit", "angle from which on the bubble reflects all", "deg"}},
                         .draw = draw,
                         .measure = drawMeasured,
                         .figure = drawFigure,
                         .readOut = readOut,
                         .check = check,
                         .scene = sceneOf,
                     });

}  // namespace
}  // namespace mv::environment
