#include "mv/demo/preset.h"

#include <gtest/gtest.h>

#include <memory>

#include "mv/paper/report.h"
#include "mv/run/command_line.h"
#include "support/demo_of.h"

using namespace mv;
using namespace mv::test;

namespace {

struct KettleValues {
    double water = 0.5;
    bool lid = true;
    double heat = 1;
};
bool hasWater(const KettleValues& s) { return s.water > 0; }
bool hasLid(const KettleValues& s) { return s.lid; }

struct Kettle : DemoOf<KettleValues> {
    Kettle()
        : DemoOf(together(mv::number("water", &KettleValues::water, {0, 2}, "how much", "l"),
                          toggle("lid", &KettleValues::lid, "on it"),
                          mv::number("heat", &KettleValues::heat, {0, 3}, "of the fire")
                              .when(hasWater, "an empty kettle is not put on the fire")
                              .when(hasLid, "it is not heated without its lid"))) {}
    Knob &water = knob("water"), &lid = knob("lid"), &heat = knob("heat");
};

DemoInfo kettle(const std::vector<Preset>& presets) {
    DemoInfo info;
    info.name = "kettle";
    info.presets = presets;
    info.make = [] { return std::make_unique<Kettle>(); };
    return info;
}

const Preset half{"half-full", "It sings."};
const Preset empty{"empty", "It is silent.", {{"water", "0"}, {"lid", "off"}}};
const std::vector<Preset> both{half, empty};
constexpr Declaration declaration{.name = "kettle"};

std::string refusalOf(const std::function<void()>& act) {
    try {
        act();
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST(Presets, set_every_knob) {
    Kettle demo;
    demo.heat.parse("3");
    EXPECT_FALSE(isAtPreset(demo, half));
    EXPECT_FALSE(isAtPreset(demo, empty));
    applyPreset(demo, empty);
    EXPECT_TRUE(isAtPreset(demo, empty));
    EXPECT_EQ(demo.water.text() + demo.lid.text() + demo.heat.text(), "0off1");
    applyPreset(demo, half);
    EXPECT_TRUE(isAtPreset(demo, half));
    EXPECT_FALSE(isAtPreset(demo, empty));
    EXPECT_EQ(demo.water.text() + demo.lid.text() + demo.heat.text(), "0.5on1");
    EXPECT_EQ(settingsText(empty), "--water 0 --lid off");
    EXPECT_EQ(settingsText(half), "");
}

TEST(Presets, are_refused_where_they_are_no_presets) {
    const auto refusal = [](const std::vector<Preset>& presets) {
        return refusalOf([&] { checkPresets(kettle(presets)); });
    };
    EXPECT_EQ(refusal({}), "accepted");
    EXPECT_EQ(refusal({half, empty}), "accepted");
    EXPECT_EQ(refusal({empty, half}),
              "preset 'empty' of kettle: must have no settings: the first preset is the knobs' initial values, "
              "--water 0 --lid off");
    EXPECT_EQ(refusal({half, empty, empty}), "preset 'empty' of kettle: must be declared once");
    EXPECT_EQ(refusal({half, {"full", ""}}), "preset 'full' of kettle: must say what to look for");
    for (const Literal name :
         std::initializer_list<Literal>{"", "Full", "half full", "-full", "full-", "half--full", "full_up"}) {
        EXPECT_EQ(
            refusal({half, {name, "It boils over."}}),
            "preset '" + std::string(name) + "' of kettle: must have a name of small letters, digits and single -");
    }
    // A demo is added with its presets checked.
    EXPECT_EQ(
        refusalOf([] { addDemo(declaration, {empty}, "", [] { return std::make_unique<Kettle>(); }); }).substr(0, 24),
        "preset 'empty' of kettle");
    // A preset sets a knob, to a value that the knob has.
    Kettle demo;
    EXPECT_EQ(refusalOf([&] {
                  applyPreset(demo, {"x", "x", {{"watr", "1"}}});
              }),
              "--watr: is no knob of this demo; did you mean 'water'?");
    EXPECT_EQ(refusalOf([&] { applyPreset(demo, {"x", "x", {{"water", "3"}}}); }), "--water: must be 0 .. 2 l, '3'");
}

TEST(Presets, are_found_by_name) {
    const DemoInfo info = kettle(both);
    EXPECT_EQ(findPreset(info, "empty").lookFor, "It is silent.");
    EXPECT_EQ(refusalOf([&] { findPreset(info, "emty"); }),
              "--preset: must be half-full | empty, 'emty'; did you mean 'empty'?");
    EXPECT_EQ(refusalOf([&] { findPreset(info, "original"); }), "--preset: must be half-full | empty, 'original'");
    EXPECT_EQ(refusalOf([] { findPreset(kettle({}), "empty"); }), "--preset: is of no use here: kettle has none");
}

TEST(Presets, are_listed_with_the_knobs) {
    const DemoInfo info = kettle(both);
    const Kettle demo;
    const std::string text = presetsText(info), json = knobsJson(info, demo);
    EXPECT_NE(text.find("--preset half-full  the initial values   (It sings.)"), std::string::npos) << text;
    EXPECT_NE(text.find("--preset empty      --water 0 --lid off  (It is silent.)"), std::string::npos) << text;
    for (const char* part : {"\"knobs\": [", "\"presets\": [", "\"name\": \"empty\"", "\"lookFor\": \"It is silent.\"",
                             "\"lid\": \"off\""}) {
        EXPECT_NE(json.find(part), std::string::npos) << part << "\n" << json;
    }
}

// Other flags move from a preset, wherever they stand.
TEST(Presets, come_before_the_other_flags) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"cube-cull", "--preset", "eye-inside", "--z-dist", "2", "--shot", "a.png"},
          {"cube-cull", "--z-dist", "2", "--shot", "a.png", "--preset=eye-inside"}}) {
        const Command command = parseCommandLine(words);
        EXPECT_EQ(command.preset, "eye-inside");
        const auto demo = command.demo->make();
        applyKnobs(*demo, command.knobs);
        EXPECT_EQ(demo->knob("z-dist").text(), "2");
        EXPECT_EQ(demo->knob("spin-x").text(), "0") << "as the preset says, and not as the demo opens";
    }
    EXPECT_EQ(refusalOf([] {
                  parseCommandLine({"cube-cull", "--preset", "orginal"});
              }).substr(0, 20),
              "--preset: must be tu");
    EXPECT_THROW(parseCommandLine({"cube-cull", "--preset", "orginal"}), UsageError);
    EXPECT_THROW(parseCommandLine({"--preset", "original"}), UsageError) << "of no demo";
    EXPECT_NE(parseCommandLine({"cube-cull", "--help"}).text.find("eye-inside: From inside no face"),
              std::string::npos);
}

// The first picture of a page of the course is one word away.
TEST(Presets, originals_are_kept) {
    for (const char* demo : {"viewpoints", "cube-ortho", "cube-persp", "stereocube", "cube-cull", "shadow",
                             "shadow-floor", "cube-shadows", "shadow-map"}) {
        EXPECT_NO_THROW((void)findPreset(findDemo(demo), "original")) << demo;
    }
}

// Why a knob does nothing, in the order in which the reasons were given.
TEST(IdleKnobs, say_why) {
    Kettle demo;
    EXPECT_EQ(demo.water.idleReason(), "");
    EXPECT_EQ(demo.heat.idleReason(), "");
    demo.lid.parse("off");
    EXPECT_EQ(demo.heat.idleReason(), "it is not heated without its lid");
    demo.water.parse("0");
    EXPECT_EQ(demo.heat.idleReason(), "an empty kettle is not put on the fire");
    const std::string text = knobsText(demo), json = knobsJson(kettle({}), demo);
    EXPECT_NE(text.find("(of the fire) idle: an empty kettle is not put on the fire"), std::string::npos) << text;
    EXPECT_NE(json.find("\"idle\": \"an empty kettle is not put on the fire\""), std::string::npos) << json;
    EXPECT_NE(json.find("\"idle\": \"\""), std::string::npos) << json;
}
