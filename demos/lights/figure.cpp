// The scene of lights, and the drawing over it: lamps, the mark, a table of the light there, and the falloff's graph.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "lights.h"
#include "mv/demo/handle.h"
#include "mv/formatted.h"
#include "mv/geometry/plot.h"
#include "mv/gl/word_size.h"
#include "mv/math/transform.h"
#include "shared/scenes.h"

namespace mv::lights {

bool isLamp(Kind kind) { return kind == Kind::point || kind == Kind::spot; }
bool hasPlace(Kind kind) { return isLamp(kind) || kind == Kind::directional; }
bool isOn(const Settings& s, Kind kind) { return std::ranges::find(s.kinds, kind) != s.kinds.end(); }
vec3 aim(const Settings& s) { return {s.aim.x, 0, s.aim.y}; }
vec3 marked(const Settings& s) { return {s.mark.x, 0, s.mark.y}; }

// The scene on the left; words and the graph on the right.
// In a picture that is higher than wide above them.
Pane paneOf(const FrameInfo& frame) {
    const int high = std::max(1, frame.height() * 12 / 20);
    if (frame.isUpright()) return {0, frame.height() - high, frame.width(), high};
    return {0, 0, std::max(1, frame.width() * 13 / 20), frame.height()};
}
// A quantity is measured all over.
Pane drawnPane(const Frame& frame) {
    return frame.measuring() ? Pane{0, 0, frame.width(), frame.height()} : paneOf(frame);
}

// The still life, and the lamps for who looks at the scene: a spot has an aim.
Scene sceneOf(const Settings& s, const FrameInfo& frame) {
    Scene scene = stillLife(paneOf(frame).aspect());
    scene.lights.clear();
    for (std::size_t i = 0; i < lightCount; ++i) {
        if (!hasPlace(s.kinds[i])) continue;
        SceneLight light{.position = vec4(placeOf(s, i), 1), .color = strength(s, i)};
        if (s.kinds[i] == Kind::directional) light.position = vec4(towardsSun(s, i), 0);
        if (s.kinds[i] == Kind::spot) light.aim = axisOf(s, i);
        scene.lights.push_back(light);
    }
    return scene;
}

namespace {

const vec4 ink(0.1, 0.1, 0.1, 1), grey(0.62, 0.62, 0.62, 1), blue(0.1, 0.35, 0.75, 1), red(0.75, 0.15, 0.1, 1);

double unitOf(const FrameInfo& frame) { return std::min(frame.width() / 960.0, frame.height() / 540.0); }
TextStyle style(double unit, const vec4& color, const vec4& background = vec4(0)) {
    return {std::max(leastWords, static_cast<int>(15 * unit)), color, background};
}

// The outer cone, 0.4 long.
void drawCone(Drawing& drawing, const Settings& s, std::size_t light, const mat4& clipFromWorld) {
    const vec3 at = placeOf(s, light);
    const mat4 worldFromLamp = inverse(lookAtAnyRoll(at, aim(s)));
    const Stroke stroke{vec4(tinted(s.lightColor, hues.at(light)), 1), 1.5};
    constexpr int corners = 16;
    std::vector<vec3> rim;
    for (int k = 0; k <= corners; ++k) {
        const double turn = 2 * std::acos(-1.0) * k / corners, wide = 0.4 * std::sin(radians(s.outer));
        rim.emplace_back(worldFromLamp *
                         vec4(wide * std::cos(turn), wide * std::sin(turn), -0.4 * std::cos(radians(s.outer)), 1));
        if (k > 0) drawing.edge(clipFromWorld, rim[rim.size() - 2], rim.back(), stroke);
        if (k % 4 == 0) drawing.edge(clipFromWorld, at, rim.back(), stroke);
    }
}

void drawLight(Drawing& drawing, const Settings& s, const FrameInfo& frame, std::size_t light,
               const mat4& clipFromWorld) {
    const double unit = unitOf(frame);
    const vec4 color(tinted(s.lightColor, hues.at(light)), 1);
    const vec3 at = placeOf(s, light);
    if (s.kinds[light] == Kind::directional) {
        const Pane pane{0, 0, paneOf(frame).width, paneOf(frame).height};
        const auto inPane = [&](const vec3& point) { return pictureFromPane(pane, clipFromWorld, point); };
        const auto from = inPane(at), to = inPane(at - 0.5 * towardsSun(s, light));
        if (from && to) drawing.arrow(*from, *to, {color, 4 * unit});
    }
    if (s.kinds[light] == Kind::spot) drawCone(drawing, s, light, clipFromWorld);
    drawing.point(clipFromWorld, at, 17 * unit, vec4(0.1, 0.1, 0.1, 1));
    drawing.point(clipFromWorld, at, 13 * unit, color);
    drawing.text(clipFromWorld, at, vec2(9, 9) * unit, std::to_string(light + 1),
                 style(unit, vec4(1), vec4(0, 0, 0, 0.4)));
}

void drawCross(Drawing& drawing, const mat4& clipFromWorld, const vec3& at, const vec4& color) {
    drawing.edge(clipFromWorld, at - vec3(0.1, -0.003, 0), at + vec3(0.1, 0.003, 0), {color, 3});
    drawing.edge(clipFromWorld, at - vec3(0, -0.003, 0.1), at + vec3(0, 0.003, 0.1), {color, 3});
}

// A table of what each light gives to the mark; in `room` pixels there may be some for those alone that are on.
void drawTable(Drawing& drawing, const Settings& s, const Pane& pane, double room, double unit) {
    const double line = std::max(20 * unit, leastWords + 3.0);
    const bool isRoomForAll = (lightCount + 2) * line < room;
    double y = pane.height - 8 * unit;
    const auto say = [&](const std::string& words, const vec4& color) {
        drawing.text({12 * unit, y}, words, style(unit, color));
        y -= line;
    };
    say("Light at the red mark", red);
    for (std::size_t i = 0; i < lightCount; ++i) {
        const vec3 light = arriving(s, i, marked(s), {0, 1, 0});
        std::string words = std::to_string(i + 1) + " " + nameOf(s.kinds[i]);
        if (isLamp(s.kinds[i])) words += formatted(", %.2f m", glm::distance(placeOf(s, i), marked(s)));
        if (s.kinds[i] == Kind::off && !isRoomForAll) continue;
        if (s.kinds[i] != Kind::off) words += formatted(": %.3f", (light.x + light.y + light.z) / 3);
        say(words, s.kinds[i] == Kind::off ? grey : ink);
    }
    say(formatted("sum %.3f", lightAtMark(s)) + formatted(", stored as %.0f", stored(lightAtMark(s))), ink);
}

void drawCurves(Drawing& drawing, const Settings& s, const Plot& plot) {
    const Falloff chosen = falloff(s), physical{.size = 1e-9};
    std::vector<vec2> chosenCurve, physicalCurve;
    for (int i = 0; i <= 400; ++i) {
        const double d = plot.value(plot.box.low + vec2(plot.box.size().x * i / 400, 0)).x;
        chosenCurve.emplace_back(d, s.power * chosen.at(d));
        if (d > 1e-6) physicalCurve.emplace_back(d, s.power * physical.at(d));
    }
    drawing.curve(plot, physicalCurve, {grey, 5});
    drawing.curve(plot, chosenCurve, {blue, 2});
    if (reach(s) > plot.x.low && reach(s) < plot.x.high) {
        const double x = plot.pixel({reach(s), plot.y.high}).x;
        drawing.line({x, plot.box.low.y}, {x, plot.box.high.y}, {red, 1.5});
    }
}

// The lamps on their curve, each at its distance from the mark.
void drawLamps(Drawing& drawing, const Settings& s, const Plot& plot, double unit) {
    for (std::size_t i = 0; i < lightCount; ++i) {
        if (!isLamp(s.kinds[i])) continue;
        const double d = glm::distance(placeOf(s, i), marked(s));
        const vec2 value(d, s.power * falloff(s).at(d));
        if (value.x < plot.x.low || value.x > plot.x.high || value.y < plot.y.low || value.y > plot.y.high) continue;
        drawing.point(plot.pixel(value), 11 * unit, ink);
        drawing.point(plot.pixel(value), 8 * unit, vec4(tinted(s.lightColor, hues.at(i)), 1));
    }
}

void drawGraph(Drawing& drawing, const Settings& s, const Pane& pane, double high, double unit) {
    const double left = std::min(58.0, pane.width / 5.0), low = std::min(52.0, pane.height / 8.0);
    const Box box{{left, low}, {pane.width - 14 * unit - 0.5, high}};
    const Plot plot{box,
                    {s.logLog ? 0.01 : 0, s.logLog ? 10.0 : 4.0, "distance, m", s.logLog},
                    {s.logLog ? 1e-3 * s.power : 0, (s.logLog ? 1e4 : 3) * s.power, "light", s.logLog}};
    drawCurves(drawing, s, plot);
    drawLamps(drawing, s, plot, unit);
    drawing.axes(plot);
    const double words = left + 0.5 * box.size().x, line = std::max(20 * unit, leastWords + 3.0);
    drawing.text({words, box.high.y}, "falloff chosen", style(unit, blue));
    drawing.text({words, box.high.y - line}, "1/d^2", style(unit, grey));
    if (std::isfinite(reach(s))) drawing.text({words, box.high.y - 2 * line}, "cut off", style(unit, red));
}

}  // namespace

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    Drawing& drawing = gpu.drawing;
    const mat4 clipFromWorld = sceneOf(s, frame).clipFromWorld();
    drawing.begin(frame);
    drawing.in(paneOf(frame));
    for (std::size_t i = 0; i < lightCount; ++i) {
        if (hasPlace(s.kinds[i])) drawLight(drawing, s, frame, i, clipFromWorld);
    }
    drawCross(drawing, clipFromWorld, marked(s), red);
    if (isOn(s, Kind::spot)) drawCross(drawing, clipFromWorld, aim(s), vec4(1, 1, 1, 1));

    // Table and graph share what is beside the scene: one above the other, and below the scene side by side
    const Pane scene = paneOf(frame);
    const bool isBelow = frame.isUpright();
    const Pane rest = isBelow ? Pane{0, 0, frame.width(), std::max(1, scene.y)}
                              : Pane{scene.width, 0, std::max(1, frame.width() - scene.width), frame.height()};
    drawing.in(rest);
    drawing.fill({vec2(0), vec2(rest.width, rest.height)}, vec4(1, 1, 1, 1));
    const double high = isBelow ? rest.height : 0.5 * rest.height;
    drawTable(drawing, s, rest, high, unitOf(frame));
    const int left = isBelow ? rest.width / 2 : 0;
    const Pane graph{rest.x + left, rest.y, std::max(1, rest.width - left), rest.height};
    drawing.in(graph);
    drawGraph(drawing, s, graph, isBelow ? high - 30 * unitOf(frame) - leastWords : high, unitOf(frame));
    drawing.draw(frame);
}

}  // namespace mv::lights
