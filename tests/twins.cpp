// The control of the golden pictures' comparison: three of this program's demos have one line changed that a student could get
// wrong (a sign, an order, a state that is not set), and so must not match. Nor may a twin differ everywhere: that would be a control
// that anything passes.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "mv/image/compare.h"
#include "mv/image/load.h"
#include "support/demo_run.h"
#include "support/golden.h"

using namespace mv;
using namespace mv::test;

namespace {

class Twin : public testing::TestWithParam<std::string> {};

std::vector<std::string> twins() {
    std::vector<std::string> names;
    for (const std::string& name : demoNames()) {
        if (std::filesystem::exists(MVGL_SOURCE_DIR "/tests/twins/" + name + ".txt")) names.push_back(name);
    }
    return names;
}

std::string goldenOfTwin(const std::string& demo) {
    const std::string inFolder = MVGL_SOURCE_DIR "/tests/" + demo + "/twin.txt";
    std::ifstream recipe(std::filesystem::exists(inFolder) ? inFolder
                                                           : MVGL_SOURCE_DIR "/tests/twins/" + demo + ".txt");
    std::string word, name;
    recipe >> word >> name;
    return word == "golden" ? name : "";
}

}  // namespace

TEST_P(Twin, does_not_match) {
    const std::string name = goldenOfTwin(GetParam());
    ASSERT_FALSE(name.empty()) << "the twin's file of " << GetParam() << " must begin with: golden <name>";
    for (const GoldenCase& golden : goldenCases()) {
        if (golden.name != name) continue;
        ASSERT_TRUE(std::filesystem::exists(goldenFile(name))) << "./test --update-goldens draws it";
        const Picture drawn = drawCase(golden);
        EXPECT_TRUE(mismatch(golden, drawn, false)) << "the broken twin matches its golden picture";
        const double fraction = compare(loadPicture(goldenFile(name)), drawn).fraction;
        EXPECT_LE(fraction, 0.5);
        std::printf("twin of %s: %.3f %% of the pixels differ\n", GetParam().c_str(), 100 * fraction);
        return;
    }
    FAIL() << "no golden case is named " << name;
}

INSTANTIATE_TEST_SUITE_P(, Twin, testing::ValuesIn(twins()), parameterWord);

TEST(Twins, are_of_three_kinds) { EXPECT_EQ(twins().size(), 3U); }
