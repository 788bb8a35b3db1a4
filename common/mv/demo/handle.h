// Handles: what is dragged in the picture itself. A handle is a place in the picture that is computed from knobs. Whoever
// drags it moves those knobs until the place is under the pointer. A lesson gives the place (LessonHandle::where), and computes
// no way back from a pixel.
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
    // `count`: how many of them there are. `coordinates`: the numbers that move one of them. `where`: the place of one in
    // the picture that the frame describes, in pixels from the lower left corner; it depends on the knobs, the frame's
    // index and its size alone, and is empty where the present settings have no such place.
    std::function<std::size_t()> count = {};
    std::function<std::vector<Coordinate>(std::size_t)> coordinates = {};
    std::function<std::optional<vec2>(const FrameInfo&, std::size_t)> where = {};
    // `add` makes one more behind that one, at the same place; `remove` takes it away. Both return false where they
    // cannot. Empty where there are always as many.
    std::function<bool(std::size_t)> add = {}, remove = {};

    // Moves one as near to that pixel of the picture as its coordinates allow. These stop at the ends of their ranges, and
    // are rounded: to their grid, or to as few digits as leave the place within about a pixel. The shortest of several
    // ways is taken, with all coordinates measured alike: a place with three of them moves across the line of sight.
    // Returns whether a knob has moved.
    bool drag(const FrameInfo& frame, std::size_t which, const vec2& pixel) const;
};

}  // namespace mv
