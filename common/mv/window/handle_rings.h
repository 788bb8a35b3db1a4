// The hand in the picture, shown in the window: rings round what can be dragged.
#pragma once
#include <optional>
#include <string>

#include "mv/show/handle_input.h"
#include "mv/window/gui.h"

namespace mv {

// The place of the picture in the window: its upper left corner is the window's.
struct PictureInWindow {
    int height;            // pixels
    double pixelsPerUnit;  // of window coordinates
    vec2 pixel(double x, double y) const { return {x * pixelsPerUnit, height - y * pixelsPerUnit}; }
    vec2 window(const vec2& pixel) const { return {pixel.x / pixelsPerUnit, (height - pixel.y) / pixelsPerUnit}; }
};

// So near to a handle, in pixels of the picture, the mouse takes it.
double handReach(const Gui& gui, const PictureInWindow& picture);

// The move of a key of GLFW: Tab picks, the arrows move, Insert makes one more, Delete takes one away, Escape lets go.
std::optional<HandleInput::Move> handleMove(int glfwKey);

// Rings round the handles while the mouse is over the picture or one is picked, and a hand for the mouse that is on one.
// Returns the name of the one that the mouse is on, or that is held or picked; "" for none.
std::string showHandles(HandleInput& hand, const Demo& demo, const FrameInfo& frame, const PictureInWindow& picture,
                        bool mouseOver, const Gui& gui);

}  // namespace mv
