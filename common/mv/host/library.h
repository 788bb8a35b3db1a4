// A shared library opened at run time, so that a program starts and says what is missing where it is not there.
#pragma once
#include <dlfcn.h>

#include <string>
#include <string_view>

#include "mv/error.h"

namespace mv {

// The resource that the system does not give: memory or threads. Nothing that could be installed helps.
class ScarceError final : public Error {
  public:
    using Error::Error;
};

// A library that is not there, however much memory there is.
class MissingError final : public Error {
  public:
    using Error::Error;
};

class Library {
  public:
    // `remedy` says what to install.
    Library(const char* file, const char* remedy) : handle_(dlopen(file, RTLD_NOW | RTLD_LOCAL)) {
        if (handle_) return;
        // The loader tells its reasons in words alone: these are glibc's where mmap or malloc gives nothing.
        const std::string_view reason = dlerror();
        for (const char* words : {"annot allocate memory", "failed to map"}) {
            if (reason.find(words) == reason.npos) continue;
            throw ScarceError(file, "must have more memory to be loaded; close other programs, or raise ulimit -v",
                              reason);
        }
        throw MissingError(file, std::string("must be installed (") + remedy + ")", reason);
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
