// What is dragged in the picture: knobs follow the pointer.
#include "mv/demo/handle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "mv/demo/demo.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

using namespace mv;

namespace {

struct Hands : Demo {
    Real x{this, "x", 0, {-2, 2}, ""}, y{this, "y", 1, {-1, 3}, ""}, z{this, "z", 0.5, {-2, 2}, ""};
    Real flatX{this, "flat-x", 0.25, {0, 1}, ""}, flatY{this, "flat-y", 0.5, {0, 1}, ""};
    Real height{this, "height", 1, {0.5, 2}, ""};
    Angle turn{this, "turn", 350, ""};
    Real coarse{this, "coarse", 0.5, {0, 1}, ""}, fine{this, "fine", 0, {0, 10}, ""};
    Real unseen{this, "unseen", 1, {0, 2}, ""};

    static mat4 clipFromWorld(double aspect) {
        return perspective(60, aspect, 0.2, 100) * lookAt(vec3(1, 2, 6), vec3(0, 0, 0), vec3(0, 1, 0));
    }
    static std::optional<vec2> placeOf(const FrameInfo& frame, const vec3& point) {
        return pictureFromPane({0, 0, frame.width(), frame.height()}, clipFromWorld(frame.aspect()), point);
    }
    Hands() {
        bindHandle("in space", {&x, &y, &z}, [this](const FrameInfo& f) { return placeOf(f, vec3(x, y, z)); });
        bindHandle("on a line", {&height}, [this](const FrameInfo& f) { return placeOf(f, vec3(-1, height, 0)); });
        bindHandle("in a pane", {&flatX, &flatY},
                   [this](const FrameInfo& f) { return pictureFromPane(f.panes(2)[1], 100.0 * vec2(flatX, flatY)); });
        bindHandle("on a circle", {&turn}, [this](const FrameInfo& f) {
            return placeOf(f, vec3(std::sin(radians(turn)), 0, std::cos(radians(turn))));
        });
        bindHandle("nowhere", {&unseen}, [this](const FrameInfo&) -> std::optional<vec2> {
            if (unseen < 0.9) throw Error("--unseen", "must be above 0.9");
            return vec2(100 * unseen, 0);
        });
        bindHandle("uneven", {&coarse, &fine}, [this](const FrameInfo&) { return vec2(100 * coarse + 5 * fine, 0); });
    }
    void init() override {}
    void draw(const Frame&) override {}

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
    const auto fromEye = [&] { return glm::length(vec3(demo.x, demo.y, demo.z) - vec3(1, 2, 6)); };
    const double before = fromEye();
    demo.drag(0, demo.at(0) + vec2(20, -12));
    // 23 pixels are 0.5 there; a straight step across the line is 0.5^2 / 2d = 0.02 farther from the eye
    EXPECT_NEAR(fromEye(), before, 0.025);
}

TEST(Handles, on_a_line_they_come_as_near_as_they_can) {
    Hands demo;
    const vec2 low = demo.at(1);
    demo.height.parse("1.5");
    const vec2 along = glm::normalize(demo.at(1) - low), aside(-along.y, along.x);
    const vec2 wanted = low + 30.0 * along + 25.0 * aside;
    demo.drag(1, wanted);
    EXPECT_NEAR(glm::dot(demo.at(1) - wanted, along), 0, 0.5);
    // And stop at the ends of the range, exactly
    demo.drag(1, low + 4000.0 * along);
    EXPECT_EQ(double(demo.height), 2);
    demo.drag(1, low - 4000.0 * along);
    EXPECT_EQ(double(demo.height), 0.5);
    EXPECT_FALSE(demo.drag(1, low - 4100.0 * along));
}

TEST(Handles, one_end_does_not_stop_the_others) {
    Hands demo;
    demo.drag(2, vec2(201 + 500, 30));
    EXPECT_EQ(double(demo.flatX), 1);
    EXPECT_NEAR(double(demo.flatY), 0.3, 1e-3);
    // Nor when the one that is at its end would have made nearly all of the way
    demo.drag(5, vec2(130, 0));
    EXPECT_EQ(double(demo.coarse), 1);
    EXPECT_NEAR(double(demo.fine), 6, 0.01);
}

TEST(Handles, angles_turn_past_their_ends) {
    Hands demo;
    for (int i = 1; i <= 36; ++i) {
        const double angle = 350 + 10 * i;
        const vec2 wanted = *Hands::placeOf(demo.frame, vec3(std::sin(radians(angle)), 0, std::cos(radians(angle))));
        demo.drag(3, wanted);
        EXPECT_LT(glm::length(demo.at(3) - wanted), 2) << angle;
    }
    EXPECT_LT(std::abs(double(demo.turn)), 360);
    demo.turn.parse("360");  // where a slider ends
    EXPECT_TRUE(demo.drag(3, *Hands::placeOf(demo.frame, vec3(std::sin(0.2), 0, std::cos(0.2)))));
}

TEST(Handles, settings_without_a_picture_are_no_place) {
    Hands demo;
    EXPECT_TRUE(demo.drag(4, vec2(-50, 0)));
    EXPECT_GE(double(demo.unseen), 0.9);
    EXPECT_LT(double(demo.unseen), 1);
    demo.unseen.parse("0.2");
    EXPECT_FALSE(demo.drag(4, vec2(150, 0)));
    EXPECT_EQ(demo.unseen.text(), "0.2");
    // Behind the eye there is none either
    EXPECT_FALSE(Hands::placeOf(demo.frame, vec3(2, 4, 12)));
    EXPECT_FALSE(Hands::placeOf(demo.frame, vec3(1, 2, 6)));
}
