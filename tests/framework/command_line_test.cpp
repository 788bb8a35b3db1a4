#include "mv/run/command_line.h"
#include "mv/run/copyable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "mv/image/file.h"
#include "mv/image/png.h"
#include "support/demo_run.h"
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
    EXPECT_TRUE(has(refusal({"cube-cull", "--frames", "1..3", "--frame", "2", "--shot", "%d.png"}),
                    "--frame: must not stand beside --frames"));
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
        EXPECT_TRUE(has(refusal(line), "--window")) << windowless.front();
    }
    EXPECT_TRUE(has(refusal({"--report"}), "must be named first"));
    EXPECT_TRUE(has(refusal({"--shot", "a.png"}), "must be named first"));
    EXPECT_TRUE(has(refusal({"--gallery", "g", "--compare", "cull=back,front"}), "does nothing beside --gallery"));
}

// A flag that does nothing beside another is refused, and both are named. All pairs, in both orders, against this list of
// those that mean something together; every other pair is refused. `--help` is not among them: whoever asks for help
// gets it.
TEST(CommandLine, every_pair_of_flags_means_something_or_is_refused) {
    using Words = std::vector<std::string>;
    const std::map<std::string, Words> flags{{"--cull", {"--cull", "front"}},
                                             {"--preset", {"--preset", "original"}},
                                             {"--shot", {"--shot", "a%d.png"}},
                                             {"--frame", {"--frame", "3"}},
                                             {"--at", {"--at", "1", "z-dist=-3"}},
                                             {"--frames", {"--frames", "3..5"}},
                                             {"--size", {"--size", "64x48"}},
                                             {"--density", {"--density", "2"}},
                                             {"--multisample", {"--multisample", "4"}},
                                             {"--strip", {"--strip", "depth=on,off"}},
                                             {"--movie", {"--movie", "a.gif"}},
                                             {"--versus", {"--versus", "depth=on,off"}},
                                             {"--plot", {"--plot", "a.svg"}},
                                             {"--headless", {"--headless=egl"}},
                                             {"--compare", {"--compare", "depth=on,off"}},
                                             {"--report", {"--report=json"}},
                                             {"--window", {"--window"}},
                                             {"--study", {"--study", "out"}},
                                             {"--vary", {"--vary", "z-dist=1,2"}},
                                             {"--until", {"--until", "1"}},
                                             {"--audit", {"--audit"}},
                                             {"--all", {"--all"}},
                                             {"--knobs", {"--knobs"}},
                                             {"--copyable", {"--copyable"}},
                                             {"--list", {"--list"}},
                                             {"--version", {"--version"}},
                                             {"--gallery", {"--gallery", "g"}},
                                             {"--docs", {"--docs", "d"}}};
    // For each flag what it may stand beside; it is enough that one of two says so.
    const std::map<std::string, Words> together{
        {"--preset",
         {"--cull", "--shot", "--frame", "--size", "--headless", "--compare", "--report", "--window", "--study",
          "--audit", "--knobs", "--copyable"}},
        {"--cull",
         {"--shot", "--frame", "--size", "--headless", "--compare", "--report", "--window", "--study", "--audit",
          "--knobs", "--copyable"}},
        {"--shot", {"--frame", "--frames", "--size", "--headless", "--compare", "--report"}},
        {"--at",
         {"--preset", "--cull", "--shot", "--frame", "--size", "--headless", "--compare", "--report", "--window",
          "--copyable"}},
        {"--frame", {"--size", "--headless", "--compare", "--report", "--window", "--study", "--audit", "--copyable"}},
        {"--size", {"--headless", "--compare", "--report", "--window", "--study", "--copyable"}},
        {"--headless", {"--report", "--study", "--audit", "--versus"}},
        {"--density",
         {"--cull", "--preset", "--at", "--shot", "--frame", "--size", "--headless", "--compare", "--report",
          "--window", "--copyable", "--until"}},
        {"--multisample",
         {"--cull", "--preset", "--at", "--shot", "--frame", "--size", "--density", "--headless", "--compare",
          "--report", "--window", "--copyable"}},
        {"--strip", {"--shot", "--copyable"}},
        {"--movie", {"--frames", "--vary"}},
        {"--versus", {"--cull", "--preset", "--frame", "--size"}},
        {"--compare", {"--window", "--copyable"}},
        {"--report", {"--window"}},
        {"--until",
         {"--preset", "--cull", "--at", "--shot", "--frame", "--size", "--headless", "--report", "--window",
          "--copyable"}},
        {"--study", {"--vary"}},
        {"--audit", {"--all"}}};
    const auto may = [&](const std::string& a, const std::string& b) {
        const auto found = together.find(a);
        return found != together.end() && std::count(found->second.begin(), found->second.end(), b) > 0;
    };
    // Alone it does nothing; and what is of no demo.
    const std::set<std::string> idle{"--vary", "--frames", "--all", "--strip", "--movie"},
        ofNoDemo{"--gallery", "--docs", "--all"};
    // All flags of the program are here.
    const auto demo = findDemo("cube-cull").make();
    std::istringstream help(parseCommandLine({"--help"}).text + parseCommandLine({"cube-cull", "--help"}).text);
    for (std::string word; help >> word;) {
        if (!word.starts_with("--")) continue;
        const std::string flag = word.substr(0, word.find_first_not_of("-abcdefghijklmnopqrstuvwxyz"));
        bool known = flags.count(flag) > 0 || flag == "--help" || flag == "--" || flag == "--from";
        for (const Knob* knob : demo->knobs()) known = known || flag == "--" + knob->name();
        EXPECT_TRUE(known) << flag;
    }
    const auto line = [&](const Words& names) {
        Words words;
        bool named = true;
        for (const std::string& name : names) named = named && ofNoDemo.count(name) == 0;
        if (named) words.emplace_back("cube-cull");
        for (const std::string& name : names) words.insert(words.end(), flags.at(name).begin(), flags.at(name).end());
        return words;
    };
    int understood = 0, refused = 0;
    for (const auto& [a, wordsOfA] : flags) {
        const std::string alone = refusal(line({a}));
        EXPECT_EQ(alone == "accepted", idle.count(a) == 0) << a << ": " << alone;
        for (const auto& [b, wordsOfB] : flags) {
            if (a == b) {
                EXPECT_EQ(refusal(line({a, a})),
                          a == "--at"      ? "accepted"
                          : a == "--strip" ? "--strip: needs --shot or --copyable, and does nothing in a window"
                                           : a + ": must be given once");
                continue;
            }
            const std::string said = refusal(line({a, b}));
            if (may(a, b) || may(b, a)) {
                ++understood;
                EXPECT_EQ(said, "accepted") << a << " " << b;
                continue;
            }
            // Two of which neither says what to do are for a window, which a third must not be needed for.
            ++refused;
            EXPECT_NE(said, "accepted") << a << " " << b;
            const bool bothNamed = has(said, a) && has(said, b);
            const bool demoMissing = (ofNoDemo.count(a) > 0 || ofNoDemo.count(b) > 0);  // no knob without its demo
            const bool oneIdle = (idle.count(a) > 0 && has(said, a)) || (idle.count(b) > 0 && has(said, b));
            EXPECT_TRUE(bothNamed || demoMissing || oneIdle) << a << " " << b << ": " << said;
        }
    }
    EXPECT_EQ(understood + refused, 28 * 27);
    EXPECT_NE(refusal({"cube-cull", "--gallery", "g"}), "accepted") << "it would be of all demos";
    EXPECT_NE(refusal({"cube-cull", "--audit", "--all"}), "accepted");
}

TEST(CommandLine, what_a_lecture_asks) {
    const Command strip = parseCommandLine(
        {"cube-cull", "--strip", "cull=none,back,front", "--strip", "depth=on,off", "--shot", "a.png"});
    ASSERT_EQ(strip.strip.size(), 2U);
    EXPECT_EQ(strip.strip[0].values, (std::vector<std::string>{"none", "back", "front"}));
    EXPECT_EQ(strip.strip[1].knob, "depth");
    const auto refusedStrip = [](const std::string& text) {
        return refusal({"cube-cull", "--shot", "a.png", "--strip", text});
    };
    EXPECT_EQ(refusedStrip("cull"), "--strip: must be one knob and one value or more, as bias=0,0.01,0.1, 'cull'");
    EXPECT_TRUE(has(refusedStrip("cull=back,,front"), "one value or more"));
    EXPECT_TRUE(has(refusedStrip("cull=back,sideways"), "--cull: must be none"));
    EXPECT_TRUE(has(refusedStrip("culls=back"), "did you mean 'cull'?"));
    EXPECT_TRUE(has(refusal({"cube-cull", "--shot", "a.png", "--strip", "cull=none,back", "--strip", "cull=front"}),
                    "must be of two knobs"));

    EXPECT_EQ(parseCommandLine({"cube-cull", "--vary", "z-dist=-4..-2:9", "--movie", "a.webm"}).movie, "a.webm");
    EXPECT_EQ(refusal({"cube-cull", "--movie", "a.avi", "--frames", "1..9"}),
              "--movie: must be a file FILE.mp4, FILE.webm or FILE.gif, 'a.avi'");
    EXPECT_EQ(refusal({"cube-cull", "--movie", ".gif", "--frames", "1..9"}),
              "--movie: must be a file FILE.mp4, FILE.webm or FILE.gif, '.gif'");
    EXPECT_TRUE(has(refusal({"cube-cull", "--movie", "a.gif"}), "needs --frames A..B, or --vary"));

    const Command versus = parseCommandLine({"shadow-methods", "--versus", "method=map,volume"});
    EXPECT_EQ(versus.versusKnob, "method");
    EXPECT_EQ(versus.versusValues, (std::vector<std::string>{"map", "volume"}));
    EXPECT_TRUE(has(refusal({"shadow-methods", "--versus", "method=map"}), "one knob and two values"));

    const Command plot = parseCommandLine({"shadow-methods", "--plot", "still life=a.svg"});
    EXPECT_EQ(plot.plot, "a.svg");
    EXPECT_EQ(plot.plotScene, "still life");
    EXPECT_TRUE(has(refusal({"shadow-methods", "--plot", "a.jpg"}), "must be [SCENE=]FILE.svg or FILE.png"));
    EXPECT_EQ(parseCommandLine({"shadow-methods", "--plot", "still life=a.png"}).plot, "a.png");

    for (const char* odd : {"0", "0.5", "9", "nan", "2x", "-2"})
        EXPECT_EQ(refusal({"cube-cull", "--density", odd}),
                  "--density: must be a number 1 .. 8, as 2 for 192 dpi, '" + std::string(odd) + "'");
    EXPECT_EQ(parseCommandLine({"cube-cull", "--density", "1.5"}).density, 1.5);
}

// A picture's file tells the line that made it; flags that are given replace those of the line.
TEST(CommandLine, begins_with_a_pictures_line) {
    const ScratchFolder folder("from");
    const std::string file = (folder.path() / "a b.png").string();
    const auto tell = [&](const std::string& line) { writePng(file, Picture(1, 1), line); };
    tell("cube-cull --cull front --spin-x -30 --at 3 'spin-y=5' --frame 7 --size 64x48");
    const Command same = parseCommandLine({"--from", file});
    EXPECT_EQ(same.demo->name, "cube-cull");
    ASSERT_EQ(same.knobs.size(), 2U);
    EXPECT_EQ(same.knobs[1].text, "-30");
    EXPECT_EQ(same.changes, (std::vector<TimedChange>{{3, "spin-y", "5"}}));
    EXPECT_EQ(same.firstFrame, 7);
    EXPECT_EQ(same.width, 64);
    const Command other =
        parseCommandLine({"cube-cull", "--size=32x32", "--from=" + file, "--cull", "back", "--shot", "b.png"});
    EXPECT_EQ(other.width, 32);
    EXPECT_EQ(other.shot, "b.png");
    ASSERT_EQ(other.knobs.size(), 2U);
    for (const KnobSetting& knob : other.knobs) EXPECT_EQ(knob.text, knob.name == "cull" ? "back" : "-30") << knob.name;
    EXPECT_EQ(refusal({"shadow-map", "--from", file}), "--from: must be a picture of shadow-map, one of cube-cull");
    EXPECT_EQ(refusal({"--from", file, "--from", file}), "--from: must be given once");
    EXPECT_EQ(refusal({"cube-cull", "--from"}), "--from: must have a value (--help says which)");
    tell("texture-map --picture 'my photo'\\''s.jpg'");
    EXPECT_EQ(parseCommandLine({"--from", file, "--copyable"}).knobs.front().text, "my photo's.jpg");
    // Nobody does what a stranger's picture tells to do.
    for (const char* action : {"--shot x", "--shot=x", "--study x", "--movie x.mp4", "--plot x.svg", "--gallery x",
                               "--docs x", "--from x", "--report", "--window", "--help", "--preset both"}) {
        const std::string flag = std::string(action).substr(0, std::string(action).find_first_of(" ="));
        tell("cube-cull --cull front " + std::string(action));
        try {
            parseCommandLine({"--from", file, "--copyable"});
            ADD_FAILURE() << action;
        } catch (const Error& error) {
            EXPECT_EQ(error.what(),
                      "--from: must be a picture whose line says what is drawn; its file has another flag, " + flag);
        }
        tell(action);
        EXPECT_THROW((void)parseCommandLine({"--from", file}), Error) << action;
    }
    tell("");
    EXPECT_THROW((void)parseCommandLine({"--from", file}), Error) << "no line";
    EXPECT_THROW((void)parseCommandLine({"--from", file + "x"}), Error) << "no file";
    EXPECT_THROW((void)parseCommandLine({"--from", tree() + "/LICENSE"}), Error) << "no picture";
}

TEST(CommandLine, empty_values_and_flags_as_values_are_refused) {
    for (const char* flag : {"--shot", "--frame", "--frames", "--size", "--compare", "--study", "--vary", "--cull",
                             "--z-dist", "--headless", "--report", "--knobs"}) {
        EXPECT_TRUE(has(refusal({"cube-cull", std::string(flag) + "="}), "must have a value")) << flag;
    }
    for (const char* flag : {"--shot", "--frame", "--frames", "--size", "--compare", "--study", "--vary", "--cull"}) {
        EXPECT_EQ(refusal({"cube-cull", flag, ""}), flag + std::string(": must have a value, ''"));
        EXPECT_EQ(refusal({"cube-cull", flag}), flag + std::string(": must have a value (--help says which)"));
        EXPECT_TRUE(has(refusal({"cube-cull", flag, "--report"}), flag + std::string(": must have a value before")));
    }
    for (const char* flag : {"--list", "--version", "--copyable", "--audit", "--window", "--help"}) {
        for (const char* value : {"5", "x", "no", "false", "off"}) {
            EXPECT_EQ(refusal({"cube-cull", std::string(flag) + "=" + value}),
                      flag + std::string(": takes no value, '") + value + "'");
        }
    }
    EXPECT_EQ(refusal({"--audit", "--all=no"}), "--all: takes no value, 'no'");
    EXPECT_EQ(parseCommandLine({"cube-cull", "--shot", "./--report"}).shot, "./--report");
    EXPECT_EQ(parseCommandLine({"cube-cull", "--shot", "-"}).shot, "-") << "standard output";
    for (const char* number : {"+-3", "++3", "-+3", "+", "-", "--3", "3-", ""}) {
        EXPECT_NE(refusal({"cube-cull", "--z-dist", number}), "accepted") << number;
    }
    EXPECT_EQ(refusal({"cube-cull", "--z-dist", "+3", "--spin-x", "-3"}), "accepted");
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
    EXPECT_EQ(copyableCommand(info.name, info, *demo, 1, 600, 600), "cube-cull");
    demo->knob("spin-x").parse("0.1");
    demo->knob("cull").parse("front");
    EXPECT_EQ(copyableCommand(info.name, info, *demo, 9, 300, 200),
              "cube-cull --cull front --spin-x 0.1 --size 300x200")
        << "no frame: nothing moves in this demo";
    // The present value is the first of the two, so it stands nowhere else.
    const std::string both = copyableCommand(info.name, info, *demo, 1, 600, 600, {"cull", "none"});
    EXPECT_EQ(both, "cube-cull --spin-x 0.1 --compare cull=front,none");
}

// The file is a PNG, whatever it is called: so no name may say otherwise.
TEST(CommandLine, a_picture_is_what_its_name_says) {
    for (const char* name : {"a.png", "a.PNG", "a", "-", "/dev/fd/1", "a.b.png", "a.7", ".a", "a.", "%d", "x.jpg/a"}) {
        EXPECT_EQ(refusal({"cube-cull", "--shot", name}), "accepted") << name;
    }
    for (const std::string name : {"x.jpg", "x.JPEG", "a.png.gif", "x.svg", "x.pngx", "f%d.bmp"}) {
        EXPECT_EQ(refusal({"cube-cull", "--shot", name}),
                  "--shot: must be a name that ends in .png, or says no other format, '" + name + "'");
    }
    EXPECT_TRUE(has(refusal({"viewpoints", "--shot", "-", "--frames", "1..3"}), "must have %d"));
    EXPECT_TRUE(has(refusal({"viewpoints", "--shot", "-", "--report"}), "goes to standard output"));
    EXPECT_TRUE(has(refusal({"viewpoints", "--shot", "-", "--until", "1"}), "goes to standard output"));
}

// Every demo, also one that stands still: the line that is copied is understood, and means the same picture.
TEST(CommandLine, a_copied_line_with_changes_is_understood) {
    int still = 0;
    for (const DemoInfo& info : catalogue()) {
        const auto demo = info.make();
        const Knob& knob = *demo->knobs().front();
        std::string other;
        for (const std::string& value : knob.sweep()) {
            if (value != knob.text()) other = value;
        }
        if (other.empty()) continue;
        still += info.animated ? 0 : 1;
        const std::vector<TimedChange> changes{{7, knob.name(), other}};
        for (const int frame : {7, 9, 3}) {
            Timeline timeline(*demo);
            timeline.setChanges(changes);
            const std::string line =
                copyableCommand(info.name, info, *demo, frame, info.width, info.height, {}, &timeline);
            std::vector<std::string> words;
            std::istringstream stream(line + " --shot a.png");
            for (std::string word; stream >> word;) {
                std::erase(word, '\'');
                words.push_back(word);
            }
            const Command command = parseCommandLine(words);
            const auto until = static_cast<std::size_t>(frame < 7 ? 0 : 1);
            EXPECT_EQ(command.changes,
                      std::vector<TimedChange>(changes.begin(), changes.begin() + std::ptrdiff_t(until)))
                << line;
            EXPECT_EQ(command.lastFrame, info.animated || until > 0 ? frame : 1) << line;
        }
    }
    EXPECT_GT(still, 5);
}

TEST(CommandLine, changes_at_frames) {
    const Command command = parseCommandLine(
        {"viewpoints", "--at", "30", "view=3", "--frame", "40", "--shot", "a.png", "--at", "7", "view=2"});
    EXPECT_EQ(command.changes, (std::vector<TimedChange>{{30, "view", "3"}, {7, "view", "2"}}));
    EXPECT_EQ(refusal({"viewpoints", "--at", "30", "view=3"}), "accepted") << "a window comes to that frame";
    EXPECT_EQ(refusal({"viewpoints", "--at", "30", "view=3", "--shot", "a.png"}),
              "--at: must be at a frame that is drawn or before, up to 1 (--frame), 30");
    EXPECT_EQ(refusal({"viewpoints", "--at", "30", "view=3", "--frames", "1..30", "--shot", "%d.png"}), "accepted");
    EXPECT_EQ(refusal({"viewpoints", "--at", "0", "view=3"}),
              "--at: must be at a frame from 1; what holds before is set by the knob's own flag");
    EXPECT_EQ(refusal({"viewpoints", "--at", "x", "view=3"}), "--at: must be a whole number 0 .. 1000000000, 'x'");
    EXPECT_EQ(refusal({"viewpoints", "--at", "3", "view"}),
              "--at: must be a frame, a knob and its value, as --at 300 pull=0.2, 'view'");
    EXPECT_EQ(refusal({"viewpoints", "--at", "3", "veiw=3"}), "--veiw: is no knob of this demo; did you mean 'view'?");
    EXPECT_TRUE(has(refusal({"viewpoints", "--at", "3", "view=99"}), "--view: must be"));
    EXPECT_TRUE(has(refusal({"viewpoints", "--at", "3"}), "--at: must have a value"));
    EXPECT_TRUE(has(refusal({"viewpoints", "--at", "3", "view=3", "--audit"}), "--at: needs"));
    EXPECT_EQ(refusal({"viewpoints", "--at", "1", "view=3", "--compare", "view=1,2"}),
              "--at: must not set the knob that --compare does, view");
    EXPECT_TRUE(has(refusal({"--at", "3", "view=3"}), "demo: must be named first"));
}

// A shell gives each word back as it was.
TEST(CommandLine, what_a_shell_would_read_otherwise_is_quoted) {
    EXPECT_EQ(quotedForShell("0,0.5/1,2"), "0,0.5/1,2");
    EXPECT_EQ(quotedForShell(""), "''");
    EXPECT_EQ(quotedForShell("a b"), "'a b'");
    EXPECT_EQ(quotedForShell("it's $HOME `date` \\ *"), "'it'\\''s $HOME `date` \\ *'");
    EXPECT_EQ(startOf("/my folder/run", findDemo("shadow")), "'/my folder/run' shadow");
    EXPECT_EQ(startOf("", findDemo("shadow")), "shadow");
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
