#include "mv/show/stage.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <tuple>
#include <utility>

#include "mv/gl/audit.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/editing.h"
#include "mv/gl/program.h"
#include "mv/gl/state.h"
#include "mv/gl/text.h"
#include "mv/gl/version.h"

namespace mv {
namespace {

std::string glText(GLenum name) {
    const auto text = reinterpret_cast<const char*>(glGetString(name));
    return text ? text : "unknown";
}

// All that the target has: the colour, 1 in the depth buffer, 0 in the stencil buffer.
void clearTarget(const vec4& color, const Needs& needs) {
    const fvec4 rounded(color);
    glClearColor(rounded.r, rounded.g, rounded.b, rounded.a);
    glClear(GL_COLOR_BUFFER_BIT | (needs.depth ? GL_DEPTH_BUFFER_BIT : 0U) |
            (needs.stencil ? GL_STENCIL_BUFFER_BIT : 0U));
    glClearColor(0, 0, 0, 0);
}

// The versions for a feature that came with one of OpenGL's: that one, the newest that was asked for, and the one that
// was given.
std::string versionsOf(const std::string& feature) {
    const std::optional<Newer> newer = newerThan33(feature);
    if (!newer || isEs()) return "";
    return " (OpenGL " + versionText(versionOf(*newer)) + "; asked for up to " + versionText(newestVersion()) +
           ", given " + versionText(contextVersion()) + ")";
}

// The sentence about a feature that these settings need and the context lacks.
std::string sentenceWithout(const std::string& feature, const DemoInfo& info) {
    for (const BeyondEs& lacking : info.needs.beyondEs) {
        if (lacking.feature != feature) continue;
        return "This driver has no " + feature + versionsOf(feature) + ": " + lacking.otherwise + ".";
    }
    throw Error("has", "must be asked for what is declared in .needs = {.beyondEs = ...}", feature);
}

}  // namespace

// A probe's questions, drawn on a stage.
class StageProbing final : public Probing {
  public:
    StageProbing(Stage& stage, const Target& drawn, int index)
        : Probing(stage.demo(), stage.frame(index, drawn.width(), drawn.height())), stage_(stage), drawn_(drawn) {}

    std::vector<float> measured(int width, int height, const std::optional<Camera>& camera) override {
        if (!floatTargets()) return {};
        stage_.fitForMeasuring(stage_.probed_, width, height);
        (void)stage_.drawInto(stage_.probed_, frame().index(), {.measuring = true, .camera = camera});
        return stage_.probed_.readRed();
    }
    Picture picture() override { return drawn_.read(); }
    std::vector<unsigned char> stencil() override { return read<unsigned char>(GL_STENCIL_INDEX, GL_UNSIGNED_BYTE); }
    std::vector<float> depths() override { return read<float>(GL_DEPTH_COMPONENT, GL_FLOAT); }

  private:
    template <class Value>
    std::vector<Value> read(GLenum format, GLenum type) const {
        if (isEs() || drawn_.buffers().samples > 0) return {};
        std::vector<Value> values(static_cast<std::size_t>(drawn_.width()) * static_cast<std::size_t>(drawn_.height()));
        drawn_.bind();
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, drawn_.width(), drawn_.height(), format, type, values.data());
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
        return values;
    }

    Stage& stage_;
    const Target& drawn_;
};

Stage::Stage(const Context& context, bool keepLast) : keepLast_(keepLast) {
    loadFunctions([&](const char* name) { return context.address(name); });
    driver_ = {context.name(), glText(GL_VENDOR), glText(GL_RENDERER), glText(GL_VERSION), contextVersion()};
}

Stage::~Stage() {
    // Not close(): a destructor does not throw, and who wants the check calls close().
    demo_.reset();
    forgetText();
}

void Stage::makeTargets(int width, int height) {
    targets_[0] = Target(width, height, {info_->needs.depth, info_->needs.stencil, samples(), GL_RGBA8}, info_->name);
    targets_[1] = Target();
    shown_ = 0;
    isDrawn_ = false;
}

void Stage::open(const DemoInfo& info, int width, int height) {
    if (isOpen()) close();
    if (!isEs() && driver_.glVersion < info.needs.gl) {
        throw Error(info.name, "needs OpenGL " + versionText(info.needs.gl) + "; this driver has",
                    versionText(driver_.glVersion) + " (" + driver_.renderer + ")");
    }
    info_ = &info;
    allowVersion(info.needs.gl);
    for (const BeyondEs& lacking : info.needs.beyondEs) {
        const std::optional<Newer> newer = newerThan33(lacking.feature);
        if (newer && !isWithheld(lacking.feature)) allow(*newer);
    }
    takeErrors();
    forgetRemarks();
    makeTargets(width, height);
    auto demo = info.make();
    demo->init();
    timeline_ = std::make_unique<Timeline>(*demo);
    demo_ = std::move(demo);
}

void Stage::begin(const std::vector<KnobSetting>& knobs, const std::vector<TimedChange>& changes) {
    applyKnobs(*demo_, knobs);
    timeline_->setChanges(changes);
}

void Stage::close() {
    steps_.reset();
    timeline_.reset();
    demo_.reset();
    refined_ = {};
    notes_ = {};
    targets_[0] = Target();
    targets_[1] = Target();
    measured_ = Target();
    probed_ = Target();
    forgetText();
    if (liveObjects() != 0) {
        throw Error(info_ ? info_->name : "stage", "must delete its GL objects; left behind",
                    std::to_string(liveObjects()));
    }
}

void Stage::resize(int width, int height) {
    const bool isSame =
        width == front().width() && height == front().height() && front().buffers().samples == samples();
    if (!isSame) makeTargets(width, height);
}

void Stage::setSamples(int samples) { samples_ = samples; }

// Makes the passes of that picture: all of them, or only the next of the one that was begun.
void Stage::refine(const FrameInfo& frame, bool onlyNext) {
    Refined wanted{{}, frame.index(), frame.width(), frame.height(), demo_->passes(frame), 0};
    if (wanted.passes > 0) {
        for (const Knob* knob : demo_->knobs()) wanted.knobs.push_back(knob->text());
    }
    const auto isOf = [](const Refined& a, const Refined& b) {
        return std::tie(a.knobs, a.index, a.width, a.height, a.passes) ==
               std::tie(b.knobs, b.index, b.width, b.height, b.passes);
    };
    if (onlyNext && isOf(wanted, refined_)) wanted.done = refined_.done;
    refined_ = {};  // a pass that throws leaves nothing to go on from
    const int until = onlyNext ? std::min(wanted.done + 1, wanted.passes) : wanted.passes;
    auto told = std::chrono::steady_clock::now();
    while (wanted.done < until) {
        demo_->refine(frame, wanted.done++);
        const auto now = std::chrono::steady_clock::now();
        if (!passesProgress || wanted.done == until || now - told < std::chrono::seconds(2)) continue;
        told = now;
        passesProgress(wanted.done, wanted.passes);
    }
    refined_ = std::move(wanted);
}

Stage::Drawn Stage::drawInto(const Target& target, int index, FrameMode mode, bool onlyNextPass) {
    takeMissing();
    timeline_->bring(index);
    demo_->check();
    refine(frame(index, target.width(), target.height()), onlyNextPass);
    return paint(*demo_, target, index, std::move(mode), {});
}

Stage::Drawn Stage::paint(Demo& demo, const Target& target, int index, FrameMode mode,
                          const std::function<void()>& beginsSteps) const {
    Drawn drawn;
    mode.bindTarget = [&target] { target.bind(); };
    restoreInitialState();
    target.bind();
    if (mode.measuring) {
        clearTarget(vec4(-1), info_->needs);
    } else if (info_->background) {
        clearTarget(*info_->background, info_->needs);
    }
    if (mode.readouts) {
        for (Readout* readout : demo.readouts()) readout->clear();
    }
    resetCounters();
    const bool before = setMeasuring(mode.measuring);
    try {
        const FrameInfo info = mode.measuring ? FrameInfo(index, target.width(), target.height())
                                              : this->frame(index, target.width(), target.height());
        const Frame frame(info, drawn.notes, mode);
        if (beginsSteps) beginsSteps();
        demo.draw(frame);
        if (!mode.measuring) demo.annotate(frame);
    } catch (...) {
        setMeasuring(before);
        restoreInitialState();
        throw;
    }
    setMeasuring(before);
    for (const std::string& feature : takeMissing()) drawn.notes.messages.push_back(sentenceWithout(feature, *info_));
    std::string unused;
    for (const std::string& uniform : takeUnusedUniforms()) unused += (unused.empty() ? "" : "; ") + uniform;
    if (!unused.empty()) drawn.notes.messages.push_back("The shaders, as they are edited, do not use " + unused + ".");
    drawn.counters = counters();
    if (auditing()) drawn.undone = changedState();
    restoreInitialState();
    const std::vector<std::string> errors = takeErrors();
    // A frame that was stopped may read what it did not come to write
    if (!errors.empty() && !beginsSteps) {
        const std::string more = listeningToDriver() ? "" : " (--audit prints what the driver says of it)";
        throw Error("OpenGL in " + info_->name, "must report no error" + more, errors.front());
    }
    return drawn;
}

void Stage::keep(Drawn drawn) {
    notes_ = std::move(drawn.notes);
    counters_ = drawn.counters;
    undone_ = std::move(drawn.undone);
}

void Stage::fitForMeasuring(Target& target, int width, int height) const {
    target.fit(width, height, {.depth = info_->needs.depth, .stencil = info_->needs.stencil, .color = GL_R32F},
               info_->name + " measured");
}

// After the picture, so that its counters and notes are those of the picture alone.
void Stage::askProbes(const Target& drawn, int index) {
    StageProbing probing(*this, drawn, index);
    for (const Probe& probe : info_->probes) {
        const std::vector<double> values = probe.measure(probing);
        if (!values.empty() && values.size() != probe.numbers.size()) {
            throw Error("probe of " + info_->name, "must give a value for each of its numbers or none",
                        std::to_string(values.size()));
        }
        for (std::size_t i = 0; i < values.size(); ++i) {
            for (Readout* readout : demo_->readouts()) {
                if (readout->name() == probe.numbers[i].name) *readout = values[i];
            }
        }
    }
}

void Stage::draw(int index, bool readouts) { drawFront(index, readouts, false); }

bool Stage::drawNext(int index, bool readouts) { return drawFront(index, readouts, true); }

bool Stage::drawFront(int index, bool readouts, bool onlyNextPass) {
    const int next = keepLast_ && isDrawn_ ? 1 - shown_ : shown_;
    if (targets_[next].width() == 0)
        targets_[next] = Target(front().width(), front().height(), front().buffers(), info_->name + " last");
    Drawn drawn = drawInto(targets_[next], index, {.readouts = readouts}, onlyNextPass);
    const bool whole = refined_.done == refined_.passes;
    if (readouts && whole)
        askProbes(targets_[next], index);  // a probe may draw other pictures: not amid the passes of one
    keep(std::move(drawn));
    shown_ = next;
    isDrawn_ = true;
    steps_.reset();
    return whole;
}

FrameSteps Stage::stepsOf(const Target& target, int index, int stopAfter) {
    StepWatch watch;  // from before the demo is made: it is told the sizes of the textures, too
    const std::unique_ptr<Demo> demo = info_->make();
    demo->init();
    for (const Knob* knob : demo_->knobs()) demo->knob(knob->name()).parse(knob->text());
    if (demo_->memory()) {
        demo->reset();
        demo->memory()->restore(demo_->memory()->copy());
    }
    const FrameInfo frame = this->frame(index, target.width(), target.height());
    for (int pass = 0; pass < demo->passes(frame); ++pass) demo->refine(frame, pass);
    target.bind();
    clearTarget(vec4(0), info_->needs);  // OpenGL says nothing of what a demo without a background would find
    paint(*demo, target, index, {}, [&] { watch.begin(stopAfter); });
    watch.end();
    return {watch.draws(), stopAfter, watch.shown()};
}

void Stage::stopAfter(int index, int draws) {
    if (samples() > 0) throw Error("draws", "are shown one by one without smooth edges, with --multisample 0");
    timeline_->bring(index);
    demo_->check();
    steps_ = stepsOf(front(), index, draws);
    const int all = static_cast<int>(steps_->draws.size());
    if (draws >= 0 && draws <= all) return;
    steps_->until = all;  // nothing was left out
    throw Error("draws", "must be 0 .. " + std::to_string(all) + ", those of this frame in these settings",
                std::to_string(draws));
}

std::vector<float> Stage::measure(int index) {
    fitForMeasuring(measured_, front().width(), front().height());
    keep(drawInto(measured_, index, {.measuring = true}));
    return measured_.readRed();
}

}  // namespace mv
