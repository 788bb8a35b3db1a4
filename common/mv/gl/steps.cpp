#include "mv/gl/steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <utility>

#include "mv/formatted.h"
#include "mv/gl/buffers_by_shader.h"
#include "mv/gl/layer.h"
#include "mv/gl/state.h"
#include "mv/gl/state_names.h"
#include "mv/gl/text.h"

namespace mv {
namespace {

using Side = std::pair<GLint, GLint>;  // width and height

std::string shortNumber(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

std::string blackAndWhite(double low, double high) {
    if (low == high) return "all " + shortNumber(low);
    return shortNumber(low) + " is black, " + shortNumber(high) + " white";
}

std::uint8_t shade(double value, double low, double high) {
    if (!std::isfinite(value)) return 0;
    // A buffer of one value has no range: it is shown as that value of 0 .. 1.
    const double part = low == high ? value : (value - low) / (high - low);
    return static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0, 1.0) * 255));
}

// Values of 1 or 4 channels, lower row first, as a picture whose shades go from the least to the largest of them.
BufferPicture shaded(const std::string& name, const std::vector<float>& values, int channels, int width, int height) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto step = static_cast<std::size_t>(channels);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i]) || (step == 4 && i % 4 == 3)) continue;  // alpha is not shown
        low = std::min(low, double(values[i]));
        high = std::max(high, double(values[i]));
    }
    BufferPicture result{name, low > high ? "no number in it is finite" : blackAndWhite(low, high), {width, height}};
    for (std::size_t pixel = 0; pixel < values.size() / step; ++pixel) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const float value = values[pixel * step + (step == 1 ? 0 : channel)];
            result.picture.rgba[4 * pixel + channel] = shade(double(value), low, high);
        }
        result.picture.rgba[4 * pixel + 3] = 255;
    }
    flipRows(result.picture);
    result.values = values;
    result.channels = channels;
    return result;
}

}  // namespace

std::string valueAt(const BufferPicture& buffer, int x, int y) {
    const Picture& picture = buffer.picture;
    if (picture.rgba.empty() || x < 0 || y < 0 || x >= picture.width || y >= picture.height) return "";
    if (buffer.values.empty()) {
        const Pixel pixel = picture.at(x, y);
        return std::to_string(pixel.red) + " " + std::to_string(pixel.green) + " " + std::to_string(pixel.blue);
    }
    const auto each = static_cast<std::size_t>(buffer.channels);
    const std::size_t first = each * pixelIndex(x, picture.height - 1 - y, picture.width);
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(each, 3); ++i)
        text += (i == 0 ? "" : " ") + formatted("%.9g", double(buffer.values[first + i]));
    return text;
}

class StepWatch::Listener {
  public:
    void begin(int stopAfter) {
        draws.clear();
        shown = {};
        stopAfter_ = stopAfter;
        inFrame_ = true;
        stopped_ = false;
        picture_ = bound(GL_DRAW_FRAMEBUFFER_BINDING);
    }
    void end() {
        if (!stopped_) stop(picture_);  // a frame with fewer draws, or none
        inFrame_ = false;
    }

    bool skip_DrawArrays(GLenum mode, GLint, GLsizei count) { return leavesOut(mode, count, false); }
    bool skip_DrawElements(GLenum mode, GLsizei count, GLenum, const void*) { return leavesOut(mode, count, true); }
    void after_DrawArrays(GLenum, GLint, GLsizei) { afterDraw(); }
    void after_DrawElements(GLenum, GLsizei, GLenum, const void*) { afterDraw(); }
    bool skip_Clear(GLbitfield) const { return inFrame_ && stopped_; }
    bool skip_ClearBufferfv(GLenum, GLint, const GLfloat*) const { return inFrame_ && stopped_; }
    bool skip_BlitFramebuffer(GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLbitfield, GLenum) const {
        return inFrame_ && stopped_;
    }
    // OpenGL ES does not tell a texture's size, nor does 3.3 without one more function.
    void after_TexImage2D(GLenum target, GLint level, GLint format, GLsizei width, GLsizei height, GLint, GLenum,
                          GLenum, const void*) {
        if (level != 0) return;
        textures_[bound(target == GL_TEXTURE_2D ? GL_TEXTURE_BINDING_2D : GL_TEXTURE_BINDING_CUBE_MAP)] = {
            {width, height}, static_cast<GLenum>(format)};
    }

    std::vector<DrawStep> draws;
    TargetPictures shown;

  private:
    static const FunctionTable& below() { return Layer<Listener>::below; }
    static GLuint bound(GLenum binding) {
        GLint name = 0;
        below().GetIntegerv(binding, &name);
        return static_cast<GLuint>(name);
    }

    bool leavesOut(GLenum mode, GLsizei count, bool indexed) {
        counts_ = inFrame_ && below().IsEnabled(GL_RASTERIZER_DISCARD) == GL_FALSE;
        if (!counts_) return false;
        if (stopAfter_ == 0 && !stopped_) stop(picture_);
        draws.push_back(described(mode, count, indexed));
        return stopped_;
    }
    void afterDraw() {
        if (counts_ && draws.size() == static_cast<std::size_t>(stopAfter_)) stop(bound(GL_DRAW_FRAMEBUFFER_BINDING));
    }

    DrawStep described(GLenum mode, GLsizei count, bool indexed) const {
        const GLuint target = bound(GL_DRAW_FRAMEBUFFER_BINDING);
        const Side size = sizeOf(target);
        DrawStep step{labelOf(GL_VERTEX_ARRAY, boundVertexArray()),
                      labelOf(GL_PROGRAM, bound(GL_CURRENT_PROGRAM)),
                      primitiveName(mode),
                      count,
                      indexed,
                      labelOf(GL_FRAMEBUFFER, target),
                      size.first,
                      size.second,
                      target == picture_,
                      stateOfDraw()};
        const auto addBox = [&](GLenum what, const char* call) {
            std::array<GLint, 4> box{};
            below().GetIntegerv(what, box.data());
            if (box == std::array<GLint, 4>{0, 0, size.first, size.second}) return;
            step.state.push_back(call + ("(" + std::to_string(box[0])) + ", " + std::to_string(box[1]) + ", " +
                                 std::to_string(box[2]) + ", " + std::to_string(box[3]) + ")");
        };
        addBox(GL_VIEWPORT, "glViewport");
        if (below().IsEnabled(GL_SCISSOR_TEST) == GL_TRUE) addBox(GL_SCISSOR_BOX, "glScissor");
        return step;
    }

    // Asks about the framebuffer that is bound for drawing.
    static GLint attachment(GLenum which, GLenum what) {
        GLint value = GL_NONE;
        below().GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, which, what, &value);
        return value;
    }
    static bool has(GLenum which) { return attachment(which, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE; }
    Side sizeOf(GLuint framebuffer) const {
        if (framebuffer == 0) return {0, 0};
        for (const GLenum which : {GLenum(GL_COLOR_ATTACHMENT0), GLenum(GL_DEPTH_ATTACHMENT)}) {
            if (!has(which)) continue;
            const auto name = static_cast<GLuint>(attachment(which, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
            if (attachment(which, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_TEXTURE) {
                const auto known = textures_.find(name);
                return known == textures_.end() ? Side{0, 0} : known->second.size;
            }
            return {storageOf(name, GL_RENDERBUFFER_WIDTH), storageOf(name, GL_RENDERBUFFER_HEIGHT)};
        }
        return {0, 0};
    }
    static GLint storageOf(GLuint renderbuffer, GLenum what) {
        const GLuint before = bound(GL_RENDERBUFFER_BINDING);
        GLint value = 0;
        below().BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
        below().GetRenderbufferParameteriv(GL_RENDERBUFFER, what, &value);
        below().BindRenderbuffer(GL_RENDERBUFFER, before);
        return value;
    }
    // Of the framebuffer that is bound for drawing, which has one, and whose size is known.
    DepthBuffer depthBuffer() const {
        const auto name = static_cast<GLuint>(attachment(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
        if (attachment(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_TEXTURE)
            return {textures_.at(name).format, 0, name};
        return {static_cast<GLenum>(storageOf(name, GL_RENDERBUFFER_INTERNAL_FORMAT)), name, 0};
    }

    // From now on the frame changes no buffer. The buffers are read at once: the demo may give them up.
    void stop(GLuint target) {
        stopped_ = true;
        const GLuint drawing = bound(GL_DRAW_FRAMEBUFFER_BINDING), reading = bound(GL_READ_FRAMEBUFFER_BINDING);
        GLint alignment = 4;
        below().GetIntegerv(GL_PACK_ALIGNMENT, &alignment);
        below().BindFramebuffer(GL_FRAMEBUFFER, target);
        below().PixelStorei(GL_PACK_ALIGNMENT, 1);
        const auto [width, height] = sizeOf(target);
        shown = {labelOf(GL_FRAMEBUFFER, target), width, height, target == picture_, {}};
        GLint samples = 0;
        below().GetIntegerv(GL_SAMPLES, &samples);
        const auto unread = [&](const char* name, const std::string& why) { shown.buffers.push_back({name, why, {}}); };
        const bool depth = has(GL_DEPTH_ATTACHMENT), stencil = has(GL_STENCIL_ATTACHMENT);
        if (samples > 0 || width == 0) {
            const std::string why = samples > 0 ? "not read: it has " + std::to_string(samples) + " samples a pixel"
                                                : std::string("not read: its size is not known");
            if (has(GL_COLOR_ATTACHMENT0)) unread("color", why);
            if (depth) unread("depth", why);
            if (stencil) unread("stencil", why);
        } else {
            if (has(GL_COLOR_ATTACHMENT0)) shown.buffers.push_back(color(width, height));
            if (depth) shown.buffers.push_back(shaded("depth", depths(target, width, height), 1, width, height));
            if (stencil) {
                const std::vector<std::uint8_t> bytes = stencils(target, width, height);
                shown.buffers.push_back(shaded("stencil", {bytes.begin(), bytes.end()}, 1, width, height));
            }
        }
        below().PixelStorei(GL_PACK_ALIGNMENT, alignment);
        below().BindFramebuffer(GL_DRAW_FRAMEBUFFER, drawing);
        below().BindFramebuffer(GL_READ_FRAMEBUFFER, reading);
    }

    template <class Value>
    static std::vector<Value> values(GLenum format, GLenum type, int channels, int width, int height) {
        std::vector<Value> all(static_cast<std::size_t>(channels) * static_cast<std::size_t>(width) *
                               static_cast<std::size_t>(height));
        below().ReadPixels(0, 0, width, height, format, type, all.data());
        return all;
    }
    // OpenGL ES 3.0 reads neither back: there a shader does, past this listener, which would take its draws for the demo's.
    template <class Read>
    static auto byShader(GLuint target, const Read& read) {
        const GLuint storage = bound(GL_RENDERBUFFER_BINDING);
        std::array<GLint, 4> viewport{};
        below().GetIntegerv(GL_VIEWPORT, viewport.data());
        auto values = [&] {
            const Layer<Listener>::Past past;
            return read();
        }();
        below().Viewport(viewport[0], viewport[1], viewport[2], viewport[3]);
        below().BindRenderbuffer(GL_RENDERBUFFER, storage);
        below().BindFramebuffer(GL_FRAMEBUFFER, target);
        return values;
    }
    std::vector<float> depths(GLuint target, int width, int height) const {
        if (!isEs()) return values<float>(GL_DEPTH_COMPONENT, GL_FLOAT, 1, width, height);
        const DepthBuffer buffer = depthBuffer();
        return byShader(target, [&] { return depthsByShader(target, buffer, width, height); });
    }
    std::vector<std::uint8_t> stencils(GLuint target, int width, int height) const {
        if (!isEs()) return values<std::uint8_t>(GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 1, width, height);
        const DepthBuffer buffer = depthBuffer();
        return byShader(target, [&] { return stencilsByShader(buffer, width, height); });
    }
    static BufferPicture color(int width, int height) {
        if (attachment(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT)
            return shaded("color", values<float>(GL_RGBA, GL_FLOAT, 4, width, height), 4, width, height);
        BufferPicture result{"color", "as it is", {width, height}};
        result.picture.rgba = values<std::uint8_t>(GL_RGBA, GL_UNSIGNED_BYTE, 4, width, height);
        flipRows(result.picture);
        return result;
    }

    int stopAfter_ = 0;
    bool inFrame_ = false, stopped_ = false;
    bool counts_ = false;  // the draw that is being made is a step
    GLuint picture_ = 0;
    struct Stored {
        Side size;
        GLenum format;
    };
    std::map<GLuint, Stored> textures_;
};

StepWatch::StepWatch() : listener_(std::make_unique<Listener>()) { Layer<Listener>::layOver(*listener_); }
StepWatch::~StepWatch() { Layer<Listener>::takeOff(); }

void StepWatch::begin(int stopAfter) { listener_->begin(stopAfter); }
void StepWatch::end() { listener_->end(); }
const std::vector<DrawStep>& StepWatch::draws() const { return listener_->draws; }
const TargetPictures& StepWatch::shown() const { return listener_->shown; }

}  // namespace mv
