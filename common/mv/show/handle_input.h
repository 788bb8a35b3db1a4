// The hand in the picture: a demo's handles, found by a pointer or one after the other, and moved. Places are in pixels from the
// picture's lower left corner.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/demo.h"

namespace mv {

class HandleInput {
  public:
    // A handle that has a place inside of the picture.
    struct Place {
        std::string name;  // "light", or of several "light 2"
        vec2 at;
        bool active;  // held, picked or under the pointer
    };
    // The moves by keys: pick the next one, and after the last none; make one more after the one that is picked or
    // under the pointer, or take that away; let the picked one go; move it.
    enum class Move { next, more, less, letGo, left, right, up, down };

    // A button goes down there: true when a handle is within `reach` of it, which is held from then on.
    bool press(const Demo& demo, const FrameInfo& frame, const vec2& pointer, double reach);
    // The pointer has moved: true when a knob has.
    bool drag(Demo& demo, const FrameInfo& frame, const vec2& pointer);
    void release() { held_.reset(); }
    bool holds() const { return held_.has_value(); }
    bool picks() const { return picked_.has_value(); }
    // The pointer's place while it holds nothing; nothing: not over the picture.
    void hover(const Demo& demo, const FrameInfo& frame, const std::optional<vec2>& pointer, double reach);
    bool isOver() const { return under_.has_value(); }

    // Moves by a pixel, or by ten where `far`. True when the key was for this; `moved`: and a knob has moved.
    bool key(Demo& demo, const FrameInfo& frame, Move move, bool far, bool& moved);

    std::vector<Place> places(const Demo& demo, const FrameInfo& frame) const;

  private:
    struct Grip {
        std::size_t handle, which;
        bool operator==(const Grip&) const = default;
    };
    struct Held {
        Grip grip;
        vec2 offset;  // from the pointer to the place
    };
    struct Found {
        Grip grip;
        vec2 at;
    };
    static std::vector<Found> found(const Demo& demo, const FrameInfo& frame);
    static std::optional<Found> nearest(const Demo& demo, const FrameInfo& frame, const vec2& pointer, double reach);
    bool pickNext(const Demo& demo, const FrameInfo& frame);
    bool changeNumber(const Demo& demo, const FrameInfo& frame, bool more, bool& moved);

    std::optional<Held> held_;
    std::optional<Grip> picked_, under_;  // by a key; by the pointer, when it was last told
};

}  // namespace mv
