#include "mv/run/window_module.h"

#include <dlfcn.h>

#include <filesystem>

namespace mv {
namespace {

// The folder of the library this code is in: the module stands beside it in the build tree and when installed.
std::filesystem::path ownFolder() {
    Dl_info info{};
    if (!dladdr(reinterpret_cast<const void*>(&openWindow), &info) || !info.dli_fname) return {};
    return std::filesystem::path(info.dli_fname).parent_path();
}

}  // namespace

void openWindow(const Command& command) {
    const auto file = ownFolder() / "mvgl-window.so";
    void* module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!module)
        throw Error("window", "needs the module mvgl-window.so beside the library; use --shot without", dlerror());
    const auto windowMain = reinterpret_cast<WindowMain>(dlsym(module, windowMainName));
    if (!windowMain) throw Error("window", "needs a module of this version of mvgl", file.string());
    windowMain(command);
}

}  // namespace mv
