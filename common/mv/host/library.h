// A shared library opened at run time, so that a program starts and says what is missing where it is not there.
#pragma once
#include <dlfcn.h>

#include <string>

#include "mv/error.h"

namespace mv {

class Library {
  public:
    // `remedy` says what to install.
    Library(const char* file, const char* remedy) : handle_(dlopen(file, RTLD_NOW | RTLD_LOCAL)) {
        if (!handle_) throw Error(file, std::string("must be installed (") + remedy + ")", dlerror());
    }
    // Never closed: Mesa's drivers leave threads and exit handlers behind that must not outlive their code.
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;

    template <class Function>
    Function get(const char* name) const {
        const auto function = reinterpret_cast<Function>(dlsym(handle_, name));
        if (!function) throw Error(name, "must be in the library; its version is too old");
        return function;
    }

  private:
    void* handle_;
};

}  // namespace mv
