#include "mv/show/session.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "mv/gl/gl.h"
#include "mv/paper/report.h"
#include "support/demo_of.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int width = 200, height = 160;

struct Knobs {
    Session& session;
    std::string operator[](const std::string& name) const { return session.demo().knob(name).text(); }
};

// The same frame without a session.
Picture drawn(const std::string& demo, const std::vector<KnobSetting>& knobs, int frame) {
    DemoRun run(demo, width, height);
    applyKnobs(run.demo(), knobs);
    return run.picture(frame);
}

// Four passes, each of which makes the picture whiter by a quarter of `level`; and what it was asked for.
struct White {
    double level = 1;
};
struct Refining final : DemoOf<White> {
    Refining() : DemoOf({mv::number("level", &White::level, {0, 1}, "how white")}) {}
    std::vector<int> asked;
    double sum = 0;
    int passes(const FrameInfo&) const override { return 4; }
    void refine(const FrameInfo&, int pass) override {
        asked.push_back(pass);
        sum = (pass == 0 ? 0 : sum) + s.level / 4;
    }
    void draw(const Frame&) override {
        const auto grey = static_cast<float>(sum);
        glClearColor(grey, grey, grey, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
};

DemoInfo refining() {
    DemoInfo info;
    info.name = "refining";
    info.make = [] { return std::make_unique<Refining>(); };
    return info;
}

}  // namespace

TEST(Session, a_picture_of_passes_gets_one_a_draw_and_begins_anew_with_a_setting) {
    const DemoInfo info = refining();
    Session session(stage(), info, {.width = 4, .height = 4});
    auto& demo = dynamic_cast<Refining&>(session.demo());
    using Asked = std::vector<int>;
    session.draw(4, 4, false);
    EXPECT_EQ(session.passesDone(), 1);
    EXPECT_EQ(session.passes(), 4);
    EXPECT_TRUE(session.stale());
    EXPECT_EQ(stage().picture().rgba[0], 64);
    session.draw(4, 4, false);
    EXPECT_EQ(demo.asked, (Asked{0, 1}));

    EXPECT_EQ(session.set("level", "0.5"), "");
    session.draw(4, 4, false);
    EXPECT_EQ(demo.asked, (Asked{0, 1, 0})) << "what another setting began is not gone on with";
    session.finish(4, 4, false);
    EXPECT_EQ(demo.asked, (Asked{0, 1, 0, 1, 2, 3}));
    EXPECT_FALSE(session.stale());
    EXPECT_EQ(stage().picture().rgba[0], 128);

    session.touch();  // a shader, say: the passes are still good
    session.draw(4, 4, false);
    EXPECT_EQ(demo.asked.size(), 6U);
    EXPECT_FALSE(session.stale());

    session.draw(5, 4, false);
    EXPECT_EQ(demo.asked.back(), 0) << "another size is another picture";
    EXPECT_TRUE(session.stale());
    demo.asked.clear();
    stage().draw(1);
    EXPECT_EQ(demo.asked, (Asked{0, 1, 2, 3})) << "without a window all of them, from the first";
    stage().draw(1);
    EXPECT_EQ(demo.asked.size(), 8U) << "and again, since whoever asks twice may take the time";
    stage().close();
}

// A page needs: a demo by its name, its knobs as data and set by name, a picture, and what is known of it.
TEST(Session, knobs_are_data_and_set_by_name) {
    const Picture front = drawn("cube-cull", {{"cull", "front"}, {"spin-x", "30"}}, 1);
    const Picture none = drawn("cube-cull", {{"cull", "none"}, {"spin-x", "30"}}, 1);
    ASSERT_NE(front, none);
    Session session(stage(), findDemo("cube-cull"),
                    {.width = width, .height = height, .knobs = {{"cull", "front"}, {"spin-x", "30"}}});
    EXPECT_TRUE(session.due(width, height));
    EXPECT_FALSE(session.hasPicture());
    session.draw(width, height, true);
    EXPECT_EQ(stage().picture(), front);
    EXPECT_EQ(session.error(), "");
    EXPECT_FALSE(session.stale());

    EXPECT_NE(knobsJson(session.info(), session.demo()).find("\"front\""), std::string::npos);
    EXPECT_EQ(session.set("cull", "none"), "");
    EXPECT_TRUE(session.stale());
    session.draw(width, height, true);
    EXPECT_EQ(stage().picture(), none);
    // Refused in words, and nothing moved.
    EXPECT_EQ(session.set("cull", "sideways"), "--cull: must be none | back | front | both, 'sideways'");
    EXPECT_EQ(session.set("cul", "none"), "--cul: is no knob of this demo; did you mean 'cull'?");
    EXPECT_EQ(session.set("cull", "none"), "");
    EXPECT_FALSE(session.stale());
    EXPECT_EQ((Knobs{session}["cull"]), "none");

    const std::string report = reportJson(stage(), session.drawnFrame(), session.times());
    for (const char* part : {"\"facing\"", "\"clipFromView\"", "\"cull\"", "\"demo\": \"cube-cull\""}) {
        EXPECT_NE(report.find(part), std::string::npos) << part << " in " << report;
    }
    ASSERT_FALSE(session.notes().matrices.empty());
}

TEST(Session, keys_pointer_and_wheel_move_the_demos_knobs) {
    Session session(stage(), findDemo("cube-cull"), {.width = width, .height = height});
    const Knobs now{session};
    const auto drawAnew = [&] {
        const bool stale = session.stale();
        session.draw(width, height, false);
        return stale;
    };
    EXPECT_TRUE(drawAnew());
    EXPECT_TRUE(session.press(Key::up));
    EXPECT_EQ(now["z-dist"], "-3.8");
    EXPECT_TRUE(drawAnew());
    EXPECT_FALSE(session.press(key('Q'))) << "the host's, if it has a use for it";
    EXPECT_FALSE(drawAnew());
    session.wheel(1);
    EXPECT_EQ(now["z-dist"], "-4");
    EXPECT_TRUE(drawAnew());
    session.pointerMove(90, 90);
    EXPECT_FALSE(drawAnew()) << "no button is down";
    EXPECT_EQ(session.set("spin-x", "0") + session.set("spin-y", "0"), "");
    EXPECT_TRUE(drawAnew());
    session.pointerDown(10, 10);
    session.pointerMove(50, 15);
    session.pointerMove(50, 20);
    EXPECT_EQ(now["spin-y"], "-40");
    EXPECT_EQ(now["spin-x"], "10");
    EXPECT_TRUE(drawAnew());
    session.pointerUp();
    session.pointerMove(90, 90);
    EXPECT_EQ(now["spin-y"], "-40");
    EXPECT_FALSE(drawAnew());
}

// Settings without a picture leave the last one, in its size, and say why; as soon as there is one again it is shown.
TEST(Session, an_error_leaves_the_last_picture) {
    Session session(stage(), findDemo("cube-cull"), {.width = width, .height = height});
    session.draw(width, height, false);
    const Picture last = stage().picture();
    EXPECT_EQ(session.set("z-dist", "0"), "") << "a value that the knob takes";
    session.draw(width / 2, height / 2, false);
    EXPECT_EQ(session.error(), "--z-dist: must not be 0: the eye would stand on the point it looks at");
    EXPECT_TRUE(session.hasPicture());
    EXPECT_EQ(stage().picture(), last);
    EXPECT_FALSE(session.due(width / 2, height / 2)) << "the same would fail again";
    EXPECT_EQ(session.set("z-dist", "0.2"), "");
    session.draw(width / 2, height / 2, false);
    EXPECT_EQ(session.error(), "");
    EXPECT_EQ(stage().picture().width, width / 2);
}

// So does a fault that the driver reports (a window keeps the last picture's target), and the demo goes on.
TEST(Session, a_drivers_fault_is_a_sentence_and_the_demo_goes_on) {
    Session session(stage(), findDemo("cube-cull"), {.width = width, .height = height});
    session.draw(width, height, false);
    const Picture last = stage().picture();
    session.set("spin-y", "90");
    reportFault("the device is unwell");
    session.draw(width, height, false);
    EXPECT_EQ(session.error(), "OpenGL in cube-cull: must report no error, the device is unwell");
    EXPECT_TRUE(session.hasPicture());
    session.set("spin-y", "100");
    session.draw(width, height, false);
    EXPECT_EQ(session.error(), "");
    EXPECT_NE(stage().picture(), last);
}

TEST(Session, time_passes_in_frames) {
    const Picture later = drawn("viewpoints", {}, 31);
    Session session(stage(), findDemo("viewpoints"), {.width = width, .height = height});
    session.draw(width, height, false);
    EXPECT_EQ(session.drawnFrame(), 1);
    session.advance(0.5);  // exactly 30 frames
    EXPECT_TRUE(session.stale());
    EXPECT_EQ(session.drawnFrame(), 1) << "of the picture that is there";
    session.draw(width, height, false);
    EXPECT_EQ(session.drawnFrame(), 31);
    EXPECT_EQ(stage().picture(), later);

    Session still(stage(), findDemo("viewpoints"), {.width = width, .height = height, .frame = 31, .paused = true});
    still.draw(width, height, false);
    still.advance(10);
    EXPECT_FALSE(still.stale());
    EXPECT_EQ(stage().picture(), later);
}

// A change at some frame comes, also in a demo that does not move by itself.
TEST(Session, a_still_demo_plays_where_something_changes) {
    Session session(stage(), findDemo("cube-cull"),
                    {.width = width, .height = height, .changes = {{7, "cull", "front"}}});
    session.draw(width, height, false);
    const Picture before = stage().picture();
    EXPECT_EQ(Knobs{session}["cull"], "back");
    session.advance(0.1);
    session.draw(width, height, false);
    EXPECT_EQ(session.drawnFrame(), 7);
    EXPECT_EQ(Knobs{session}["cull"], "front");
    EXPECT_NE(stage().picture(), before);
    stage().close();
    Session still(stage(), findDemo("cube-cull"), {.width = width, .height = height});
    still.advance(0.1);
    still.draw(width, height, false);
    EXPECT_EQ(still.drawnFrame(), 1);
    stage().close();
}

TEST(Session, draws_what_is_due_and_no_more) {
    Session session(stage(), findDemo("cube-cull"), {.width = width, .height = height});
    for (int i = 0; i < 3; ++i) session.draw(width, height, false);
    EXPECT_EQ(session.picturesDrawn(), 1);
    session.touch();
    session.draw(width, height, false);
    EXPECT_EQ(session.picturesDrawn(), 2);
    session.draw(width + 1, height, false);
    EXPECT_EQ(session.picturesDrawn(), 3);
    EXPECT_EQ(session.times().runs, 1);
    EXPECT_EQ(session.times(4).runs, 4);
    EXPECT_EQ(session.picturesDrawn(), 3) << "what is timed is not shown";

    // Something else in the picture's place: its own check, its own count.
    struct Two final : OtherPicture {
        bool refuses = false;
        void check(const Demo&) override {
            if (refuses) throw Error("the second", "makes no picture");
        }
        Cost draw(Stage& on, int index, bool readouts) override {
            on.draw(index, readouts);
            on.draw(index, readouts);
            return {2, 1.5};
        }
    } two;
    session.touch();
    session.draw(width, height, false, &two);
    EXPECT_EQ(session.picturesDrawn(), 5);
    EXPECT_EQ(session.lastMilliseconds(), 1.5);
    two.refuses = true;
    session.touch();
    session.draw(width, height, false, &two);
    EXPECT_EQ(session.error(), "the second: makes no picture");
}
