#include "mv/gl/undefined.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "mv/gl/functions.h"
#include "mv/gl/layer.h"
#include "mv/gl/state_names.h"

namespace mv {
namespace {

class UndefinedWatch;
const FunctionTable& below = Layer<UndefinedWatch>::below;

GLint ask(GLenum what) {
    GLint answer = 0;
    below.GetIntegerv(what, &answer);
    return answer;
}
GLuint bound(GLenum binding) { return static_cast<GLuint>(ask(binding)); }

// ---- Samplers

enum class Reads { floats, integers, naturals, comparison };

struct SamplerKind {
    GLenum type, target, binding;
    Reads reads;
};

constexpr std::array samplerKinds{
    SamplerKind{GL_SAMPLER_1D, GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D, Reads::floats},
    SamplerKind{GL_SAMPLER_2D, GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, Reads::floats},
    SamplerKind{GL_SAMPLER_3D, GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D, Reads::floats},
    SamplerKind{GL_SAMPLER_CUBE, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP, Reads::floats},
    SamplerKind{GL_SAMPLER_2D_ARRAY, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY, Reads::floats},
    SamplerKind{GL_SAMPLER_2D_SHADOW, GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, Reads::comparison},
    SamplerKind{GL_SAMPLER_CUBE_SHADOW, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP, Reads::comparison},
    SamplerKind{GL_SAMPLER_2D_ARRAY_SHADOW, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY, Reads::comparison},
    SamplerKind{GL_INT_SAMPLER_2D, GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, Reads::integers},
    SamplerKind{GL_INT_SAMPLER_2D_ARRAY, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY, Reads::integers},
    SamplerKind{GL_UNSIGNED_INT_SAMPLER_2D, GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, Reads::naturals},
    SamplerKind{GL_UNSIGNED_INT_SAMPLER_2D_ARRAY, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY, Reads::naturals},
};

const SamplerKind* samplerKind(GLenum type) {
    const auto found = std::find_if(samplerKinds.begin(), samplerKinds.end(),
                                    [&](const SamplerKind& kind) { return kind.type == type; });
    return found == samplerKinds.end() ? nullptr : &*found;
}

bool isSampler(GLenum type) {
    const auto within = [&](GLenum first, GLenum last) { return type >= first && type <= last; };
    return within(GL_SAMPLER_1D, GL_SAMPLER_2D_RECT_SHADOW) || within(GL_SAMPLER_1D_ARRAY, GL_SAMPLER_CUBE_SHADOW) ||
           within(GL_INT_SAMPLER_1D, GL_UNSIGNED_INT_SAMPLER_BUFFER) ||
           within(GL_SAMPLER_CUBE_MAP_ARRAY, GL_UNSIGNED_INT_SAMPLER_CUBE_MAP_ARRAY) ||
           within(GL_SAMPLER_2D_MULTISAMPLE, GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE_ARRAY);
}

bool isImage(GLenum type) { return type >= GL_IMAGE_1D && type <= GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE_ARRAY; }

struct UniformPlace {
    std::string name;
    GLenum type;
    GLint location;
};

// Each element of an array by itself. Those of a block have no location.
std::vector<UniformPlace> uniformsOf(GLuint program) {
    std::vector<UniformPlace> uniforms;
    GLint count = 0;
    below.GetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        std::array<char, 256> text{};
        GLint size = 0;
        GLenum type = 0;
        below.GetActiveUniform(program, static_cast<GLuint>(i), static_cast<GLsizei>(text.size()), nullptr, &size,
                               &type, text.data());
        std::string name = text.data();
        if (name.ends_with("[0]")) name.resize(name.size() - 3);
        for (GLint element = 0; element < size; ++element) {
            const std::string one = size == 1 ? name : name + "[" + std::to_string(element) + "]";
            uniforms.push_back({one, type, below.GetUniformLocation(program, one.c_str())});
        }
    }
    return uniforms;
}

// ---- Textures

GLint textureParameter(GLenum target, GLenum what) {
    GLint answer = 0;
    below.GetTexParameteriv(target, what, &answer);
    return answer;
}

GLint levelParameter(GLenum face, GLint level, GLenum what) {
    GLint answer = 0;
    below.GetTexLevelParameteriv(face, level, what, &answer);
    return answer;
}

std::vector<GLenum> facesOf(GLenum target) {
    if (target != GL_TEXTURE_CUBE_MAP) return {target};
    std::vector<GLenum> faces;
    for (GLenum face = 0; face < 6; ++face) faces.push_back(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face);
    return faces;
}

// The levels of the texture that is bound to a target, from the base to the last that its filter reads.
struct Levels {
    GLint first, last;
};

Levels levelsRead(GLenum target) {
    const GLint base = textureParameter(target, GL_TEXTURE_BASE_LEVEL);
    const auto filter = static_cast<GLenum>(textureParameter(target, GL_TEXTURE_MIN_FILTER));
    if (filter == GL_NEAREST || filter == GL_LINEAR) return {base, base};
    const GLenum face = facesOf(target).front();
    GLint last = base;
    for (GLint side =
             std::max(levelParameter(face, base, GL_TEXTURE_WIDTH), levelParameter(face, base, GL_TEXTURE_HEIGHT));
         side > 1; side /= 2) {
        ++last;
    }
    return {base, std::min(last, textureParameter(target, GL_TEXTURE_MAX_LEVEL))};
}

// The fault of the texture that is bound to a target, for a sampler of this kind; nothing where all is right.
std::optional<std::string> textureFault(GLenum target, Reads reads) {
    const std::vector<GLenum> faces = facesOf(target);
    const Levels levels = levelsRead(target);
    const GLint width = levelParameter(faces.front(), levels.first, GL_TEXTURE_WIDTH);
    const GLint height = levelParameter(faces.front(), levels.first, GL_TEXTURE_HEIGHT);
    const GLint format = levelParameter(faces.front(), levels.first, GL_TEXTURE_INTERNAL_FORMAT);
    if (width == 0) return "which has no texels";
    if (faces.size() > 1 && width != height) return "whose faces are not square";
    for (const GLenum face : faces) {
        for (GLint level = levels.first; level <= levels.last; ++level) {
            const int halvings = level - levels.first;
            if (levelParameter(face, level, GL_TEXTURE_WIDTH) != std::max(1, width >> halvings) ||
                levelParameter(face, level, GL_TEXTURE_HEIGHT) != std::max(1, height >> halvings) ||
                levelParameter(face, level, GL_TEXTURE_INTERNAL_FORMAT) != format) {
                return "which is not complete: level " + std::to_string(level) +
                       " is missing or of another size or format";
            }
        }
    }
    const bool depth = levelParameter(faces.front(), levels.first, GL_TEXTURE_DEPTH_SIZE) > 0;
    const bool compares = textureParameter(target, GL_TEXTURE_COMPARE_MODE) == GL_COMPARE_REF_TO_TEXTURE;
    if (reads == Reads::comparison) {
        if (!depth) return "which holds no depths, and a shadow sampler compares depths";
        if (!compares) return "whose comparison is off (GL_TEXTURE_COMPARE_MODE), and it is read by a shadow sampler";
        return {};
    }
    if (depth && compares) return "which compares depths, and it is read by a sampler that does not";
    const auto type = depth ? GLenum(GL_FLOAT)
                            : static_cast<GLenum>(levelParameter(faces.front(), levels.first, GL_TEXTURE_RED_TYPE));
    const Reads holds = type == GL_INT ? Reads::integers : type == GL_UNSIGNED_INT ? Reads::naturals : Reads::floats;
    if (holds != reads) return "whose numbers are of another kind than the sampler's";
    if (holds != Reads::floats && textureParameter(target, GL_TEXTURE_MAG_FILTER) != GL_NEAREST)
        return "which holds whole numbers, and they cannot be filtered";
    return {};
}

// ---- Framebuffers

// One picture of a texture or a renderbuffer, and which of its aspects: GL_COLOR, GL_DEPTH or GL_STENCIL.
struct Image {
    GLenum kind = GL_NONE;  // GL_TEXTURE or GL_RENDERBUFFER
    GLuint name = 0;
    GLenum face = GL_NONE;  // of a cube map
    GLint level = 0;
    GLenum aspect = GL_COLOR;
    auto key() const { return std::tie(kind, name, face, level, aspect); }
    bool operator<(const Image& other) const { return key() < other.key(); }
};

std::optional<Image> attached(GLenum framebuffer, GLenum attachment, GLenum aspect) {
    const auto parameter = [&](GLenum what) {
        GLint answer = 0;
        below.GetFramebufferAttachmentParameteriv(framebuffer, attachment, what, &answer);
        return answer;
    };
    const auto kind = static_cast<GLenum>(parameter(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE));
    if (kind == GL_NONE) return {};
    Image image{kind, static_cast<GLuint>(parameter(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)), GL_NONE, 0, aspect};
    if (kind == GL_TEXTURE) {
        image.level = parameter(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL);
        image.face = static_cast<GLenum>(parameter(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE));
    }
    return image;
}

std::vector<Image> imagesOf(GLenum framebuffer, GLbitfield mask) {
    std::vector<Image> images;
    const auto add = [&](GLbitfield bit, GLenum attachment, GLenum aspect) {
        if ((mask & bit) == 0) return;
        if (const std::optional<Image> image = attached(framebuffer, attachment, aspect)) images.push_back(*image);
    };
    for (GLenum i = 0; i < 8; ++i) add(GL_COLOR_BUFFER_BIT, GL_COLOR_ATTACHMENT0 + i, GL_COLOR);
    add(GL_DEPTH_BUFFER_BIT, GL_DEPTH_ATTACHMENT, GL_DEPTH);
    add(GL_STENCIL_BUFFER_BIT, GL_STENCIL_ATTACHMENT, GL_STENCIL);
    return images;
}

std::string nameOf(GLenum aspect) {
    return aspect == GL_COLOR ? "colors" : aspect == GL_DEPTH ? "depths" : "stencil values";
}

std::vector<GLenum> aspectsOf(GLenum format) {
    switch (format) {
        case GL_DEPTH_COMPONENT:
        case GL_DEPTH_COMPONENT16:
        case GL_DEPTH_COMPONENT24:
        case GL_DEPTH_COMPONENT32F:
            return {GL_DEPTH};
        case GL_DEPTH_STENCIL:
        case GL_DEPTH24_STENCIL8:
        case GL_DEPTH32F_STENCIL8:
            return {GL_DEPTH, GL_STENCIL};
        default:
            return {GL_COLOR};
    }
}

// ---- The listener

struct Vertices {
    long first = 0, last = -1;  // none where the last is before the first
};

class UndefinedWatch {
  public:
    // ---- draws
    void before_DrawArrays(GLenum mode, GLint first, GLsizei count) {
        beforeDraw(mode, [&] { return Vertices{first, long{first} + count - 1}; });
    }
    void before_DrawElements(GLenum mode, GLsizei count, GLenum type, const void* offset) {
        beforeDraw(mode, [&] { return indexed(count, type, reinterpret_cast<std::uintptr_t>(offset)); });
    }
    void before_DispatchCompute(GLuint, GLuint, GLuint) {
        if (!isAllowed(Newer::compute)) return;  // it is refused
        subject_ = "dispatch";
        if (const GLuint program = programInUse()) checkUniforms(program, {}, true);
        for (const auto& [unit, texture] : imageUnits_) wrote(Image{GL_TEXTURE, texture, GL_NONE, 0, GL_COLOR});
    }
    void before_BindImageTexture(GLuint unit, GLuint texture, GLint, GLboolean, GLint, GLenum, GLenum) {
        imageUnits_[unit] = texture;
    }

    // ---- programs
    void after_LinkProgram(GLuint program) {
        samplers_.erase(program);
        unset_[program] = {};
        for (const UniformPlace& uniform : uniformsOf(program)) {
            const bool isArray = uniform.name.ends_with(']'),
                       hasUnit = isSampler(uniform.type) || isImage(uniform.type);
            if (uniform.location >= 0 && !isArray && !hasUnit) unset_[program].emplace(uniform.location, uniform.name);
        }
    }
    void before_DeleteProgram(GLuint program) {
        samplers_.erase(program);
        unset_.erase(program);
    }
    void before_Uniform1f(GLint at, GLfloat) { set(at); }
    void before_Uniform1i(GLint at, GLint) { set(at); }
    void before_Uniform2fv(GLint at, GLsizei, const GLfloat*) { set(at); }
    void before_Uniform3fv(GLint at, GLsizei, const GLfloat*) { set(at); }
    void before_Uniform4fv(GLint at, GLsizei, const GLfloat*) { set(at); }
    void before_UniformMatrix3fv(GLint at, GLsizei, GLboolean, const GLfloat*) { set(at); }
    void before_UniformMatrix4fv(GLint at, GLsizei, GLboolean, const GLfloat*) { set(at); }

    // ---- contents
    void after_TexImage2D(GLenum target, GLint level, GLint, GLsizei, GLsizei, GLint, GLenum format, GLenum,
                          const void* data) {
        const bool isFace = target != GL_TEXTURE_2D;
        const GLuint texture = bound(isFace ? GL_TEXTURE_BINDING_CUBE_MAP : GL_TEXTURE_BINDING_2D);
        for (const GLenum aspect : aspectsOf(format)) {
            const Image image{GL_TEXTURE, texture, isFace ? target : GLenum(GL_NONE), level, aspect};
            data ? wrote(image) : void(unwritten_.insert(image));
        }
    }
    void after_RenderbufferStorage(GLenum, GLenum format, GLsizei, GLsizei) { madeRenderbuffer(format); }
    void after_RenderbufferStorageMultisample(GLenum, GLsizei, GLenum format, GLsizei, GLsizei) {
        madeRenderbuffer(format);
    }
    void before_DeleteTextures(GLsizei n, const GLuint* names) { gone(GL_TEXTURE, n, names); }
    void before_DeleteRenderbuffers(GLsizei n, const GLuint* names) { gone(GL_RENDERBUFFER, n, names); }
    void before_Clear(GLbitfield mask) { wroteInto(mask); }
    void before_ClearBufferfv(GLenum buffer, GLint, const GLfloat*) {
        wroteInto(buffer == GL_DEPTH ? GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT);
    }
    void before_BlitFramebuffer(GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLbitfield mask, GLenum) {
        subject_ = "blit";
        requireWritten(GL_READ_FRAMEBUFFER, mask, "it reads");
        wroteInto(mask);
    }
    void before_ReadPixels(GLint, GLint, GLsizei, GLsizei, GLenum format, GLenum, void*) {
        subject_ = "read-back";
        const bool stencil = format == GL_STENCIL_INDEX || format == GL_DEPTH_STENCIL,
                   depth = format == GL_DEPTH_COMPONENT || format == GL_DEPTH_STENCIL;
        requireWritten(GL_READ_FRAMEBUFFER,
                       (stencil ? GL_STENCIL_BUFFER_BIT : 0U) | (depth ? GL_DEPTH_BUFFER_BIT : 0U) |
                           (stencil || depth ? 0U : GL_COLOR_BUFFER_BIT),
                       "it reads");
    }

    // ---- queries and feedback
    void before_BeginQuery(GLenum target, GLuint query) {
        if (openQueries_.contains(target)) fault("query: begun while another of its kind is open");
        openQueries_[target] = query;
        ended_.erase(query);
    }
    void before_EndQuery(GLenum target) {
        const auto open = openQueries_.find(target);
        if (open == openQueries_.end()) return fault("query: ended, and none of its kind was begun");
        ended_.insert(open->second);
        openQueries_.erase(open);
    }
    void before_GetQueryObjectuiv(GLuint query, GLenum, GLuint*) {
        if (!ended_.contains(query)) fault("query: asked for its result, and it was not begun and ended");
    }
    void before_DeleteQueries(GLsizei n, const GLuint* names) {
        for (GLsizei i = 0; i < n; ++i) {
            ended_.erase(names[i]);
            const auto isIt = [&](const auto& open) { return open.second == names[i]; };
            if (std::erase_if(openQueries_, isIt) > 0) fault("query: deleted while it is open");
        }
    }
    void before_BeginTransformFeedback(GLenum) {
        if (feedback_) fault("transform feedback: begun while it is open");
        feedback_ = true;
    }
    void before_EndTransformFeedback() {
        if (!feedback_) fault("transform feedback: ended, and it was not begun");
        feedback_ = false;
    }
    void before_UseProgram(GLuint) {
        if (feedback_) fault("transform feedback: another program is used while it is open");
    }

    // ---- indices: the largest of an element buffer is asked for once
    void before_BufferData(GLenum, GLsizeiptr, const void*, GLenum) { largest_.clear(); }
    void before_DeleteBuffers(GLsizei, const GLuint*) { largest_.clear(); }

  private:
    void fault(const std::string& sentence) { reportFault(sentence); }
    void faultHere(const std::string& rest) { fault(subject_ + ": " + rest); }

    GLuint programInUse() {
        const GLuint program = bound(GL_CURRENT_PROGRAM);
        if (program == 0) faultHere("no program is used");
        return program;
    }

    template <class FindVertices>
    void beforeDraw(GLenum mode, const FindVertices& vertices) {
        subject_ = "draw of " + labelOf(GL_VERTEX_ARRAY, bound(GL_VERTEX_ARRAY_BINDING));
        const GLuint program = programInUse();
        if (program == 0) return;
        const bool drawsPixels = below.IsEnabled(GL_RASTERIZER_DISCARD) == GL_FALSE;
        const bool own = bound(GL_DRAW_FRAMEBUFFER_BINDING) != 0;  // a window's is its own affair
        std::vector<Image> written;
        if (own && drawsPixels) {
            if (below.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
                return faultHere("the framebuffer is not complete");
            written = imagesOf(GL_DRAW_FRAMEBUFFER, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        }
        checkUniforms(program, written, drawsPixels && writesColors(own, written));
        checkAttributes(vertices());
        if (drawsPixels && mode < GL_TRIANGLES && below.IsEnabled(GL_POLYGON_OFFSET_FILL) == GL_TRUE)
            faultHere(
                "points and lines have no polygon's offset, and GL_POLYGON_OFFSET_FILL is on: some drivers push them "
                "all the same");
        if (!own || !drawsPixels) return;
        GLbitfield reads = 0, writes = GL_COLOR_BUFFER_BIT;
        if (below.IsEnabled(GL_BLEND) == GL_TRUE) reads |= GL_COLOR_BUFFER_BIT;
        if (below.IsEnabled(GL_DEPTH_TEST) == GL_TRUE) {
            if (static_cast<GLenum>(ask(GL_DEPTH_FUNC)) != GL_ALWAYS) reads |= GL_DEPTH_BUFFER_BIT;
            if (ask(GL_DEPTH_WRITEMASK) != GL_FALSE) writes |= GL_DEPTH_BUFFER_BIT;
        }
        if (below.IsEnabled(GL_STENCIL_TEST) == GL_TRUE) {
            reads |= GL_STENCIL_BUFFER_BIT;
            writes |= GL_STENCIL_BUFFER_BIT;
        }
        requireWritten(GL_DRAW_FRAMEBUFFER, reads, "a test or blending reads");
        wroteInto(writes);
    }

    // ---- uniforms
    // Where only depths or stencil values are written, or nothing is rasterized, the fragments' colour need not be known.
    static bool writesColors(bool own, const std::vector<Image>& written) {
        std::array<GLint, 4> mask{};
        below.GetIntegerv(GL_COLOR_WRITEMASK, mask.data());
        const auto isColor = [](const Image& image) { return image.aspect == GL_COLOR; };
        return mask != std::array<GLint, 4>{} && (!own || std::any_of(written.begin(), written.end(), isColor));
    }

    void set(GLint location) {
        if (const auto unset = unset_.find(bound(GL_CURRENT_PROGRAM)); unset != unset_.end())
            unset->second.erase(location);
    }

    void checkUniforms(GLuint program, const std::vector<Image>& written, bool colorsCount) {
        if (const auto unset = unset_.find(program); unset != unset_.end() && colorsCount) {
            for (const auto& [location, name] : unset->second)
                faultHere("uniform " + name + " of program " + labelOf(GL_PROGRAM, program) +
                          " is used and was never set: it is 0");
        }
        auto known = samplers_.find(program);
        if (known == samplers_.end()) {
            std::vector<UniformPlace> samplers = uniformsOf(program);
            std::erase_if(samplers, [](const UniformPlace& uniform) { return !isSampler(uniform.type); });
            known = samplers_.emplace(program, std::move(samplers)).first;
        }
        std::map<GLint, const SamplerKind*> units;
        const auto active = static_cast<GLenum>(ask(GL_ACTIVE_TEXTURE));
        for (const UniformPlace& sampler : known->second) checkSampler(program, sampler, units, written);
        below.ActiveTexture(active);
    }

    void checkSampler(GLuint program, const UniformPlace& sampler, std::map<GLint, const SamplerKind*>& units,
                      const std::vector<Image>& written) {
        const SamplerKind* kind = samplerKind(sampler.type);
        if (!kind) return faultHere("sampler " + sampler.name + " is of a kind that mv/gl/undefined.cpp does not know");
        GLint unit = 0;
        below.GetUniformiv(program, sampler.location, &unit);
        const std::string where = "sampler " + sampler.name + " reads unit " + std::to_string(unit);
        const auto [other, isFirst] = units.emplace(unit, kind);
        if (!isFirst && other->second->type != kind->type)
            return faultHere(where + ", as another kind of sampler does");
        below.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        const GLuint texture = bound(kind->binding);
        if (texture == 0) return faultHere(where + ", where no texture is bound");
        const std::string what = where + ", texture " + labelOf(GL_TEXTURE, texture);
        if (const std::optional<std::string> wrong = textureFault(kind->target, kind->reads))
            return faultHere(what + ", " + *wrong);
        const Levels levels = levelsRead(kind->target);
        const auto isRead = [&](const Image& image) {
            return image.kind == GL_TEXTURE && image.name == texture && image.level >= levels.first &&
                   image.level <= levels.last;
        };
        if (std::any_of(written.begin(), written.end(), isRead)) faultHere(what + ", which the draw writes");
        const auto never = std::find_if(unwritten_.begin(), unwritten_.end(), isRead);
        if (never != unwritten_.end()) faultHere(what + ", whose " + nameOf(never->aspect) + " were never written");
    }

    // ---- attributes
    static long sizeOfBuffer(GLuint buffer) {
        const GLuint before = bound(GL_COPY_READ_BUFFER_BINDING);
        below.BindBuffer(GL_COPY_READ_BUFFER, buffer);
        GLint size = 0;
        below.GetBufferParameteriv(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &size);
        below.BindBuffer(GL_COPY_READ_BUFFER, before);
        return size;
    }

    Vertices indexed(GLsizei count, GLenum type, std::uintptr_t offset) {
        const GLuint buffer = bound(GL_ELEMENT_ARRAY_BUFFER_BINDING);
        if (buffer == 0) return faultHere("it has indices, and no buffer of them is bound"), Vertices{};
        const std::size_t one = type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : 4;
        const std::size_t all = one * static_cast<std::size_t>(count);
        if (offset + all > static_cast<std::size_t>(sizeOfBuffer(buffer)))
            return faultHere("its indices reach beyond their buffer"), Vertices{};
        const auto [known, isNew] = largest_.try_emplace({buffer, offset, count, type}, -1);
        if (isNew) {
            std::vector<std::uint8_t> bytes(all);
            below.GetBufferSubData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(all),
                                   bytes.data());
            for (std::size_t i = 0; i < all; i += one) {
                long index = 0;
                for (std::size_t byte = one; byte-- > 0;) index = index * 256 + bytes[i + byte];  // little-endian
                known->second = std::max(known->second, index);
            }
        }
        return {0, known->second};
    }

    void checkAttributes(Vertices vertices) {
        if (vertices.last < vertices.first) return;
        const auto most = static_cast<GLuint>(ask(GL_MAX_VERTEX_ATTRIBS));
        for (GLuint attribute = 0; attribute < most; ++attribute) {
            const auto parameter = [&](GLenum what) {
                GLint answer = 0;
                below.GetVertexAttribiv(attribute, what, &answer);
                return answer;
            };
            if (parameter(GL_VERTEX_ATTRIB_ARRAY_ENABLED) == GL_FALSE) continue;
            const std::string name = "attribute " + std::to_string(attribute);
            const auto buffer = static_cast<GLuint>(parameter(GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING));
            if (buffer == 0) return faultHere(name + " is enabled, and has no buffer");
            const auto type = static_cast<GLenum>(parameter(GL_VERTEX_ATTRIB_ARRAY_TYPE));
            const long one = type == GL_UNSIGNED_BYTE || type == GL_BYTE     ? 1
                             : type == GL_UNSIGNED_SHORT || type == GL_SHORT ? 2
                                                                             : 4;
            const long size = one * parameter(GL_VERTEX_ATTRIB_ARRAY_SIZE);
            const long stride = parameter(GL_VERTEX_ATTRIB_ARRAY_STRIDE);
            void* pointer = nullptr;
            below.GetVertexAttribPointerv(attribute, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
            const long end = static_cast<long>(reinterpret_cast<std::uintptr_t>(pointer)) +
                             vertices.last * (stride ? stride : size) + size;
            if (end > sizeOfBuffer(buffer)) {
                faultHere(name + " ends before vertex " + std::to_string(vertices.last) + ": its buffer has " +
                          std::to_string(sizeOfBuffer(buffer)) + " bytes of " + std::to_string(end));
            }
        }
    }

    // ---- contents
    void madeRenderbuffer(GLenum format) {
        for (const GLenum aspect : aspectsOf(format))
            unwritten_.insert({GL_RENDERBUFFER, bound(GL_RENDERBUFFER_BINDING), GL_NONE, 0, aspect});
    }
    void gone(GLenum kind, GLsizei n, const GLuint* names) {
        for (GLsizei i = 0; i < n; ++i) {
            std::erase_if(unwritten_, [&](const Image& image) { return image.kind == kind && image.name == names[i]; });
        }
    }
    void wrote(const Image& image) { unwritten_.erase(image); }
    void wroteInto(GLbitfield mask) {
        if (bound(GL_DRAW_FRAMEBUFFER_BINDING) == 0) return;
        for (const Image& image : imagesOf(GL_DRAW_FRAMEBUFFER, mask)) wrote(image);
    }
    void requireWritten(GLenum framebuffer, GLbitfield mask, const std::string& why) {
        const bool read = framebuffer == GL_READ_FRAMEBUFFER;
        const GLuint name = bound(read ? GL_READ_FRAMEBUFFER_BINDING : GL_DRAW_FRAMEBUFFER_BINDING);
        if (name == 0) return;
        for (const Image& image : imagesOf(framebuffer, mask)) {
            if (unwritten_.contains(image)) {
                faultHere(why + " the " + nameOf(image.aspect) + " of " + labelOf(GL_FRAMEBUFFER, name) +
                          ", which were never written");
            }
        }
    }

    std::string subject_;
    std::map<GLuint, std::vector<UniformPlace>> samplers_;  // of a program
    std::map<GLuint, std::map<GLint, std::string>> unset_;  // uniforms of a program that was linked since this watches
    std::set<Image> unwritten_;
    std::map<GLuint, GLuint> imageUnits_;
    std::map<GLenum, GLuint> openQueries_;
    std::set<GLuint> ended_;
    bool feedback_ = false;
    std::map<std::tuple<GLuint, std::uintptr_t, GLsizei, GLenum>, long> largest_;  // index
};

UndefinedWatch watch;
bool watching = false;

}  // namespace

void watchUndefined(bool on) {
    watching = on;
    watch = {};
    setChecks(on ? +[] {
        if (!isEs()) Layer<UndefinedWatch>::layOver(watch);
    } : nullptr);
}

bool watchingUndefined() { return watching; }

}  // namespace mv
