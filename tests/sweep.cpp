// Every demo, every knob at its ends, its initial value and each of its choices.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "mv/gl/beyond_es.h"
#include "mv/gl/gl.h"
#include "mv/run/audit.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

class Sweep : public testing::TestWithParam<std::string> {};
class Floor : public testing::TestWithParam<std::string> {};

// A quarter of the points of the initial size: what a knob's end breaks does not depend on the size.
void halve() { stage().resize(stage().front().width() / 2, stage().front().height() / 2); }

// One picture of the present settings: no error (the stage throws on GL errors and debug messages), something to see,
// the same bytes again, and the same bytes with the readouts measured.
void expectPicture(const std::string& setting) {
    SCOPED_TRACE(setting);
    try {
        stage().draw(1);
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
    strikePose(run.demo(), stage().info());
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
    halve();
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
        const std::set<std::string> asked{beyond_es::clipControl, beyond_es::floatBlending, beyond_es::clipDistances};
        if (!asked.contains(lacking.feature)) continue;  // others are asked by isEs(), and met by the ES tests
        SCOPED_TRACE("without " + lacking.feature);
        withhold({lacking.feature});
        watchBeyondEs();
        {
            DemoRun run(GetParam());
            halve();
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

// What stands in the declaration is what the picture depends on.
TEST_P(Sweep, animated_as_declared) {
    DemoRun run(GetParam());
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

// A frame at the initial settings does nothing needless that the demo does not declare.
TEST_P(Sweep, nothing_needless) {
    const AuditReport report = auditDemo(stage(), findDemo(GetParam()), {}, 1);
    EXPECT_TRUE(report.clean()) << auditText(report);
    EXPECT_GT(report.first.samplesPassed, 0);
}

// Other sizes than the original's, the smallest one and odd ones too.
TEST_P(Sweep, sizes) {
    DemoRun run(GetParam());
    for (const auto& [width, height] : {std::pair{1, 1}, {37, 91}, {640, 200}}) {
        stage().resize(width, height);
        const Picture picture = run.picture();
        EXPECT_EQ(picture.width, width);
        EXPECT_EQ(picture.height, height);
        EXPECT_EQ(run.picture(), picture);
    }
}

// Run with MESA_GL_VERSION_OVERRIDE at the declared version: the demo draws the same there.
TEST_P(Floor, draws) {
    DemoRun run(GetParam());
    ASSERT_EQ(stage().driver().glVersion, stage().info().needs.gl) << "the override is not in force";
    const Picture picture = run.picture();
    EXPECT_GT(countColors(picture, 2), 1);
}

INSTANTIATE_TEST_SUITE_P(Demos, Sweep, testing::ValuesIn(demoNames()), parameterWord);
INSTANTIATE_TEST_SUITE_P(DemosAtTheir, Floor, testing::ValuesIn(demoNames()), parameterWord);

}  // namespace
