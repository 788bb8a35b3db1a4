// At each preset: its picture, what it tells, the work of its frame, and its frame stopped after each of its draws.
#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "mv/gl/gl.h"
#include "mv/paper/audit.h"
#include "visits/visit.h"

namespace mv::test {
namespace {

FrameSteps stopped(int draws) {
    stage().stopAfter(1, draws);
    return *stage().steps();
}

// So many of 1..all, evenly, and both ends with the one before the last.
std::set<int> chosen(int all, int most) {
    std::set<int> draws{1, std::max(1, all - 1), all};
    for (int i = 1; i < most; ++i) draws.insert(std::max(1, all * i / most));
    return draws;
}

// Whether it can be made by clears alone, of the whole and of boxes such as panes: few rows differ, and few colours. A thing that is
// drawn (a slope, a word) has tens.
bool isClearedOnly(const Picture& picture) {
    std::set<std::vector<std::uint8_t>> rows;
    for (int y = 0; y < picture.height; ++y) {
        const auto first = picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * pixelIndex(0, y, picture.width));
        rows.emplace(first, first + 4 * std::ptrdiff_t(picture.width));
    }
    return rows.size() <= 4 && countColors(picture) <= 4;
}

// The present frame, stopped after each of its draws, or after so many of them. Each lists the draws of the whole frame, in the
// same states: what a demo draws does not hang on what it reads back.
void expectStops(DemoRun& run, int most) {
    const Picture whole = run.picture();
    const long objects = liveObjects();
    const auto expectShown = [&](const FrameSteps& steps, int draws) {
        EXPECT_EQ(steps.until, draws);
        EXPECT_EQ(steps.shown.isPicture, draws == 0 || steps.draws[std::size_t(draws) - 1].inPicture);
        ASSERT_FALSE(steps.shown.buffers.empty());
        if (!steps.shown.isPicture) return;
        // The buffer that is shown is the picture that is saved
        EXPECT_EQ(steps.shown.buffers[0].name, "color");
        EXPECT_EQ(steps.shown.buffers[0].picture, stage().picture());
    };
    const FrameSteps none = stopped(0);
    ASSERT_FALSE(none.draws.empty());
    expectShown(none, 0);
    EXPECT_TRUE(isClearedOnly(stage().picture()))
        << saveFailure(stage().info().name + " before draw 1", stage().picture());
    for (const DrawStep& draw : none.draws) {
        EXPECT_GT(draw.count, 0);
        EXPECT_GT(draw.width, 0) << draw.target;
        EXPECT_TRUE(draw.program.starts_with("'")) << "a program without a name: " << draw.program;
    }
    for (const int draws : chosen(static_cast<int>(none.draws.size()), most)) {
        SCOPED_TRACE("until draw " + std::to_string(draws));
        const FrameSteps steps = stopped(draws);
        ASSERT_EQ(steps.draws, none.draws);
        expectShown(steps, draws);
    }
    // The last of them was after all draws.
    EXPECT_EQ(stage().picture(), whole) << "all draws make another picture than the whole frame";
    // Nothing half made is kept: the whole frame is what it was.
    EXPECT_EQ(run.picture(), whole);
    EXPECT_EQ(liveObjects(), objects);
}

// A preset (the first; in ./test --long each) asks of each pixel about as much in a picture of any size: what is drawn over and over where
// the horizon meets the middle of a row is found by its counts, not by its time. (A shader's own loops and its textures' footprints no
// count shows: those of texture-filter have a claim.)
void expectSameWorkAtOddSizes(const DemoInfo& demo, const std::vector<KnobSetting>& settings) {
    DemoInfo info = demo;
    const auto workAt = [&](int width, int height) {
        info.width = width;
        info.height = height;
        return auditDemo(stage(), info, settings, 1).first;
    };
    // A quarter of the demo's own picture, and one near it whose horizon is in the middle of a row, as 320x288 has it.
    const int width = demo.width / 4, height = demo.height / 4;
    const FrameWork usual = workAt(width, height), odd = workAt(160, 144);
    const double pixels = 160.0 * 144, usualPixels = double(width) * height;
    // Shadow maps and sheets of words have sizes of their own, so that a smaller picture has more of them a pixel.
    const double more = std::max(1.0, usualPixels / pixels);
    EXPECT_LE(double(odd.samplesPassed) / pixels, 4 * more * (1 + double(usual.samplesPassed) / usualPixels));
    EXPECT_LE(odd.draws, 2 * usual.draws + 8);
    EXPECT_LE(odd.triangles.submitted, 4 * usual.triangles.submitted + 10'000);
}

// By any renderer: each draws, and what the driver lacks is said.
class AnyRenderer : public Visits {};
TEST_P(AnyRenderer, presets) {
    DemoRun run(GetParam());
    drawSmall();
    for (const Preset& preset : stage().info().presets) {
        run.preset(preset.name);
        visitScene(preset.name);
    }
    std::printf("%s by %s\n", GetParam().c_str(), stage().driver().renderer.c_str());
}
INSTANTIATE_TEST_SUITE_P(Demos, AnyRenderer, testing::ValuesIn(demoNames()), parameterWord);

// Each is a picture, and no two are alike; it is written as the knobs write their values, and the readouts that its sentence tells
// are as it tells them.
// (What the processor computes in passes is drawn as small as the ends of the knobs: golden pictures show it large. So is all under the
// sanitizers, where presets are not compared.)
TEST_P(Visits, presets) {
    DemoRun run(GetParam());
    if (sanitized || hasPasses(stage().info())) drawSmall();
    const std::vector<Preset>& presets = stage().info().presets;
    ASSERT_GE(presets.size(), 2U);
    EXPECT_LE(presets.size(), 8U);
    std::vector<Picture> pictures;
    for (const Preset& preset : presets) {
        applyPreset(run.demo(), preset);
        EXPECT_TRUE(isAtPreset(run.demo(), preset)) << preset.name << " is not written as the knobs write it";
        EXPECT_EQ(run.refusal(), "") << preset.name;
        // Once: `steps_of_presets` draws each again.
        pictures.push_back(visitScene("preset " + preset.name, Times::once).value_or(Picture()));
        if (sanitized) continue;
        for (const ExpectedReadout& expected : preset.expect) {
            const double value = run.readout(expected.readout);
            EXPECT_TRUE(expected.low <= value && value <= expected.high)
                << preset.name << " says otherwise: " << expected.readout << " is " << value;
        }
    }
    for (std::size_t a = 0; a < pictures.size() && !sanitized; ++a) {
        for (std::size_t b = a + 1; b < pictures.size(); ++b) {
            if (pictures[a].width != pictures[b].width) continue;  // one of them failed
            // A smaller difference is not seen at a glance.
            EXPECT_GT(double(differentPixels(pictures[a], pictures[b])), 0.01 * pictures[a].width * pictures[a].height)
                << presets[a].name << " and " << presets[b].name << " are too much alike";
        }
    }
    // A setting that a preset leaves unsaid is initial, whatever was set before.
    for (Knob* knob : run.demo().knobs()) knob->parse(knob->sweep().back());
    applyPreset(run.demo(), presets.front());
    for (const Knob* knob : run.demo().knobs()) EXPECT_TRUE(knob->isInitial()) << knob->name();
}

// A frame of a preset does nothing needless that the demo does not declare; and what it declares, some preset does.
// (Under the sanitizers these are the same counts of the same draws, which `presets` has made.)
TEST_P(Visits, work_of_presets) {
    if (sanitized) return;
    const DemoInfo& demo = findDemo(GetParam());
    DemoInfo info = demo;
    // What the processor computes in passes is one draw of any size
    const int by = coarser(info);
    info.width /= by;
    info.height /= by;
    std::set<std::string> idle;
    for (const Preset& preset : info.presets) {
        SCOPED_TRACE(preset.name);
        const std::vector<KnobSetting> settings(preset.settings.begin(), preset.settings.end());
        const AuditReport report = auditDemo(stage(), info, settings, 1);
        EXPECT_TRUE(report.clean()) << auditText(report);
        EXPECT_GT(report.first.samplesPassed, 0);
        const std::set<std::string> here(report.idleExcuses.begin(), report.idleExcuses.end());
        if (&preset == &info.presets.front()) idle = here;
        std::erase_if(idle, [&](const std::string& excuse) { return !here.contains(excuse); });
        if (&preset == &info.presets.front() || isLong()) expectSameWorkAtOddSizes(demo, settings);
    }
    for (const std::string& excuse : idle) ADD_FAILURE() << "declared, and in no preset: " << excuse;
}

// Every draw, or 12 of them, in the demo's own settings; in ./test --long the ends in the other presets. (What stops a frame is the same in
// all.)
TEST_P(Visits, steps_of_presets) {
    const int by = coarser(findDemo(GetParam()));
    DemoRun run(GetParam(), 160 / by, 120 / by);
    const std::vector<Preset>& presets = stage().info().presets;
    for (const Preset& preset : presets) {
        SCOPED_TRACE(preset.name);
        const bool initial = &preset == presets.data();
        if (!isLong() && !initial) break;
        run.preset(preset.name);
        expectStops(run, initial && !sanitized ? 12 : 1);
    }
}

}  // namespace
}  // namespace mv::test
