#include "context.h"

#include <GLES3/gl3.h>
#include <emscripten/em_js.h>
#include <emscripten/html5.h>

#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <string_view>

#include "mv/error.h"

namespace {

// What OpenGL has and ES 3.0 lacks; a demo asks before it calls it.
namespace lacking {
constexpr std::nullptr_t glBindImageTexture = nullptr, glClearDepth = nullptr, glClipControl = nullptr,
                         glDepthRange = nullptr, glDispatchCompute = nullptr, glGetBufferSubData = nullptr,
                         glGetTexLevelParameteriv = nullptr, glMemoryBarrier = nullptr, glPatchParameteri = nullptr,
                         glPolygonMode = nullptr;
}
using namespace lacking;

}  // namespace

// WebGL maps no buffers: one that is read is copied out.
EM_JS(void, copyOutOfBuffer, (unsigned target, int offset, void* to, int size),
      { GLctx.getBufferSubData(target, offset, HEAPU8, to, size); });

// An extension, which a page has once it has asked for it.
EM_JS(void, clipControl, (unsigned origin, unsigned depth),
      { GLctx.getExtension("EXT_clip_control").clipControlEXT(origin, depth); });

// The canvas that the module was opened with, by the name that canvasName has for it: a page may have several, each with a module.
EM_JS(void, nameCanvas, (), { specialHTMLTargets["!canvas"] = Module["canvas"]; });

namespace {

void* mappedCopy = nullptr;

void* mapForReading(GLenum target, GLintptr offset, GLsizeiptr size, GLbitfield access) {
    if (access != GL_MAP_READ_BIT || mappedCopy) return nullptr;
    mappedCopy = std::malloc(static_cast<std::size_t>(size));
    if (mappedCopy) copyOutOfBuffer(target, static_cast<int>(offset), mappedCopy, static_cast<int>(size));
    return mappedCopy;
}
GLboolean unmap(GLenum) {
    std::free(mappedCopy);
    mappedCopy = nullptr;
    return GL_TRUE;
}

#define glMapBufferRange mapForReading
#define glUnmapBuffer unmap
// Filled from the names themselves: smaller than a page's own table of all functions by name.
void* functionOf(std::string_view name) {
    static const std::map<std::string_view, void*> functions{
#define X(name, TYPE, version) {"gl" #name, (void*)(gl##name)},
#include "mv/gl/function_list.inc"
#undef X
        {"glClearDepthf", (void*)glClearDepthf},
        {"glDepthRangef", (void*)glDepthRangef},
        {"glClipControlEXT", (void*)clipControl},
    };
    const auto found = functions.find(name);
    return found == functions.end() ? nullptr : found->second;
}

class WebGl final : public mv::Context {
  public:
    WebGl() {
        EmscriptenWebGLContextAttributes wanted;
        emscripten_webgl_init_context_attributes(&wanted);
        wanted.majorVersion = 2;  // all else the page has said already, when it asked first (begin.js)
        nameCanvas();
        context_ = emscripten_webgl_create_context(mv::canvasName, &wanted);
        if (context_ <= 0) throw mv::Error("WebGL 2", "must be there; this browser, or its driver, gives none");
        emscripten_webgl_make_context_current(context_);
    }
    ~WebGl() override { emscripten_webgl_destroy_context(context_); }

    std::string name() const override { return "browser"; }
    void* address(const char* function) const override { return functionOf(function); }

  private:
    EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context_;
};

}  // namespace

namespace mv {

std::unique_ptr<Context> openWebGl() { return std::make_unique<WebGl>(); }

}  // namespace mv
