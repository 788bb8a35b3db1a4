// The settings of shading: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "shading.h"

namespace mv::shading {
namespace {

constexpr Declaration about{
    .name = "shading",
    .sentence = "Flat, Gouraud and Phong shading, and the highlights of Phong and Blinn.",
    .lookFor = "On a coarse mesh Gouraud shading smears the highlight over whole faces, or loses it.",
    .chapter = "Light, colour and texture",
    .number = 18,
    .width = 960,
    .height = 560,
    .background = vec4(0.93, 0.94, 0.96, 1),
    .needs = {.depth = true, .beyondEs = {{"float targets", "the readouts of the highlight are not measured"}}},
};

bool isLit(const Settings& s) { return s.shading != Shading::own; }
bool asksForLobe(const Settings& s) { return isLit(s) && s.material != Kind::diffuse && s.material != Kind::brushed; }

std::vector<Row<Settings>> panelRows() {
    const Literal ownColor = "a colour of its own asks for no light";
    return {
        word("shading", &Settings::shading,
             {{"own", "one colour, whatever the light"},
              {"flat", "light of one corner for the whole face"},
              {"gouraud", "light at the corners, interpolated"},
              {"phong", "normals interpolated, light at every pixel"}},
             "where the light of a surface is computed"),
        word("highlight", &Settings::lobe,
             {{"phong", "mirrored light against the eye"}, {"blinn", "half vector against the normal"}},
             "the model of the highlight")
            .when(asksForLobe, "the surface has a highlight of neither model"),
        word("material", &Settings::material,
             {{"plastic", "diffuse, with a highlight"},
              {"diffuse", "spreads light evenly, by Lambert"},
              {"mirror-like", "nearly all goes into the highlight"},
              {"brushed", "anisotropic: the highlight runs across the brushing"},
              {"emitting", "sends out light of its own, too"}},
             "what the surface does with light")
            .when(isLit, ownColor),
        number("exponent", &Settings::exponent, {1, 1000, Scale::logarithmic}, "how narrow the highlight is"),
        word("body", &Settings::body, {{"sphere"}, {"teapot", "32 Bezier patches"}}, "what is shaded"),
        oneOf("edges", &Settings::edges, {4, 8, 16, 32, 64, 128, 256},
              "edges round the body, four patches of the teapot"),
        toggle("normals", &Settings::normals, "draw the normals at the corners"),
        angle("lamp-turn", &Settings::lampTurn, "the lamp's direction about the y axis, from the eye's")
            .when(isLit, ownColor),
        number("lamp-height", &Settings::lampHeight, {-89, 89}, "the lamp's direction above the horizon", "deg")
            .when(isLit, ownColor),
        number("angle", &Settings::angle, {0, 80}, "in the figure, the light's angle from the normal", "deg"),
        number("view-angle", &Settings::viewAngle, {0, 80}, "in the figure, the eye's angle on the other side", "deg"),
        angle("spin-x", &Settings::spinX, "turn about the x axis"),
        angle("spin-y", &Settings::spinY, "turn about the y axis"),
    };
}

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"coarse", "Sixteen edges round the sphere: the highlight has the shape of the faces."},
        {"flat", "One colour a face.", {.shading = Shading::flat}},
        {"flat-enough",
         "Diffuse, of one colour, and faces so small that their light hardly changes: once a face is enough.",
         {.shading = Shading::flat, .material = Kind::diffuse, .edges = 256}},
        {"per-pixel",
         "The same mesh, its normals interpolated: only the outline shows the faces.",
         {.shading = Shading::phong}},
        {"missed",
         "A narrow highlight within a face: none of the corners sees it, and it is gone.",
         {.exponent = 400, .edges = 8, .lampTurn = 15, .lampHeight = 12, .spinX = 0}},
        {"teapot",
         "The 32 patches of 1975, in Blinn's model.",
         {.shading = Shading::phong, .lobe = Lobe::blinn, .body = Body::teapot, .edges = 64}},
        {"brushed",
         "Metal brushed round its axis: the highlight runs across the brushing.",
         {.shading = Shading::phong, .material = Kind::brushed, .exponent = 40, .edges = 64}},
    };
}

using MaybePlace = std::optional<vec2>;

MaybePlace placeOfLamp(const Settings& s, const FrameInfo& frame) {
    return pictureFromPane({0, 0, frame.width(), frame.height()}, sceneOf(s, frame).clipFromWorld(), lampOf(s));
}
MaybePlace placeOfLight(const Settings& s, const FrameInfo& frame) { return inFigure(frame, -s.angle, 1.1); }
MaybePlace placeOfEye(const Settings& s, const FrameInfo& frame) { return inFigure(frame, s.viewAngle, 1.1); }

const bool added = addLesson(
    about, Lesson<Settings, Gpu>{
               .rows = panelRows(),
               .presets = presets(),
               .controls = {drag("spin-y", 1, "spin-x", 1), wheel("exponent", 0.1),
                            keys(Key::left, Key::right, "lamp-turn", 5), keys(Key::down, Key::up, "lamp-height", 5)},
               .handles = {{"lamp", {"lamp-turn", "lamp-height"}, placeOfLamp},
                           {"light", {"angle"}, placeOfLight},
                           {"eye", {"view-angle"}, placeOfEye}},
               .readouts = {{"triangles", "triangles of the body"},
                            {"matching",
                             "exponent with which Blinn's highlight is as strong as Phong's, at the figure's angle"},
                            {"forth", "f_r(l, v): reflected from the figure's light to its eye"},
                            {"back", "f_r(v, l): the same way back"}},
               .draw = draw,
               .figure = drawFigure,
               .readOut = readOut,
               .scene = sceneOf,
           });

}  // namespace
}  // namespace mv::shading
