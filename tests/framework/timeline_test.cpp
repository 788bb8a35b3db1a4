// A demo that remembers is the same at a frame whatever was drawn before.
#include "mv/show/timeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "support/demo_of.h"

using namespace mv;
using namespace mv::test;

namespace {

struct Walk {
    std::vector<double> places;
    long steps = 0;
    bool operator==(const Walk&) const = default;
};

// Each place follows from the last, by a knob, in a way that no other order of steps gives.
struct Values {
    double pull = 0.5;
    int masses = 2;
    bool shine = false;
};

struct Walker final : DemoOf<Values> {
    Walker()
        : DemoOf(together(mv::number("pull", &Values::pull, {0, 1}, "how strongly"),
                          whole("masses", &Values::masses, {1, 9}, "how many").beginsAnew(),
                          toggle("shine", &Values::shine, "for the eye alone"))) {}
    Knob &pull = knob("pull"), &masses = knob("masses"), &shine = knob("shine");
    Memory<Walk> walk{this};
    long stepped = 0, begun = 0;
    int breaksAt = -1;

    void reset() override {
        ++begun;
        *walk = {std::vector<double>(static_cast<std::size_t>(s.masses), 1.0)};
    }
    void step(int index) override {
        if (index == breaksAt) throw Error("walker", "must not fall");
        ++stepped;
        ++walk->steps;
        for (double& place : walk->places) place = std::sin(3 * place + s.pull) + index % 7;
    }
};

struct Level {
    double level = 0.5;
};
struct Still final : DemoOf<Level> {
    Still() : DemoOf({mv::number("level", &Level::level, {0, 1}, "how bright")}) {}
    Knob& level = knob("level");
};

// As a fresh demo comes to that frame in one go.
Walk straight(int index, const std::vector<KnobSetting>& beginning = {}, const std::vector<TimedChange>& changes = {}) {
    Walker demo;
    applyKnobs(demo, beginning);
    Timeline timeline(demo);
    timeline.setChanges(changes);
    timeline.bring(index);
    return *demo.walk;
}

TEST(Timeline, frames_in_any_order_are_those_of_going_straight) {
    const std::vector<TimedChange> changes{{700, "pull", "0.25"}, {30, "pull", "1"}, {700, "masses", "4"}};
    Walker demo;
    Timeline timeline(demo);
    timeline.setChanges(changes);
    std::mt19937 random(3);
    for (int i = 0; i < 60; ++i) {
        const int index = static_cast<int>(random() % 1500);
        timeline.bring(index);
        SCOPED_TRACE(index);
        EXPECT_EQ(*demo.walk, straight(index, {}, changes));
        EXPECT_EQ(demo.pull.text(), index < 30 ? "0.5" : index < 700 ? "1" : "0.25");
        EXPECT_EQ(demo.walk->places.size(), index < 700 ? 2U : 4U);
    }
}

TEST(Timeline, a_change_is_made_after_the_step_to_its_frame) {
    const std::vector<TimedChange> changes{{5, "pull", "1"}};
    EXPECT_EQ(straight(5, {}, changes), straight(5));
    EXPECT_NE(straight(6, {}, changes), straight(6));
    // One that begins anew leaves nothing of the frames before.
    const Walk anew = straight(5, {}, {{5, "masses", "3"}});
    EXPECT_EQ(anew.steps, 0);
    EXPECT_EQ(anew.places, (std::vector<double>{1, 1, 1}));
    // The same value is no change.
    EXPECT_EQ(straight(9, {}, {{5, "masses", "2"}}), straight(9));
}

TEST(Timeline, going_back_begins_at_a_kept_frame_and_keeps_not_many) {
    Walker demo;
    Timeline timeline(demo);
    timeline.bring(100'000);
    for (const int index : {99'999, 50'001, 3, 99'998}) {
        demo.stepped = 0;
        timeline.bring(index);
        // 64 frames are kept at most, and from 64 on every second one is forgotten: at least 32 remain.
        EXPECT_LE(demo.stepped, 100'000 / 32) << index;
        EXPECT_EQ(demo.walk->steps, index);
    }
    demo.stepped = 0;
    timeline.bring(99'998);
    timeline.bring(99'999);
    EXPECT_EQ(demo.stepped, 1) << "a frame that is there costs nothing, the next one step";
}

TEST(Timeline, a_knob_that_is_moved_is_another_beginning) {
    Walker demo;
    Timeline timeline(demo);
    timeline.bring(500);
    const Walk before = *demo.walk;
    demo.pull.parse("0.75");
    timeline.bring(500);
    EXPECT_EQ(*demo.walk, straight(500, {{"pull", "0.75"}}));
    demo.stepped = 0;
    demo.pull.parse("0.5");
    timeline.bring(500);
    EXPECT_EQ(*demo.walk, before);
    EXPECT_EQ(demo.stepped, 0) << "the way that was gone before is remembered";
}

// Somebody plays: moves knobs, goes back, lets it run. The copied command then gives the same in a fresh demo.
TEST(Timeline, what_was_played_is_repeated_from_its_beginning_and_its_changes) {
    std::mt19937 random(5);
    const auto below = [&](unsigned count) { return static_cast<int>(random() % count); };
    for (int game = 0; game < 40; ++game) {
        Walker demo;
        applyKnobs(demo, {{"pull", "0.125"}});
        Timeline timeline(demo);
        timeline.record();
        int frame = 1;
        for (int act = 0; act < 60; ++act) {
            switch (below(6)) {
                case 0:
                    demo.pull.parse(std::to_string(below(5) * 0.25));
                    break;
                case 1:
                    demo.masses.parse(std::to_string(1 + below(4)));
                    break;
                case 2:
                    frame = std::max(0, frame - below(200));  // back
                    break;
                case 3:
                    break;  // the same frame once more
                default:
                    frame += 1 + below(100);
            }
            timeline.bring(frame);
            SCOPED_TRACE("game " + std::to_string(game) + ", act " + std::to_string(act));
            Walker again;
            applyKnobs(again, timeline.beginning());
            Timeline repeated(again);
            repeated.setChanges(timeline.changesUntil(frame));
            repeated.bring(frame);
            ASSERT_EQ(*again.walk, *demo.walk);
            ASSERT_EQ(again.pull.text(), demo.pull.text());
            ASSERT_EQ(again.masses.text(), demo.masses.text());
        }
    }
}

TEST(Timeline, going_back_brings_the_knobs_back_and_a_move_there_drops_what_came_later) {
    Walker demo;
    Timeline timeline(demo);
    timeline.record();
    timeline.bring(10);
    demo.pull.parse("1");
    timeline.bring(20);
    EXPECT_EQ(timeline.changesUntil(20), (std::vector<TimedChange>{{10, "pull", "1"}}));
    timeline.bring(9);
    EXPECT_EQ(demo.pull.text(), "0.5");
    timeline.bring(15);
    EXPECT_EQ(demo.pull.text(), "1");
    timeline.bring(9);
    demo.pull.parse("0.25");
    timeline.bring(15);
    EXPECT_EQ(timeline.changesUntil(15), (std::vector<TimedChange>{{9, "pull", "0.25"}}));
    EXPECT_EQ(*demo.walk, straight(15, {}, {{9, "pull", "0.25"}}));
    // At one frame only the last of several moves counts, and one that is taken back is none.
    demo.pull.parse("0.75");
    timeline.bring(15);
    demo.pull.parse("0");
    timeline.bring(15);
    EXPECT_EQ(timeline.changesUntil(15).size(), 2U);
    timeline.beginAnew();
    timeline.bring(1);
    EXPECT_TRUE(timeline.changesUntil(1'000).empty());
    EXPECT_EQ(*demo.walk, straight(1, {{"pull", "0"}}));
}

TEST(Timeline, another_value_is_as_if_it_had_been_all_the_time_and_each_goes_on_from_its_last_frame) {
    Walker demo;
    Timeline timeline(demo);
    timeline.record();
    for (int frame = 1; frame <= 300; ++frame) {
        if (frame == 100) demo.masses.parse("3");
        demo.stepped = 0;
        const std::string present = demo.pull.text();
        timeline.vary(KnobSetting{"pull", "1"});
        demo.pull.parse("1");  // as a comparison does
        timeline.bring(frame);
        const Walk other = *demo.walk;
        timeline.vary({});
        demo.pull.parse(present);
        timeline.bring(frame);
        EXPECT_LE(demo.stepped, 2) << frame;
        if (frame % 50 != 0) continue;
        const std::vector<TimedChange> changes = timeline.changesUntil(frame);
        EXPECT_EQ(*demo.walk, straight(frame, {}, changes)) << frame;
        EXPECT_EQ(other, straight(frame, {{"pull", "1"}}, changes)) << frame;
    }
    EXPECT_EQ(timeline.changesUntil(300), (std::vector<TimedChange>{{99, "masses", "3"}}));
}

TEST(Timeline, a_demo_without_memory_is_left_alone) {
    Still demo;
    Timeline timeline(demo);
    timeline.record();
    for (const int frame : {1, 100, 3}) timeline.bring(frame);
    demo.level.parse("0.75");
    timeline.bring(4);
    EXPECT_EQ(demo.level.text(), "0.75");
    EXPECT_FALSE(timeline.matters());
    // With a change that comes it is brought to its settings, too.
    Timeline timed(demo);
    timed.setChanges({{50, "level", "1"}});
    for (const int frame : {60, 10, 50, 49}) {
        timed.bring(frame);
        EXPECT_EQ(demo.level.text(), frame < 50 ? "0.75" : "1") << frame;
    }
}

// 24 hours of frames: kept frames stay few, the memory's numbers are those of the formula.
// Frames of a demo that remembers nothing are not gone through one by one, however many there are.
TEST(Timeline, the_last_frame_of_a_still_demo_is_as_near_as_the_first) {
    struct Counted {
        int level = 1;
    };
    struct Counting final : DemoOf<Counted> {
        Counting() : DemoOf({whole("level", &Counted::level, {1, 9}, "a number")}) {}
        int steps = 0;
        void step(int) override { ++steps; }
    } demo;
    Timeline timeline(demo);
    timeline.setChanges({{5, "level", "3"}, {1'000'000'000, "level", "7"}});
    for (const auto& [frame, level] : std::vector<std::pair<int, int>>{{4, 1},
                                                                       {5, 3},
                                                                       {999'999'999, 3},
                                                                       {1'000'000'000, 7},
                                                                       {std::numeric_limits<int>::max(), 7},
                                                                       {5, 3},
                                                                       {0, 1}}) {
        timeline.bring(frame);
        EXPECT_EQ(demo.s.level, level) << frame;
    }
    EXPECT_EQ(demo.steps, 0);
}

TEST(Timeline, lasts_a_day) {
    Walker demo;
    Timeline timeline(demo);
    int told = 0;
    timeline.progress = [&](int reached, int wanted) {
        EXPECT_LT(reached, wanted);
        ++told;
    };
    timeline.bring(24 * 3600 * 60);
    EXPECT_EQ(demo.walk->steps, 24 * 3600 * 60);
    demo.stepped = 0;
    timeline.bring(24 * 3600 * 60 - 1);
    EXPECT_LE(demo.stepped, 24 * 3600 * 60 / 32);
}

TEST(Timeline, a_step_that_fails_is_no_way_to_go_on) {
    Walker demo;
    Timeline timeline(demo);
    timeline.bring(5);
    demo.breaksAt = 8;
    EXPECT_THROW(timeline.bring(20), Error);
    demo.breaksAt = -1;
    timeline.bring(20);
    EXPECT_EQ(*demo.walk, straight(20));
}

TEST(Memory, is_one_for_a_demo) {
    struct Two final : DemoOf<Level> {
        Memory<int> one{this}, another{this};
    };
    EXPECT_THROW(Two(), Error);
}

}  // namespace
