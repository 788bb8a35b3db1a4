// A current OpenGL context, whoever made it.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mv {

class Context {
  public:
    virtual ~Context() = default;
    virtual std::string name() const = 0;  // "OSMesa", "EGL surfaceless", "EGL software device", "window (GLFW)"
    virtual void* address(const char* function) const = 0;
};

// eglDevice leaves the surfaceless platform out: the software device of EGL, else a GPU.
enum class HostKind { automatic, osmesa, egl, eglDevice };
// The host of that name: osmesa, egl or egl-device; nothing for another one.
std::optional<HostKind> hostNamed(std::string_view name);

struct ContextRequest {
    int version = 33;  // least core version, 10 * major + minor; ES 3.0 where `es` is set
    bool es = false;
};

// Makes a context without a display and makes it current: OSMesa, and where that is missing EGL; or the host asked for,
// and no other. `notes` receives a line for each host that was passed over, with the reason. Each driver is tried in a
// child process first if the environment steers drivers. Error: no host is left; the message has the reason of each.
std::unique_ptr<Context> openHeadless(HostKind kind, ContextRequest request, std::vector<std::string>& notes);

// The hosts themselves; each throws Error with its reason.
std::unique_ptr<Context> openOsmesa(ContextRequest request);
std::unique_ptr<Context> openEgl(ContextRequest request, bool surfaceless, std::vector<std::string>& notes);

}  // namespace mv
