// Every golden picture is drawn again and compared. With MVGL_UPDATE_GOLDENS=1 those that differ are written instead,
// each with its difference printed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>

#include "mv/image/file.h"
#include "mv/image/png.h"
#include "support/demo_run.h"
#include "support/golden.h"

using namespace mv;
using namespace mv::test;

namespace {

class Golden : public testing::TestWithParam<std::string> {};

std::vector<std::string> names() {
    std::vector<std::string> list;
    for (const GoldenCase& golden : goldenCases()) list.push_back(golden.name);
    return list;
}

const GoldenCase& caseOf(const std::string& name) {
    for (const GoldenCase& golden : goldenCases()) {
        if (golden.name == name) return golden;
    }
    throw Error(name, "must be a golden case");
}

bool updating() { return std::getenv("MVGL_UPDATE_GOLDENS") != nullptr; }

}  // namespace

TEST_P(Golden, matches) {
    const Picture drawn = drawCase(caseOf(GetParam()));
    EXPECT_GT(countColors(drawn), 1) << "nothing was drawn";
    const auto reason = mismatch(GetParam(), drawn);
    if (reason && updating()) {
        writePng(goldenFile(GetParam()), drawn);
        writeFileAtomically(MVGL_SOURCE_DIR "/tests/goldens/recorded.txt", std::string_view(presentDriver() + "\n"));
        std::cout << "updated " << GetParam() << ": " << *reason << "\n";
        return;
    }
    EXPECT_FALSE(reason) << *reason;
}

INSTANTIATE_TEST_SUITE_P(, Golden, testing::ValuesIn(names()), parameterWord);

TEST(GoldenFiles, every_demo_has_one_and_no_file_is_left_over) {
    std::set<std::string> wanted{"recorded.txt", "cases.txt"}, demos;
    for (const GoldenCase& golden : goldenCases()) {
        wanted.insert(golden.name + ".png");
        demos.insert(golden.command.demo->name);
    }
    for (const DemoInfo& info : catalogue()) {
        EXPECT_TRUE(demos.count(info.name)) << info.name << " has no golden picture";
        EXPECT_TRUE(wanted.count(info.name + ".png"))
            << info.name << " needs one of its initial picture, by its own name";
    }
    if (updating()) return;
    std::set<std::string> present;
    for (const auto& entry : std::filesystem::directory_iterator(MVGL_SOURCE_DIR "/tests/goldens")) {
        present.insert(entry.path().filename().string());
    }
    EXPECT_EQ(present, wanted);
}

TEST(GoldenFiles, the_rule_in_force_is_said) {
    ASSERT_FALSE(recordedDriver().empty());
    std::cout << "recorded: " << recordedDriver() << "\npresent:  " << presentDriver() << "\n";
}
