// Every demo, every knob at its ends, its initial value and each of its choices.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>

#include "mv/gl/beyond_es.h"
#include "mv/gl/gl.h"
#include "mv/paper/audit.h"
#include "support/demo_run.h"
#include "support/sanitized.h"

using namespace mv;
using namespace mv::test;

namespace {

class Sweep : public testing::TestWithParam<std::string> {};
class Floor : public testing::TestWithParam<std::string> {};
class Renderer : public testing::TestWithParam<std::string> {};

// A quarter of the points of the initial size, and of what the processor computes in passes a hundredth: there are many settings
// to draw, and each still shows something. (Under the sanitizers, where that is not looked at, a quarter of it.)
void drawSmall() {
    const int by = (sanitized ? 2 : 1) * std::max(2, coarser(stage().info()));
    stage().resize(stage().front().width() / by, stage().front().height() / by);
}

// One picture of the present settings: no error (the stage throws on GL errors and debug messages), something to see,
// the same bytes again, and the same bytes with the readouts measured. (Under the sanitizers it is drawn once, with the readouts.)
void expectPicture(const std::string& setting) {
    SCOPED_TRACE(setting);
    try {
        stage().draw(1, sanitized);
        if (sanitized) return;
        const Picture first = stage().picture();
        EXPECT_GT(countColors(first, 2), 1) << "one colour: a useless setting; saved " << saveFailure("sweep", first);
        stage().draw(1);
        EXPECT_EQ(stage().picture(), first) << "another picture the second time";
        stage().draw(1, true);
        EXPECT_EQ(stage().picture(), first) << "measuring the readouts changes the picture";
    } catch (const Error& error) {
        ADD_FAILURE() << error.what();
    }
}

// Each value of each knob that a test tries; how many were tried, and how many of them were refused.
struct Tried {
    int cases = 1, refused = 0;
    std::set<std::string> sentences;  // said beside the pictures, or in refusals
};
Tried tryKnobs(DemoRun& run) {
    // By index: a range-for over make()->knobs() would read a dead temporary; here the stage keeps the demo alive.
    const std::vector<Knob*>& knobs = run.demo().knobs();
    expectPicture("initial");
    Tried tried;
    for (Knob* knob : knobs) {
        const std::string before = knob->text();
        for (const std::string& value : knob->sweep()) {
            knob->parse(value);
            EXPECT_EQ(knob->text(), value);
            ++tried.cases;
            const std::string refusal = run.refusal();
            if (refusal.empty()) {
                expectPicture(knob->name() + " = " + value);
                for (const std::string& message : run.messages()) tried.sentences.insert(message);
            } else {
                ++tried.refused;
                tried.sentences.insert(refusal);
                EXPECT_EQ(refusal.rfind("--", 0), 0U) << "a refusal begins with the flag: " << refusal;
                EXPECT_THROW(stage().draw(1), Error);
            }
        }
        knob->parse(before);
    }
    EXPECT_LE(tried.refused, tried.cases / 10) << "at least 90 % of the settings draw";
    return tried;
}

TEST_P(Sweep, knobs) {
    stage();
    watchBeyondEs();
    DemoRun run(GetParam());
    drawSmall();
    const Tried tried = tryKnobs(run);
    // All that ES 3.0 lacks and these frames have used is declared, and nothing else.
    std::set<std::string> declared;
    for (const BeyondEs& lacking : stage().info().needs.beyondEs) declared.insert(lacking.feature);
    EXPECT_EQ(stopWatchingBeyondEs(), declared) << ".needs = {.beyondEs = ...} is not what the demo uses";
    std::printf("%s on %s: %d settings, %d refused\n", GetParam().c_str(), stage().driver().host.c_str(), tried.cases,
                tried.refused);
}

// What a demo asks for by has(), as if the context lacked it: it draws all the same, does not use it, and says so.
TEST_P(Sweep, without_what_a_context_may_lack) {
    stage();
    const DemoInfo& info = findDemo(GetParam());
    for (const BeyondEs& lacking : info.needs.beyondEs) {
        const std::set<std::string> asked{
            beyond_es::clipControl,  beyond_es::floatBlending,  beyond_es::clipDistances,  beyond_es::geometryShaders,
            beyond_es::tessellation, beyond_es::computeShaders, beyond_es::countingQueries};
        if (!asked.contains(lacking.feature)) continue;  // others are asked by isEs(), and met by the ES tests
        SCOPED_TRACE("without " + lacking.feature);
        withhold({lacking.feature});
        watchBeyondEs();
        {
            DemoRun run(GetParam());
            drawSmall();
            const Tried tried = tryKnobs(run);
            const bool said = std::any_of(tried.sentences.begin(), tried.sentences.end(), [&](const std::string& one) {
                return one.find("has no " + lacking.feature) != std::string::npos;
            });
            EXPECT_TRUE(said) << "no setting says what it lacks";
        }
        EXPECT_FALSE(stopWatchingBeyondEs().contains(lacking.feature));
        withhold({});
        stage().close();
    }
}

// Each preset is a picture, and no two are alike; it is written as the knobs write their values, and the readouts that its
// sentence tells are as it tells them.
// (Under the sanitizers it is drawn as small as the ends of the knobs, and what it shows is not looked at.)
TEST_P(Sweep, presets) {
    DemoRun run(GetParam());
    if (sanitized) drawSmall();
    const std::vector<Preset>& presets = stage().info().presets;
    EXPECT_GE(presets.size(), 2U);
    EXPECT_LE(presets.size(), 8U);
    std::vector<Picture> pictures;
    for (const Preset& preset : presets) {
        applyPreset(run.demo(), preset);
        EXPECT_TRUE(isAtPreset(run.demo(), preset)) << preset.name << " is not written as the knobs write it";
        EXPECT_EQ(run.refusal(), "") << preset.name;
        expectPicture("preset " + preset.name);
        if (sanitized) continue;
        for (const ExpectedReadout& expected : preset.expect) {
            const double value = run.readout(expected.readout);
            EXPECT_TRUE(expected.low <= value && value <= expected.high)
                << preset.name << " says otherwise: " << expected.readout << " is " << value;
        }
        pictures.push_back(stage().picture());
    }
    for (std::size_t a = 0; a < pictures.size(); ++a) {
        for (std::size_t b = a + 1; b < pictures.size(); ++b) {
            // What is less is not seen at a glance.
            EXPECT_GT(double(differentPixels(pictures[a], pictures[b])), 0.01 * pictures[a].width * pictures[a].height)
                << presets[a].name << " and " << presets[b].name << " are too much alike";
        }
    }
    // What a preset leaves unsaid is initial, whatever was set before.
    if (presets.size() == 0) return;
    for (Knob* knob : run.demo().knobs()) knob->parse(knob->sweep().back());
    applyPreset(run.demo(), presets.front());
    for (const Knob* knob : run.demo().knobs()) EXPECT_TRUE(knob->isInitial()) << knob->name();
}

// Knobs that change no picture on purpose.
const std::set<std::string> unseen{
    "cube-ortho distance",   // which is the lesson: a parallel view does not depend on it
    "shadow-map keep",       // what is kept is what would be drawn again
    "shadow-lights keep",    // the same
    "shadow-methods keep",   // the same
    "environment keep",      // the same
    "mirror keep",           // the same
    "mirror leave-out",      // what is left out is not seen
    "displacement cull",     // the same
    "lights ask",            // lights that are off, or reach nothing, give nothing
    "path pieces",           // a digit of the length, in words for which pictures as small as these have no room
    "springs confirm",       // a line of words, likewise
    "gpu-stages direct3d",   // names of stages, likewise
    "color-models written",  // numbers in words, likewise
    "clipping polygon",      // its ends, all corners in one place or on one line, are refused: they are no polygon
    "clipping against",      // the same
    "ray-cast threads",      // who computes a row changes nothing
    "ray-trace structure",   // who is asked for a triangle, likewise
};

// In a setting that a knob calls idle it changes no byte of the picture; and a knob that changes none in any of the
// settings below says so there, or is one of the above. The settings: each preset, and beside the first one each choice
// and switch.
TEST_P(Sweep, idle_knobs) {
    const bool small = hasPasses(findDemo(GetParam()));
    DemoRun run(GetParam(), small ? 60 : 160, small ? 40 : 120);
    const std::vector<Knob*>& knobs = run.demo().knobs();
    std::set<std::string> seen, saidIdle;
    int cases = 0;
    const auto drawn = [&]() -> std::optional<Picture> {
        if (!run.refusal().empty()) return {};
        stage().draw(1);
        return stage().picture();
    };
    const auto tryAll = [&](const std::string& context) {
        const auto before = drawn();
        if (!before) return;
        for (Knob* knob : knobs) {
            const std::string reason = knob->idleReason(), present = knob->text();
            if (!reason.empty()) saidIdle.insert(knob->name());
            if (reason.empty() && seen.count(knob->name()) > 0) continue;
            for (const std::string& value : knob->sweep()) {
                if (value == present) continue;
                knob->parse(value);
                const auto after = drawn();
                ++cases;
                if (!reason.empty()) {
                    EXPECT_EQ(after, before)
                        << context << ": --" << knob->name() << " " << value
                        << " changes the picture, or is refused, and is said to be idle: " << reason;
                } else if (after && after != before) {
                    seen.insert(knob->name());
                }
                if (reason.empty() && seen.count(knob->name()) > 0) break;
            }
            knob->parse(present);
        }
    };
    for (const Preset& preset : stage().info().presets) {
        applyPreset(run.demo(), preset);
        tryAll(preset.name);
        if (&preset != stage().info().presets.data()) continue;
        for (Knob* knob : knobs) {
            const std::string present = knob->text();
            const bool few = !knob->options().empty() || knob->range() == "on | off";
            for (const std::string& value : few ? knob->sweep() : std::vector<std::string>{}) {
                if (value == present) continue;
                knob->parse(value);
                tryAll(preset.name + " --" + knob->name() + " " + value);
            }
            knob->parse(present);
        }
    }
    for (const Knob* knob : knobs) {
        const std::string name = GetParam() + " " + knob->name();
        EXPECT_EQ(seen.count(knob->name()), 1 - unseen.count(name))
            << name << (seen.count(knob->name()) ? " is listed as unseen, and is seen" : " changes no picture");
    }
    std::printf("%s: %d cases, %zu knobs idle somewhere\n", GetParam().c_str(), cases, saidIdle.size());
}

// What stands in the declaration is what the picture depends on.
TEST_P(Sweep, animated_as_declared) {
    DemoRun run(GetParam());
    drawSmall();
    EXPECT_EQ(run.picture(1) != run.picture(17), stage().info().animated);
}

// The target has the buffers that the demo declares, and no other.
TEST_P(Sweep, buffers_as_declared) {
    DemoRun run(GetParam());
    stage().front().bind();
    const Needs& needs = stage().info().needs;
    const auto present = [](GLenum attachment) {
        GLint kind = 0;
        glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &kind);
        return kind != GL_NONE;
    };
    EXPECT_EQ(present(GL_DEPTH_ATTACHMENT), needs.depth || needs.stencil);
    EXPECT_EQ(present(GL_STENCIL_ATTACHMENT), needs.stencil);
    GLint samples = -1;
    glGetIntegerv(GL_SAMPLES, &samples);
    EXPECT_EQ(samples, needs.samples);
}

// A frame of a preset does nothing needless that the demo does not declare; and what it declares, some preset does.
TEST_P(Sweep, nothing_needless) {
    DemoInfo info = findDemo(GetParam());
    const int by = coarserIfSanitized(info);
    info.width /= by;
    info.height /= by;
    std::set<std::string> idle;
    for (const Preset& preset : info.presets) {
        SCOPED_TRACE(preset.name);
        const AuditReport report = auditDemo(stage(), info, {preset.settings.begin(), preset.settings.end()}, 1);
        EXPECT_TRUE(report.clean()) << auditText(report);
        EXPECT_GT(report.first.samplesPassed, 0);
        const std::set<std::string> here(report.idleExcuses.begin(), report.idleExcuses.end());
        if (&preset == &info.presets.front()) idle = here;
        std::erase_if(idle, [&](const std::string& excuse) { return !here.contains(excuse); });
    }
    for (const std::string& excuse : idle) ADD_FAILURE() << "declared, and in no preset: " << excuse;
}

// Other sizes than the original's, the smallest one and odd ones too.
TEST_P(Sweep, sizes) {
    DemoRun run(GetParam());
    const int by = coarserIfSanitized(stage().info());
    for (const auto& [width, height] : {std::pair{1, 1}, {37, 91}, {640 / by, 200 / by}}) {
        stage().resize(width, height);
        const Picture picture = run.picture();
        EXPECT_EQ(picture.width, width);
        EXPECT_EQ(picture.height, height);
        EXPECT_EQ(run.picture(), picture);
    }
}

// A preset asks of each pixel about as much in a picture of any size: what is drawn over and over where a side is odd, or where the
// horizon meets the middle of a row, is found by its counts, not by its time. (A shader's own loops and its textures' footprints no
// count shows: those of texture-filter have a claim.)
TEST_P(Sweep, work_at_odd_sizes) {
    if (sanitized) return;  // counts of the same draws, ten times as slow
    DemoInfo info = findDemo(GetParam());
    for (const Preset& preset : info.presets) {
        const std::vector<KnobSetting> settings(preset.settings.begin(), preset.settings.end());
        const auto workAt = [&](int width, int height) {
            info.width = width;
            info.height = height;
            return auditDemo(stage(), info, settings, 1).first;
        };
        // A quarter of the demo's own picture, and two near it: of the parity that 320x288 has, and of no parity.
        const int width = findDemo(GetParam()).width / 4, height = findDemo(GetParam()).height / 4;
        const FrameWork usual = workAt(width, height);
        for (const auto& [w, h] : {std::pair{160, 144}, {97, 61}}) {
            const FrameWork odd = workAt(w, h);
            SCOPED_TRACE(preset.name + " " + std::to_string(w) + "x" + std::to_string(h));
            const double pixels = double(w) * h, usualPixels = double(width) * height;
            // Shadow maps and sheets of words have sizes of their own, so that a smaller picture has more of them a pixel.
            const double more = std::max(1.0, usualPixels / pixels);
            EXPECT_LE(double(odd.samplesPassed) / pixels, 4 * more * (1 + double(usual.samplesPassed) / usualPixels));
            EXPECT_LE(odd.draws, 2 * usual.draws + 8);
            EXPECT_LE(odd.triangles.submitted, 4 * usual.triangles.submitted + 10'000);
        }
    }
}

// Run with MVGL_GL at the declared version: the demo draws there, whatever the driver has.
TEST_P(Floor, draws) {
    DemoRun run(GetParam());
    ASSERT_EQ(stage().driver().glVersion, stage().info().needs.gl) << "MVGL_GL is not in force";
    const Picture picture = run.picture();
    EXPECT_GT(countColors(picture, 2), 1);
}

// Run on another renderer than the recorded one: each preset draws there without an error and without what OpenGL leaves undefined,
// and what the driver lacks is said.
TEST_P(Renderer, draws_each_preset) {
    DemoRun run(GetParam());
    drawSmall();
    for (const Preset& preset : stage().info().presets) {
        run.preset(preset.name);
        expectPicture(preset.name);
    }
    std::printf("%s by %s\n", GetParam().c_str(), stage().driver().renderer.c_str());
}

INSTANTIATE_TEST_SUITE_P(Demos, Sweep, testing::ValuesIn(demoNames()), parameterWord);
INSTANTIATE_TEST_SUITE_P(Demos, Renderer, testing::ValuesIn(demoNames()), parameterWord);
INSTANTIATE_TEST_SUITE_P(DemosAtTheir, Floor, testing::ValuesIn(demoNames()), parameterWord);

}  // namespace
