// The footprint of a pixel of texture-filter: the part of the texture that it covers, and the level that OpenGL takes for it.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "texture-filter.h"

namespace mv::texture_filter {

// The left part of the picture, and of one that is higher than wide the lower part.
Pane floorPane(const FrameInfo& frame) {
    if (frame.isUpright()) return {0, 0, frame.width(), std::max(1, frame.height() * 5 / 8)};
    return {0, 0, std::max(1, frame.width() * 5 / 8), frame.height()};
}
// A measured picture is the floor alone, in the whole frame.
Pane paneOf(const Frame& frame) {
    return frame.measuring() ? Pane{0, 0, frame.width(), frame.height()} : floorPane(frame);
}

// The place of the shown pixel, in pixels of the floor's pane.
vec2 pixelShown(const Settings& s, const FrameInfo& frame) {
    const Pane pane = floorPane(frame);
    const mat3 repeats = repeatsFromPixel(pane.width, pane.height, 0);
    const double horizon = -repeats[2].z / repeats[1].z;  // where the third component is 0
    return {s.pixelX * pane.width, s.pixelY * horizon};
}

Lookup lookupAt(const Settings& s, const FrameInfo& frame) {
    // Find how far the place in the texture moves with a pixel in x and in y of the picture
    const Pane pane = floorPane(frame);
    Lookup lookup{.repeats = repeatsFromPixel(pane.width, pane.height, s.turn)};
    const vec2 at = pixelShown(s, frame);
    lookup.pixel = vec2(std::min(std::floor(at.x), pane.width - 1.0), std::floor(at.y));
    lookup.footprint = footprintOf(lookup.repeats, lookup.pixel + 0.5);
    const double x = s.size * glm::length(lookup.footprint.acrossX), y = s.size * glm::length(lookup.footprint.acrossY);
    lookup.longer = std::max(x, y);
    lookup.shorter = std::min(x, y);

    // Take the level whose texels are as long as the longer of both, or as the part of it that each look covers
    const double parts = std::min(std::ceil(lookup.longer / lookup.shorter), double(looks(s)));
    lookup.level = std::log2(lookup.longer / parts) + s.bias;
    return lookup;
}

}  // namespace mv::texture_filter
