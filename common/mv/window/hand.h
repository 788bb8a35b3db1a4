// The hand in the picture: a demo's handles, found by the mouse or the Tab key, and moved.
#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/window/gui.h"

namespace mv {

// Where the picture is in the window: its upper left corner is the window's.
struct PictureInWindow {
    int height;            // pixels
    double pixelsPerUnit;  // of window coordinates
    vec2 pixel(double x, double y) const { return {x * pixelsPerUnit, height - y * pixelsPerUnit}; }
    vec2 window(const vec2& pixel) const { return {pixel.x / pixelsPerUnit, (height - pixel.y) / pixelsPerUnit}; }
};

class Hand {
  public:
    explicit Hand(Gui& gui) : gui_(gui) {}

    // A button goes down there, in window coordinates: true when a handle is there, which is held from then on.
    bool press(Demo& demo, const FrameInfo& frame, const PictureInWindow& picture, double x, double y);
    // The mouse has moved: true when a knob has.
    bool move(Demo& demo, const FrameInfo& frame, const PictureInWindow& picture, double x, double y);
    void release() { held_.reset(); }
    bool holds() const { return held_.has_value(); }

    // Tab picks one handle after the other, and then none; the arrows move the one that is picked by a pixel, by ten
    // with Shift; Escape lets it go. Insert makes one more after the one that is picked or under the mouse, where there
    // can be more, and Delete takes that one away. True when the key was for this.
    bool key(Demo& demo, const FrameInfo& frame, int glfwKey, bool shift, bool& moved);

    // Rings round the handles while the mouse is over the picture or one is picked, and a hand for the mouse that is on one.
    void show(const Demo& demo, const FrameInfo& frame, const PictureInWindow& picture, bool mouseOver);
    // The one that the mouse was on when it was last shown, or that is held or picked; "" for none.
    const std::string& hovered() const { return hovered_; }

  private:
    struct Grip {
        std::size_t handle, which;
        bool operator==(const Grip&) const = default;
    };
    struct Held {
        Grip grip;
        vec2 offset;  // from the pointer to the place, pixels
    };
    struct Place {
        Grip grip;
        vec2 at;  // pixels of the picture
    };
    // Those that are inside of the picture.
    std::vector<Place> placesOf(const Demo& demo, const FrameInfo& frame) const;
    std::optional<Place> nearest(const Demo& demo, const FrameInfo& frame, const PictureInWindow& picture, double x,
                                 double y) const;
    std::string nameOf(const Demo& demo, const Grip& grip) const;

    Gui& gui_;
    std::optional<Held> held_;
    std::optional<Grip> picked_, under_;  // by the Tab key; by the mouse, when it was last shown
    std::string hovered_;
};

}  // namespace mv
