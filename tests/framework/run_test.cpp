#include "mv/run/run.h"

#include <gtest/gtest.h>

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

using namespace mv;

namespace {

// What the user is told when `work` throws.
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
