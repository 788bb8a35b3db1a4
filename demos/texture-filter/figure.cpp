// Beside the picture of texture-filter: the texture under the pixel that is shown, and the level that is read for it.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <utility>
#include <vector>

#include "mv/formatted.h"
#include "mv/gl/gl.h"
#include "mv/gl/word_size.h"
#include "texture-filter.h"

namespace mv::texture_filter {
namespace {

const vec4 red(0.8, 0.1, 0.1, 1), blue(0.1, 0.35, 0.8, 1);

// The pixel's corners on the floor, in repeats; the first again at the end.
std::vector<vec2> cornersOf(const Lookup& lookup) {
    std::vector<vec2> corners;
    for (const vec2& corner : {vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 1), vec2(0, 0)}) {
        const vec3 at = lookup.repeats * vec3(lookup.pixel + corner, 1);
        corners.push_back(vec2(at) / at.z);
    }
    return corners;
}

// The part of the texture around them, with room for a texel and a half at least of the level that is read.
Box partShown(const Lookup& lookup, const std::vector<vec2>& corners, int texelsAlong, double aspect) {
    vec2 reach(0.75 / texelsAlong);
    for (const vec2& corner : corners) reach = glm::max(reach, 1.4 * glm::abs(corner - lookup.footprint.middle));
    reach = std::max(reach.x / aspect, reach.y) * vec2(aspect, 1);
    return {lookup.footprint.middle - reach, lookup.footprint.middle + reach};
}

void drawTexels(Gpu& gpu, const FrameInfo& frame, const Pane& pane, const Box& part, int texelsAlong,
                const Lookup& lookup, const std::vector<vec2>& corners) {
    Drawing& drawing = gpu.drawing;
    const auto [x, y, width, height] = frame.pixels(pane);
    glViewport(x, y, width, height);
    gpu.cover.draw();
    drawing.in(pane);
    const auto plotOf = [&](double times) {
        return Plot{{{0, 0}, {pane.width, pane.height}},
                    {times * part.low.x, times * part.high.x},
                    {times * part.low.y, times * part.high.y}};
    };
    if (pane.height > 8 * part.size().y * texelsAlong)
        drawing.pixelGrid(plotOf(texelsAlong), {vec4(0.5, 0.5, 0.5, 0.7), 1});
    const Plot plot = plotOf(1);
    std::vector<vec2> outline;
    outline.reserve(corners.size());
    for (const vec2& corner : corners) outline.push_back(plot.pixel(corner));
    drawing.line(outline, {red, 2.5});
    const Footprint& print = lookup.footprint;
    const vec2 axis = glm::length(print.acrossX) > glm::length(print.acrossY) ? print.acrossX : print.acrossY;
    drawing.line(plot.pixel(print.middle - 0.5 * axis), plot.pixel(print.middle + 0.5 * axis), {blue, 2});
}

// Above each other right of the floor; in a picture that is higher than wide beside each other, above it.
std::pair<Pane, Pane> texelPanes(const FrameInfo& frame) {
    const Pane floor = floorPane(frame);
    if (frame.isUpright()) {
        const int y = floor.height + 4, height = std::max(1, frame.height() - y),
                  half = std::max(1, frame.width() / 2 - 2);
        return {{0, y, half, height}, {frame.width() - half, y, half, height}};
    }
    const int x = floor.width + 4, width = std::max(1, frame.width() - x), half = std::max(1, frame.height() / 2 - 2);
    return {{x, frame.height() - half, width, half}, {x, 0, width, half}};
}

void drawWords(Drawing& drawing, const std::string& title, const std::string& foot, int paneHeight) {
    const int height = std::clamp(paneHeight / 16, leastWords, 20);
    drawing.text({6, paneHeight - 6}, title, {.height = height});
    drawing.text({6, 1.8 * height}, foot, {.height = height});
}

}  // namespace

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Lookup lookup = lookupAt(s, frame.inPixels());  // of a pixel
    const double clamped = std::clamp(lookup.level, 0.0, gpu.image->levels() - 1.0);
    const bool between = s.filter >= Filter::trilinear && clamped != std::floor(clamped);
    const int read = isMipmapped(s) ? static_cast<int>(s.filter >= Filter::trilinear ? std::floor(clamped)
                                                                                     : std::ceil(clamped - 0.5))
                                    : 0;
    Drawing& drawing = gpu.drawing;
    drawing.begin(frame);

    // Show what the pixel covers, and below it what is read
    const Pane left = floorPane(frame);
    const auto [covered, readFrom] = texelPanes(frame);
    const int width = readFrom.width, half = readFrom.height;
    const std::vector<vec2> corners = cornersOf(lookup);
    const Box part = partShown(lookup, corners, std::max(1, s.size >> read), double(width) / half);
    const Program& program = *gpu.texelProgram;
    program.use();
    program.set("encoded", s.average == Average::encoded);
    program.set("low", part.low - glm::floor(part.low));  // near 0, where floats are fine
    program.set("high", part.high - glm::floor(part.low));
    program.set("pixel", part.size() / (frame.scale() * vec2(width, half)));
    program.set("level", 0);
    drawTexels(gpu, frame, covered, part, s.size, lookup, corners);
    drawWords(drawing, "level 0: what the pixel covers",
              formatted("%.3g", lookup.longer) + formatted(" x %.3g texels", lookup.shorter), half);
    if (read > 0) program.set("level", read);
    drawTexels(gpu, frame, readFrom, part, std::max(1, s.size >> read), lookup, corners);
    drawWords(drawing, "level " + std::to_string(read) + ": what is read",
              between          ? formatted("and %.0f %% of the next", 100 * (clamped - read))
              : isMipmapped(s) ? formatted("the footprint's is %.2f", lookup.level)
                               : std::string("the only level"),
              half);

    // Mark the pixel, and name the filter
    drawing.in(left);
    const vec2 at = (lookup.pixel + 0.5) / frame.scale();
    drawing.line(
        std::vector<vec2>{at + vec2(-6, -6), at + vec2(6, -6), at + vec2(6, 6), at + vec2(-6, 6), at + vec2(-6, -6)},
        {red, 2});
    drawing.text({8, left.height - 8}, nameOf(s.filter) + (looks(s) > 1 ? " " + std::to_string(looks(s)) : ""),
                 {.height = std::clamp(frame.height() / 32, leastWords, 22) * 5 / 4});
    const FrameInfo inPixels = frame.inPixels();
    glViewport(0, 0, inPixels.width(), inPixels.height());
    drawing.draw(frame);
}

void tell(const Settings& s, const Frame& frame) {
    if (frame.measuring()) return;
    if (s.filter == Filter::anisotropic && looks(s) < s.anisotropy && looks(s) > 1)
        frame.say("This driver looks " + std::to_string(looks(s)) + " times along a footprint at most.");
    constexpr std::array<int, 6> texelsOf{1, 4, 1, 4, 8, 8};
    frame.count("texels a lookup, at most", texelsOf.at(static_cast<std::size_t>(s.filter)) * looks(s));
}

}  // namespace mv::texture_filter
