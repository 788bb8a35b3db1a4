#include <gtest/gtest.h>

#include "support/demo_of.h"

using namespace mv;
using namespace mv::test;

namespace {

struct Values {
    double distance = -4, across = 0, down = 0;
    int view = 1;
};

struct Controls : DemoOf<Values> {
    Controls()
        : DemoOf(together(mv::number("distance", &Values::distance, {-10, 10}, ""),
                          angle("across", &Values::across, ""), angle("down", &Values::down, ""),
                          whole("view", &Values::view, {1, 9}, ""))) {
        addControl(keys(Key::down, Key::up, "distance", 0.2));
        addControl(keySets(key('3'), "view", "3"));
        addControl(mv::drag("across", 1, "down", -1));
        addControl(mv::wheel("distance", -0.1));
    }
    Knob &distance = knob("distance"), &across = knob("across"), &down = knob("down");
};

}  // namespace

TEST(Bindings, gestures_move_their_knobs) {
    Controls demo;
    EXPECT_TRUE(demo.press(Key::up));
    EXPECT_EQ(demo.distance.text(), "-3.8");
    EXPECT_TRUE(demo.press(Key::down));
    EXPECT_EQ(demo.distance.text(), "-4");
    EXPECT_TRUE(demo.press(key('3')));
    EXPECT_EQ(demo.s.view, 3);
    EXPECT_FALSE(demo.press(key('3'))) << "already there: nothing to draw anew";
    EXPECT_FALSE(demo.press(key('Q'))) << "a key of no binding";
    EXPECT_TRUE(demo.drag(40, 10));
    EXPECT_EQ(demo.across.text(), "40");
    EXPECT_EQ(demo.down.text(), "-10");
    EXPECT_FALSE(demo.drag(0, 0));
    EXPECT_TRUE(demo.wheel(1));
    EXPECT_EQ(demo.distance.text(), "-4.1");
}

TEST(Bindings, keys_have_names) {
    EXPECT_EQ(keyName(Key::up), "Up");
    EXPECT_EQ(keyName(key('7')), "7");
}

TEST(Names, slips_of_the_hand_find_the_nearest) {
    const std::vector<std::string> names{"cube-cull", "cube-ortho", "shadow"};
    EXPECT_EQ(nearestName("cube-cul", names), "cube-cull");
    EXPECT_EQ(nearestName("shaddow", names), "shadow");
    EXPECT_EQ(nearestName("teapot", names), "");
    EXPECT_EQ(suggestion("teapot", names), "");
    EXPECT_EQ(suggestion("cube-cul", names), "; did you mean 'cube-cull'?");
}
