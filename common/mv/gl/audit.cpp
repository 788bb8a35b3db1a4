#include "mv/gl/audit.h"

#include <cstring>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>

#include "mv/gl/audit_reads.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/feedback.h"
#include "mv/gl/layer.h"
#include "mv/gl/object.h"
#include "mv/gl/state_names.h"

namespace mv {
namespace {

class Recorder;
const FunctionTable& below = Layer<Recorder>::below;

using Objects = std::map<GLuint, bool>;  // made, and whether used

// Hears of every call before it is made (before_NAME) or after (after_NAME), where it has such a member.
class Recorder {
  public:
    void begin(bool repeats);
    FrameWork end();
    std::vector<Finding> take();

    // ---- State: set again to what it was is needless, and a frame begins in OpenGL's initial state.
    void before_Enable(GLenum cap) { state("glEnable/glDisable(" + stateName(cap) + ")", "on"); }
    void before_Disable(GLenum cap) { state("glEnable/glDisable(" + stateName(cap) + ")", "off"); }
    void before_DepthFunc(GLenum f) { state("glDepthFunc", f); }
    void before_DepthMask(GLboolean on) { state("glDepthMask", on); }
    void before_CullFace(GLenum face) { state("glCullFace", face); }
    void before_FrontFace(GLenum winding) { state("glFrontFace", winding); }
    void before_BlendFunc(GLenum from, GLenum to) { before_BlendFuncSeparate(from, to, from, to); }
    void before_BlendFuncSeparate(GLenum from, GLenum to, GLenum alphaFrom, GLenum alphaTo) {
        state("glBlendFunc", from, to, alphaFrom, alphaTo);
    }
    void before_BlendEquation(GLenum mode) { state("glBlendEquation", mode); }
    void before_ColorMask(GLboolean r, GLboolean g, GLboolean b, GLboolean a) { state("glColorMask", r, g, b, a); }
    void before_StencilFunc(GLenum f, GLint ref, GLuint mask) {
        before_StencilFuncSeparate(GL_FRONT_AND_BACK, f, ref, mask);
    }
    void before_StencilFuncSeparate(GLenum face, GLenum f, GLint ref, GLuint mask) {
        bothFaces("glStencilFunc", face, values(f, ref, mask));
    }
    void before_StencilOp(GLenum fail, GLenum zfail, GLenum pass) {
        before_StencilOpSeparate(GL_FRONT_AND_BACK, fail, zfail, pass);
    }
    void before_StencilOpSeparate(GLenum face, GLenum fail, GLenum zfail, GLenum pass) {
        bothFaces("glStencilOp", face, values(fail, zfail, pass));
    }
    void before_StencilMask(GLuint mask) { state("glStencilMask", mask); }
    void before_ClearColor(GLfloat r, GLfloat g, GLfloat b, GLfloat a) { state("glClearColor", r, g, b, a); }
    void before_ClearDepth(GLdouble depth) { state("glClearDepth", depth); }
    void before_ClearStencil(GLint value) { state("glClearStencil", value); }
    void before_PolygonOffset(GLfloat factor, GLfloat units) { state("glPolygonOffset", factor, units); }
    void before_PolygonMode(GLenum, GLenum mode) { state("glPolygonMode", mode); }
    void before_DepthRange(GLdouble near, GLdouble far) { state("glDepthRange", near, far); }
    void before_LineWidth(GLfloat width) { state("glLineWidth", width); }
    void before_Scissor(GLint x, GLint y, GLsizei w, GLsizei h) { state("glScissor", x, y, w, h); }
    void before_Viewport(GLint x, GLint y, GLsizei w, GLsizei h) { state("glViewport", x, y, w, h); }
    void before_ClipControl(GLenum origin, GLenum depth) { state("glClipControl", origin, depth); }
    void before_UseProgram(GLuint program) {
        state("glUseProgram", program);
        program_ = program;
    }
    void before_BindVertexArray(GLuint array) {
        state("glBindVertexArray", array);
        vertexArray_ = array;
    }
    void before_ActiveTexture(GLenum unit) { unit_ = unit; }
    void before_BindTexture(GLenum target, GLuint texture) {
        state(bindingOf(unit_), target, texture);
        if (inFrame_ && texture != 0) bound_.insert(texture);
        texture_ = texture;
    }
    void before_BindFramebuffer(GLenum target, GLuint framebuffer) {
        // Reading and drawing may be bound apart; a blit then belongs to the framework.
        if (target == GL_FRAMEBUFFER) state("glBindFramebuffer", framebuffer);
        if (target != GL_READ_FRAMEBUFFER) {
            framebuffer_ = framebuffer;
            passOpen_ = false;
        }
    }

    // ---- Uniforms
    void before_Uniform1f(GLint at, GLfloat value) { uniform(at, values(value), 4); }
    void before_Uniform1i(GLint at, GLint value) { uniform(at, values(value), 4); }
    void before_Uniform2fv(GLint at, GLsizei n, const GLfloat* v) { uniform(at, bytes(v, 8 * n), 8 * n); }
    void before_Uniform3fv(GLint at, GLsizei n, const GLfloat* v) { uniform(at, bytes(v, 12 * n), 12 * n); }
    void before_Uniform4fv(GLint at, GLsizei n, const GLfloat* v) { uniform(at, bytes(v, 16 * n), 16 * n); }
    void before_UniformMatrix3fv(GLint at, GLsizei n, GLboolean, const GLfloat* v) {
        uniform(at, bytes(v, 36 * n), 36 * n);
    }
    void before_UniformMatrix4fv(GLint at, GLsizei n, GLboolean, const GLfloat* v) {
        uniform(at, bytes(v, 64 * n), 64 * n);
    }

    // ---- Uploads and objects
    void before_BindBuffer(GLenum target, GLuint buffer) { buffers_[target] = buffer; }
    void before_BufferData(GLenum target, GLsizeiptr size, const void* data, GLenum) {
        upload("buffer", GL_BUFFER, buffers_[target], data, size);
    }
    void before_TexImage2D(GLenum, GLint level, GLint, GLsizei width, GLsizei height, GLint, GLenum format, GLenum type,
                           const void* data) {
        filled(level, data, long(width) * height * bytesOfPixel(format, type));
    }
    void before_TexImage3D(GLenum, GLint level, GLint, GLsizei width, GLsizei height, GLsizei depth, GLint,
                           GLenum format, GLenum type, const void* data) {
        filled(level, data, long(width) * height * depth * bytesOfPixel(format, type));
    }
    void before_GenerateMipmap(GLenum) { parts_.levelsMade(texture_); }
    void before_TexParameteri(GLenum, GLenum name, GLint value) {
        if (name == GL_TEXTURE_MIN_FILTER) parts_.filterSet(texture_, static_cast<GLenum>(value));
    }
    void before_EnableVertexAttribArray(GLuint attribute) { parts_.attributeMade(vertexArray_, attribute); }
    void after_GenTextures(GLsizei n, GLuint* names) { made(textures_, n, names); }
    void after_GenVertexArrays(GLsizei n, GLuint* names) { made(arrays_, n, names); }
    void before_AttachShader(GLuint program, GLuint shader) {
        GLint kind = 0;
        below.GetShaderiv(shader, GL_SHADER_TYPE, &kind);
        if (kind == GL_GEOMETRY_SHADER) makesPrimitives_[program] = GL_GEOMETRY_SHADER;
        if (kind == GL_TESS_EVALUATION_SHADER) makesPrimitives_.emplace(program, GL_TESS_EVALUATION_SHADER);
    }
    void before_LinkProgram(GLuint program) { programs_.emplace(program, false); }
    void before_DeleteTextures(GLsizei n, const GLuint* names) {
        gone(textures_, n, names);
        forget(GL_TEXTURE, n, names);
        for (GLsizei i = 0; i < n; ++i) parts_.textureGone(names[i]);
    }
    void before_DeleteBuffers(GLsizei n, const GLuint* names) { forget(GL_BUFFER, n, names); }
    void before_DeleteVertexArrays(GLsizei n, const GLuint* names) {
        gone(arrays_, n, names);
        for (GLsizei i = 0; i < n; ++i) parts_.meshGone(names[i]);
    }
    void before_DeleteProgram(GLuint program) {
        programs_.erase(program);
        samplers_.erase(program);
        makesPrimitives_.erase(program);
    }
    void after_FramebufferTexture2D(GLenum, GLenum, GLenum, GLuint texture, GLint) {
        attached_[framebuffer_].insert(texture);
    }
    void before_DeleteFramebuffers(GLsizei n, const GLuint* names) {
        for (GLsizei i = 0; i < n; ++i) {
            attached_.erase(names[i]);
            unread_.erase(names[i]);
            tested_.erase(names[i]);
        }
    }
    void before_BlitFramebuffer(GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLbitfield, GLenum) {
        readBack();
    }
    void before_ReadPixels(GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void*) { readBack(); }

    // ---- Draws. Draws within a query of the demo's own are a measurement, as of a probe, and no work of the picture.
    void before_BeginQuery(GLenum, GLuint) { inQuery_ = true; }
    void after_EndQuery(GLenum) { inQuery_ = false; }
    void before_DrawArrays(GLenum, GLint, GLsizei) { beginDraw(); }
    void after_DrawArrays(GLenum mode, GLint first, GLsizei count) {
        endDraw(mode, count, [=] { below.DrawArrays(mode, first, count); });
    }
    void before_DrawElements(GLenum, GLsizei, GLenum, const void*) { beginDraw(); }
    void after_DrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
        endDraw(mode, count, [=] { below.DrawElements(mode, count, type, indices); });
    }
    void before_DispatchCompute(GLuint, GLuint, GLuint) {
        if (!inFrame_) return;
        use(programs_, program_);
        std::erase_if(pending_, [&](const auto& key) { return key.first == program_; });
    }
    void before_PatchParameteri(GLenum, GLint value) { state("glPatchParameteri", value); }
    void before_Clear(GLbitfield) { ++work_.stateChanges; }

  private:
    template <class... T>
    static std::string values(T... value) {
        std::string text;
        ((text += std::to_string(value) + " "), ...);
        return text;
    }
    static std::string bytes(const void* data, GLsizei count) {
        return {static_cast<const char*>(data), static_cast<std::size_t>(count)};
    }
    void filled(GLint level, const void* texels, long size) {
        if (level > 0) parts_.levelsMade(texture_);
        // Bound to be filled, not to be sampled; binding it again for that is another thing.
        bound_.erase(texture_);
        state_.erase(bindingOf(unit_));
        upload("texture", GL_TEXTURE, texture_, texels, size);
    }
    static std::string bindingOf(GLenum unit) { return "glBindTexture on unit " + std::to_string(unit - GL_TEXTURE0); }
    static long bytesOfPixel(GLenum format, GLenum type) {
        const long channels = format == GL_RGBA ? 4 : format == GL_RGB ? 3 : format == GL_RG ? 2 : 1;
        return channels * (type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT || type == GL_HALF_FLOAT ? 2 : 4);
    }
    static void made(Objects& objects, GLsizei n, const GLuint* names) {
        for (GLsizei i = 0; i < n; ++i) objects.emplace(names[i], false);
    }
    static void gone(Objects& objects, GLsizei n, const GLuint* names) {
        for (GLsizei i = 0; i < n; ++i) objects.erase(names[i]);
    }
    static void use(Objects& objects, GLuint name) {
        const auto found = objects.find(name);
        if (found != objects.end()) found->second = true;
    }

    template <class... T>
    void state(const std::string& what, T... value) {
        state(what, values(value...));
    }
    void state(const std::string& what, const char* value) { state(what, std::string(value)); }
    void state(const std::string& what, const std::string& value) {
        if (!inFrame_) return;
        ++work_.stateChanges;
        const auto [known, isNew] = state_.emplace(what, value);
        if (!isNew && known->second == value) find(waste::stateAgain, what);
        known->second = value;
    }
    void bothFaces(const std::string& what, GLenum face, const std::string& value) {
        if (!inFrame_) return;
        ++work_.stateChanges;
        bool changed = false;
        for (const GLenum one : std::initializer_list<GLenum>{GL_FRONT, GL_BACK}) {
            if (face != GL_FRONT_AND_BACK && face != one) continue;
            const auto [known, isNew] = state_.emplace(what + (one == GL_FRONT ? " front" : " back"), value);
            changed |= isNew || known->second != value;
            known->second = value;
        }
        if (!changed) find(waste::stateAgain, what);
    }
    void uniform(GLint at, const std::string& value, long size) {
        if (!inFrame_) return;
        work_.bytesUploaded += size;
        const std::pair key{program_, at};
        const auto [known, isNew] = uniforms_.emplace(key, value);
        if (!isNew && (known->second == value || pending_.contains(key))) find(waste::uniformAgain, uniformName(at));
        known->second = value;
        pending_.insert(key);
    }
    // An upload is known by its bytes and by the label of where it went, not by the object's number: an object
    // that is made anew in each frame and filled with the same is as needless as one that is filled again. Two objects
    // that live beside each other may well hold the same.
    using Content = std::tuple<std::string, long, std::size_t>;  // where to, how many bytes, and their hash
    struct Holders {
        std::set<GLuint> objects;
        bool lost = false;  // one held it and no longer does
    };
    void upload(const char* word, GLenum kind, GLuint object, const void* data, long size) {
        if (!data) return;
        work_.bytesUploaded += size;
        std::string label = labelOf(kind, object);
        if (label.starts_with("unnamed")) label = "without a label";
        const std::string_view all(static_cast<const char*>(data), static_cast<std::size_t>(size));
        const Content content(word + (" " + label), size, std::hash<std::string_view>{}(all));
        Holders& holders = uploaded_[content];
        if (inFrame_ && (holders.lost || holders.objects.contains(object))) {
            find(waste::uploadAgain, std::get<0>(content), size);
        } else if (inFrame_ && !holders.objects.empty()) {
            perhapsAgain_.push_back(content);  // it may replace one of them, which is deleted after it
        }
        forget(kind, object);
        holders.objects.insert(object);
        holds_[{kind, object}] = content;
    }
    void forget(GLenum kind, GLuint object) {
        const auto held = holds_.find({kind, object});
        if (held == holds_.end()) return;
        Holders& holders = uploaded_[held->second];
        holders.objects.erase(object);
        holders.lost = true;
        holds_.erase(held);
    }
    void forget(GLenum kind, GLsizei n, const GLuint* names) {
        for (GLsizei i = 0; i < n; ++i) forget(kind, names[i]);
    }
    struct Uniform {
        std::string name;
        GLenum type;
        GLint location;
    };
    std::vector<Uniform> activeUniforms() const {
        GLint count = 0;
        below.GetProgramiv(program_, GL_ACTIVE_UNIFORMS, &count);
        std::vector<Uniform> uniforms;
        for (GLint i = 0; i < count; ++i) {
            char name[128] = {};
            GLint size = 0;
            GLenum type = 0;
            below.GetActiveUniform(program_, static_cast<GLuint>(i), sizeof name, nullptr, &size, &type, name);
            uniforms.push_back({name, type, below.GetUniformLocation(program_, name)});
        }
        return uniforms;
    }
    std::string uniformName(GLint at) const {
        for (const Uniform& uniform : activeUniforms()) {
            if (uniform.location == at) return "uniform " + uniform.name;
        }
        return "uniform at " + std::to_string(at);
    }

    void expectInitialState();
    void find(const char* kind, const std::string& what, long size = 0) {
        Finding& finding = findings_.try_emplace({kind, what}, Finding{kind, what, 0, 0}).first->second;
        ++finding.times;
        finding.bytes += size;
    }
    void beginDraw();
    template <class Draw>
    void endDraw(GLenum mode, GLsizei count, const Draw& draw);
    template <class Draw>
    TriangleCount triangles(GLenum mode, GLsizei count, const Draw& draw) const;
    std::optional<bool> makesTriangles() const;
    bool stencilCountsElsewhere() const;
    void noteSampled();
    void notePass();
    void readBack();
    void checkAttachments();

    std::map<std::pair<std::string, std::string>, Finding> findings_;
    FrameWork work_;
    bool inFrame_ = false, inQuery_ = false, repeats_ = false, passOpen_ = false;
    GLuint picture_ = 0, framebuffer_ = 0, program_ = 0, vertexArray_ = 0, texture_ = 0;
    GLenum unit_ = GL_TEXTURE0;
    GLuint query_ = 0;

    std::map<std::string, std::string> state_;
    std::map<std::pair<GLuint, GLint>, std::string> uniforms_;
    std::set<std::pair<GLuint, GLint>> pending_;  // set, and no draw since

    std::map<GLenum, GLuint> buffers_;  // bound, by target
    std::map<Content, Holders> uploaded_;
    std::map<std::pair<GLenum, GLuint>, Content> holds_;
    std::vector<Content> perhapsAgain_;  // uploaded in this frame, and some other object already held it

    Objects textures_, arrays_, programs_;
    std::map<GLuint, GLenum> makesPrimitives_;  // of a program: its last stage that makes others of those it is given
    ReadParts parts_{below};
    struct Sampler {
        GLint location;
        GLenum binding;  // by which the driver is asked for the texture
    };
    std::map<GLuint, std::vector<Sampler>> samplers_;  // of a program
    std::map<GLuint, std::set<GLuint>> attached_;      // of a framebuffer: its textures
    std::set<GLuint> bound_, sampled_;                 // textures, in this frame
    std::set<GLuint> unread_;                          // framebuffers drawn into, whose result nobody has read yet
    std::map<GLuint, std::pair<bool, bool>> tested_;   // of a framebuffer drawn into: whether depth, stencil was used
};

std::unique_ptr<Recorder> recorder;

// ---- Draws

void Recorder::beginDraw() {
    if (!inFrame_ || inQuery_) return;
    below.GenQueries(1, &query_);
    below.BeginQuery(GL_SAMPLES_PASSED, query_);
}

template <class Draw>
void Recorder::endDraw(GLenum mode, GLsizei count, const Draw& draw) {
    if (!inFrame_) return;
    if (inQuery_) {
        use(programs_, program_);
        use(arrays_, vertexArray_);
        std::erase_if(pending_, [&](const auto& key) { return key.first == program_; });
        return;
    }
    GLuint samples = 0;
    below.EndQuery(GL_SAMPLES_PASSED);
    below.GetQueryObjectuiv(query_, GL_QUERY_RESULT, &samples);
    below.DeleteQueries(1, &query_);
    ++work_.draws;
    work_.samplesPassed += samples;
    use(programs_, program_);
    use(arrays_, vertexArray_);
    parts_.drawn(vertexArray_, program_);
    std::erase_if(pending_, [&](const auto& key) { return key.first == program_; });
    notePass();
    const TriangleCount sorted = triangles(mode, count, draw);
    work_.triangles.submitted += sorted.submitted;
    work_.triangles.outside += sorted.outside;
    work_.triangles.culled += sorted.culled;
    work_.triangles.surviving += sorted.surviving;
    const std::string name = labelOf(GL_VERTEX_ARRAY, vertexArray_);
    if (samples > 0) {
        noteSampled();
    } else if (sorted.submitted > 0 && sorted.outside == sorted.submitted) {
        find(waste::outsideView, "draw of " + name);
    } else if (!stencilCountsElsewhere() && below.IsEnabled(GL_RASTERIZER_DISCARD) == GL_FALSE) {
        find(waste::noSample, "draw of " + name);
    }
}

// Whether a sample that fails its test changes the stencil: then a draw that passes none still does its work.
bool Recorder::stencilCountsElsewhere() const {
    if (below.IsEnabled(GL_STENCIL_TEST) == GL_FALSE) return false;
    for (const GLenum op : std::initializer_list<GLenum>{GL_STENCIL_FAIL, GL_STENCIL_PASS_DEPTH_FAIL,
                                                         GL_STENCIL_BACK_FAIL, GL_STENCIL_BACK_PASS_DEPTH_FAIL}) {
        GLint value = GL_KEEP;
        below.GetIntegerv(op, &value);
        if (value != GL_KEEP) return true;
    }
    return false;
}

// Whether a program's own stages end in triangles; nothing where they make no primitives.
std::optional<bool> Recorder::makesTriangles() const {
    const auto found = makesPrimitives_.find(program_);
    if (found == makesPrimitives_.end()) return {};
    const auto ask = [&](GLenum what) {
        GLint answer = 0;
        below.GetProgramiv(program_, what, &answer);
        return answer;
    };
    if (found->second == GL_GEOMETRY_SHADER) return ask(GL_GEOMETRY_OUTPUT_TYPE) == GL_TRIANGLE_STRIP;
    return ask(GL_TESS_GEN_POINT_MODE) == GL_FALSE && ask(GL_TESS_GEN_MODE) != GL_ISOLINES;
}

template <class Draw>
TriangleCount Recorder::triangles(GLenum mode, GLsizei count, const Draw& draw) const {
    if (const std::optional<bool> made = makesTriangles()) {
        if (!*made) return {};
        const Layer<Recorder>::Past past;
        return sortTriangles(captured(GL_TRIANGLES, draw).positions);
    }
    if (mode != GL_TRIANGLES && mode != GL_TRIANGLE_STRIP && mode != GL_TRIANGLE_FAN) return {};
    if (count < 3) return {};
    const Layer<Recorder>::Past past;
    const Counters counted = counters();
    // The feedback expands strips and fans into separate triangles.
    const GLsizei corners = mode == GL_TRIANGLES ? count : 3 * (count - 2);
    std::vector<fvec4> positions(static_cast<std::size_t>(corners));
    const auto size = static_cast<GLsizeiptr>(positions.size() * sizeof(fvec4));
    const Buffer buffer = makeBuffer();
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer.id());
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, size, nullptr, GL_STREAM_READ);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_TRIANGLES);
    draw();
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    if (const void* mapped = glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, size, GL_MAP_READ_BIT)) {
        std::memcpy(positions.data(), mapped, static_cast<std::size_t>(size));
        glUnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
    }
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    resetCounters(counted);
    return sortTriangles(positions);
}

// The textures on the units of the program's samplers were read by this draw.
void Recorder::noteSampled() {
    const auto [known, isNew] = samplers_.try_emplace(program_);
    if (isNew) {
        for (const Uniform& uniform : activeUniforms()) {
            if (uniform.type == GL_SAMPLER_2D || uniform.type == GL_SAMPLER_2D_SHADOW) {
                known->second.push_back({uniform.location, GL_TEXTURE_BINDING_2D});
            } else if (uniform.type == GL_SAMPLER_3D) {
                known->second.push_back({uniform.location, GL_TEXTURE_BINDING_3D});
            } else if (uniform.type == GL_SAMPLER_CUBE) {
                known->second.push_back({uniform.location, GL_TEXTURE_BINDING_CUBE_MAP});
            }
        }
    }
    for (const Sampler& sampler : known->second) {
        GLint unit = 0, texture = 0;
        below.GetUniformiv(program_, sampler.location, &unit);
        below.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        below.GetIntegerv(sampler.binding, &texture);
        const auto name = static_cast<GLuint>(texture);
        sampled_.insert(name);
        use(textures_, name);
        parts_.sampled(name);
        std::erase_if(unread_, [&](GLuint framebuffer) { return attached_[framebuffer].contains(name); });
    }
    below.ActiveTexture(unit_);
}

void Recorder::notePass() {
    auto& [depth, stencil] = tested_[framebuffer_];
    depth |= below.IsEnabled(GL_DEPTH_TEST) == GL_TRUE;
    stencil |= below.IsEnabled(GL_STENCIL_TEST) == GL_TRUE;
    if (passOpen_) return;
    passOpen_ = true;
    ++work_.passes;
    if (framebuffer_ == picture_) return;
    unread_.insert(framebuffer_);
    if (repeats_) find(waste::repeatedPass, "pass into " + labelOf(GL_FRAMEBUFFER, framebuffer_));
}

void Recorder::readBack() {
    GLint reading = 0;
    below.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &reading);
    unread_.erase(static_cast<GLuint>(reading));
}

void Recorder::checkAttachments() {
    const Layer<Recorder>::Past past;
    GLint before = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
    const auto has = [](GLenum attachment) {
        GLint kind = GL_NONE;
        glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE,
                                              &kind);
        return kind != GL_NONE;
    };
    for (const auto& [framebuffer, tests] : tested_) {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
        const std::string name = labelOf(GL_FRAMEBUFFER, framebuffer);
        const bool stencil = has(GL_STENCIL_ATTACHMENT);
        // Depth comes with stencil: there is no stencil alone.
        if (!tests.first && has(GL_DEPTH_ATTACHMENT) && !stencil) find(waste::unusedBuffer, "depth of " + name);
        if (!tests.second && stencil) find(waste::unusedBuffer, "stencil of " + name);
    }
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(before));
}

// ---- Frames

// As if it had been set so just before.
void Recorder::expectInitialState() {
    state_.clear();
    for (const GLenum capability : std::initializer_list<GLenum>{
             GL_BLEND, GL_CULL_FACE, GL_DEPTH_CLAMP, GL_DEPTH_TEST, GL_FRAMEBUFFER_SRGB, GL_POLYGON_OFFSET_FILL,
             GL_PROGRAM_POINT_SIZE, GL_RASTERIZER_DISCARD, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_COVERAGE,
             GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_TEXTURE_CUBE_MAP_SEAMLESS}) {
        before_Disable(capability);
    }
    for (GLenum i = 0; i < 8; ++i) before_Disable(GL_CLIP_DISTANCE0 + i);
    before_Enable(GL_DITHER);
    before_Enable(GL_MULTISAMPLE);
    before_BlendEquation(GL_FUNC_ADD);
    before_BlendFunc(GL_ONE, GL_ZERO);
    before_ClearColor(0, 0, 0, 0);
    before_ClearDepth(1);
    before_ClearStencil(0);
    before_ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    before_ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    before_CullFace(GL_BACK);
    before_DepthFunc(GL_LESS);
    before_DepthMask(GL_TRUE);
    before_DepthRange(0, 1);
    before_FrontFace(GL_CCW);
    before_LineWidth(1);
    before_PatchParameteri(GL_PATCH_VERTICES, 3);
    before_PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    before_PolygonOffset(0, 0);
    before_StencilFunc(GL_ALWAYS, 0, ~0U);
    before_StencilMask(~0U);
    before_StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

void Recorder::begin(bool repeats) {
    inFrame_ = true;
    expectInitialState();
    work_ = {};
    uniforms_.clear();
    pending_.clear();
    bound_.clear();
    sampled_.clear();
    unread_.clear();
    tested_.clear();
    passOpen_ = false;
    repeats_ = repeats;
    GLint value = 0;
    below.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &value);
    picture_ = framebuffer_ = static_cast<GLuint>(value);
    below.GetIntegerv(GL_CURRENT_PROGRAM, &value);
    program_ = static_cast<GLuint>(value);
    below.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &value);
    vertexArray_ = static_cast<GLuint>(value);
}

FrameWork Recorder::end() {
    inFrame_ = false;
    checkAttachments();
    for (const Content& content : perhapsAgain_) {
        if (uploaded_[content].lost) find(waste::uploadAgain, std::get<0>(content), std::get<1>(content));
    }
    perhapsAgain_.clear();
    for (const GLuint texture : bound_) {
        if (!sampled_.contains(texture)) find(waste::unsampled, "texture " + labelOf(GL_TEXTURE, texture));
    }
    for (const GLuint framebuffer : unread_) {
        if (!attached_[framebuffer].empty()) {
            find(waste::unreadPass, "pass into " + labelOf(GL_FRAMEBUFFER, framebuffer));
        }
    }
    return work_;
}

std::vector<Finding> Recorder::take() {
    const auto unused = [&](const Objects& objects, GLenum kind, const char* word) {
        for (const auto& [name, used] : objects) {
            if (!used) find(waste::unusedObject, std::string(word) + " " + labelOf(kind, name));
        }
    };
    unused(textures_, GL_TEXTURE, "texture");
    unused(arrays_, GL_VERTEX_ARRAY, "mesh");
    unused(programs_, GL_PROGRAM, "program");
    parts_.unread([&](GLenum kind, GLuint object, const std::string& part) {
        // An object that is never used at all has been named already.
        const Objects& objects = kind == GL_TEXTURE ? textures_ : arrays_;
        const auto found = objects.find(object);
        if (found != objects.end() && found->second) find(waste::unreadPart, part + labelOf(kind, object));
    });
    std::vector<Finding> findings;
    for (const auto& [key, finding] : findings_) findings.push_back(finding);
    return findings;
}

}  // namespace

bool auditing() { return recorder != nullptr; }

void startAudit() {
    recorder = std::make_unique<Recorder>();
    takeBeyondEs();
    setLayer([] {
        Layer<Recorder>::layOver(*recorder);
        layBeyondEs();  // over it, so that the recorder's own calls are none of the demo's
    });
}

void beginAuditedFrame(bool repeats) { recorder->begin(repeats); }
FrameWork endAuditedFrame() { return recorder->end(); }

std::vector<Finding> stopAudit() {
    setLayer({});
    std::vector<Finding> findings = recorder->take();
    recorder.reset();
    return findings;
}

}  // namespace mv
