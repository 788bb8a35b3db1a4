// Handles: what is dragged in the picture itself. A handle is a place in the picture that follows from knobs; who drags it moves
// those knobs, so that it comes to the pointer. No demo computes the way back from a pixel.
#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/frame.h"
#include "mv/demo/knob.h"

namespace mv {

// Places in the picture, in pixels from its lower left corner: of a pixel of a pane, and of a point in space as that pane's
// projection draws it. The latter is nothing at or behind the eye.
vec2 pictureFromPane(const Pane& pane, const vec2& pixel);
std::optional<vec2> pictureFromPane(const Pane& pane, const mat4& clipFromModel, const vec3& point);

struct Handle {
    std::string name;          // "light"
    std::vector<Knob*> knobs;  // those that it moves
    // How many of them there are, by these knobs; the coordinates that move one; and where it is in the picture that the frame
    // describes, pixels from the lower left corner: a function of the knobs, the frame's index and its size, and of nothing else.
    // Nothing where the present settings have no such place.
    std::function<std::size_t()> count = {};
    std::function<std::vector<Coordinate>(std::size_t)> coordinates = {};
    std::function<std::optional<vec2>(const FrameInfo&, std::size_t)> where = {};
    // Makes one more after that one, at the same place, or takes it away; false where it cannot. None where there is one alone.
    std::function<bool(std::size_t)> add = {}, remove = {};

    // Moves one so that it is as near to that pixel of the picture as its coordinates let it come, which stop at the ends of their
    // ranges, and are rounded to their grid, or to as few digits as leave it within about a pixel. Of several ways the shortest is taken, all
    // coordinates measured alike: three in space move it across the line of sight. True when a knob has moved.
    bool drag(const FrameInfo& frame, std::size_t which, const vec2& pixel) const;
};

}  // namespace mv
