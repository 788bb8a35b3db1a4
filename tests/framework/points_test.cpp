// Points: a list of points as a setting, and as handles.
#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>

#include "support/demo_of.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr PointLimits within(std::size_t least, std::size_t most) {
    return {.low = vec2(-1, -1), .high = vec2(3, 1), .least = least, .most = most, .grid = 0.1};
}

struct Values {
    std::vector<vec2> dots{{0, 0}, {1, -0.5}};
    vec2 one{0, 0};
    std::array<vec2, 2> ends{vec2(0, 0), vec2(1, 0)};
};

struct Dots : DemoOf<Values> {
    Dots()
        : DemoOf(together(mv::points("dots", &Values::dots, within(1, 4), "where they are"),
                          mv::points("one", &Values::one, within(1, 1), "where it is"),
                          mv::points("ends", &Values::ends, within(2, 2), "where they are"))) {
        addPlaces("dot", "dots", [](const FrameInfo& f, const vec2& value) -> std::optional<vec2> {
            return pictureFromPane(f.panes(2)[1], 50.0 * (value + 1.0));
        });
        addPlaces("end", "ends", [](const FrameInfo&, const vec2& value) { return value; });
    }
    Knob &dots = knob("dots"), &one = knob("one"), &ends = knob("ends");

    FrameInfo frame{1, 401, 200};  // the second pane begins at 201
    const Handle& handle() const { return handles().front(); }
    vec2 at(std::size_t i) const { return *handle().where(frame, i); }
};

std::string errorOf(Dots& demo, const std::string& text) {
    const std::string before = demo.dots.text();
    try {
        demo.dots.parse(text);
    } catch (const Error& error) {
        EXPECT_EQ(demo.dots.text(), before) << "a refused value must not be taken";
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST(PointsKnob, prints_and_parses) {
    Dots demo;
    EXPECT_EQ(demo.dots.text(), "0,0/1,-0.5");
    EXPECT_TRUE(demo.dots.isInitial());
    for (const std::string& text : demo.dots.sweep()) {
        demo.dots.parse(text);
        EXPECT_EQ(demo.dots.text(), text);
    }
    EXPECT_EQ(demo.dots.sweep().front(), "-1,-1");
    EXPECT_EQ(demo.dots.sweep().back(), "-1,-1/0.3,-0.3/1.7,0.3/3,1");
    demo.dots.parse("+2.9999999999,0.3/0,-0");
    EXPECT_EQ(demo.dots.text(), "3,0.3/0,0") << "a rounding of the text is no other value";
    EXPECT_EQ(demo.s.dots[0].x, 3);
    demo.dots.reset();
    EXPECT_EQ(demo.s.dots.size(), 2U);
}

TEST(PointsKnob, refuses_what_is_outside_beside_the_grid_or_no_point) {
    Dots demo;
    EXPECT_EQ(errorOf(demo, "0,1.1"),
              "--dots: must be 1 .. 4 points x,y/x,y with x in -1 .. 3, y in -1 .. 1, multiples of 0.1, '0,1.1'");
    for (const char* text : {"", "1", "1,", ",1", "1,0/", "/1,0", "1,0//0,0", "1,0,0", "1;0", "nan,0", "0.05,0",
                             "-1.1,0", "0,0/0,0/0,0/0,0/0,0", "0,0 ", "inf,0"})
        EXPECT_NE(errorOf(demo, text), "accepted") << "'" << text << "'";
}

TEST(PointsKnob, is_dragged_onto_its_grid_and_within_its_limits) {
    Dots demo;
    EXPECT_EQ(demo.handle().count(), 2U);
    EXPECT_EQ(demo.at(0), vec2(251, 50));
    EXPECT_TRUE(demo.handle().drag(demo.frame, 0, {201 + 83, 61}));
    EXPECT_EQ(demo.dots.text(), "0.7,0.2/1,-0.5");
    EXPECT_FALSE(demo.handle().drag(demo.frame, 0, {201 + 86, 60})) << "not as far as the next multiple";
    EXPECT_TRUE(demo.handle().drag(demo.frame, 1, {900, -900}));
    EXPECT_EQ(demo.dots.text(), "0.7,0.2/3,-1");
}

TEST(PointsKnob, has_as_many_as_it_may) {
    Dots demo;
    EXPECT_TRUE(demo.handle().add(0));
    EXPECT_EQ(demo.dots.text(), "0,0/0,0/1,-0.5");
    EXPECT_TRUE(demo.handle().add(2));
    EXPECT_FALSE(demo.handle().add(0));
    EXPECT_EQ(demo.handle().count(), 4U);
    EXPECT_TRUE(demo.handle().remove(0));
    EXPECT_TRUE(demo.handle().remove(0));
    EXPECT_TRUE(demo.handle().remove(0));
    EXPECT_FALSE(demo.handle().remove(0));
    EXPECT_EQ(demo.dots.text(), "1,-0.5");
}

// Nothing is offered that cannot be done: neither a key nor a button adds one, and the range tells no second number.
TEST(PointsKnob, of_a_fixed_number_offers_no_other) {
    Dots demo;
    const Handle& fixed = demo.handles().back();
    EXPECT_FALSE(fixed.add);
    EXPECT_FALSE(fixed.remove);
    EXPECT_TRUE(demo.handle().add && demo.handle().remove);
    EXPECT_EQ(demo.ends.range(), "2 points x,y/x,y with x in -1 .. 3, y in -1 .. 1, multiples of 0.1");
    EXPECT_EQ(demo.one.range(), "1 point x,y with x in -1 .. 3, y in -1 .. 1, multiples of 0.1");
    EXPECT_TRUE(demo.dots.range().starts_with("1 .. 4 points x,y/x,y with"));
    EXPECT_EQ(demo.one.sweep(), (std::vector<std::string>{"-1,-1", "0,0", "-1,-1"}));
}

TEST(PointsKnob, steps) {
    Dots demo;
    EXPECT_TRUE(demo.dots.step(0.5));
    EXPECT_EQ(demo.dots.text(), "0.5,0/1.5,-0.5");
    EXPECT_TRUE(demo.dots.step(100));
    EXPECT_FALSE(demo.dots.step(100));
}
