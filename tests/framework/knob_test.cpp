#include "mv/demo/knob.h"

#include <gtest/gtest.h>

#include "support/demo_of.h"

using namespace mv;
using namespace mv::test;

namespace {

enum class Fruit { apple, pear, plum };

struct Values {
    double real = 0.5, angle = 350;
    int whole = 7;
    bool toggle = false;
    Fruit fruit = Fruit::pear;
    double factor = 0.1, small = 0;
    int texels = 512;
};

struct Settings : DemoOf<Values> {
    Settings()
        : DemoOf(together(
              mv::number("real", &Values::real, {-2, 3}, "a number", "m"), angle("angle", &Values::angle, "an angle"),
              mv::whole("whole", &Values::whole, {1, 40}, "a count"), mv::toggle("toggle", &Values::toggle, "a switch"),
              mv::word("fruit", &Values::fruit, {{"apple", "red"}, {"pear"}, {"plum"}}, "a fruit"),
              mv::number("factor", &Values::factor, {0.01, 100, Scale::logarithmic}, "a number by its factors", "m"),
              mv::number("small", &Values::small, {1e-6, 0.1, Scale::logarithmic, true}, "the same, or nothing"),
              oneOf("texels", &Values::texels, {1, 512, 1024, 100'000}, "a number of a few"))) {}
    Knob &real = knob("real"), &turn = knob("angle"), &whole = knob("whole"), &toggle = knob("toggle"),
         &fruit = knob("fruit"), &factor = knob("factor"), &small = knob("small"), &texels = knob("texels");
    Readout result{this, "number", "a result", "px"};
};

// A demo of one row over a double, which is 0.5, or over an int, which is 2.
struct One {
    double number = 0.5;
    int few = 2;
};

std::string errorOf(Knob& knob, const std::string& text) {
    const std::string before = knob.text();
    try {
        knob.parse(text);
    } catch (const Error& error) {
        EXPECT_EQ(knob.text(), before) << "a refused value must not be taken";
        return error.what();
    }
    return "accepted";
}

}  // namespace

// A knob reads back what it prints as the same value: that is what makes a printed command line reproduce a picture.
TEST(Knobs, print_and_parse_are_inverse) {
    Settings settings;
    for (const double value : {0.1, 1.0 / 3, -2.0, 3.0, 1e-17, 2.718281828459045}) {
        settings.real.parse(numberText(value));
        EXPECT_EQ(settings.s.real, value);
        const std::string text = settings.real.text();
        settings.real.parse(text);
        EXPECT_EQ(settings.s.real, value);
    }
    for (Knob* knob : settings.knobs()) {
        for (const std::string& text : knob->sweep()) {
            knob->parse(text);
            EXPECT_EQ(knob->text(), text);
        }
        knob->reset();
        EXPECT_TRUE(knob->isInitial());
    }
}

TEST(Knobs, refuse_with_their_range) {
    Settings settings;
    EXPECT_EQ(errorOf(settings.real, "+-1"), "--real: must be -2 .. 3 m, '+-1'");
    EXPECT_EQ(errorOf(settings.whole, "+-3"), "--whole: must be a whole number in 1 .. 40, '+-3'");
    EXPECT_EQ(errorOf(settings.real, "3.5"), "--real: must be -2 .. 3 m, '3.5'");
    EXPECT_EQ(errorOf(settings.whole, "0"), "--whole: must be a whole number in 1 .. 40, '0'");
    EXPECT_EQ(errorOf(settings.toggle, "yes"), "--toggle: must be on | off, 'yes'");
    EXPECT_EQ(errorOf(settings.fruit, "aple"), "--fruit: must be apple | pear | plum, 'aple'");
    for (const char* text : {"", "nan", "inf", "-inf", "0x1", "1e400", "1,5", " 1", "1 ", "--1", "1.", "1e"}) {
        if (std::string(text) == "1.") continue;  // a number to from_chars, as to every reader of numbers
        EXPECT_NE(errorOf(settings.real, text), "accepted") << "'" << text << "'";
    }
    for (const char* text : {"1.5", "", "7x", "99999999999", "1e-1", "nan"})
        EXPECT_NE(errorOf(settings.whole, text), "accepted") << text;
    settings.whole.parse("2e1");
    EXPECT_EQ(settings.whole.text(), "20");
}

TEST(Knobs, an_initial_value_outside_the_range_is_a_mistake_of_the_demo) {
    EXPECT_THROW((void)DemoOf<One>({mv::number("wrong", &One::number, {0, 0.1}, "outside")}), Error);
    const auto row = [] { return mv::number("twice", &One::number, {0, 1}, "the same name"); };
    EXPECT_NO_THROW((void)DemoOf<One>({row()}));
    EXPECT_THROW((void)DemoOf<One>({row(), row()}), Error);
}

TEST(Knobs, steps_stop_at_the_ends_and_angles_go_round) {
    Settings settings;
    settings.real.parse("-2");
    for (int i = 0; i < 20; ++i) settings.real.step(0.1);
    EXPECT_EQ(settings.real.text(), "0") << "twenty steps of 0.1, on a grid of 1e-9";
    EXPECT_TRUE(settings.real.step(100));
    EXPECT_EQ(settings.s.real, 3);
    EXPECT_FALSE(settings.real.step(1)) << "nothing moves at the end";
    EXPECT_TRUE(settings.turn.step(20));
    EXPECT_EQ(settings.s.angle, 10);
    EXPECT_TRUE(settings.turn.step(-30));
    EXPECT_EQ(settings.s.angle, -20) << "the sign is kept, as % does in JavaScript";
    settings.fruit.step(1);
    settings.fruit.step(1);
    EXPECT_EQ(settings.fruit.text(), "apple") << "choices go round";
    settings.fruit.step(-1);
    EXPECT_EQ(settings.fruit.text(), "plum");
}

// A number of a few is the number, in the code and however it is typed.
TEST(Knobs, a_number_choice_gives_its_number) {
    Settings settings;
    EXPECT_EQ(settings.s.texels, 512);
    for (const char* text : {"1024", "+1024", "1024.0", "1.024e3"}) {
        settings.texels.reset();
        settings.texels.parse(text);
        EXPECT_EQ(settings.s.texels, 1024) << text;
        EXPECT_EQ(settings.texels.text(), "1024") << text;
    }
    settings.texels.parse("100000");
    EXPECT_EQ(settings.texels.text(), "1e5");
    EXPECT_EQ(settings.texels.range(), "1 | 512 | 1024 | 1e5");
    for (const char* text : {"0", "513", "512.5", "-1", "", "nan", "3"}) {
        EXPECT_EQ(errorOf(settings.texels, text),
                  "--texels: must be 1 | 512 | 1024 | 1e5, '" + std::string(text) + "'");
    }
    settings.texels.step(1);
    EXPECT_EQ(settings.s.texels, 1) << "choices go round";
    EXPECT_THROW((void)DemoOf<One>({oneOf("wrong", &One::few, {1, 4}, "none of its numbers")}), Error);
}

// A logarithmic knob goes by equal factors; zero is an end of its own.
TEST(Knobs, logarithmic_ones_go_by_factors) {
    Settings settings;
    EXPECT_EQ(settings.factor.rangeInFull(), "0.01 .. 100 m, logarithmic");
    EXPECT_EQ(settings.small.rangeInFull(), "0 or 1e-06 .. 0.1, logarithmic");
    EXPECT_EQ(settings.factor.stepText(0.1, "m"), "\u00D7 1.26") << "a factor has no unit";
    EXPECT_EQ(settings.real.stepText(0.5, "m"), "+0.5 m");
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(settings.factor.step(0.1));
    EXPECT_NEAR(settings.s.factor, 10, 10 * 20 * 5e-4) << "each step is rounded to four digits";
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(settings.factor.step(-0.1));
    EXPECT_NEAR(settings.s.factor, 0.1, 0.1 * 40 * 5e-4);
    EXPECT_TRUE(settings.factor.step(9));
    EXPECT_EQ(settings.s.factor, 100);
    EXPECT_FALSE(settings.factor.step(0.1)) << "nothing moves at the end";
    EXPECT_TRUE(settings.factor.step(-9));
    EXPECT_EQ(settings.s.factor, 0.01) << "without 0 the low end is the end";
    EXPECT_FALSE(settings.factor.step(-0.1));

    EXPECT_FALSE(settings.small.step(-1));
    EXPECT_TRUE(settings.small.step(0.5));
    EXPECT_EQ(settings.s.small, 1e-6) << "no factor leads away from 0: the first step is to the low end";
    EXPECT_TRUE(settings.small.step(1));
    EXPECT_EQ(settings.s.small, 1e-5);
    EXPECT_TRUE(settings.small.step(-2));
    EXPECT_EQ(settings.s.small, 1e-6) << "the low end is not jumped over";
    EXPECT_TRUE(settings.small.step(-0.1));
    EXPECT_EQ(settings.small.text(), "0");
    EXPECT_EQ(errorOf(settings.small, "1e-7"), "--small: must be 0 or 1e-06 .. 0.1, '1e-7'");
    EXPECT_EQ(errorOf(settings.small, "-1"), "--small: must be 0 or 1e-06 .. 0.1, '-1'");
    EXPECT_EQ(errorOf(settings.small, "0"), "accepted");
    EXPECT_EQ(errorOf(settings.factor, "0"), "--factor: must be 0.01 .. 100 m, '0'");
    EXPECT_EQ(settings.factor.sweep(), (std::vector<std::string>{"0.01", "1", "0.1", "100"}));
    EXPECT_EQ(settings.small.sweep(), (std::vector<std::string>{"0", "1e-06", "0.000316", "0", "0.1"}));
}

TEST(Knobs, a_logarithmic_range_is_above_0) {
    const auto make = [](NumberRange range) { (void)DemoOf<One>({mv::number("wrong", &One::number, range, "")}); };
    EXPECT_NO_THROW(make({0.1, 1, Scale::logarithmic}));
    for (const double low : {0.0, -1.0}) {
        try {
            make({low, 1, Scale::logarithmic});
            ADD_FAILURE() << "accepted from " << low;
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()),
                      "knob wrong: must have a logarithmic range above 0, " + numberText(low) + " .. 1");
        }
    }
    EXPECT_THROW(make({0.1, 1, Scale::linear, true}), Error) << "0 beside a linear range is no end of its own";
}

TEST(Knobs, two_demos_share_nothing) {
    Settings a, b;
    a.real.parse("1");
    EXPECT_EQ(b.s.real, 0.5);
    EXPECT_EQ(a.knobs().size(), 8U);
    EXPECT_NE(a.knobs().front(), b.knobs().front());
}

TEST(Readouts, are_finite_or_absent) {
    Settings settings;
    EXPECT_FALSE(settings.result.value());
    settings.result = 3;
    EXPECT_EQ(settings.result.value(), 3);
    EXPECT_THROW(settings.result = 0.0 / 0.0, Error);
    EXPECT_THROW(settings.result = 1e308 * 10, Error);
    settings.result.clear();
    EXPECT_FALSE(settings.result.value());
}
