// A window system and a clock that are none: loaded before GLFW and the C++ library (LD_PRELOAD), it answers some of their
// calls in their place. SHAM says what it plays:
// - twice: as Wayland on a screen of double density, the framebuffer has twice the window's size. The real window is one
//   of X11, twice as large as the program is told, so that what it shows can be seen and clicked at.
// - torn: a window that changes from 1 to its real width between two questions for its size.
// - absurd: a framebuffer a hundred times the window's size.
// - paced: a clock that goes on by SHAM_MS milliseconds from one question to the next, so that a frame takes one or a few
//   times that on any machine.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <dlfcn.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <string_view>

namespace {

bool plays(const char* name) {
    const char* sham = std::getenv("SHAM");
    return sham && std::string_view(sham) == name;
}
int factor() { return plays("twice") ? 2 : 1; }

template <typename Function>
Function* real(Function*, const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

bool shown = false;
bool odd = false;
GLFWwindowsizefun onSize = nullptr;
GLFWframebuffersizefun onPixels = nullptr;
GLFWcursorposfun onCursor = nullptr;

}  // namespace

#define REAL(name) real(&name, #name)

extern "C" {

GLFWwindow* glfwCreateWindow(int width, int height, const char* title, GLFWmonitor* monitor, GLFWwindow* share) {
    return REAL(glfwCreateWindow)(width * factor(), height * factor(), title, monitor, share);
}
void glfwShowWindow(GLFWwindow* window) {
    REAL(glfwShowWindow)(window);
    shown = true;
}
void glfwSetWindowSize(GLFWwindow* window, int width, int height) {
    REAL(glfwSetWindowSize)(window, width * factor(), height * factor());
}
void glfwGetWindowSize(GLFWwindow* window, int* width, int* height) {
    REAL(glfwGetWindowSize)(window, width, height);
    odd = !odd;
    if (width) *width = plays("torn") && shown && odd ? 1 : *width / factor();
    if (height) *height /= factor();
}
void glfwGetMonitorWorkarea(GLFWmonitor* monitor, int* x, int* y, int* width, int* height) {
    REAL(glfwGetMonitorWorkarea)(monitor, x, y, width, height);
    *width /= factor();
    *height /= factor();
}
void glfwGetWindowContentScale(GLFWwindow* window, float* across, float* down) {
    REAL(glfwGetWindowContentScale)(window, across, down);
    if (across) *across *= static_cast<float>(factor());
    if (down) *down *= static_cast<float>(factor());
}
void glfwGetCursorPos(GLFWwindow* window, double* x, double* y) {
    REAL(glfwGetCursorPos)(window, x, y);
    *x /= factor();
    *y /= factor();
}
GLFWwindowsizefun glfwSetWindowSizeCallback(GLFWwindow* window, GLFWwindowsizefun callback) {
    onSize = callback;
    return REAL(glfwSetWindowSizeCallback)(
        window, [](GLFWwindow* at, int width, int height) { onSize(at, width / factor(), height / factor()); });
}
GLFWframebuffersizefun glfwSetFramebufferSizeCallback(GLFWwindow* window, GLFWframebuffersizefun callback) {
    onPixels = callback;
    return REAL(glfwSetFramebufferSizeCallback)(window, [](GLFWwindow* at, int width, int height) {
        const int times = plays("absurd") ? 100 : 1;
        onPixels(at, width * times, height * times);
    });
}
GLFWcursorposfun glfwSetCursorPosCallback(GLFWwindow* window, GLFWcursorposfun callback) {
    onCursor = callback;
    return REAL(glfwSetCursorPosCallback)(
        window, [](GLFWwindow* at, double x, double y) { onCursor(at, x / factor(), y / factor()); });
}

}  // extern "C"

std::chrono::steady_clock::time_point std::chrono::steady_clock::now() noexcept {
    static const auto realNow =
        reinterpret_cast<time_point (*)()>(dlsym(RTLD_NEXT, "_ZNSt6chrono3_V212steady_clock3nowEv"));
    static const auto pace = std::chrono::milliseconds(plays("paced") ? std::atoi(std::getenv("SHAM_MS")) : 0);
    static std::atomic<int> questions = 0;
    return pace.count() > 0 ? time_point(pace * ++questions) : realNow();
}
