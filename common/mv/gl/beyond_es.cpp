#include "mv/gl/beyond_es.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "mv/error.h"
#include "mv/gl/functions.h"
#include "mv/gl/layer.h"
#include "mv/gl/state_names.h"
#include "mv/gl/target.h"
#include "mv/gl/texture.h"

namespace mv {
namespace {

bool isOneOf(GLenum value, std::initializer_list<GLenum> list) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

// Hears of the calls that ES 3.0 lacks, or has for other values only.
class EsWatch {
  public:
    std::set<std::string> used;

    void before_Enable(GLenum what) {
        if (what >= GL_CLIP_DISTANCE0 && what < GL_CLIP_DISTANCE0 + 8) {
            used.insert(beyond_es::clipDistances);
        } else if (!isOneOf(what, {GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_DITHER, GL_POLYGON_OFFSET_FILL,
                                   GL_PRIMITIVE_RESTART_FIXED_INDEX, GL_RASTERIZER_DISCARD, GL_SAMPLE_ALPHA_TO_COVERAGE,
                                   GL_SAMPLE_COVERAGE, GL_SCISSOR_TEST, GL_STENCIL_TEST}) &&
                   !isOneOf(what, {GL_MULTISAMPLE, GL_PROGRAM_POINT_SIZE, GL_TEXTURE_CUBE_MAP_SEAMLESS, GL_DEBUG_OUTPUT,
                                   GL_DEBUG_OUTPUT_SYNCHRONOUS})) {  // ES has these always on, or apart
            used.insert(stateName(what));
        }
    }
    void before_ClipControl(GLenum origin, GLenum depth) {
        if (origin != GL_LOWER_LEFT || depth != GL_NEGATIVE_ONE_TO_ONE) used.insert(beyond_es::clipControl);
    }
    void before_PolygonMode(GLenum, GLenum mode) {
        if (mode != GL_FILL) used.insert(beyond_es::polygonMode);
    }
    void before_BindTexture(GLenum, GLuint texture) { texture_ = texture; }
    void before_TexImage2D(GLenum, GLint, GLint format, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*) {
        filled(format);
    }
    void before_TexImage3D(GLenum, GLint, GLint format, GLsizei, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*) {
        filled(format);
    }
    void before_TexParameteri(GLenum, GLenum name, GLint value) {
        if (name == anisotropy) {
            if (value > 1) used.insert(beyond_es::anisotropicFiltering);
            return;
        }
        if (value == GL_CLAMP_TO_BORDER) used.insert(beyond_es::borderClamp);
        const bool isFilter = name == GL_TEXTURE_MIN_FILTER || name == GL_TEXTURE_MAG_FILTER;
        if (isFilter && value != GL_NEAREST && value != GL_NEAREST_MIPMAP_NEAREST && float32_.contains(texture_))
            used.insert(beyond_es::floatFiltering);
    }
    void before_ReadPixels(GLint, GLint, GLsizei, GLsizei, GLenum format, GLenum, void*) {
        if (format == GL_DEPTH_COMPONENT || format == GL_DEPTH_STENCIL) used.insert(beyond_es::depthReadBack);
        if (format == GL_STENCIL_INDEX || format == GL_DEPTH_STENCIL) used.insert(beyond_es::stencilReadBack);
    }
    void before_BeginQuery(GLenum target, GLuint) {
        if (!isOneOf(target, {GL_ANY_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED_CONSERVATIVE,
                              GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN})) {
            used.insert(beyond_es::countingQueries);
        }
    }
    void before_CreateShader(GLenum kind) {
        if (kind == GL_GEOMETRY_SHADER) used.insert(beyond_es::geometryShaders);
        if (isOneOf(kind, {GL_TESS_CONTROL_SHADER, GL_TESS_EVALUATION_SHADER})) used.insert(beyond_es::tessellation);
        if (kind == GL_COMPUTE_SHADER) used.insert(beyond_es::computeShaders);
    }
    void before_BeginTransformFeedback(GLenum primitive) { captured_ = primitive; }
    void before_EndTransformFeedback() { captured_ = GL_NONE; }
    void before_DrawArrays(GLenum mode, GLint, GLsizei) { noteDraw(mode); }
    void before_DrawElements(GLenum mode, GLsizei, GLenum, const void*) {
        noteDraw(mode);
        if (captured_ != GL_NONE) used.insert(beyond_es::indexedFeedback);
    }

  private:
    void filled(GLint format) {
        if (isOneOf(static_cast<GLenum>(format), {GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F})) {
            float32_.insert(texture_);
        } else {
            float32_.erase(texture_);
        }
    }
    void noteDraw(GLenum mode) {
        if (captured_ != GL_NONE && captured_ != mode) used.insert(beyond_es::expandedFeedback);
        const auto& gl = Layer<EsWatch>::below;
        if (gl.IsEnabled(GL_RASTERIZER_DISCARD) == GL_TRUE) return;
        GLint framebuffer = 0, kind = GL_NONE, number = GL_NONE, bits = 0;
        gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
        if (framebuffer == 0) return;
        const auto ask = [&](GLenum what, GLint& answer) {
            gl.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, what, &answer);
        };
        ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, kind);
        if (kind == GL_NONE) return;
        ask(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, number);
        if (number != GL_FLOAT) return;
        used.insert(beyond_es::floatTargets);
        ask(GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, bits);
        if (bits == 32 && gl.IsEnabled(GL_BLEND) == GL_TRUE) used.insert(beyond_es::floatBlending);
    }

    static constexpr GLenum anisotropy = 0x84FE;  // GL_TEXTURE_MAX_ANISOTROPY, of OpenGL 4.6
    GLuint texture_ = 0;                          // that is bound
    std::set<GLuint> float32_;                    // textures of 32-bit floats
    GLenum captured_ = GL_NONE;                   // the primitive of the transform feedback that is active
};

EsWatch& watch() {
    static EsWatch only;
    return only;
}

std::set<std::string> missing, withheld;

bool isThere(const std::string& feature) {
    if (isWithheld(feature)) return false;
    if (feature == beyond_es::floatTargets) return floatTargets();
    if (feature == beyond_es::floatBlending) return floatBlending();
    if (feature == beyond_es::floatFiltering) return !isEs() || hasExtension("GL_OES_texture_float_linear");
    if (feature == beyond_es::anisotropicFiltering) return largestAnisotropy() > 1;
    const std::optional<Newer> newer = newerThan33(feature);
    if (!newer) return !isEs();
    if (isAllowed(*newer)) return true;
    if (contextHas(*newer))
        throw Error("has", "must be asked for what is declared in .needs = {.beyondEs = ...}", feature);
    return false;
}

}  // namespace

std::optional<Newer> newerThan33(const std::string& feature) {
    if (feature == beyond_es::clipControl) return Newer::clipControl;
    if (feature == beyond_es::tessellation) return Newer::tessellation;
    if (feature == beyond_es::computeShaders) return Newer::compute;
    return {};
}

bool has(const char* feature) {
    const bool there = isThere(feature);
    if (!there) missing.insert(feature);
    return there;
}

std::set<std::string> takeMissing() { return std::exchange(missing, {}); }

void withhold(std::set<std::string> features) { withheld = std::move(features); }

bool isWithheld(const std::string& feature) { return withheld.contains(feature); }

void layBeyondEs() { Layer<EsWatch>::layOver(watch()); }

std::set<std::string> takeBeyondEs() { return std::exchange(watch().used, {}); }

void watchBeyondEs() {
    takeBeyondEs();
    setLayer(layBeyondEs);
}

std::set<std::string> stopWatchingBeyondEs() {
    setLayer({});
    return takeBeyondEs();
}

}  // namespace mv
