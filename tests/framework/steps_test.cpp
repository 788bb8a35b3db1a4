// A frame that is stopped after some of its draws. (Each demo is, by the visits.)
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "mv/paper/report.h"
#include "mv/run/command_line.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

FrameSteps stopped(int draws, int frame = 1) {
    stage().stopAfter(frame, draws);
    return *stage().steps();
}

int drawsOf(int frame = 1) { return static_cast<int>(stopped(0, frame).draws.size()); }

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
    // A pixel's depth is a number, of which the picture shows a shade
    const BufferPicture& depth = steps.shown.buffers[0];
    std::map<int, double> depthOfShade;
    for (int x = 0; x < depth.picture.width; ++x) {
        const std::string value = valueAt(depth, x, depth.picture.height / 3);
        ASSERT_FALSE(value.empty());
        const double number = std::strtod(value.c_str(), nullptr);
        EXPECT_TRUE(number >= 0 && number <= 1) << value;
        const int shade = depth.picture.at(x, depth.picture.height / 3).red;
        for (const auto& [other, known] : depthOfShade) {
            EXPECT_TRUE(shade >= other || number < known + 1e-6) << "a darker pixel is not farther";
        }
        depthOfShade[shade] = number;
    }
    EXPECT_GT(depthOfShade.size(), 1U) << "more than one depth in that row";
    EXPECT_EQ(valueAt(depth, -1, 0), "");
    EXPECT_EQ(valueAt(depth, 0, depth.picture.height), "");
    EXPECT_EQ(valueAt({"color", "as it is", Picture(1, 1)}, 0, 0), "0 0 0");
    EXPECT_EQ(countColors(stage().picture()), 1);
}

// By OpenGL ES 3.0, which gives back neither depths nor stencils, shaders read what OpenGL reads: the same ranges, and the same
// shades but for a depth that two drivers round otherwise.
TEST(StepRules, depth_and_stencil_are_seen_by_es_too) {
    for (const char* demo : {"shadow-map", "shadow-volume"}) {  // depths in a texture, and stencils beside depths
        std::vector<std::vector<BufferPicture>> seen[2];
        for (const bool es : {false, true}) {
            stageOn(HostKind::egl, es);
            DemoRun run(demo, 240, 180);
            const Picture whole = run.picture();
            const int all = drawsOf();
            for (const int draws : {1, all / 2, all}) seen[es].push_back(stopped(draws).shown.buffers);
            EXPECT_EQ(stage().picture(), whole) << demo;  // nothing is left set that a later draw would feel
        }
        bool anyDepth = false;
        for (std::size_t step = 0; step < seen[0].size(); ++step) {
            ASSERT_EQ(seen[0][step].size(), seen[1][step].size()) << demo << " " << step;
            for (std::size_t i = 0; i < seen[0][step].size(); ++i) {
                const BufferPicture &one = seen[0][step][i], &other = seen[1][step][i];
                EXPECT_EQ(one.name, other.name);
                EXPECT_EQ(one.range, other.range) << demo << " " << one.name;
                ASSERT_EQ(one.picture.rgba.size(), other.picture.rgba.size()) << demo << " " << one.name;
                EXPECT_FALSE(one.picture.rgba.empty()) << demo << " " << one.name;
                int most = 0;
                for (std::size_t byte = 0; byte < one.picture.rgba.size(); ++byte)
                    most = std::max(most, std::abs(one.picture.rgba[byte] - other.picture.rgba[byte]));
                EXPECT_LE(most, 1) << demo << " " << one.name;
                anyDepth |= one.name == "depth" && countColors(one.picture) > 2;
            }
        }
        EXPECT_TRUE(anyDepth) << demo;
    }
    leaveStage();
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
