#include "mv/window/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <utility>

#include "mv/error.h"
#include "mv/gl/functions.h"
#include "mv/gl/version.h"

namespace mv {
namespace {

std::string lastProblem;
bool trying = false;  // a failed attempt is expected and told later, if at all

void onProblem(int, const char* text) {
    lastProblem = text;
    if (!trying) std::cerr << "window: " << text << "\n";
}

// With a core context of that version, or 0: whatever the driver has.
GLFWwindow* makeWindow(int version) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    // The demo has its own buffers; the window only shows them.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "mvgl");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "mvgl");
    if (version != 0) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, version / 10);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, version % 10);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    }
    return glfwCreateWindow(640, 480, "mvgl", nullptr, nullptr);
}

// The version of OpenGL where there is no 3.3, in the driver's words.
std::string versionFound() {
    GLFWwindow* any = makeWindow(0);
    if (!any) return "none (" + lastProblem + ")";
    glfwMakeContextCurrent(any);
    const auto getString = reinterpret_cast<PFNGLGETSTRINGPROC>(glfwGetProcAddress("glGetString"));
    const auto text = getString ? reinterpret_cast<const char*>(getString(GL_VERSION)) : nullptr;
    std::string version = text ? text : "unknown";
    glfwDestroyWindow(any);
    return version;
}

// Asks what only the X server can answer, which it does after all that it was told before.
void roundTrip(GLFWwindow* handle) {
    int width = 0;
    glfwGetWindowSize(handle, &width, nullptr);
}

}  // namespace

// GLFW's callbacks: each notes the event, to be handed on in its frame.
struct WindowCallbacks {
    static Window& of(GLFWwindow* handle) { return *static_cast<Window*>(glfwGetWindowUserPointer(handle)); }
    static void add(GLFWwindow* handle, Event event) {
        Window& window = of(handle);
        event.x = window.mouseX_;
        event.y = window.mouseY_;
        window.events_.push_back(std::move(event));
    }
    static void other(GLFWwindow* handle) { add(handle, {}); }

    static void install(GLFWwindow* handle) {
        glfwSetKeyCallback(handle, [](GLFWwindow* at, int key, int scancode, int action, int modifiers) {
            Event event{.key = key, .scancode = scancode, .modifiers = modifiers};
            event.kind = action == GLFW_RELEASE ? Event::Kind::keyUp : Event::Kind::key;
            event.repeat = action == GLFW_REPEAT;
            add(at, event);
        });
        glfwSetCharCallback(handle, [](GLFWwindow* at, unsigned codePoint) {
            add(at, {.kind = Event::Kind::character, .codePoint = codePoint});
        });
        glfwSetMouseButtonCallback(handle, [](GLFWwindow* at, int button, int action, int modifiers) {
            const auto kind = action == GLFW_PRESS ? Event::Kind::press : Event::Kind::release;
            add(at, {.kind = kind, .key = button, .modifiers = modifiers});
        });
        glfwSetCursorPosCallback(handle, [](GLFWwindow* at, double x, double y) {
            of(at).mouseX_ = x;
            of(at).mouseY_ = y;
            add(at, {.kind = Event::Kind::move});
        });
        glfwSetScrollCallback(handle, [](GLFWwindow* at, double across, double notches) {
            add(at, {.kind = Event::Kind::wheel, .across = across, .notches = notches});
        });
        glfwSetDropCallback(handle, [](GLFWwindow* at, int count, const char** files) {
            for (int i = 0; i < count; ++i) add(at, {.kind = Event::Kind::drop, .file = files[i]});
        });
        glfwSetCursorEnterCallback(handle, [](GLFWwindow* at, int) { other(at); });
        glfwSetWindowFocusCallback(handle, [](GLFWwindow* at, int) { other(at); });
        glfwSetWindowRefreshCallback(handle, [](GLFWwindow* at) { other(at); });
        glfwSetWindowIconifyCallback(handle, [](GLFWwindow* at, int) { other(at); });
        // Both sizes as the window system tells them, one right after the other. Asked for, each would be that of its own
        // moment: between two answers a window can grow from 1 to 1200.
        glfwSetWindowSizeCallback(handle, [](GLFWwindow* at, int width, int height) {
            of(at).size_.setUnits(width, height);
            other(at);
        });
        glfwSetFramebufferSizeCallback(handle, [](GLFWwindow* at, int width, int height) {
            of(at).size_.setPixels(width, height);
            other(at);
        });
        glfwSetWindowContentScaleCallback(handle, [](GLFWwindow* at, float scale, float) {
            of(at).contentScale_.set(double(scale));
            other(at);
        });
        glfwSetWindowCloseCallback(handle, [](GLFWwindow* at) { other(at); });
    }
};

Window::Window() {
    const auto set = [](const char* name) {
        const char* value = std::getenv(name);
        return value && *value;
    };
    if (!set("DISPLAY") && !set("WAYLAND_DISPLAY")) {
        throw Error("window", "needs a display (DISPLAY or WAYLAND_DISPLAY); use --shot FILE without");
    }
    glfwSetErrorCallback(onProblem);
    trying = true;
    if (!glfwInit()) throw Error("window", "needs a display that answers; use --shot FILE without", lastProblem);
    try {
        open();
    } catch (...) {
        glfwTerminate();
        throw;
    }
    trying = false;
}

void Window::open() {
    for (const int version : versionsToAskFor(33)) {
        handle_ = makeWindow(version);
        if (handle_) break;
    }
    if (!handle_) throw Error("window", "needs OpenGL 3.3 core; this driver has", versionFound());
    glfwSetWindowUserPointer(handle_, this);
    WindowCallbacks::install(handle_);
    glfwGetCursorPos(handle_, &mouseX_, &mouseY_);
    inputs_.mouseX = mouseX_;
    inputs_.mouseY = mouseY_;
    // Hidden as it is yet, nobody changes its size between these two.
    int width = 0, height = 0;
    glfwGetWindowSize(handle_, &width, &height);
    size_.setUnits(width, height);
    glfwGetFramebufferSize(handle_, &width, &height);
    size_.setPixels(width, height);
    size_.take();
    float scale = 1;
    glfwGetWindowContentScale(handle_, &scale, nullptr);
    contentScale_.set(double(scale));
    glfwMakeContextCurrent(handle_);
    glfwSwapInterval(1);
}

Window::~Window() {
    glfwDestroyWindow(handle_);
    glfwTerminate();
}

void* Window::address(const char* function) const { return reinterpret_cast<void*>(glfwGetProcAddress(function)); }

void Window::setTitle(const std::string& title) { glfwSetWindowTitle(handle_, title.c_str()); }

std::optional<WorkArea> Window::workArea() const {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (!monitor) return {};
    int x = 0, y = 0;
    WorkArea area;
    glfwGetMonitorWorkarea(monitor, &x, &y, &area.width, &area.height);
    return area.width > 0 && area.height > 0 ? std::optional(area) : std::nullopt;
}

void Window::show(int width, int height, bool fit) {
    if (!glfwGetWindowAttrib(handle_, GLFW_MAXIMIZED)) {
        if (const auto area = fit ? workArea() : std::nullopt) {
            width = std::min(width, area->width);
            height = std::min(height, area->height);
        }
        glfwSetWindowSize(handle_, width, height);
    }
    glfwShowWindow(handle_);
    // The new size before the first frame, where the window system has it at once.
    roundTrip(handle_);
    glfwPollEvents();
    size_.take();
}

void Window::toggleFullScreen() {
    if (glfwGetWindowMonitor(handle_))
        return glfwSetWindowMonitor(handle_, nullptr, before_.x, before_.y, before_.width, before_.height,
                                    GLFW_DONT_CARE);
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (!mode) return;
    glfwGetWindowPos(handle_, &before_.x, &before_.y);
    glfwGetWindowSize(handle_, &before_.width, &before_.height);
    glfwSetWindowMonitor(handle_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::copyToClipboard(const std::string& text) { glfwSetClipboardString(handle_, text.c_str()); }

bool Window::hidden() const {
    return glfwGetWindowAttrib(handle_, GLFW_ICONIFIED) || size_.pixelWidth() < 1 || size_.pixelHeight() < 1;
}

bool Window::closing() const { return glfwWindowShouldClose(handle_) != 0; }

std::vector<Event> Window::waitForEvents(double seconds) {
    if (seconds > 0 && events_.empty()) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
    size_.take();
    std::vector<Event> frame;
    bool keyDown = false, button = false;
    while (!events_.empty()) {
        const Event& event = events_.front();
        const bool isKey = (event.kind == Event::Kind::key && !event.repeat) || event.kind == Event::Kind::keyUp;
        const bool isButton = event.kind == Event::Kind::press || event.kind == Event::Kind::release;
        if (keyDown && isKey) break;
        if (button && (isButton || event.kind == Event::Kind::move)) break;
        keyDown |= isKey && event.kind == Event::Kind::key;
        button |= isButton;
        count(event);
        frame.push_back(event);
        events_.pop_front();
    }
    return frame;
}

void Window::count(const Event& event) {
    inputs_.mouseX = event.x;
    inputs_.mouseY = event.y;
    switch (event.kind) {
        case Event::Kind::key:
            ++inputs_.keys;
            if (!event.repeat) ++inputs_.keysHeld;
            break;
        case Event::Kind::keyUp:
            inputs_.keysHeld = std::max(inputs_.keysHeld - 1, 0);  // one may have been pressed in another window
            break;
        case Event::Kind::press:
            ++inputs_.buttons;
            ++inputs_.buttonsHeld;
            break;
        case Event::Kind::release:
            inputs_.buttonsHeld = std::max(inputs_.buttonsHeld - 1, 0);
            break;
        case Event::Kind::wheel:
            ++inputs_.wheel;
            break;
        case Event::Kind::character:
        case Event::Kind::move:
        case Event::Kind::drop:
        case Event::Kind::other:
            break;
    }
}

bool Window::eventsLeft() const { return !events_.empty(); }

void Window::swap() { glfwSwapBuffers(handle_); }

void Window::finish() {
    glFinish();
    roundTrip(handle_);
}

}  // namespace mv
