// OSMesa: Mesa's rasterizer drawing into plain memory. Opened at run time and never linked, since libOSMesa exports the
// same gl* names as libGL, and since newer distributions no longer have it.
#include <GL/glcorearb.h>

#include <array>
#include <cstdint>
#include <string>

#include "mv/gl/version.h"
#include "mv/host/context.h"
#include "mv/host/library.h"

namespace mv {
namespace {

// From OSMesa's interface, which is frozen since Mesa 12 (2016); its header is not in every distribution.
constexpr int osmesaFormat = 0x22, osmesaDepthBits = 0x30, osmesaStencilBits = 0x31, osmesaProfile = 0x33,
              osmesaCoreProfile = 0x34, osmesaMajor = 0x36, osmesaMinor = 0x37;
using OsmesaContext = struct OsmesaContextTag*;

class Osmesa final : public Context {
  public:
    explicit Osmesa(ContextRequest request)
        : library_("libOSMesa.so.8", "package libosmesa6; --headless=egl works without") {
        if (request.es) throw Error("OSMesa", "has no OpenGL ES; use --headless=egl");
        const auto create = library_.get<OsmesaContext (*)(const int*, OsmesaContext)>("OSMesaCreateContextAttribs");
        const auto makeCurrent =
            library_.get<GLboolean (*)(OsmesaContext, void*, GLenum, GLsizei, GLsizei)>("OSMesaMakeCurrent");
        destroy_ = library_.get<void (*)(OsmesaContext)>("OSMesaDestroyContext");
        address_ = library_.get<void* (*)(const char*)>("OSMesaGetProcAddress");
        // Its own framebuffer is never drawn to: no depth, no stencil, a few pixels.
        for (const int version : versionsToAskFor(request.version)) {
            const std::array attributes{
                // clang-format off
                osmesaFormat, static_cast<int>(GL_RGBA),
                osmesaDepthBits, 0,
                osmesaStencilBits, 0,
                osmesaProfile, osmesaCoreProfile,
                osmesaMajor, version / 10,
                osmesaMinor, version % 10,
                0,
                // clang-format on
            };
            context_ = create(attributes.data(), nullptr);
            if (context_) break;
        }
        if (!context_) {
            throw Error("OSMesa", "must make a core context of OpenGL " + versionText(request.version) +
                                      ", or newer; this Mesa cannot");
        }
        if (!makeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, side, side)) {
            destroy_(context_);
            throw Error("OSMesa", "must make its context current");
        }
    }
    ~Osmesa() override { destroy_(context_); }
    Osmesa(const Osmesa&) = delete;
    Osmesa& operator=(const Osmesa&) = delete;

    std::string name() const override { return "OSMesa"; }
    void* address(const char* function) const override { return address_(function); }

  private:
    static constexpr int side = 4;
    Library library_;
    OsmesaContext context_ = nullptr;
    void (*destroy_)(OsmesaContext) = nullptr;
    void* (*address_)(const char*) = nullptr;
    std::array<std::uint32_t, std::size_t{side} * side> pixels_{};
};

}  // namespace

std::unique_ptr<Context> openOsmesa(ContextRequest request) { return std::make_unique<Osmesa>(request); }

}  // namespace mv
