// Below the picture of bump-map: the maps, the angle of sight, the lamp. In it: the methods' names, and the ring that is measured.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "bump-map.h"
#include "mv/gl/gl.h"
#include "mv/gl/word_size.h"
#include "shared/strip.h"

namespace mv::bump_map {
namespace {

const vec4 ink(0.1, 0.1, 0.1, 1), blue(0.1, 0.3, 0.75, 1);

double reach(const FrameInfo& frame) { return 0.10 * std::min(1.0 * frame.height(), 0.8 * frame.width()); }
vec2 inStrip(const FrameInfo& frame, double part) { return {part * frame.width(), 0.125 * frame.height()}; }

void drawMap(Gpu& gpu, ReliefBody body, const Frame& frame, int unit, const char* name, int words) {
    const double wide = 2 * reach(frame), high = body == ReliefBody::wall ? wide : wide / 2;
    const vec2 corner = inStrip(frame, 0.02) + vec2(unit * 1.2, -0.5) * wide;
    const auto [x, y, width, height] =
        frame.pixels({static_cast<int>(corner.x), static_cast<int>(corner.y), std::max(1, static_cast<int>(wide)),
                      std::max(1, static_cast<int>(high))});
    glViewport(x, y, width, height);
    gpu.mapProgram->set("image", unit);
    gpu.mapProgram->set("isAlpha", unit == 0);
    gpu.sheet->draw();
    if (words > 0) gpu.drawing.text(corner + vec2(0, high + 1.5 * words), name, {words, ink, vec4(0)});
}

// The place on the orange that is seen at that angle.
void drawRing(Drawing& drawing, const Pane& left, double angle) {
    const vec2 size(left.width, left.height);
    const double r = 0.5 * std::min(size.x, size.y) / 1.1 * std::sin(radians(angle));
    std::vector<vec2> ring;
    for (int i = 0; i <= 96; ++i) ring.push_back(0.5 * size + r * vec2(std::cos(pi * i / 48), std::sin(pi * i / 48)));
    drawing.line(ring, {blue, 1});
}

void drawName(Drawing& drawing, const Frame& frame, const Pane& pane, Method shown, int words) {
    constexpr std::array<const char*, 6> titles{"no bumps", "bumps by the height map", "bumps by the normal map",
                                                "parallax", "parallax occlusion",      "really displaced"};
    drawing.in(pane);
    if (words > 0) drawWords(drawing, frame, pane, 0, {{titles.at(static_cast<std::size_t>(shown)), ink}});
}

}  // namespace

SightFigure sightFigure(const FrameInfo& frame) {
    return {inStrip(frame, 0.58) - vec2(0, reach(frame)), 1.75 * reach(frame)};
}
LampDial lampDial(const FrameInfo& frame) { return {inStrip(frame, 0.84), reach(frame)}; }

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    Drawing& drawing = gpu.drawing;
    drawing.begin(frame);
    // No words where they have no room
    const int size = std::clamp(std::min(frame.height() / 36, frame.width() / 50), leastWords, 16);
    const int words = textWidth("height map", {size}) < 2.4 * reach(frame) ? size : 0;
    gpu.mapProgram->use();
    drawMap(gpu, s.body, frame, 0, "height map", words);
    if (usesNormals(s.method)) drawMap(gpu, s.body, frame, 1, "normal map", words);
    const FrameInfo inPixels = frame.inPixels();
    glViewport(0, 0, inPixels.width(), inPixels.height());
    sightFigure(frame).draw(drawing, s.angle, words);
    lampDial(frame).draw(drawing, towardsLamp(s), words);

    const Pane left = leftPane(s, frame);
    drawName(drawing, frame, left, s.method, words);
    if (s.body == ReliefBody::orange) drawRing(drawing, left, s.angle);
    if (showsBoth(s)) drawName(drawing, frame, rightPane(frame), Method::displaced, words);
    drawing.draw(frame);
}

}  // namespace mv::bump_map
