// A screen of the window: the menu, or a demo. The loop in app.cpp shows one after the other.
#pragma once
#include "mv/demo/demo.h"
#include "mv/window/window.h"

namespace mv {

// The screen to come after this one.
struct Wish {
    enum class Kind { stay, menu, open, quit };
    Kind kind = Kind::stay;
    const DemoInfo* demo = nullptr;  // to open
};

// How far the window has come, for the report.
struct WindowState {
    long frames = 0;     // that were drawn of the screen
    double seconds = 0;  // that the screen was given, up to what it shows now
    // Everything that was done to the window is handled and seen; nothing more changes, but for an animation.
    bool settled = false;
    bool hidden = false;
    bool closing = false;  // the screen's last report
    WindowSize size;
    Inputs inputs;
};

class Screen {
  public:
    Screen() = default;
    virtual ~Screen() = default;
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    virtual void handle(const Event& event) = 0;
    // Lets time pass, a visible window's only; true when something is to be drawn anew for it.
    virtual bool advance(double seconds) = 0;
    // Whether it goes on by itself, as an animation does: if not, the loop sleeps until something happens.
    virtual bool moving() const = 0;
    // Whether what is shown is not yet what is to be shown.
    virtual bool pending() const = 0;
    // Draws into the window's framebuffer, the widgets included.
    virtual void draw() = 0;
    // Prints the report, where one was asked for.
    virtual void report(const WindowState& state) = 0;

    Wish wish() const { return wish_; }

  protected:
    Wish wish_;
};

}  // namespace mv
