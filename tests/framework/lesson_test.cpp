#include "mv/demo/lesson.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mv/demo/seen.h"

using namespace mv;

namespace {

enum class Tea { none, green, black };
struct Fire {
    double heat = 1;
    int logs = 3;
};
struct TeaSettings {
    double water = 0.5;
    bool lid = true;
    Tea tea = Tea::green;
    int cups = 2;
    vec3 spout{1, 2, 3};
    double turn = 30;
    std::vector<vec2> leaves{{1, 2}, {3, 4}};
    vec2 handle{5, 6};
    std::array<vec2, 2> feet{vec2(7, 8), vec2(9, 10)};
    Fire fire = {};
};
struct Gpu {};

bool hasWater(const TeaSettings& s) { return s.water > 0; }
bool burns(const Fire& fire) { return fire.logs > 0; }

constexpr PointLimits few{{0, 0}, {10, 10}, 1, 3, 1};

std::vector<std::string> calls;
void check(const TeaSettings& s) {
    if (s.water == 2 && s.lid) throw Error("--water", "must leave room for the lid");
}

Lesson<TeaSettings, Gpu> kettle() {
    Lesson<TeaSettings, Gpu> lesson;
    lesson.rows = together(
        number("water", &TeaSettings::water, {0, 2}, "how much", "l"), toggle("lid", &TeaSettings::lid, "on it"),
        word("tea", &TeaSettings::tea, {{"none"}, {"green", "steamed"}, {"black"}}, "in it")
            .when(hasWater, "it is dry"),
        oneOf("cups", &TeaSettings::cups, {1, 2, 4}, "of it"),
        number("spout-y", y(&TeaSettings::spout), {0, 9}, "of the spout"), angle("turn", &TeaSettings::turn, "of it"),
        points("leaves", &TeaSettings::leaves, few, "where they are"),
        points("handle", &TeaSettings::handle, {{0, 0}, {10, 10}, 1, 1, 1}, "where it is"),
        points("feet", &TeaSettings::feet, {{0, 0}, {10, 10}, 2, 2, 1}, "where they are"),
        part(&TeaSettings::fire,
             {number("heat", &Fire::heat, {0, 3}, "of it").when(burns, "there is no wood"),
              whole("logs", &Fire::logs, {0, 9}, "of wood")},
             hasWater, "an empty kettle is not put on the fire"));
    lesson.presets = {{"half-full", "It sings."},
                      {"full", "It boils over.", {.water = 2, .lid = false, .tea = Tea::black, .fire = {.heat = 3}}}};
    lesson.controls = {keys(Key::down, Key::up, "water", 0.25), keySets(key('L'), "lid", "off"),
                       drag("turn", 2, "spout-y", -1), wheel("heat", 0.5)};
    lesson.handles = {
        {"spout", {"spout-y"}, [](const TeaSettings& s, const FrameInfo&) { return std::optional(vec2(s.spout)); }},
        {"leaf", {"leaves"}, {}, [](const TeaSettings&, const FrameInfo&, const vec2& at) {
             return std::optional(at);
         }}};
    lesson.readouts = {{"steam", "above it"}};
    lesson.draw = [](Gpu&, const TeaSettings&, const Frame&) { calls.emplace_back("draw"); };
    lesson.figure = [](Gpu&, const TeaSettings&, const Frame&) { calls.emplace_back("figure"); };
    lesson.readOut = [](Gpu&, const TeaSettings& s, const Frame&, Numbers& numbers) {
        calls.emplace_back("readOut");
        numbers.set("steam", s.fire.heat * s.water);
    };
    lesson.check = check;
    return lesson;
}

using Kettle = LessonDemo<TeaSettings, Gpu, NothingKept>;
std::shared_ptr<const Lesson<TeaSettings, Gpu>> shared() {
    return std::make_shared<const Lesson<TeaSettings, Gpu>>(kettle());
}

std::string refusalOf(const std::function<void()>& act) {
    try {
        act();
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST(Lessons, rows_are_knobs_of_the_settings) {
    Kettle demo(shared());
    std::string texts;
    for (const Knob* knob : demo.knobs()) texts += knob->name() + "=" + knob->text() + " ";
    EXPECT_EQ(
        texts,
        "water=0.5 lid=on tea=green cups=2 spout-y=2 turn=30 leaves=1,2/3,4 handle=5,6 feet=7,8/9,10 heat=1 logs=3 ");
    for (const auto& [name, text] : std::vector<std::pair<const char*, const char*>>{{"water", "1.5"},
                                                                                     {"lid", "off"},
                                                                                     {"tea", "black"},
                                                                                     {"cups", "4"},
                                                                                     {"spout-y", "7"},
                                                                                     {"turn", "-90"},
                                                                                     {"leaves", "0,1/2,3/4,5"},
                                                                                     {"handle", "1,2"},
                                                                                     {"feet", "3,4/5,6"},
                                                                                     {"heat", "2.5"},
                                                                                     {"logs", "7"}}) {
        demo.knob(name).parse(text);
    }
    const TeaSettings s = demo.settings();
    EXPECT_EQ(s.water, 1.5);
    EXPECT_FALSE(s.lid);
    EXPECT_EQ(s.tea, Tea::black);
    EXPECT_EQ(s.cups, 4);
    EXPECT_EQ(s.spout, vec3(1, 7, 3)) << "only what a row names";
    EXPECT_EQ(s.turn, -90);
    EXPECT_EQ(s.leaves, (std::vector<vec2>{{0, 1}, {2, 3}, {4, 5}}));
    EXPECT_EQ(s.handle, vec2(1, 2));
    EXPECT_EQ(s.feet, (std::array<vec2, 2>{vec2(3, 4), vec2(5, 6)}));
    EXPECT_EQ(s.fire.heat, 2.5);
    EXPECT_EQ(s.fire.logs, 7);
    EXPECT_EQ(settingsOf<TeaSettings>(demo).fire.logs, 7);
    EXPECT_THROW((void)settingsOf<Fire>(demo), Error) << "another lesson's settings";
    EXPECT_EQ(refusalOf([&] { demo.knob("water").parse("3"); }), "--water: must be 0 .. 2 l, '3'");
}

TEST(Lessons, conditions_are_asked_of_the_settings_and_of_the_part) {
    Kettle demo(shared());
    EXPECT_EQ(demo.knob("tea").idleReason(), "");
    EXPECT_EQ(demo.knob("heat").idleReason(), "");
    demo.knob("logs").parse("0");
    EXPECT_EQ(demo.knob("heat").idleReason(), "there is no wood");
    EXPECT_EQ(demo.knob("logs").idleReason(), "");
    demo.knob("water").parse("0");
    EXPECT_EQ(demo.knob("tea").idleReason(), "it is dry");
    EXPECT_EQ(demo.knob("logs").idleReason(), "an empty kettle is not put on the fire");
    EXPECT_EQ(demo.knob("heat").idleReason(), "an empty kettle is not put on the fire")
        << "the first reason, though there is no wood either";
}

TEST(Lessons, presets_are_what_differs_from_the_first) {
    const auto lesson = shared();
    const Kettle initial(lesson), full(lesson, lesson->presets.back().settings);
    std::string text;
    for (const auto& [name, value] : changedKnobs(initial, full)) text += name + "=" + value + " ";
    EXPECT_EQ(text, "water=2 lid=off tea=black heat=3 ");
    TeaSettings wrong;
    wrong.water = 5;
    EXPECT_EQ(refusalOf([&] { Kettle(lesson, wrong); }), "--water: must be 0 .. 2 l, '5'");
    EXPECT_EQ(with(wrong, [](TeaSettings& s) { s.water = 1; }).water, 1);
}

TEST(Lessons, controls_and_handles_move_the_settings) {
    Kettle demo(shared());
    EXPECT_TRUE(demo.press(Key::up));
    EXPECT_EQ(demo.settings().water, 0.75);
    EXPECT_TRUE(demo.press(key('L')));
    EXPECT_FALSE(demo.settings().lid);
    EXPECT_TRUE(demo.drag(5, 1));
    EXPECT_EQ(demo.settings().turn, 40);
    EXPECT_EQ(demo.settings().spout.y, 1);
    EXPECT_TRUE(demo.wheel(1));
    EXPECT_EQ(demo.settings().fire.heat, 1.5);
    ASSERT_EQ(demo.handles().size(), 2U);
    const FrameInfo frame(1, 100, 100);
    EXPECT_TRUE(demo.handles()[0].drag(frame, 0, {1, 6}));
    EXPECT_EQ(demo.settings().spout.y, 6);
    EXPECT_TRUE(demo.handles()[1].drag(frame, 1, {8, 9}));
    EXPECT_EQ(demo.settings().leaves[1], vec2(8, 9));
    // A place in a figure is in its units
    const FrameInfo large(1, 200, 200, 2);
    EXPECT_EQ(*demo.handles()[0].where(large, 0), 2.0 * *demo.handles()[0].where(frame, 0));
    auto misspelt = kettle();
    misspelt.controls = {wheel("heats", 1)};
    EXPECT_EQ(refusalOf([&] { Kettle(std::make_shared<const Lesson<TeaSettings, Gpu>>(misspelt)); }),
              "--heats: is no knob of this demo; did you mean 'heat'?");
    misspelt = kettle();
    misspelt.handles.front().knobs = {"lid"};
    EXPECT_EQ(refusalOf([&] { Kettle(std::make_shared<const Lesson<TeaSettings, Gpu>>(misspelt)); }),
              "handle: must name rows that are numbers, lid");
}

TEST(Lessons, functions_are_called_where_a_demo_would_be) {
    Kettle demo(shared());
    demo.init();
    calls.clear();
    FrameNotes notes;
    demo.draw(Frame({1, 10, 10}, notes, {}));
    EXPECT_EQ(calls, std::vector<std::string>{"draw"}) << "numbers are told where somebody reads them";
    demo.draw(Frame({1, 10, 10}, notes, {.readouts = true}));
    demo.annotate(Frame({1, 10, 10}, notes, {}));
    EXPECT_EQ(calls, (std::vector<std::string>{"draw", "draw", "readOut", "figure"}));
    EXPECT_EQ(demo.readouts().front()->value(), 0.5);
    Numbers numbers(demo);
    EXPECT_EQ(refusalOf([&] { numbers.set("fog", 1); }), "readout fog: must be one of the lesson's");
    EXPECT_EQ(refusalOf([&] { demo.check(); }), "accepted");
    demo.knob("water").parse("2");
    EXPECT_EQ(refusalOf([&] { demo.check(); }), "--water: must leave room for the lid");
    EXPECT_THROW((void)demo.scene(FrameInfo(1, 1, 1)), Error);
    EXPECT_THROW((void)demo.values(), Error);
}

TEST(Lessons, draws_what_a_study_measures_in_the_pictures_place) {
    Lesson<TeaSettings, Gpu> lesson = kettle();
    FrameNotes notes;
    const auto drawnFor = [&](bool measuring) {
        Kettle demo(std::make_shared<const Lesson<TeaSettings, Gpu>>(lesson));
        demo.init();
        calls.clear();
        demo.draw(Frame(FrameInfo(1, 8, 8), notes, {.measuring = measuring}));
        return calls;
    };
    EXPECT_EQ(drawnFor(true), std::vector<std::string>{"draw"});
    lesson.measure = [](Gpu&, const TeaSettings&, const Frame&) { calls.emplace_back("measure"); };
    EXPECT_EQ(drawnFor(true), std::vector<std::string>{"measure"});
    EXPECT_EQ(drawnFor(false), std::vector<std::string>{"draw"});
}

// Knobs and check() keep what was asked for; what draws gets what the context can.
TEST(Lessons, fallback_changes_what_is_drawn_and_no_knob) {
    static double drawn, told;
    Lesson<TeaSettings, Gpu> lesson = kettle();
    lesson.fallback = [](TeaSettings s) {
        s.water = 0.25;
        return s;
    };
    lesson.draw = [](Gpu&, const TeaSettings& s, const Frame&) { drawn = s.water; };
    lesson.figure = {};
    lesson.readOut = [](Gpu&, const TeaSettings& s, const Frame&, Numbers&) { told = s.water; };
    LessonDemo<TeaSettings, Gpu, NothingKept> demo(std::make_shared<const Lesson<TeaSettings, Gpu>>(lesson));
    FrameNotes notes;
    demo.init();
    demo.draw(Frame({1, 4, 4}, notes, {.readouts = true}));
    EXPECT_EQ(drawn, 0.25);
    EXPECT_EQ(told, 0.25);
    EXPECT_EQ(demo.number("water"), 0.5);
    EXPECT_EQ(demo.settings().water, 0.5);
}

// The memory of a lesson is copied, and comes back: the framework steps to any frame.
TEST(Lessons, memory_is_the_frameworks_to_keep) {
    struct Sum {
        int of = 0;
    };
    Lesson<TeaSettings, Gpu, Sum> lesson;
    lesson.rows = together(oneOf("cups", &TeaSettings::cups, {1, 2, 4}, "of it").beginsAnew());
    lesson.start = [](const TeaSettings& s) { return Sum{100 * s.cups}; };
    lesson.step = [](Sum& sum, const TeaSettings&, int index) { sum.of += index; };
    static int drawn = 0;
    lesson.draw = [](Gpu&, const TeaSettings&, const Sum& sum, const Frame&) { drawn = sum.of; };
    LessonDemo<TeaSettings, Gpu, Sum> demo(std::make_shared<const Lesson<TeaSettings, Gpu, Sum>>(lesson));
    ASSERT_NE(demo.memory(), nullptr);
    EXPECT_TRUE(demo.knob("cups").doesBeginAnew());
    demo.init();
    demo.reset();
    demo.step(1);
    const auto kept = demo.memory()->copy();
    demo.step(2);
    FrameNotes notes;
    demo.draw(Frame({2, 10, 10}, notes, {}));
    EXPECT_EQ(drawn, 203);
    demo.memory()->restore(kept);
    demo.draw(Frame({1, 10, 10}, notes, {}));
    EXPECT_EQ(drawn, 201);
    EXPECT_EQ(Kettle(shared()).memory(), nullptr);
}

TEST(Lessons, passes_make_what_is_drawn) {
    struct Made {
        int passes = 0;
    };
    Lesson<TeaSettings, Gpu, Made> lesson;
    lesson.rows = together(oneOf("cups", &TeaSettings::cups, {1, 2, 4}, "of it"));
    lesson.passes = [](const TeaSettings& s, const FrameInfo&) { return s.cups; };
    lesson.refine = [](Made& made, const TeaSettings&, const FrameInfo&, int pass) { made.passes = pass + 1; };
    static int drawn = 0;
    lesson.draw = [](Gpu&, const TeaSettings&, const Made& made, const Frame&) { drawn = made.passes; };
    LessonDemo<TeaSettings, Gpu, Made> demo(std::make_shared<const Lesson<TeaSettings, Gpu, Made>>(lesson));
    EXPECT_EQ(demo.memory(), nullptr) << "what passes made is no memory";
    demo.init();
    const FrameInfo frame(1, 10, 10);
    ASSERT_EQ(demo.passes(frame), 2);
    for (int pass = 0; pass < demo.passes(frame); ++pass) demo.refine(frame, pass);
    FrameNotes notes;
    demo.draw(Frame(frame, notes, {}));
    EXPECT_EQ(drawn, 2);
}
