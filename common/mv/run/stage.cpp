#include "mv/run/stage.h"

#include <initializer_list>
#include <utility>

#include "mv/gl/text.h"

namespace mv {
namespace {

std::string glText(GLenum name) {
    const auto text = reinterpret_cast<const char*>(glGetString(name));
    return text ? text : "unknown";
}

std::string versionText(int version) { return std::to_string(version / 10) + "." + std::to_string(version % 10); }

}  // namespace

void resetState() {
    for (const GLenum capability : std::initializer_list<GLenum>{
             GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_POLYGON_OFFSET_FILL, GL_RASTERIZER_DISCARD, GL_SCISSOR_TEST,
             GL_STENCIL_TEST, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_COVERAGE}) {
        glDisable(capability);
    }
    glEnable(GL_DITHER);
    if (!isEs()) {
        for (GLenum i = 0; i < 6; ++i) glDisable(GL_CLIP_DISTANCE0 + i);
        glDisable(GL_DEPTH_CLAMP);
        glDisable(GL_FRAMEBUFFER_SRGB);
        glDisable(GL_PROGRAM_POINT_SIZE);
        glEnable(GL_MULTISAMPLE);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    }
    glClearDepth(1);
    glDepthRange(0, 1);
    if (clipControlAllowed()) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ZERO);
    glClearColor(0, 0, 0, 0);
    glClearStencil(0);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glLineWidth(1);
    glPolygonOffset(0, 0);
    glStencilFunc(GL_ALWAYS, 0, ~0U);
    glStencilMask(~0U);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glUseProgram(0);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, 0);
}

Stage::Stage(const Context& context, bool keepLast) : keepLast_(keepLast) {
    loadFunctions([&](const char* name) { return context.address(name); });
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    driver_ = {context.name(), glText(GL_VENDOR), glText(GL_RENDERER), glText(GL_VERSION), 10 * major + minor};
}

Stage::~Stage() {
    // Not close(): a destructor does not throw, and who wants the check calls close().
    demo_.reset();
    forgetText();
}

void Stage::makeTargets(int width, int height) {
    const Target::Buffers buffers{info_->needs.depth, info_->needs.stencil, info_->needs.samples, GL_RGBA8};
    Target first(width, height, buffers, info_->name);
    Target second = keepLast_ ? Target(width, height, buffers, info_->name + " last") : Target();
    targets_[0] = std::move(first);
    targets_[1] = std::move(second);
    shown_ = 0;
}

void Stage::open(const DemoInfo& info, int width, int height) {
    if (isOpen()) close();
    if (!isEs() && driver_.glVersion < info.needs.gl) {
        throw Error(info.name, "needs OpenGL " + versionText(info.needs.gl) + "; this driver has",
                    versionText(driver_.glVersion) + " (" + driver_.renderer + ")");
    }
    info_ = &info;
    resetState();
    allowVersion(info.needs.gl);
    takeErrors();
    makeTargets(width, height);
    auto demo = info.make();
    demo->init();
    demo_ = std::move(demo);
}

void Stage::close() {
    demo_.reset();
    notes_ = {};
    targets_[0] = Target();
    targets_[1] = Target();
    measured_ = Target();
    forgetText();
    if (liveObjects() != 0) {
        throw Error(info_ ? info_->name : "stage", "must delete its GL objects; left behind",
                    std::to_string(liveObjects()));
    }
}

void Stage::resize(int width, int height) {
    if (width != front().width() || height != front().height()) makeTargets(width, height);
}

void Stage::drawInto(const Target& target, int index, FrameMode mode) {
    demo_->check();
    FrameNotes notes;
    mode.bindTarget = [&target] { target.bind(); };
    target.bind();
    if (mode.readouts) {
        for (Readout* readout : demo_->readouts()) readout->clear();
    }
    resetCounters();
    demo_->draw(Frame(index, target.width(), target.height(), notes, mode));
    counters_ = counters();
    const std::vector<std::string> errors = takeErrors();
    if (!errors.empty()) throw Error("OpenGL in " + info_->name, "must report no error", errors.front());
    notes_ = std::move(notes);
}

void Stage::draw(int index, bool readouts) {
    const int drawn = keepLast_ ? 1 - shown_ : shown_;
    drawInto(targets_[drawn], index, {.readouts = readouts});
    shown_ = drawn;
}

std::vector<float> Stage::measure(int index) {
    if (measured_.width() != front().width() || measured_.height() != front().height()) {
        measured_ = Target(front().width(), front().height(),
                           {.depth = info_->needs.depth, .stencil = info_->needs.stencil, .color = GL_R32F},
                           info_->name + " measured");
    }
    drawInto(measured_, index, {.measuring = true});
    return measured_.readRed();
}

}  // namespace mv
