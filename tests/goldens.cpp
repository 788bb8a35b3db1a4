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
#include "support/softpipe.h"

using namespace mv;
using namespace mv::test;

namespace {

class Golden : public testing::TestWithParam<std::string> {};

bool updating() { return std::getenv("MVGL_UPDATE_GOLDENS") != nullptr; }

void expectMatch(const GoldenCase& golden) {
    const Picture drawn = drawCase(golden);
    EXPECT_GT(countColors(drawn, 2), 1) << golden.name << ": nothing was drawn";
    const auto reason = mismatch(golden, drawn);
    if (reason && updating()) {
        writePng(goldenFile(golden.name), drawn);
        writeFileAtomically(tree() + "/tests/goldens/recorded.txt", std::string_view(presentDriver() + "\n"));
        std::cout << "updated " << golden.name << ": " << *reason << "\n";
        return;
    }
    EXPECT_FALSE(reason) << golden.name << ": " << *reason;
}

}  // namespace

// The picture that a demo opens with, which has its name.
TEST_P(Golden, first_picture) {
    for (const GoldenCase& golden : goldenCases()) {
        if (golden.name == GetParam()) return expectMatch(golden);
    }
    FAIL() << GetParam() << " has no golden picture";
}

TEST_P(Golden, other_pictures) {
    int compared = 0;
    for (const GoldenCase& golden : goldenCases()) {
        if (golden.command.demo->name != GetParam() || golden.name == GetParam()) continue;
        if (golden.name == "rasterizer-sampled" && hasOneSample()) continue;
        expectMatch(golden);
        ++compared;
    }
    EXPECT_GT(compared, 0) << GetParam() << " has no other golden picture";
}

INSTANTIATE_TEST_SUITE_P(, Golden, testing::ValuesIn(demoNames()), parameterWord);

TEST(GoldenFiles, every_demo_has_one_and_no_file_is_left_over) {
    std::set<std::string> wanted{"recorded.txt", "cases.txt"};
    for (const GoldenCase& golden : goldenCases()) wanted.insert(golden.name + ".png");
    for (const DemoInfo& info : catalogue()) {
        EXPECT_TRUE(wanted.count(info.name + ".png"))
            << info.name << " needs one of its initial picture, by its own name";
    }
    if (updating()) return;
    std::set<std::string> present;
    for (const auto& entry : std::filesystem::directory_iterator(tree() + "/tests/goldens")) {
        present.insert(entry.path().filename().string());
    }
    EXPECT_EQ(present, wanted);
}

TEST(GoldenFiles, the_rule_in_force_is_said) {
    ASSERT_FALSE(recordedDriver().empty());
    std::cout << "recorded: " << recordedDriver() << "\npresent:  " << presentDriver() << "\n";
}
