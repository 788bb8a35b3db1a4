#include "mv/show/stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <utility>

#include "mv/gl/gl.h"
#include "mv/gl/state.h"
#include "mv/paper/report.h"
#include "support/demo_of.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

TEST(Panes, share_the_picture_without_overlap) {
    for (int count = 1; count <= 10; ++count) {
        for (const auto& [width, height] : {std::pair{960, 720}, {101, 37}, {40, 300}}) {
            const auto panes = FrameInfo(1, width, height).panes(count);
            ASSERT_EQ(panes.size(), std::size_t(count));
            std::vector<int> owner(std::size_t(width) * std::size_t(height), -1);
            long owned = 0;
            for (int i = 0; i < count; ++i) {
                const Pane& pane = panes[std::size_t(i)];
                EXPECT_EQ(std::pair(pane.width, pane.height), std::pair(panes[0].width, panes[0].height));
                for (int y = pane.y; y < pane.y + pane.height; ++y) {
                    for (int x = pane.x; x < pane.x + pane.width; ++x) {
                        ASSERT_TRUE(x >= 0 && y >= 0 && x < width && y < height);
                        int& pixel = owner[pixelIndex(x, y, width)];
                        ASSERT_EQ(pixel, -1) << i << " of " << count;
                        pixel = i;
                        ++owned;
                    }
                }
            }
            // Lines of 1 pixel, a rest of less than a row or column of panes, and the cells that are left over
            const int columns = int(std::ceil(std::sqrt(count))), rows = (count + columns - 1) / columns;
            const long cells = long(columns) * rows - count;
            EXPECT_GE(owned + cells * panes[0].width * panes[0].height,
                      long(width - 2 * columns) * (height - 2 * rows));
        }
    }
    const FrameInfo frame(1, 21, 11);
    const auto four = frame.panes(4);  // row by row from the upper left, y counted from below
    EXPECT_EQ(std::pair(four[0].x, four[0].y), std::pair(0, 6));
    EXPECT_EQ(std::pair(four[1].x, four[1].y), std::pair(11, 6));
    EXPECT_EQ(std::pair(four[2].x, four[2].y), std::pair(0, 0));
    EXPECT_EQ(std::pair(four[3].x, four[3].y), std::pair(11, 0));
    EXPECT_EQ(frame.panes(1)[0].width, 21);
    EXPECT_EQ(FrameInfo(1, 1, 1).panes(4)[3].width, 1);
    EXPECT_THROW(frame.panes(0), Error);
}

// What a demo leaves behind is the same in pictures of any size.
Picture freshPicture(const std::string& name) { return DemoRun(name, 160, 120).picture(); }

// A demo that can be told to go wrong.
enum class Mood { good, refused, glError, leak, dirty };
struct Temper {
    Mood mood = Mood::good;
};
struct Unruly final : DemoOf<Temper> {
    Unruly()
        : DemoOf({mv::word("mood", &Temper::mood, {{"good"}, {"refused"}, {"gl-error"}, {"leak"}, {"dirty"}}, "")}) {}
    static Buffer leaked;
    void check() const override {
        if (s.mood == Mood::refused) throw Error("--mood", "must not be refused");
    }
    void draw(const Frame& frame) override {
        glClearColor(float(frame.index() % 7) / 7.0F, 0.5F, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        if (s.mood == Mood::glError) glEnable(GL_TEXTURE_2D);  // no capability of core OpenGL
        if (s.mood == Mood::leak && !leaked) leaked = makeBuffer();
    }
};
Buffer Unruly::leaked;

DemoInfo unruly() {
    DemoInfo info;
    info.name = "unruly";
    info.make = [] { return std::make_unique<Unruly>(); };
    return info;
}

}  // namespace

// No demo sees what another left: for all ordered pairs, A, B, A again equals A on a fresh stage, byte for byte.
TEST(Stage, demos_leave_no_trace) {
    std::map<std::string, Picture> fresh;
    for (const std::string& name : demoNames()) fresh[name] = freshPicture(name);
    const std::vector<std::string> names = demoNames();
    std::string before = names.back();
    const auto visit = [&](const std::string& name) {
        EXPECT_EQ(freshPicture(name), fresh[name]) << name << " after " << before;
        before = name;
    };
    // Round once, and back: each demo after both of its neighbours.
    for (const std::string& name : names) visit(name);
    std::vector<std::string> back = names;
    std::reverse(back.begin(), back.end());
    for (const std::string& name : back) visit(name);
    // And after each of the others: 0 1 0 2 0 3 ... 1 2 1 3 ...
    for (std::size_t a = 0; std::getenv("MVGL_LONG") && a < names.size(); ++a) {
        for (std::size_t b = a + 1; b < names.size(); ++b) {
            visit(names[a]);
            visit(names[b]);
        }
    }
    stage().close();
    EXPECT_EQ(liveObjects(), 0);
}

// The stage undoes what a reader has to undo, who pastes a draw into a loop of their own: each demo drawn twice without
// it, those that then differ, and that they do not once it is undone.
TEST(Stage, a_draw_pasted_elsewhere_needs_what_is_undone) {
    std::vector<std::string> differing;
    for (const std::string& name : demoNames()) {
        const DemoInfo& info = findDemo(name);
        const int by = coarserIfSanitized(info), width = info.width / by, height = info.height / by;
        stage().open(info, width, height);
        const auto drawAlone = [&] {
            FrameNotes notes;
            FrameMode mode;
            mode.bindTarget = [] { stage().front().bind(); };
            stage().front().bind();
            const fvec4 color(info.background.value_or(vec4(0)));
            glClearColor(color.r, color.g, color.b, color.a);
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
            glClearColor(0, 0, 0, 0);
            const Frame frame({1, width, height}, notes, mode);
            stage().demo().draw(frame);
            stage().demo().annotate(frame);
            return stage().picture();
        };
        stage().draw(1);
        const Picture right = stage().picture();
        EXPECT_EQ(drawAlone(), right) << name << ": the first draw by itself";
        EXPECT_FALSE(changedState().empty()) << name;
        if (drawAlone() != right) differing.push_back(name);
        restoreInitialState();
        EXPECT_EQ(drawAlone(), right) << name << ": after what was undone";
    }
    stage().close();
    std::string list;
    for (const std::string& name : differing) list += " " + name;
    std::cout << "drawn twice without undoing, another picture:" << list << "\n";
    EXPECT_FALSE(differing.empty()) << "then nothing would have to be undone";
}

TEST(Stage, errors_are_thrown_and_a_leak_is_found) {
    const DemoInfo info = unruly();
    stage().open(info, 8, 8);
    EXPECT_NO_THROW(stage().draw(1));
    stage().demo().knob("mood").parse("refused");
    EXPECT_THROW(stage().draw(1), Error);
    stage().demo().knob("mood").parse("gl-error");
    try {
        stage().draw(1);
        ADD_FAILURE() << "an OpenGL error must be thrown";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("OpenGL in unruly"), std::string::npos) << error.what();
    }
    stage().demo().knob("mood").parse("leak");
    stage().draw(1);
    EXPECT_THROW(stage().close(), Error);
    Unruly::leaked = Buffer();
    EXPECT_EQ(liveObjects(), 0);
}

TEST(Stage, sizes_beyond_the_driver_are_refused) {
    const DemoInfo& info = findDemo("cube-cull");
    EXPECT_THROW(stage().open(info, 0, 5), Error);
    EXPECT_THROW(stage().open(info, 1000000, 5), Error);
    EXPECT_NO_THROW(stage().open(info, 1, 1));
}

TEST(Stage, samples_are_what_was_asked_or_refused) {
    DemoInfo info = findDemo("cube-cull");
    GLint most = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    info.needs.samples = most;
    stage().open(info, 64, 64);
    stage().draw(1);
    EXPECT_GT(countColors(stage().picture()), 4) << "edges are mixed by the samples";
    info.needs.samples = most + 1;
    EXPECT_THROW(stage().open(info, 64, 64), Error);
    if (stage().driver().renderer.rfind("llvmpipe", 0) == 0) {  // it has 4, and makes 4 of 2 in silence
        info.needs.samples = 2;
        EXPECT_THROW(stage().open(info, 64, 64), Error);
    }
    stage().open(findDemo("cube-cull"), 8, 8);
}

TEST(Stage, a_newer_opengl_than_declared_is_refused) {
    DemoRun run("cube-cull");
    EXPECT_THROW(glPatchParameteri(GL_PATCH_VERTICES, 3), Error);
    allowVersion(40);
    EXPECT_NO_THROW(glPatchParameteri(GL_PATCH_VERTICES, 3));
    allowVersion(33);
    DemoInfo info = findDemo("cube-cull");
    info.needs.gl = 99;
    try {
        stage().open(info, 8, 8);
        ADD_FAILURE() << "OpenGL 9.9 must be refused";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("needs OpenGL 9.9"), std::string::npos) << error.what();
    }
}

TEST(Report, has_readouts_counters_and_matrices) {
    DemoRun run("cube-cull");
    run.set("apart", "off").picture();
    const std::string text = reportText(stage(), 1, {});
    for (const char* part :
         {"cube-cull, frame 1, 600x600", "readout   facing", "(faces of the cube turned towards the eye, of 6)",
          "2 draws, 12 triangles", "buffers   color, depth, 0 samples", "matrix    viewFromModel", "cull=back"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    }
    const std::string json = reportJson(stage(), 1, {});
    EXPECT_NE(json.find("\"facing\""), std::string::npos);
    EXPECT_EQ(timeFrames(stage(), 1, 9, 0).runs, 9);
}
