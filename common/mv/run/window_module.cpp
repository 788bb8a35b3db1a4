#include "mv/run/window_module.h"

#include <dlfcn.h>

#include "mv/gl/shader_folder.h"

namespace mv {

void openWindow(const Command& command) {
    // In the build tree and when installed.
    const auto file = libraryFolder() / "mvgl-window.so";
    void* module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!module)
        throw Error("window", "needs the module mvgl-window.so beside the library; use --shot without", dlerror());
    const auto windowMain = reinterpret_cast<WindowMain>(dlsym(module, windowMainName));
    if (!windowMain) throw Error("window", "needs a module of this version of mvgl", file.string());
    windowMain(command);
}

}  // namespace mv
