#include "mv/run/command_line.h"

#include <gtest/gtest.h>

#include "support/hostile_lines.h"

using namespace mv;
using namespace mv::test;

namespace {

std::string refusal(const std::vector<std::string>& arguments) {
    try {
        parseCommandLine(arguments);
        return "accepted";
    } catch (const UsageError& error) {
        return error.what();
    }
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST(CommandLine, reads_what_is_meant) {
    const Command window = parseCommandLine({"cube-cull"});
    EXPECT_EQ(window.action, Action::window);
    EXPECT_EQ(window.demo->name, "cube-cull");
    EXPECT_EQ(parseCommandLine({}).demo, nullptr) << "the launcher's menu";

    const Command shot = parseCommandLine({"cube-cull", "--shot", "a.png", "--spin-x", "-30", "--cull=front", "--frame",
                                           "7", "--size", "64x32", "--headless=egl"});
    EXPECT_EQ(shot.action, Action::render);
    EXPECT_EQ(shot.shot, "a.png");
    EXPECT_EQ(shot.firstFrame, 7);
    EXPECT_EQ(shot.lastFrame, 7);
    EXPECT_EQ(shot.width, 64);
    EXPECT_EQ(shot.height, 32);
    EXPECT_EQ(shot.host, HostKind::egl);
    ASSERT_EQ(shot.knobs.size(), 2U);

    const Command frames = parseCommandLine({"cube-cull", "--shot", "a.%04d.png", "--frames", "2..5", "--report=json"});
    EXPECT_EQ(frames.firstFrame, 2);
    EXPECT_EQ(frames.lastFrame, 5);
    EXPECT_EQ(frames.report, ReportForm::json);
    EXPECT_EQ(parseCommandLine({"cube-cull", "--headless"}).action, Action::render);
    EXPECT_EQ(parseCommandLine({"cube-cull", "--headless"}).report, ReportForm::text)
        << "a headless run says something";
    EXPECT_EQ(parseCommandLine({"cube-cull", "--knobs=json"}).action, Action::knobs);
    EXPECT_TRUE(parseCommandLine({"cube-cull", "--knobs=json"}).json);
    EXPECT_EQ(parseCommandLine({"cube-cull", "--copyable"}).action, Action::copyable);
    EXPECT_EQ(parseCommandLine({"--list"}).action, Action::list);
    EXPECT_EQ(parseCommandLine({"--version"}).action, Action::version);
    const Command compare = parseCommandLine({"cube-cull", "--compare", "cull=back,front", "--shot", "a.png"});
    EXPECT_EQ(compare.compareKnob, "cull");
    EXPECT_EQ(compare.compareValues, (std::vector<std::string>{"back", "front"}));
    EXPECT_EQ(compare.action, Action::render);
    const Command both = parseCommandLine({"cube-cull", "--compare", "cull=back,front"});
    EXPECT_EQ(both.action, Action::window);
    EXPECT_EQ(both.compareKnob, "cull");

    // A report is printed, and the program ends, whether there is a display or not; a window is asked for by name.
    EXPECT_EQ(parseCommandLine({"cube-cull", "--report"}).action, Action::render);
    EXPECT_EQ(parseCommandLine({"cube-cull", "--report=json"}).report, ReportForm::json);
    const Command live = parseCommandLine({"cube-cull", "--window", "--report=json"});
    EXPECT_EQ(live.action, Action::window);
    EXPECT_EQ(live.report, ReportForm::json);
    EXPECT_EQ(parseCommandLine({"cube-cull", "--window"}).report, ReportForm::none);
    EXPECT_EQ(parseCommandLine({"--window", "--report"}).demo, nullptr) << "the launcher's menu, with a report";
}

TEST(CommandLine, refuses_with_the_rule_and_the_nearest_name) {
    EXPECT_TRUE(has(refusal({"cube-cul"}), "did you mean 'cube-cull'?"));
    EXPECT_TRUE(has(refusal({"cube-cull", "--spin-z", "3"}), "did you mean '--spin-x'?"));
    EXPECT_TRUE(has(refusal({"cube-cull", "--cul=back"}), "did you mean '--cull'?"));
    EXPECT_TRUE(has(refusal({"cube-cull", "--cull", "bak"}), "--cull: must be none | back | front | both, 'bak'"));
    EXPECT_TRUE(has(refusal({"cube-cull", "--z-dist", "11"}), "--z-dist: must be -10 .. 10, '11'"));
    EXPECT_TRUE(has(refusal({"cube-cull", "--z-dist", "nan"}), "--z-dist: must be -10 .. 10"));
    EXPECT_TRUE(has(refusal({"cube-cull", "--z-dist", "0x1"}), "--z-dist: must be"));
    EXPECT_NE(refusal({"cube-cull", "--z-dist"}), "accepted") << "a knob without its value";
    EXPECT_NE(refusal({"cube-cull", "stray"}), "accepted");
    EXPECT_NE(refusal({"cube-cull", "-5"}), "accepted");
    for (const char* size : {"64", "64x", "x64", "0x5", "-1x5", "20000x5", "64x32x1", "6 x5"}) {
        EXPECT_TRUE(has(refusal({"cube-cull", "--size", size}), "--size: must be WIDTHxHEIGHT")) << size;
    }
    for (const char* frame : {"-1", "1.5", "x", "99999999999", "2147483647"}) {
        EXPECT_TRUE(has(refusal({"cube-cull", "--frame", frame}), "--frame: must be a whole number 0 .. 1000000000"))
            << frame;
    }
    for (const char* frames : {"1", "1..", "..2", "5..2", "1...3", "a..b"}) {
        EXPECT_TRUE(has(refusal({"cube-cull", "--frames", frames, "--shot", "%d.png"}), "--frames: must")) << frames;
    }
    EXPECT_TRUE(has(refusal({"cube-cull", "--frames", "1..3"}), "needs --shot"));
    EXPECT_TRUE(has(refusal({"cube-cull", "--frames", "1..3", "--shot", "a.png"}), "must have %d"));
    EXPECT_TRUE(has(refusal({"cube-cull", "--frames", "1..3", "--frame", "2"}), "must not stand beside"));
    for (const char* compare : {"cull", "cull=", "cull=back", "=back,front", "cull=a,b,c", "cull=back,fornt",
                                "z-dist=99,1", "depht=on,off"}) {
        EXPECT_NE(refusal({"cube-cull", "--shot", "a.png", "--compare", compare}), "accepted") << compare;
    }
    EXPECT_TRUE(has(refusal({"cube-cull", "--compare", "cull=back,front", "--headless"}), "needs --shot"));
    EXPECT_TRUE(has(refusal({"cube-cull", "--headless=glx"}), "must be osmesa | egl | egl-device"));
    EXPECT_TRUE(has(refusal({"cube-cull", "--report=xml"}), "must be json"));
    EXPECT_TRUE(has(refusal({"cube-cull", "--compare", "cull=back,front", "--report"}), "needs --shot"));
    for (const std::vector<std::string>& windowless : {std::vector<std::string>{"--shot", "a.png"},
                                                       {"--headless"},
                                                       {"--study", "out"},
                                                       {"--audit"},
                                                       {"--knobs"},
                                                       {"--copyable"},
                                                       {"--list"},
                                                       {"--version"}}) {
        std::vector<std::string> line{"cube-cull", "--window"};
        line.insert(line.end(), windowless.begin(), windowless.end());
        EXPECT_TRUE(has(refusal(line), "--window: must not stand beside")) << windowless.front();
    }
    EXPECT_TRUE(has(refusal({"--report"}), "must be named first"));
    EXPECT_TRUE(has(refusal({"--shot", "a.png"}), "must be named first"));
    EXPECT_TRUE(has(refusal({"--gallery", "g", "--compare", "cull=back,front"}), "must be named first"));
}

TEST(CommandLine, help_has_every_knob_with_its_range) {
    for (const DemoInfo& info : catalogue()) {
        const std::string help = parseCommandLine({info.name, "--help"}).text;
        const auto demo = info.make();
        for (const Knob* knob : demo->knobs()) EXPECT_TRUE(has(help, "--" + knob->name())) << help;
        EXPECT_FALSE(has(help, "{")) << help;
    }
}

TEST(CommandLine, a_copyable_command_says_what_differs) {
    const DemoInfo& info = findDemo("cube-cull");
    const auto demo = info.make();
    EXPECT_EQ(copyableCommand(info, *demo, 1, 600, 600), "cube-cull");
    demo->knob("spin-x").parse("0.1");
    demo->knob("cull").parse("front");
    EXPECT_EQ(copyableCommand(info, *demo, 9, 300, 200), "cube-cull --cull front --spin-x 0.1 --size 300x200")
        << "no frame: nothing moves in this demo";
    // The present value is the first of the two, so it stands nowhere else.
    const std::string both = copyableCommand(info, *demo, 1, 600, 600, {"cull", "none"});
    EXPECT_EQ(both, "cube-cull --spin-x 0.1 --compare cull=front,none");
}

TEST(CommandLine, frame_files_are_numbered) {
    EXPECT_EQ(frameFile("a.%04d.png", 7), "a.0007.png");
    EXPECT_EQ(frameFile("a.%d.png", 12), "a.12.png");
    EXPECT_EQ(frameFile("a.png", 12), "a.png");
    EXPECT_EQ(frameFile("100%.png", 3), "100%.png");
    EXPECT_EQ(frameFile("%s%03d", 3), "%s003");
}

// Whatever is typed is understood or refused as not understood; nothing else is thrown and nothing is done.
TEST(CommandLine, ten_thousand_hostile_lines) {
    HostileLines lines(20);
    int understood = 0, refused = 0;
    for (int line = 0; line < 10000; ++line) {
        try {
            parseCommandLine(lines.next());
            ++understood;
        } catch (const UsageError& error) {
            ++refused;
            ASSERT_NE(std::string(error.what()).find(": "), std::string::npos) << error.what();
        }
    }
    // Both happen often: a generator of nothing but nonsense would try little.
    EXPECT_GT(understood, 2000);
    EXPECT_GT(refused, 2000);
}
