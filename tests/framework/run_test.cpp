#include "mv/run/run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <new>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "mv/error.h"
#include "mv/paper/report.h"
#include "mv/run/command_line.h"
#include "mv/show/caught.h"
#include "support/demo_run.h"

using namespace mv;

namespace {

// The sentence that the user is told when `work` throws.
template <class Work>
std::string told(const Work& work) {
    try {
        work();
    } catch (const std::exception&) {
        return caughtSentence("cube-cull");
    }
    return "nothing was thrown";
}

}  // namespace

// Columns do not touch, however long a name, a value or a range is.
TEST(Run, knobs_and_readouts_stand_in_columns) {
    for (const DemoInfo& info : catalogue()) {
        SCOPED_TRACE(info.name);
        const auto demo = info.make();
        std::istringstream lines(knobsText(*demo));
        std::vector<std::size_t> columns;
        for (const Knob* knob : demo->knobs()) {
            std::string line;
            ASSERT_TRUE(std::getline(lines, line));
            // Name, value and range, each between two spaces at least, at the same places in each line.
            std::vector<std::size_t> places;
            for (const std::string& cell : {"--" + knob->name() + "  ", "  " + knob->text() + "  ",
                                            "  " + knob->range(), "  (" + knob->help() + ")"}) {
                const auto at = line.find(cell, places.empty() ? 0 : places.back());
                ASSERT_NE(at, std::string::npos) << cell << " in: " << line;
                places.push_back(at);
            }
            if (columns.empty()) columns = places;
            EXPECT_EQ(places, columns) << line;
        }
    }
}

// An Error's words are ours; those of a library ("std::bad_alloc", "vector::_M_range_check: ...") never reach the user.
TEST(Run, what_a_library_throws_is_said_in_our_words) {
    EXPECT_EQ(told([] { throw Error("--near", "must be below --far", "9"); }), "--near: must be below --far, 9");
    EXPECT_EQ(told([] { throw UsageError("--frame", "must be given once"); }), "--frame: must be given once");
    const std::string memory = "cube-cull: needs more memory than there is; a smaller --size needs less";
    EXPECT_EQ(told([] { throw std::bad_alloc(); }), memory);
    EXPECT_EQ(told([] { throw std::bad_array_new_length(); }), memory);
    EXPECT_EQ(told([] { std::vector<int>().reserve(~std::size_t{0}); }), memory);
    EXPECT_EQ(told([] { (void)std::filesystem::file_size("/nonexistent/a"); }),
              "/nonexistent/a: must be there and may be used, No such file or directory");
    EXPECT_EQ(told([] { throw std::system_error(EAGAIN, std::generic_category(), "thread"); }),
              "cube-cull: needs what the system does not give, Resource temporarily unavailable");
    const std::string fault = "cube-cull: met a fault of its own, which ended it; please report the command line";
    EXPECT_EQ(told([] { (void)std::vector<int>().at(3); }), fault);
    EXPECT_EQ(told([] { (void)std::optional<int>().value(); }), fault);
    EXPECT_EQ(told([] { (void)std::stoi("x"); }), fault);
}

// A sentence beside knobs names them as their labels do, and says what to do; a command line's words stay as they are elsewhere.
TEST(Run, a_refusal_in_plain_words) {
    const auto demo = findDemo("view-volume").make();
    demo->knob("near").parse("20");
    demo->knob("far").parse("15");
    EXPECT_EQ(inPlainWords("--near: must be less than --far 15, 20", *demo),
              "near is 20 m, and must be less than far 15: move near or far");
    EXPECT_EQ(inPlainWords("--far: must be above 16, '15'", *demo), "far is 15 m, and must be above 16: move far");
    EXPECT_EQ(inPlainWords("--near: needs a larger far, 20", *demo), "near: needs a larger far: move near");
    // A reason behind a colon stands for what to do
    EXPECT_EQ(inPlainWords("--near: has no volume: both planes are one", *demo),
              "near: has no volume: both planes are one");
    // Of no knob of this demo, or not of one first
    for (const char* other : {"--spam: must be less than 3, 4", "view-volume: needs more memory than there is",
                              "out.png: must be a folder, as --near says"})
        EXPECT_EQ(inPlainWords(other, *demo), other);
    EXPECT_EQ(knobsNamed("--near: must be less than --far 15, as --near says, not --nearer", *demo),
              (std::vector<std::string>{"near", "far"}));
}

TEST(Run, roundings_are_told_as_none) {
    EXPECT_EQ(withoutRounding(6.1e-17, 1), 0);
    EXPECT_EQ(withoutRounding(-6.1e-14, 1000), 0);
    EXPECT_FALSE(std::signbit(withoutRounding(-6.1e-17, 1)));
    EXPECT_FALSE(std::signbit(withoutRounding(-0.0, 0)));
    // Small is not nothing: beside others as small, and from some thousand roundings of the largest on
    EXPECT_EQ(withoutRounding(-6.1e-17, 1e-16), -6.1e-17);
    EXPECT_EQ(withoutRounding(1.1e-12, 1), 1.1e-12);

    // A quarter turn has no 6e-17 in what is printed of its matrix.
    test::DemoRun run("cube-cull");
    (void)run.set("spin-x", 0).set("spin-y", 90).picture();
    const mat4 turned = run.matrix("viewFromModel");
    ASSERT_TRUE(turned[0][0] != 0 && std::abs(turned[0][0]) < 1e-15) << "there is one to leave out";
    const std::string text = reportText(test::stage(), 1, {});
    const auto rows = text.substr(text.find("matrix    viewFromModel"));
    EXPECT_EQ(rows.find("e-1"), std::string::npos) << rows;
}
