// Handles that are dragged in the picture: knobs follow the pointer.
#include "mv/demo/handle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "support/demo_of.h"

using namespace mv;
using namespace mv::test;

namespace {

struct Values {
    double x = 0, y = 1, z = 0.5, flatX = 0.25, flatY = 0.5, height = 1, turn = 350, coarse = 0.5, fine = 0, unseen = 1;
};

struct Hands : DemoOf<Values> {
    static mat4 clipFromWorld(double aspect) {
        return perspective(60, aspect, 0.2, 100) * lookAt(vec3(1, 2, 6), vec3(0, 0, 0), vec3(0, 1, 0));
    }
    static std::optional<vec2> placeOf(const FrameInfo& frame, const vec3& point) {
        return pictureFromPane({0, 0, frame.width(), frame.height()}, clipFromWorld(frame.aspect()), point);
    }
    Hands()
        : DemoOf(together(
              mv::number("x", &Values::x, {-2, 2}, ""), mv::number("y", &Values::y, {-1, 3}, ""),
              mv::number("z", &Values::z, {-2, 2}, ""), mv::number("flat-x", &Values::flatX, {0, 1}, ""),
              mv::number("flat-y", &Values::flatY, {0, 1}, ""), mv::number("height", &Values::height, {0.5, 2}, ""),
              angle("turn", &Values::turn, ""), mv::number("coarse", &Values::coarse, {0, 1}, ""),
              mv::number("fine", &Values::fine, {0, 10}, ""), mv::number("unseen", &Values::unseen, {0, 2}, ""))) {
        addPlace("in space", {"x", "y", "z"}, [this](const FrameInfo& f) { return placeOf(f, vec3(s.x, s.y, s.z)); });
        addPlace("on a line", {"height"}, [this](const FrameInfo& f) { return placeOf(f, vec3(-1, s.height, 0)); });
        addPlace("in a pane", {"flat-x", "flat-y"},
                 [this](const FrameInfo& f) { return pictureFromPane(f.panes(2)[1], 100.0 * vec2(s.flatX, s.flatY)); });
        addPlace("on a circle", {"turn"}, [this](const FrameInfo& f) {
            return placeOf(f, vec3(std::sin(radians(s.turn)), 0, std::cos(radians(s.turn))));
        });
        addPlace("nowhere", {"unseen"}, [this](const FrameInfo&) -> std::optional<vec2> {
            if (s.unseen < 0.9) throw Error("--unseen", "must be above 0.9");
            return vec2(100 * s.unseen, 0);
        });
        addPlace("uneven", {"coarse", "fine"},
                 [this](const FrameInfo&) { return vec2(100 * s.coarse + 5 * s.fine, 0); });
    }

    FrameInfo frame{1, 400, 300};
    vec2 at(std::size_t handle) const { return *handles()[handle].where(frame, 0); }
    bool drag(std::size_t handle, const vec2& pixel) { return handles()[handle].drag(frame, 0, pixel); }
};

}  // namespace

TEST(Handles, come_to_the_pointer) {
    Hands demo;
    for (const vec2& pixel : {vec2(200, 150), vec2(150.5, 99), vec2(260, 222)}) {
        EXPECT_TRUE(demo.drag(0, pixel));
        EXPECT_LT(glm::length(demo.at(0) - pixel), 0.1);
        EXPECT_TRUE(demo.drag(2, vec2(201, 0) + pixel / 4.0));
        EXPECT_LT(glm::length(demo.at(2) - vec2(201, 0) - pixel / 4.0), 0.1);
    }
    // All of it is in the text, which is short: the same setting again is the same place.
    const vec2 before = demo.at(0);
    for (Knob* knob : demo.knobs()) {
        EXPECT_LE(knob->text().size(), 8U) << knob->text();
        knob->parse(knob->text());
    }
    EXPECT_EQ(demo.at(0), before);
    EXPECT_FALSE(demo.drag(0, before)) << "it is there already";
}

TEST(Handles, in_space_they_move_across_the_line_of_sight) {
    Hands demo;
    const auto fromEye = [&] { return glm::length(vec3(demo.s.x, demo.s.y, demo.s.z) - vec3(1, 2, 6)); };
    const double before = fromEye();
    demo.drag(0, demo.at(0) + vec2(20, -12));
    // 23 pixels are 0.5 there; a straight step across the line is 0.5^2 / 2d = 0.02 farther from the eye
    EXPECT_NEAR(fromEye(), before, 0.025);
}

TEST(Handles, on_a_line_they_come_as_near_as_they_can) {
    Hands demo;
    const vec2 low = demo.at(1);
    demo.knob("height").parse("1.5");
    const vec2 along = glm::normalize(demo.at(1) - low), aside(-along.y, along.x);
    const vec2 wanted = low + 30.0 * along + 25.0 * aside;
    demo.drag(1, wanted);
    EXPECT_NEAR(glm::dot(demo.at(1) - wanted, along), 0, 0.5);
    // And stop at the ends of the range, exactly
    demo.drag(1, low + 4000.0 * along);
    EXPECT_EQ(demo.s.height, 2);
    demo.drag(1, low - 4000.0 * along);
    EXPECT_EQ(demo.s.height, 0.5);
    EXPECT_FALSE(demo.drag(1, low - 4100.0 * along));
}

TEST(Handles, one_end_does_not_stop_the_others) {
    Hands demo;
    demo.drag(2, vec2(201 + 500, 30));
    EXPECT_EQ(demo.s.flatX, 1);
    EXPECT_NEAR(demo.s.flatY, 0.3, 1e-3);
    // Nor when the one that is at its end would have made nearly all of the way
    demo.drag(5, vec2(130, 0));
    EXPECT_EQ(demo.s.coarse, 1);
    EXPECT_NEAR(demo.s.fine, 6, 0.01);
}

TEST(Handles, angles_turn_past_their_ends) {
    Hands demo;
    for (int i = 1; i <= 36; ++i) {
        const double angle = 350 + 10 * i;
        const vec2 wanted = *Hands::placeOf(demo.frame, vec3(std::sin(radians(angle)), 0, std::cos(radians(angle))));
        demo.drag(3, wanted);
        EXPECT_LT(glm::length(demo.at(3) - wanted), 2) << angle;
    }
    EXPECT_LT(std::abs(demo.s.turn), 360);
    demo.knob("turn").parse("360");  // where a slider ends
    EXPECT_TRUE(demo.drag(3, *Hands::placeOf(demo.frame, vec3(std::sin(0.2), 0, std::cos(0.2)))));
}

TEST(Handles, settings_without_a_picture_are_no_place) {
    Hands demo;
    EXPECT_TRUE(demo.drag(4, vec2(-50, 0)));
    EXPECT_GE(demo.s.unseen, 0.9);
    EXPECT_LT(demo.s.unseen, 1);
    demo.knob("unseen").parse("0.2");
    EXPECT_FALSE(demo.drag(4, vec2(150, 0)));
    EXPECT_EQ(demo.knob("unseen").text(), "0.2");
    // Behind the eye there is none either
    EXPECT_FALSE(Hands::placeOf(demo.frame, vec3(2, 4, 12)));
    EXPECT_FALSE(Hands::placeOf(demo.frame, vec3(1, 2, 6)));
}
