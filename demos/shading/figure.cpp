// The scene of shading, and the figure beside it: light and eye over a surface, and what each model sends where.
#include <algorithm>
#include <cmath>
#include <string>

#include "mv/geometry/plot.h"
#include "mv/gl/word_size.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shading.h"
#include "shared/wide_lines.h"

namespace mv::shading {

// Lamp and camera. The body is no part of it: what stands for it is under study.
Scene sceneOf(const Settings& s, const FrameInfo& frame) {
    Scene scene;
    scene.lights = {{.position = vec4(lampOf(s), 1)}};
    scene.viewFromWorld = lookAt(eye, vec3(0, 0, 0), vec3(0, 1, 0));
    // The body stands in the left part of the picture, or in the upper one; the figures are beside or below it
    scene.clipFromView = frame.isUpright()
                             ? translate(0, 0.5, 0) * scale(1, 0.5, 1) * perspective(35, 2 * frame.aspect(), 1, 20)
                             : translate(-0.4, 0, 0) * perspective(35, frame.aspect(), 1, 20);
    return scene;
}

vec3 direction(double angle) { return {std::sin(radians(angle)), 0, std::cos(radians(angle))}; }

// The foot of the normal, in pixels, and how long the unit of the directions is.
struct FigurePlace {
    vec2 foot;
    double radius;
};
static FigurePlace placeOf(const FrameInfo& frame) {
    if (frame.isUpright())
        return {{0.27 * frame.width(), 0.2 * frame.height()}, std::min(0.2 * frame.width(), 0.2 * frame.height())};
    return {{0.8 * frame.width(), 0.6 * frame.height()}, std::min(0.16 * frame.width(), 0.3 * frame.height())};
}
vec2 inFigure(const FrameInfo& frame, double angle, double part) {
    const FigurePlace place = placeOf(frame);
    return place.foot + part * place.radius * vec2(std::sin(radians(angle)), std::cos(radians(angle)));
}

double matchingAt(Gpu& gpu, const Settings& s) {
    return gpu.matching.of({s.exponent, s.angle}, [&] { return matchingExponent(s.exponent, s.angle); });
}

static int wordHeight(const FrameInfo& frame) { return std::clamp(frame.height() / 40, leastWords, 15); }
static void label(Drawing& drawing, const FrameInfo& frame, const vec2& at, const std::string& text,
                  const vec4& color) {
    drawing.textAround(at, text, {wordHeight(frame), color, vec4(0)});
}

// Draw the surface, its normal, light and eye.
static void drawDirections(Drawing& drawing, const Settings& s, const FrameInfo& frame) {
    const auto at = [&](double angle, double part) { return inFigure(frame, angle, part); };
    const vec2 foot = placeOf(frame).foot;
    drawing.line(at(-90, 1.15), at(90, 1.15), {ink, 2});
    drawing.arrow(foot, at(0, 1.1), {grey});
    drawing.arrow(foot, at(-s.angle, 1.1), {{0.85, 0.6, 0.0, 1}, 2});
    drawing.arrow(foot, at(s.viewAngle, 1.1), {ink, 2});
    drawing.line(foot, at(s.angle, 1.1), {grey, 1});
    label(drawing, frame, at(0, 1.2), "n", grey);
    label(drawing, frame, at(-s.angle, 1.2), "l", {0.7, 0.5, 0.0, 1});
    label(drawing, frame, at(s.viewAngle, 1.2), "v", ink);
    label(drawing, frame, at(s.angle, 1.2), "r", grey);
}

// Draw what is sent into each direction: the farther out, the more.
static void drawLobes(Drawing& drawing, const Settings& s, const FrameInfo& frame, double matching) {
    const auto drawLobe = [&](const vec4& color, double width, const auto& sent) {
        std::vector<vec2> outline;
        for (int half = -180; half <= 180; ++half) outline.push_back(inFigure(frame, 0.5 * half, sent(0.5 * half)));
        drawing.line(outline, {color, width});
    };
    const auto sentTo = [&](double angle, Lobe by, double power) {
        return highlight(by, direction(0), direction(-s.angle), direction(angle), power);
    };
    drawLobe(grey, 1.5, [&](double) { return 0.5 * std::cos(radians(s.angle)); });
    drawLobe(red, 2, [&](double angle) { return sentTo(angle, Lobe::phong, s.exponent); });
    drawLobe(blue, 2, [&](double angle) { return sentTo(angle, Lobe::blinn, s.exponent); });
    drawLobe(blue, 1, [&](double angle) { return sentTo(angle, Lobe::blinn, matching); });
    const auto [foot, radius] = placeOf(frame);
    const int words = wordHeight(frame);
    label(drawing, frame, foot - vec2(0.75 * radius, 1.1 * words), "Lambert", grey);
    label(drawing, frame, foot - vec2(0.2 * radius, 1.1 * words), "Phong", red);
    label(drawing, frame, foot + vec2(0.6 * radius, -1.1 * words), "Blinn, and matching (thin)", blue);
}

static std::vector<vec2> ratiosFor(double exponent) {
    std::vector<vec2> ratios;
    for (int a = 0; a <= 80; a += 5) ratios.emplace_back(a, matchingExponent(exponent, a) / exponent);
    return ratios;
}

// Draw the exponent that matches, over the angle.
static void drawMatching(Gpu& gpu, const Settings& s, const FrameInfo& frame, double matching) {
    Drawing& drawing = gpu.drawing;
    const std::vector<vec2>& ratios = gpu.ratios.of({s.exponent}, [&] { return ratiosFor(s.exponent); });
    const vec2 size(frame.width(), frame.height());
    const Box box = frame.isUpright() ? Box{size * vec2(0.62, 0.12), size * vec2(0.96, 0.42)}
                                      : Box{size * vec2(0.64, 0.13), size * vec2(0.97, 0.44)};
    const Plot plot{
        box,
        {0, 80, frame.isUpright() ? "angle of the light, deg" : "angle of the light from the normal, degrees"},
        {0, 5, "Blinn's exponent / Phong's"}};
    std::vector<vec2> rule;
    for (int a = 0; a <= 80; a += 2) rule.emplace_back(a, 4 * std::cos(radians(a)));
    drawing.axes(plot);
    drawing.curve(plot, rule, {grey, 1});
    drawing.curve(plot, ratios, {blue, 2});
    label(drawing, frame, plot.pixel({18, 4.6}), "as strong", blue);
    label(drawing, frame, plot.pixel({45, 4.6}), "4 cos", grey);
    drawing.point(plot.pixel({s.angle, matching / s.exponent}), 8, blue);
}

// A needle along the normal of each corner.
static MeshData needlesOf(const MeshData& body) {
    MeshData lines{.primitive = Primitive::lines};
    for (std::size_t i = 0; i < body.positions.size(); ++i) {
        lines.positions.push_back(body.positions[i]);
        lines.positions.push_back(body.positions[i] + 0.2F * body.normals[i]);
    }
    return lines;
}

static void drawNormals(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Mesh& needles = gpu.needles.of({s.body, s.edges}, [&] { return Mesh(needlesOf(bodyOf(s)), "normals"); });
    gpu.plain->use();
    gpu.plain->set("clipFromBody", sceneOf(s, frame).clipFromWorld() * worldFromBody(s));
    gpu.plain->set("color", vec3(blue));
    drawWide(frame, [&] { needles.draw(); });
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    if (s.normals) drawNormals(gpu, s, frame);
    const double matching = matchingAt(gpu, s);
    gpu.drawing.begin(frame);
    drawDirections(gpu.drawing, s, frame);
    drawLobes(gpu.drawing, s, frame, matching);
    drawMatching(gpu, s, frame, matching);
    if (s.shading != Shading::own) {
        const mat4 clipFromWorld = sceneOf(s, frame).clipFromWorld();
        gpu.drawing.point(clipFromWorld, lampOf(s), 14, {1, 0.8, 0.2, 1});
        gpu.drawing.text(clipFromWorld, lampOf(s), {10, 6}, "lamp", {wordHeight(frame), ink, vec4(0)});
    }
    gpu.drawing.draw(frame);
}

}  // namespace mv::shading
