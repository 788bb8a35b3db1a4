// shading: where the light of a surface is computed (once, for a face, at its corners, at every pixel), and by which model.
//
// Claims (each is a test in tests/claims/shading.cpp; X46, X47 and X50 in docs/stability.md are its extremes):
// - [one-colour-a-face] Flat shading gives each face one colour; a body without shading has one in all.
// - [misses-the-highlight] Gouraud shading shows nothing of a highlight that lies within a face, and Phong shading does.
// - [finer-is-alike] The finer the mesh, the nearer are flat and Gouraud shading to Phong's.
// - [no-light-from-behind] Where the lamp is behind the surface there is no light, and no highlight, in any model.
// - [blinn-matches-phong] Blinn's highlight is as strong as Phong's with 4 cos(angle) times the exponent.
// - [reciprocity] Lambert's model reflects light that goes the other way alike; Phong's and Blinn's highlight divided by
//   the cosine do not, by the ratio of the two cosines.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/made_for.h"
#include "mv/geometry/plot.h"
#include "mv/geometry/shapes.h"
#include "mv/geometry/teapot.h"
#include "mv/gl/drawing.h"
#include "mv/gl/gl.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/scene_meshes.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/reflection.h"
#include "shared/spin.h"

using namespace mv;

namespace {

enum class Shading { own, flat, gouraud, phong };
enum class Body { sphere, teapot };

// What a surface does with light: the parts that it spreads, mirrors, and sends out by itself.
struct Material {
    double diffuse, highlight, emitted;
    bool isBrushed = false;
};
constexpr std::array<Material, 5> materials{{
    {0.75, 0.5, 0.2},
    {0.8, 0, 0.2},
    {0.1, 0.9, 0.1},
    {0.2, 0.75, 0.2, true},
    {0.3, 0.2, 0.7},
}};
enum class Kind { plastic, diffuse, mirrorLike, brushed, emitting };

constexpr double sphereRadius = 1.5;
const vec3 eye(0, 0.5, 7);
const vec3 bodyColor(0.80, 0.35, 0.15);
const vec4 red(0.75, 0.15, 0.1, 1), blue(0.1, 0.3, 0.7, 1), grey(0.6, 0.6, 0.6, 1), ink(0.1, 0.1, 0.1, 1);

struct ShadingDemo final : Demo {
    Choice<Shading> shading{this,
                            "shading",
                            Shading::gouraud,
                            {{"own", "one colour, whatever the light"},
                             {"flat", "light of one corner for the whole face"},
                             {"gouraud", "light at the corners, interpolated"},
                             {"phong", "normals interpolated, light at every pixel"}},
                            "where the light of a surface is computed"};
    Choice<Lobe> lobe{this,
                      "highlight",
                      Lobe::phong,
                      {{"phong", "mirrored light against the eye"}, {"blinn", "half vector against the normal"}},
                      "the model of the highlight"};
    Choice<Kind> material{this,
                          "material",
                          Kind::plastic,
                          {{"plastic", "diffuse, with a highlight"},
                           {"diffuse", "spreads light evenly, by Lambert"},
                           {"mirror-like", "nearly all goes into the highlight"},
                           {"brushed", "anisotropic: the highlight runs across the brushing"},
                           {"emitting", "sends out light of its own, too"}},
                          "what the surface does with light"};
    Real exponent{this, "exponent", 20, {1, 1000, Scale::logarithmic}, "how narrow the highlight is"};
    Choice<Body> body{this, "body", Body::sphere, {{"sphere"}, {"teapot", "32 Bezier patches"}}, "what is shaded"};
    NumberChoice edges{
        this, "edges", 16, {4, 8, 16, 32, 64, 128, 256}, "edges round the body, four patches of the teapot"};
    Toggle normals{this, "normals", false, "draw the normals at the corners"};
    Angle lampTurn{this, "lamp-turn", 35, "the lamp's direction about the y axis, from the eye's"};
    Real lampHeight{this, "lamp-height", 35, {-89, 89}, "the lamp's direction above the horizon", "deg"};
    Real angle{this, "angle", 45, {0, 80}, "in the figure, the light's angle from the normal", "deg"};
    Real viewAngle{this, "view-angle", 20, {0, 80}, "in the figure, the eye's angle on the other side", "deg"};
    Spin spin{this, 15, 0};

    Readout triangles{this, "triangles", "triangles of the body"};
    Readout matching{this, "matching",
                     "exponent with which Blinn's highlight is as strong as Phong's, at the figure's angle"};
    Readout forth{this, "forth", "f_r(l, v): reflected from the figure's light to its eye"};
    Readout back{this, "back", "f_r(v, l): the same way back"};

    OnDemand<Program> byPixel{"shading"}, byVertex{"shading", "gouraud"}, byFace{"shading", "flat"};
    OnDemand<Program> plain{"shading", "own"};
    Mesh mesh, needles;
    MadeFor<Body, int> meshFor, needlesFor;
    std::size_t count = 0;
    std::vector<vec2> ratios;  // of the exponents that match, over the angle
    MadeFor<double> ratiosFor;
    double matched = 0;  // the exponent at the figure's angle
    MadeFor<double, double> matchedFor;
    Drawing drawing;

    ShadingDemo() {
        bindWheel(exponent, 0.1);
        bindKeys(Key::left, Key::right, lampTurn, 5);
        bindKeys(Key::down, Key::up, lampHeight, 5);
        bindHandle("lamp", {&lampTurn, &lampHeight}, [this](const FrameInfo& frame) {
            return pictureFromPane({0, 0, frame.width(), frame.height()}, clipFromWorld(frame), lamp());
        });
        bindHandle("light", {&angle}, [this](const FrameInfo& frame) { return figure(frame).at(-angle, 1.1); });
        bindHandle("eye", {&viewAngle}, [this](const FrameInfo& frame) { return figure(frame).at(viewAngle, 1.1); });
        const auto asks = [this] { return shading != Shading::own; };
        for (Knob* knob : std::vector<Knob*>{&material, &lampTurn, &lampHeight})
            knob->onlyWhen(asks, "a colour of its own asks for no light");
        lobe.onlyWhen([=, this] { return asks() && material != Kind::diffuse && material != Kind::brushed; },
                      "the surface has a highlight of neither model");
    }

    void init() override {}

    // ---- the body, lit

    void draw(const Frame& frame) override {
        if (meshFor.changed(body, edges)) {
            const MeshData data = bodyMesh();
            mesh = Mesh(withoutTexCoords(data), "body");
            count = data.indices.size() / 3;
        }
        triangles = double(count);
        const mat4 clipFromBody = clipFromWorld(frame) * worldFromBody();
        frame.show("worldFromBody", worldFromBody());
        frame.show("clipFromWorld", clipFromWorld(frame));
        glEnable(GL_DEPTH_TEST);

        if (shading == Shading::own) {
            plain->use();
            plain->set("clipFromBody", clipFromBody);
            plain->set("color", bodyColor);
        } else {
            const Program& program = shading == Shading::flat      ? *byFace
                                     : shading == Shading::gouraud ? *byVertex
                                                                   : *byPixel;
            const Material& surface = materials.at(static_cast<std::size_t>(Kind(material)));
            program.use();
            program.set("clipFromBody", clipFromBody);
            program.set("worldFromBody", worldFromBody());
            program.set("worldFromNormal", normalMatrix(worldFromBody()));
            program.set("color", bodyColor);
            program.set("lamp", lamp());
            program.set("eye", eye);
            program.set("diffusePart", surface.diffuse);
            program.set("emitted", surface.emitted);
            program.set("highlightPart", surface.highlight);
            program.set("exponent", exponent);
            program.set("middleWithin", 6.0 / 7 * sphereRadius);
            program.set("lobe", static_cast<int>(surface.isBrushed ? Lobe::brushed : Lobe(lobe)));
        }
        mesh.draw();

        if (normals && !frame.measuring()) drawNormals(clipFromBody);
        if (frame.readouts()) readFigure();
    }

    MeshData bodyMesh() const {
        return body == Body::sphere ? sphere(sphereRadius, edges, edges / 2) : tessellated(teapot(), edges / 4);
    }
    mat4 worldFromBody() const {
        if (body == Body::sphere) return spin.turn();
        return spin.turn() * scale(0.66) * translate(-0.2, -1.5, 0);
    }
    vec3 lamp() const { return 2.6 * vec3(rotateY(lampTurn) * rotateX(-lampHeight) * vec4(0, 0, 1, 0)); }
    mat4 clipFromWorld(const FrameInfo& frame) const { return scene(frame).clipFromWorld(); }

    void drawNormals(const mat4& clipFromBody) {
        if (needlesFor.changed(body, edges)) {
            const MeshData data = bodyMesh();
            MeshData lines{.primitive = Primitive::lines};
            for (std::size_t i = 0; i < data.positions.size(); ++i) {
                lines.positions.push_back(data.positions[i]);
                lines.positions.push_back(data.positions[i] + 0.2F * data.normals[i]);
            }
            needles = Mesh(lines, "normals");
        }
        plain->use();
        if (shading != Shading::own) plain->set("clipFromBody", clipFromBody);
        plain->set("color", vec3(blue));
        needles.draw();
    }

    // ---- the figure: light and eye over a surface, and what each model sends where

    // Directions in its plane, by their angle from the normal; the eye's side is positive.
    struct Figure {
        vec2 foot;
        double radius;
        vec2 at(double degrees, double part) const {
            return foot + part * radius * vec2(std::sin(radians(degrees)), std::cos(radians(degrees)));
        }
    };
    static Figure figure(const FrameInfo& frame) {
        return {{0.8 * frame.width(), 0.6 * frame.height()}, std::min(0.16 * frame.width(), 0.3 * frame.height())};
    }
    static vec3 direction(double degrees) { return {std::sin(radians(degrees)), 0, std::cos(radians(degrees))}; }
    double sentTo(double degrees, Lobe by, double power) const {
        return mv::highlight(by, direction(0), direction(-angle), direction(degrees), power);
    }

    double match() {
        if (matchedFor.changed(exponent, angle)) matched = matchingExponent(exponent, angle);
        return matched;
    }

    void readFigure() {
        matching = match();
        const Lobe by = lobe;
        forth = reflectance(by, direction(0), direction(-angle), direction(viewAngle), exponent);
        back = reflectance(by, direction(0), direction(viewAngle), direction(-angle), exponent);
    }

    void annotate(const Frame& frame) override {
        drawing.begin(frame);
        const int words = std::clamp(frame.height() / 40, 8, 15);
        const auto label = [&](const vec2& at, const std::string& text, const vec4& color = ink) {
            drawing.textAround(at, text, {words, color, vec4(0)});
        };
        // The surface, its normal, light and eye
        const Figure f = figure(frame);
        drawing.line(f.at(-90, 1.15), f.at(90, 1.15), {ink, 2});
        drawing.arrow(f.foot, f.at(0, 1.1), {grey});
        drawing.arrow(f.foot, f.at(-angle, 1.1), {{0.85, 0.6, 0.0, 1}, 2});
        drawing.arrow(f.foot, f.at(viewAngle, 1.1), {ink, 2});
        drawing.line(f.foot, f.at(angle, 1.1), {grey, 1});
        label(f.at(0, 1.2), "n", grey);
        label(f.at(-angle, 1.2), "l", {0.7, 0.5, 0.0, 1});
        label(f.at(viewAngle, 1.2), "v");
        label(f.at(angle, 1.2), "r", grey);

        // What is sent into each direction: the farther out, the more
        const double same = exponent, other = match();
        const auto drawLobe = [&](const vec4& color, double width, const auto& sent) {
            std::vector<vec2> outline;
            for (int half = -180; half <= 180; ++half) outline.push_back(f.at(0.5 * half, sent(0.5 * half)));
            drawing.line(outline, {color, width});
        };
        drawLobe(grey, 1.5, [&](double) { return 0.5 * std::cos(radians(angle)); });
        drawLobe(red, 2, [&](double t) { return sentTo(t, Lobe::phong, same); });
        drawLobe(blue, 2, [&](double t) { return sentTo(t, Lobe::blinn, same); });
        drawLobe(blue, 1, [&](double t) { return sentTo(t, Lobe::blinn, other); });
        label(f.foot - vec2(0.75 * f.radius, 1.1 * words), "Lambert", grey);
        label(f.foot - vec2(0.2 * f.radius, 1.1 * words), "Phong", red);
        label(f.foot + vec2(0.6 * f.radius, -1.1 * words), "Blinn, and matching (thin)", blue);

        // The exponent that matches
        if (ratiosFor.changed(exponent)) {
            ratios.clear();
            for (int a = 0; a <= 80; a += 5) ratios.emplace_back(a, matchingExponent(exponent, a) / exponent);
        }
        const Plot plot{{{0.64 * frame.width(), 0.13 * frame.height()}, {0.97 * frame.width(), 0.44 * frame.height()}},
                        {0, 80, "angle of the light from the normal, degrees"},
                        {0, 5, "Blinn's exponent / Phong's"}};
        std::vector<vec2> rule;
        for (int a = 0; a <= 80; a += 2) rule.emplace_back(a, 4 * std::cos(radians(a)));
        drawing.axes(plot);
        drawing.curve(plot, rule, {grey, 1});
        drawing.curve(plot, ratios, {blue, 2});
        label(plot.pixel({18, 4.6}), "as strong", blue);
        label(plot.pixel({45, 4.6}), "4 cos", grey);
        drawing.point(plot.pixel({angle, other / exponent}), 8, blue);
        if (shading != Shading::own) {
            drawing.point(clipFromWorld(frame), lamp(), 14, {1, 0.8, 0.2, 1});
            drawing.text(clipFromWorld(frame), lamp(), {10, 6}, "lamp", {words, ink, vec4(0)});
        }
        drawing.draw(frame);
    }

    // Lamp and camera. The body is no part of it: what stands for it is under study.
    Scene scene(const FrameInfo& frame) const override {
        Scene scene;
        scene.lights = {{.position = vec4(lamp(), 1)}};
        scene.viewFromWorld = lookAt(eye, vec3(0, 0, 0), vec3(0, 1, 0));
        // The body stands in the left part of the picture; the figures are beside it.
        scene.clipFromView = translate(-0.4, 0, 0) * perspective(35, frame.aspect(), 1, 20);
        return scene;
    }
};

constexpr Declaration declaration{
    .name = "shading",
    .sentence = "Flat, Gouraud and Phong shading, and the highlights of Phong and Blinn.",
    .lookFor = "On a coarse mesh Gouraud shading smears the highlight over whole faces, or loses it.",
    .chapter = "Light, colour and texture",
    .number = 18,
    .width = 960,
    .height = 560,
    .background = vec4(0.93, 0.94, 0.96, 1),
    .needs = {.depth = true, .beyondEs = {{"float targets", "the readouts of the highlight are not measured"}}},
    .presets =
        {
            {"coarse", "Sixteen edges round the sphere: the highlight has the shape of the faces."},
            {"flat", "One colour a face.", {{"shading", "flat"}}},
            {"per-pixel",
             "The same mesh, its normals interpolated: only the outline shows the faces.",
             {{"shading", "phong"}}},
            {"missed",
             "A narrow highlight within a face: none of the corners sees it, and it is gone.",
             {{"exponent", "400"}, {"edges", "8"}, {"lamp-turn", "15"}, {"lamp-height", "12"}, {"spin-x", "0"}}},
            {"teapot",
             "The 32 patches of 1975, in Blinn's model.",
             {{"body", "teapot"}, {"shading", "phong"}, {"highlight", "blinn"}, {"edges", "64"}}},
            {"brushed",
             "Metal brushed round its axis: the highlight runs across the brushing.",
             {{"material", "brushed"}, {"shading", "phong"}, {"edges", "64"}, {"exponent", "40"}}},
        },
};

const bool added = addDemo<ShadingDemo, declaration>();

}  // namespace
