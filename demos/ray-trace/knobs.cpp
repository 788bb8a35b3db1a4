// The settings of ray-trace: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "ray-trace.h"

namespace mv::ray_trace {

constexpr WordList structureWords{{"none", "every triangle is asked"},
                                  {"boxes", "those of the patches whose box is met"},
                                  {"grid", "those in the cells along the ray"},
                                  {"tree", "a bounding volume hierarchy"}};
const char* nameOf(RayStructure structure) { return wordOf(structureWords, structure); }

void check(const Settings& s) {
    if (s.room != TracedRoom::teapot) return;
    const int most = s.structure == RayStructure::none ? 1024 : s.structure == RayStructure::boxes ? 4096 : 1 << 20;
    if (s.triangles > most)
        throw Error("--triangles",
                    "must be at most " + std::to_string(most) + " with --structure " + nameOf(s.structure) +
                        ", or a picture takes minutes; with grid or tree it may be",
                    std::to_string(s.triangles));
}

namespace {

bool hasLamp(const Settings& s) { return s.room != TracedRoom::white && s.room != TracedRoom::glassBall; }
bool hasShadows(const Settings& s) { return s.shadows; }
bool partsColors(const Settings& s) { return s.room == TracedRoom::stillLife || s.room == TracedRoom::glassBall; }
bool hasGlass(const Settings& s) { return partsColors(s) || s.room == TracedRoom::white; }
bool hasWavelengths(const Settings& s) { return s.wavelengths > 1; }
bool hasTeapot(const Settings& s) { return s.room == TracedRoom::teapot; }
bool hasTriangles(const Settings& s) { return hasTeapot(s) || s.room == TracedRoom::strips; }
bool hasGlobes(const Settings& s) { return s.room == TracedRoom::globes; }
bool hasPattern(const Settings& s) { return partsColors(s) || hasTeapot(s) || hasGlobes(s); }
bool isFollowed(const Settings& s) { return hasPattern(s) || s.room == TracedRoom::white; }

std::vector<Row<Settings>> panelRows() {
    return together(
        word("room", &Settings::room,
             {{"still-life", "mirror, glass, a floor of squares"},
              {"teapot", "triangles beside a mirror"},
              {"soft-shadow", "a ball over a grey floor"},
              {"lamp", "that floor and the lamp alone"},
              {"white", "mirror and glass where all else is white and shines"},
              {"strips", "the ball over a grey floor of slender triangles"},
              {"globes", "two balls with a picture round them, and a mirror"},
              {"glass-ball", "over the squares, without a lamp"}},
             "what is seen"),
        word("show", &Settings::show,
             {{"light"}, {"cut", "what the depth leaves out"}, {"rays", "how many a sample takes"}}, "of each pixel"),
        whole("depth", &Settings::depth, {0, 16}, "rays that follow each other, at most")
            .when(isFollowed, "nothing is followed"),
        oneOf("samples", &Settings::samples, {1, 4, 16, 64, 256}, "rays through each pixel"),
        word("pattern", &Settings::pattern,
             {{"regular", "the middles of equal cells"},
              {"random"},
              {"jittered", "one in each cell, at random"},
              {"sequence", "a (0,2)-sequence"}},
             "where in the pixel, and on the lamp"),
        number("lamp-size", &Settings::lampSize, {0, 2}, "half a side of the lamp")
            .when(hasLamp, "there is no lamp")
            .when(hasShadows, "without shadows only the lamp's middle is asked"),
        number("index", &Settings::index, {1, 2.5}, "of the glass").when(hasGlass, "there is no glass"),
        word("fresnel", &Settings::fresnel,
             {{"exact"}, {"schlick", "Schlick's curve, by the angle on the ray's own side"}},
             "which part glass reflects")
            .when(hasGlass, "there is no glass"),
        toggle("shadows", &Settings::shadows, "ask whether the lamp is seen").when(hasLamp, "there is no lamp"),
        toggle("filtered", &Settings::filtered,
               "average the floor's squares, or a globe's picture, over the ray's cone")
            .when(hasPattern, "there is no pattern"),
        word("structure", &Settings::structure, structureWords, "how a ray finds its triangle")
            .when(hasTeapot, "there is no teapot"),
        oneOf("triangles", &Settings::triangles, {1024, 4096, 16384, 65536, 262144, 1048576},
              "of the teapot, less those that have collapsed to an edge; of the floor of strips")
            .when(hasTriangles, "there are no triangles"),
        word("leave", &Settings::leave,
             {{"point", "at the point itself"},
              {"components", "off it by roundings of each coordinate along the normal"},
              {"largest", "by as many roundings of the largest coordinate"},
              {"bounded", "and nothing is met in whose plane the ray begins"}},
             "where a ray begins that leaves a triangle")
            .when(hasTriangles, "there are no triangles"),
        angle("eye-turn", &Settings::eyeTurn, "of the eye about the middle"),
        number("eye-height", &Settings::eyeHeight, {0.2, 5}, "of the eye above the floor"),
        whole("seed", &Settings::seed, {1, 8}, "of what is random"),
        number("highlight", &Settings::highlight, {0, 200}, "Phong's exponent, of what is not glass; 0: no highlight")
            .when(hasLamp, "there is no lamp"),
        toggle("falloff", &Settings::falloff, "the lamp's light falls as 1/d^2; at the middle of the floor it stays")
            .when(hasLamp, "there is no lamp"),
        angle("globe-turn", &Settings::globeTurn, "of the globes about their axis")
            .when(hasGlobes, "there is no globe"),
        oneOf("wavelengths", &Settings::wavelengths, {1, 3, 4, 8, 16, 32},
              "that are traced where glass is met; 1: one index for all")
            .when(partsColors, "no glass parts colours here"),
        number("abbe", &Settings::abbe, {20, 90}, "Abbe number of the glass: the smaller, the more it parts colours")
            .when(partsColors, "no glass parts colours here")
            .when(hasWavelengths, "all wavelengths have one index"));
}

constexpr Declaration about{
    .name = "ray-trace",
    .sentence =
        "Rays followed through mirrors and glass to a lamp with an area, in passes that make the picture better.",
    .lookFor =
        "The glass ball turns the room upside down, and its shadow has light in it; the lamp's shadows are sharp where "
        "a ball touches the floor.",
    .chapter = "Rays, clipping and pixels",
    .number = 23,
    .width = 480,
    .height = 320,
    .background = vec4(1, 1, 1, 1),
};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"still-life", "Mirror, glass, squares that do not flicker, soft shadows."},
        {"teapot", "Triangles, which a tree finds.", {.room = TracedRoom::teapot}},
        {"soft",
         "A large lamp asked at random places: the noise of few samples.",
         {.room = TracedRoom::softShadow, .samples = 4, .pattern = SamplePattern::random, .lampSize = 2}},
        {"diamond", "A larger index: more is reflected, and more totally.", {.index = 2.4}},
        {"cut-off",
         "Where all light is 1, what is missing is what the depth has cut off.",
         {.room = TracedRoom::white, .show = Show::cut, .depth = 3}},
        {"globes",
         "A picture round a ball: each ray that meets it is taken to the ball's own space, and from there to the "
         "picture.",
         {.room = TracedRoom::globes}},
        {"flint",
         "Heavy flint glass, N-SF11: each edge that it shows has coloured fringes, orange on one side and blue on "
         "the other.",
         {.room = TracedRoom::glassBall, .samples = 4, .index = 1.7847, .wavelengths = 8, .abbe = 25.68}},
        {"rays", "How many rays a sample takes: most where glass and mirror see each other.", {.show = Show::rays}},
    };
}

const bool added = addLesson(
    about,
    Lesson<Settings, Gpu, Made>{
        .rows = panelRows(),
        .presets = presets(),
        .controls = {keys(Key::left, Key::right, "eye-turn", 5), keys(Key::down, Key::up, "depth", 1),
                     drag("eye-turn", 0.5, "eye-height", 0.01)},
        .readouts = {{"rays", "rays a pixel, with those to the lamp"},
                     {"cut", "of the light that rays would bring, what the depth leaves out", "%"},
                     {"cut-most", "the same, of the pixel where it is most", "%"},
                     {"missing", "in the white room: how far a pixel's light and what is cut are from 1, at most"}},
        .draw = draw,
        .figure = drawFigure,
        .readOut = readOut,
        .check = check,
        .passes =
            [](const Settings& s, const FrameInfo& frame) {
                return TracePicture::passesOf(s.samples, frame.width(), frame.height());
            },
        .refine = refine,
        .values = values,
        .valueCounts = valueCounts,
    });

}  // namespace
}  // namespace mv::ray_trace
