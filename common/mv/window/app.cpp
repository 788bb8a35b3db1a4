// The loop of the window: waits, hands on what the user did, and draws when there is something to draw.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

#include "mv/run/window_module.h"
#include "mv/show/caught.h"
#include "mv/window/demo_screen.h"
#include "mv/window/menu_screen.h"

namespace mv {
namespace {

// Dear ImGui lays out with what it knows of the frame before: after an event it takes this many to come to rest.
constexpr int framesToSettle = 3;
// How long to sleep while nothing happens; then the shader files are looked at.
constexpr double idleSeconds = 0.25;
// This holds the pace where the swap does not wait for the screen (it does not everywhere): 62 frames a second.
constexpr auto leastFrameTime = std::chrono::milliseconds(16);

// So often a window that does not come to rest is reported.
constexpr auto reportTime = std::chrono::seconds(1);

// Common to every screen: F11, and Ctrl with + and - and 0.
bool isOfTheWindow(Window& window, Gui& gui, const Event& event) {
    if (event.kind != Event::Kind::key) return false;
    if (event.key == GLFW_KEY_F11) {
        if (!event.repeat) window.toggleFullScreen();
        return true;
    }
    if ((event.modifiers & GLFW_MOD_CONTROL) == 0) return false;
    const char* name = glfwGetKeyName(event.key, event.scancode);
    const std::string sign = name ? name : "";
    if (event.key == GLFW_KEY_0 || event.key == GLFW_KEY_KP_0) {
        gui.setZoom(1);
    } else if (event.key == GLFW_KEY_KP_ADD || sign == "+" || sign == "=") {
        gui.setZoom(std::min(gui.zoom() * 1.125, 2.5));
    } else if (event.key == GLFW_KEY_KP_SUBTRACT || sign == "-") {
        gui.setZoom(std::max(gui.zoom() / 1.125, 0.6));
    } else if (sign == "l") {
        gui.setLight(!gui.light());
    } else {
        return false;
    }
    return true;
}

// Shows a screen until it wishes for another one, or the window closes. The window reports each time that what was done
// to it is handled and seen, so that a program that drives it knows when to go on.
Wish show(Window& window, Gui& gui, Screen& screen, bool reporting) {
    using Clock = std::chrono::steady_clock;
    gui.forgetPlaces();  // the screen before had them
    gui.setNavigation(false);
    const auto start = Clock::now();
    auto last = start, reported = start;
    int settling = framesToSettle;
    bool due = true;  // something happened since the last report
    WindowState state;
    Wish wish;
    const auto report = [&](bool closing) {
        if (!reporting) return;
        window.finish();  // what is reported can be seen
        state.seconds = std::chrono::duration<double>(last - start).count();
        state.hidden = window.hidden();
        state.closing = closing;
        state.size = window.size();
        state.inputs = window.inputs();
        screen.report(state);
        reported = Clock::now();
        due = !state.settled;
    };
    for (;;) {
        const bool hidden = window.hidden();
        const bool awake = !hidden && (settling > 0 || screen.moving() || screen.pending() || window.eventsLeft());
        for (const Event& event : window.waitForEvents(awake ? 0 : std::min(idleSeconds, gui.untilTip()))) {
            if (!isOfTheWindow(window, gui, event)) screen.handle(event);
            gui.feed(event);
            settling = framesToSettle;
            due = true;
        }
        if (!hidden && gui.untilTip() <= 0) {
            settling = std::max(settling, 2);  // a tooltip's size is known to its second frame
            due = true;
        }
        const auto now = Clock::now();
        if (!hidden && screen.advance(std::chrono::duration<double>(now - last).count())) {
            settling = std::max(settling, screen.moving() ? 1 : framesToSettle);
            due |= !screen.moving();
        }
        last = now;
        wish = screen.wish();
        if (window.closing()) wish = {Wish::Kind::quit};
        if (wish.kind != Wish::Kind::stay) break;
        const bool seen = !window.hidden();
        if (seen && (settling > 0 || screen.moving() || screen.pending())) {
            screen.draw();
            window.swap();
            ++state.frames;
            if (settling > 0) --settling;
        }
        // Nothing is drawn of a hidden window: it rests as it is.
        state.settled = !window.eventsLeft() && (!seen || (settling == 0 && !screen.pending()));
        const bool late = (due || screen.moving()) && Clock::now() - reported >= reportTime;
        if ((due && state.settled) || late) report(false);
        if (seen && (settling > 0 || screen.moving() || screen.pending()))
            std::this_thread::sleep_until(now + leastFrameTime);
    }
    state.settled = false;
    report(true);
    return wish;
}

void runWindow(const Command& command) {
    Window window;
    Gui gui(window);
    Cards cards;
    Stage stage(window, true);
    const bool menu = catalogue().size() > 1;
    Command next = command;
    std::string problem;
    for (bool first = true;; first = false) {
        std::unique_ptr<Screen> screen;
        if (next.demo) {
            try {
                screen = std::make_unique<DemoScreen>(window, gui, stage, next, menu, !first);
                cards.selected = next.demo->name;
            } catch (const std::exception&) {
                if (first) throw;  // asked for by name on the command line: no menu instead
                problem = caughtSentence("mvgl");
            }
        }
        if (!screen) screen = std::make_unique<MenuScreen>(window, gui, stage, cards, problem, command.report);
        problem.clear();
        const Wish wish = show(window, gui, *screen, command.report != ReportForm::none);
        screen.reset();
        try {
            stage.close();
        } catch (const std::exception&) {
            if (wish.kind == Wish::Kind::quit) throw;
            problem = caughtSentence("mvgl");
        }
        if (wish.kind == Wish::Kind::quit) return;
        next = {};
        next.report = command.report;
        next.program = command.program;
        next.demo = wish.kind == Wish::Kind::open ? wish.demo : nullptr;
    }
}

}  // namespace
}  // namespace mv

extern "C" __attribute__((visibility("default"))) void mvglWindowMain(const mv::Command& command) {
    mv::runWindow(command);
}
