// EGL without a display: Mesa's surfaceless platform, else the software device, else (a real GPU) any device.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "mv/gl/version.h"
#include "mv/host/context.h"
#include "mv/host/library.h"

namespace mv {
namespace {

// The few functions of EGL that are needed; libEGL is opened at run time, so that a program starts without it.
struct Egl {
    Library library{"libEGL.so.1", "package libegl1"};
#define MVGL_EGL(name) decltype(&::egl##name) name = library.get<decltype(&::egl##name)>("egl" #name)
    MVGL_EGL(GetProcAddress);
    MVGL_EGL(GetError);
    MVGL_EGL(Initialize);
    MVGL_EGL(BindAPI);
    MVGL_EGL(ChooseConfig);
    MVGL_EGL(CreateContext);
    MVGL_EGL(DestroyContext);
    MVGL_EGL(MakeCurrent);
    MVGL_EGL(QueryString);
#undef MVGL_EGL
    template <class Function>
    Function extension(const char* name) const {
        return reinterpret_cast<Function>(GetProcAddress(name));
    }
};

std::string eglError(const Egl& egl) {
    const EGLint code = egl.GetError();
    if (code == EGL_BAD_ALLOC) return "EGL_BAD_ALLOC, out of memory";
    char text[16];
    std::snprintf(text, sizeof text, "0x%04x", static_cast<unsigned>(code));
    return std::string("EGL error ") + text;
}

class EglContext final : public Context {
  public:
    EglContext(ContextRequest request, bool surfaceless, std::vector<std::string>& notes) {
        const auto platformDisplay = egl_.extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
        if (!platformDisplay) throw Error("EGL", "must have EGL_EXT_platform_base; a newer libEGL is needed");
        std::string reasons;
        for (const Candidate& candidate : candidates(platformDisplay, surfaceless)) {
            try {
                open(candidate, request);
                if (!reasons.empty()) notes.push_back("using " + name_ + ", since " + reasons);
                return;
            } catch (const Error& error) {
                reasons += (reasons.empty() ? "" : "; ") + std::string(error.what());
            }
        }
        throw Error("EGL", "must have a driver that draws without a display", reasons);
    }
    ~EglContext() override { close(); }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    std::string name() const override { return name_; }
    void* address(const char* function) const override {
        return reinterpret_cast<void*>(egl_.GetProcAddress(function));
    }

  private:
    struct Candidate {
        std::string name;
        EGLDisplay display;
    };

    std::vector<Candidate> candidates(PFNEGLGETPLATFORMDISPLAYEXTPROC platformDisplay, bool surfaceless) const {
        std::vector<Candidate> list;
        if (surfaceless) {
            list.push_back(
                {"EGL surfaceless", platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)});
        }
        const auto queryDevices = egl_.extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
        const auto deviceString = egl_.extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
        if (!queryDevices || !deviceString) return list;
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        queryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count);
        std::vector<Candidate> hardware;
        for (EGLint i = 0; i < count; ++i) {
            const EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
            const char* extensions = deviceString(device, EGL_EXTENSIONS);
            const bool software =
                extensions && std::string(extensions).find("EGL_MESA_device_software") != std::string::npos;
            (software ? list : hardware)
                .push_back({software ? "EGL software device" : "EGL device " + std::to_string(i),
                            platformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr)});
        }
        list.insert(list.end(), hardware.begin(), hardware.end());
        return list;
    }

    void open(const Candidate& candidate, ContextRequest request) {
        if (candidate.display == EGL_NO_DISPLAY) throw Error(candidate.name, "has no display here", eglError(egl_));
        if (!egl_.Initialize(candidate.display, nullptr, nullptr)) {
            throw Error(candidate.name, "must initialize; its driver is missing, broken or short of memory",
                        eglError(egl_));
        }
        display_ = candidate.display;
        name_ = candidate.name;
        try {
            makeContext(request);
        } catch (...) {
            close();
            throw;
        }
    }

    void makeContext(ContextRequest request) {
        if (!egl_.BindAPI(request.es ? EGL_OPENGL_ES_API : EGL_OPENGL_API)) {
            throw Error(name_, "must know this kind of OpenGL", eglError(egl_));
        }
        const std::array configAttributes{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE,
                                          request.es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (!egl_.ChooseConfig(display_, configAttributes.data(), &config, 1, &count) || count < 1) {
            throw Error(name_, "must have a configuration to draw with", eglError(egl_));
        }
        for (const int version : request.es ? std::vector{30} : versionsToAskFor(request.version)) {
            std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION, version / 10, EGL_CONTEXT_MINOR_VERSION,
                                           version % 10};
            if (!request.es) {
                attributes.insert(attributes.end(),
                                  {EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT});
            }
            attributes.push_back(EGL_NONE);
            context_ = egl_.CreateContext(display_, config, EGL_NO_CONTEXT, attributes.data());
            if (context_ != EGL_NO_CONTEXT) break;
        }
        if (context_ == EGL_NO_CONTEXT) {
            const std::string wanted =
                request.es ? "OpenGL ES 3.0" : "OpenGL " + versionText(request.version) + " core, or newer";
            throw Error(name_, "must make a context of " + wanted, eglError(egl_));
        }
        if (!egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
            throw Error(name_, "must make a context current without a surface", eglError(egl_));
        }
    }

    void close() {
        if (context_ != EGL_NO_CONTEXT) {
            egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            egl_.DestroyContext(display_, context_);
            context_ = EGL_NO_CONTEXT;
        }
        // The display is not terminated: EGL has one for each platform, another context of this process may be using it,
        // and Mesa would unload its driver under its own exit handlers.
        display_ = EGL_NO_DISPLAY;
    }

    Egl egl_;
    std::string name_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    ::EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Context> openEgl(ContextRequest request, bool surfaceless, std::vector<std::string>& notes) {
    return std::make_unique<EglContext>(request, surfaceless, notes);
}

}  // namespace mv
