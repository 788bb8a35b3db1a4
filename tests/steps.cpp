// Every demo, stopped after each of its draws.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "mv/gl/gl.h"
#include "mv/paper/report.h"
#include "mv/run/command_line.h"
#include "support/demo_run.h"
#include "support/sanitized.h"

using namespace mv;
using namespace mv::test;

namespace {

FrameSteps stopped(int draws, int frame = 1) {
    stage().stopAfter(frame, draws);
    return *stage().steps();
}

int drawsOf(int frame = 1) { return static_cast<int>(stopped(0, frame).draws.size()); }

// So many of 0..all, evenly, and both ends with the two beside them.
std::set<int> chosen(int all, int most) {
    std::set<int> draws{0, std::min(1, all), std::max(0, all - 1), all};
    for (int i = 1; i < most; ++i) draws.insert(all * i / most);
    return draws;
}

// Whether it can be made by clears alone, of the whole and of boxes such as panes: few rows differ, and few colours. What is
// drawn (a slope, a word) has tens.
bool isClearedOnly(const Picture& picture) {
    std::set<std::vector<std::uint8_t>> rows;
    for (int y = 0; y < picture.height; ++y) {
        const auto first = picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * pixelIndex(0, y, picture.width));
        rows.emplace(first, first + 4 * std::ptrdiff_t(picture.width));
    }
    return rows.size() <= 4 && countColors(picture) <= 4;
}

class Steps : public testing::TestWithParam<std::string> {};

TEST_P(Steps, stop_after_every_draw) {
    for (const Preset& preset : findDemo(GetParam()).presets) {
        SCOPED_TRACE(preset.name);
        const int by = coarserIfSanitized(findDemo(GetParam()));
        DemoRun run(GetParam(), 160 / by, 120 / by);
        run.preset(preset.name);
        const Picture whole = run.picture();
        const long objects = liveObjects();
        const int all = drawsOf();
        ASSERT_GT(all, 0);
        // Every draw, or 12 of them, in the demo's own settings; the ends in the other presets.
        const bool initial = &preset == findDemo(GetParam()).presets.data();
        if (sanitized && !initial) break;  // what stops a frame is the same in all
        for (const int draws :
             chosen(all, initial && !sanitized ? 12 : 1)) {  // each throws where OpenGL reports an error
            SCOPED_TRACE(draws);
            const FrameSteps steps = stopped(draws);
            EXPECT_EQ(steps.until, draws);
            ASSERT_EQ(steps.draws.size(), std::size_t(all));
            ASSERT_FALSE(steps.shown.buffers.empty());
            for (const DrawStep& draw : steps.draws) {
                EXPECT_GT(draw.count, 0);
                EXPECT_GT(draw.width, 0) << draw.target;
                EXPECT_TRUE(draw.program.starts_with("'")) << "a program without a name: " << draw.program;
            }
            const DrawStep& last = steps.draws[std::size_t(std::max(draws, 1)) - 1];
            EXPECT_EQ(steps.shown.isPicture, draws == 0 || last.inPicture);
            if (steps.shown.isPicture) {
                // The buffer that is shown is the picture that is saved.
                EXPECT_EQ(steps.shown.buffers[0].name, "color");
                EXPECT_EQ(steps.shown.buffers[0].picture, stage().picture());
            }
        }
        (void)stopped(all);
        EXPECT_EQ(stage().picture(), whole) << "all draws make another picture than the whole frame";
        (void)stopped(0);
        EXPECT_TRUE(isClearedOnly(stage().picture())) << saveFailure(GetParam() + " before draw 1", stage().picture());
        // Nothing half made is kept: the whole frame is what it was.
        EXPECT_EQ(run.picture(), whole);
        EXPECT_EQ(liveObjects(), objects);
    }
}

INSTANTIATE_TEST_SUITE_P(Demos, Steps, testing::ValuesIn(demoNames()), parameterWord);

TEST(StepRules, what_is_out_of_range_is_refused_with_the_number_of_draws) {
    DemoRun run("cube-cull");
    (void)run.picture();
    const int all = drawsOf();
    for (const int draws : {-1, all + 1, 1 << 30}) {
        try {
            stage().stopAfter(1, draws);
            FAIL() << draws;
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find("draws: must be 0 .. " + std::to_string(all) + ","), 0U)
                << error.what();
        }
    }
}

TEST(StepRules, the_state_of_a_draw_is_what_its_demo_sets) {
    DemoRun run("cube-cull");
    (void)run.set("cull", "front").set("depth", "on").picture();
    const FrameSteps steps = stopped(1);
    const std::vector<std::string>& state = steps.draws[0].state;
    const auto has = [&](const char* call) { return std::count(state.begin(), state.end(), call) == 1; };
    EXPECT_TRUE(has("glEnable(GL_CULL_FACE)"));
    EXPECT_TRUE(has("glEnable(GL_DEPTH_TEST)"));
    EXPECT_TRUE(has("glCullFace(GL_FRONT)"));
    EXPECT_EQ(steps.draws[0].primitive, "GL_TRIANGLES");
    EXPECT_EQ(steps.draws[0].program, "'cube-cull'");
    EXPECT_EQ(steps.draws[0].count, 36);
    (void)run.set("cull", "none").set("depth", "off").picture();
    const FrameSteps without = stopped(1);
    for (const std::string& call : without.draws[0].state) {
        EXPECT_EQ(call.find("glCullFace"), std::string::npos) << call;
        EXPECT_EQ(call.find("GL_DEPTH_TEST"), std::string::npos) << call;
    }
}

TEST(StepRules, a_map_that_is_kept_is_drawn_all_the_same) {
    DemoRun run("shadow-map");
    const Picture first = run.picture();
    EXPECT_EQ(run.picture(), first);  // now the map is kept
    const FrameSteps steps = stopped(1);
    EXPECT_FALSE(steps.draws[0].inPicture);
    ASSERT_EQ(steps.shown.buffers.size(), 1U);
    EXPECT_EQ(steps.shown.buffers[0].name, "depth");
    EXPECT_EQ(steps.shown.width, steps.shown.buffers[0].picture.width);
    EXPECT_GT(countColors(steps.shown.buffers[0].picture), 1);
    EXPECT_EQ(countColors(stage().picture()), 1);
}

TEST(StepRules, a_demo_that_remembers_is_stopped_at_its_frame) {
    DemoRun run("springs");
    const Picture at30 = run.picture(30);
    const int all = drawsOf(30);
    (void)stopped(all, 30);
    EXPECT_EQ(stage().picture(), at30);
    EXPECT_EQ(run.picture(30), at30);
}

}  // namespace
