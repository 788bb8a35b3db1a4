// The settings of lights: rows, presets, handles and readouts.
#include "lights.h"
#include "mv/demo/lesson.h"

namespace mv::lights {

void check(const Settings& s) {
    if (s.constant + s.linear + s.quadratic == 0)
        throw Error("--quadratic", "must be above 0, or --constant or --linear: all light would be divided by 0", "0");
    if (!isOn(s, Kind::spot)) return;
    if (s.inner > s.outer) throw Error("--inner", "must not be above --outer", numberText(s.inner));
    for (std::size_t i = 0; i < lightCount; ++i) {
        if (s.kinds[i] == Kind::spot && placeOf(s, i) == aim(s))
            throw Error("--height", "must not be 0 for a spot that stands where it aims", numberText(s.height));
    }
}

namespace {

constexpr WordList kindWords{{"off"}, {"ambient"}, {"directional"}, {"point"}, {"spot"}};

constexpr WordList tintWords{{"own", "each its own"}, {"white"}, {"red"}, {"green"}, {"blue"}};

}  // namespace

const char* nameOf(Kind kind) { return wordOf(kindWords, kind); }

namespace {

bool hasSpot(const Settings& s) { return isOn(s, Kind::spot); }
bool hasPlaces(const Settings& s) { return isOn(s, Kind::directional) || isOn(s, Kind::point) || hasSpot(s); }

std::vector<Row<Settings>> panelRows() {
    const auto light = [](std::size_t index, Literal name, Literal help) {
        return word(name, element(&Settings::kinds, index), kindWords, help);
    };
    const Literal noPlace = "no light that has a place is on", noSpot = "no spot is on";
    return together(
        light(0, "light-1", "what light 1 is"), light(1, "light-2", "what light 2 is"),
        light(2, "light-3", "what light 3 is"), light(3, "light-4", "what light 4 is"),
        light(4, "light-5", "what light 5 is"), light(5, "light-6", "what light 6 is"),
        light(6, "light-7", "what light 7 is"), light(7, "light-8", "what light 8 is"),
        points("places", &Settings::places,
               {.low = vec2(-2, -1.5), .high = vec2(2.5, 2), .least = 8, .most = 8, .grid = 0.05},
               "x and z of the lights; an ambient one has none")
            .when(hasPlaces, noPlace),
        number("height", &Settings::height, {0, 3}, "y of the lights", "m").when(hasPlaces, noPlace),
        number("power", &Settings::power, {0.01, 100, Scale::logarithmic}, "light of a lamp at 1 m, by 1/d^2"),
        number("constant", &Settings::constant, {0, 4}, "term of the falloff that is the same at any distance"),
        number("linear", &Settings::linear, {0, 4}, "term that grows with the distance"),
        number("quadratic", &Settings::quadratic, {0, 4}, "term that grows with its square"),
        number("lamp-size", &Settings::size, {0.01, 0.5}, "radius of a lamp", "m"),
        number("cut-off", &Settings::cutOff, {1e-4, 0.1, Scale::logarithmic, true},
               "a lamp ends where it gives less than this; 0: nowhere"),
        number("inner", &Settings::inner, {0, 80}, "angle from a spot's axis up to which it shines fully", "deg")
            .when(hasSpot, noSpot),
        number("outer", &Settings::outer, {1, 80}, "angle from which on it does not shine", "deg")
            .when(hasSpot, noSpot),
        number("aim-x", x(&Settings::aim), {-2, 2.5}, "x of the place on the floor that spots aim at", "m")
            .when(hasSpot, noSpot),
        number("aim-z", y(&Settings::aim), {-1.5, 2}, "z of that place", "m").when(hasSpot, noSpot),
        number("mark-x", x(&Settings::mark), {-2, 2.5}, "x of a place on the floor whose light is told", "m"),
        number("mark-z", y(&Settings::mark), {-1.5, 2}, "z of that place", "m"),
        word("ask", &Settings::ask,
             {{"reaching", "those that are on, and whose light comes to something that is seen"},
              {"all", "all but ambient ones, whatever they give"}},
             "which lights the shader asks for each pixel"),
        toggle("encode", &Settings::encode, "add linear light and encode the sum; off: take stored numbers for light"),
        toggle("log-log", &Settings::logLog, "both axes of the graph logarithmic"),
        word("light-color", &Settings::lightColor, tintWords, "of all lights"),
        word("surface-color", &Settings::surfaceColor, tintWords, "of all surfaces, as sRGB"));
}

constexpr Declaration about{
    .name = "lights",
    .sentence = "Ambient, directional, point and spot lights, up to eight, and how their light falls off.",
    .lookFor =
        "Drag lamp 3 towards a surface and away: its light falls as 1/d^2. Then light 2: only its direction matters.",
    .chapter = "Light, colour and texture",
    .number = 17,
    .width = 960,
    .height = 540,
    .background = vec4(0, 0, 0, 1),
    .needs = {.depth = true},
};

const Settings oneLamp{.kinds{Kind::off, Kind::off, Kind::point}};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"four", "One light of each model: everywhere, from far away, from a lamp, from a lamp with a cone."},
        {"point", "One lamp alone: bright below it, dark behind, by 1/d^2 and by the angle at which light arrives.",
         oneLamp},
        {"constant", "The same lamp without falloff: distance does not matter, only the angle does.",
         with(oneLamp,
              [](Settings& s) {
                  s.constant = 1;
                  s.quadratic = 0;
              })},
        {"hard-spot",
         "A spot whose inner cone is its outer one: an edge with a step.",
         {.kinds{Kind::ambient, Kind::off, Kind::off, Kind::spot}, .inner = 22, .outer = 22}},
        {"not-encoded",
         "The lamp with numbers that are not encoded: dark too soon, and a hard edge of the shade on the ball.",
         with(oneLamp, [](Settings& s) { s.encode = false; })},
        {"cut-off",
         "Seven lamps that end where they give less than a tenth: circles with an edge on floor and wall.",
         {.kinds{Kind::ambient, Kind::point, Kind::point, Kind::spot, Kind::point, Kind::point, Kind::point,
                 Kind::point},
          .height = 0.5,
          .power = 0.2,
          .cutOff = 0.1}},
    };
}

std::optional<vec2> inPicture(const Settings& s, const FrameInfo& frame, const vec3& point) {
    return pictureFromPane(paneOf(frame), sceneOf(s, frame).clipFromWorld(), point);
}
// The first of two lights at one place is dragged.
std::optional<vec2> placeOfLight(const Settings& s, const FrameInfo& frame, const vec2& place) {
    for (std::size_t i = 0; i < lightCount; ++i) {
        if (s.places[i] == place && hasPlace(s.kinds[i])) return inPicture(s, frame, placeOf(s, i));
    }
    return {};
}
std::optional<vec2> placeOfAim(const Settings& s, const FrameInfo& frame) {
    if (!hasSpot(s)) return {};
    return inPicture(s, frame, aim(s));
}
std::optional<vec2> placeOfMark(const Settings& s, const FrameInfo& frame) { return inPicture(s, frame, marked(s)); }

const bool added = addLesson(
    about, Lesson<Settings, Gpu>{
               .rows = panelRows(),
               .presets = presets(),
               .handles = {{"light", {"places"}, {}, placeOfLight},
                           {"aim", {"aim-x", "aim-z"}, placeOfAim},
                           {"mark", {"mark-x", "mark-z"}, placeOfMark}},
               .readouts = {{"lights-sent", "lights that the shader asks for each pixel"},
                            {"mark", "light that arrives at the mark, mean of red, green and blue"},
                            {"mark-stored", "the number that sRGB has for that on a white surface, at most 255"}},
               .draw = draw,
               .figure = drawFigure,
               .readOut = readOut,
               .check = check,
               .scene = sceneOf,
           });

}  // namespace
}  // namespace mv::lights
