// The window: GLFW, the OpenGL context in it, and what the user did to it.
#pragma once
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "mv/host/context.h"
#include "mv/window/window_size.h"

struct GLFWwindow;

namespace mv {

// One thing the user did, in the order it was done. Positions are window coordinates from the upper left corner: pixels
// where the window system does not scale.
struct Event {
    enum class Kind { key, keyUp, character, press, release, move, wheel, drop, other };
    Kind kind = Kind::other;
    int key = 0, scancode = 0, modifiers = 0;  // GLFW's; for a button of the mouse, its number is the key
    bool repeat = false;
    unsigned codePoint = 0;          // of a character
    double x = 0, y = 0;             // where the mouse was
    double across = 0, notches = 0;  // of the wheel; notches away from the user
    std::string file = {};           // that was dropped; of several each is an event
};

// The events that a window has been given so far, as far as frames have had them.
struct Inputs {
    long keys = 0, buttons = 0, wheel = 0;  // pressed, a repeated key each time; turns of the wheel
    int keysHeld = 0, buttonsHeld = 0;      // that are down
    double mouseX = 0, mouseY = 0;          // where the last event had the mouse, in window coordinates
};

// What a screen has for windows, in window coordinates.
struct WorkArea {
    int width = 0, height = 0;
};

class Window final : public Context {
  public:
    // Opens a window, still hidden, with a core context of the highest version the driver gives, and makes that
    // current. Error: no display, or a driver without OpenGL 3.3 (the message has the version it has).
    Window();
    ~Window() override;
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    std::string name() const override { return "window (GLFW)"; }
    void* address(const char* function) const override;

    GLFWwindow* handle() const { return handle_; }
    void setTitle(const std::string& title);
    // Asks for an inner size in window coordinates, and shows the window. A maximised window stays as it is.
    // With `fit`, never larger than the screen.
    void show(int width, int height, bool fit);
    // Of the first screen; nothing where the window system does not tell.
    std::optional<WorkArea> workArea() const;
    // Over the whole screen, or back to where it was.
    void toggleFullScreen();
    void copyToClipboard(const std::string& text);

    // Its size as of the last waitForEvents: the same in all of a frame.
    const WindowSize& size() const { return size_; }
    // Pixels for each pixel of a screen of ordinary density: what words and widgets are to grow by.
    double contentScale() const { return contentScale_.value(); }
    // Nothing can be seen of it: minimised, or without a pixel.
    bool hidden() const;
    bool closing() const;

    // Waits until something happens, for at most so many seconds (0: not at all); returns what did, as much of it as
    // belongs into one frame. A key that is pressed and let go between two frames is pressed in the first and let go in
    // the second: widgets look at states, and would miss it.
    std::vector<Event> waitForEvents(double seconds);
    // Whether there are more for the next frame.
    bool eventsLeft() const;
    // The events that frames have had, the last one included.
    const Inputs& inputs() const { return inputs_; }
    void swap();
    // Returns when the display has done all that was asked of it: what was swapped is seen.
    void finish();

  private:
    friend struct WindowCallbacks;
    void open();
    void count(const Event& event);
    GLFWwindow* handle_ = nullptr;
    WindowSize size_;
    Believed contentScale_{"the screen's scale"};
    std::deque<Event> events_;  // that no frame has had yet
    Inputs inputs_;
    double mouseX_ = 0, mouseY_ = 0;
    struct Rectangle {
        int x = 0, y = 0, width = 640, height = 480;
    } before_;  // the full screen
};

}  // namespace mv
