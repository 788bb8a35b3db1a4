// Every row of the table of extreme cases, and the page made of them. With MVGL_UPDATE_DOCS=1 the page is written
// instead of compared.
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string_view>

#include "extremes/row.h"
#include "mv/image/file.h"

using namespace mv;
using namespace mv::test;

namespace {

const std::string pageFile = MVGL_SOURCE_DIR "/docs/stability.md";

class Extreme : public testing::TestWithParam<std::size_t> {
  protected:
    const Row& row() const { return rows()[GetParam()]; }
};

std::string rowWord(const testing::TestParamInfo<std::size_t>& parameter) {
    std::string word = rows()[parameter.param].id;
    for (char& letter : word) {
        if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '_';
    }
    return word;
}

std::string fileText(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

TEST_P(Extreme, ours_holds) {
    EXPECT_TRUE(holds(row().ourError, row().tolerance))
        << row().input << "\n"
        << row().ours << ": " << row().ourError << ", allowed " << row().tolerance;
}

// Else the case is no extreme one, and the row says nothing for ours.
TEST_P(Extreme, the_usual_form_fails) {
    EXPECT_FALSE(holds(row().naiveError, row().tolerance))
        << row().input << "\n"
        << row().naive << ": " << row().naiveError << ", allowed " << row().tolerance;
}

INSTANTIATE_TEST_SUITE_P(, Extreme, testing::Range(std::size_t{0}, rows().size()), rowWord);

TEST(StabilityPage, is_fresh) {
    const std::string fresh = stabilityPage(rows());
    std::cout << fresh.substr(fresh.find("| case"));
    if (std::getenv("MVGL_UPDATE_DOCS") != nullptr) {
        writeFileAtomically(pageFile, std::string_view(fresh));
        return;
    }
    EXPECT_EQ(pageDifference(fileText(pageFile), fresh), "")
        << "MVGL_UPDATE_DOCS=1 build/tests/test-extremes makes it anew";
}

TEST(StabilityPage, a_stale_one_is_told) {
    const Row row{
        "Z01", "in", "metres", "naive", 1, "ours", 2e-7, 1e-6, "why",
    };
    const std::string page = stabilityPage({row});
    const auto changed = [&](auto change) {
        Row other = row;
        change(other);
        return pageDifference(page, stabilityPage({other}));
    };
    EXPECT_EQ(pageDifference(page, page), "");
    EXPECT_EQ(changed([](Row& r) { r.ourError = 7e-7; }), "");  // another machine's
    EXPECT_NE(changed([](Row& r) { r.ourError = 9e-7; }), "");
    EXPECT_NE(changed([](Row& r) { r.naiveError = 5; }), "");
    EXPECT_NE(changed([](Row& r) { r.naiveError = std::nan(""); }), "");
    EXPECT_NE(changed([](Row& r) { r.tolerance = 2e-6; }), "");
    EXPECT_NE(changed([](Row& r) { r.reason = "why not"; }), "");
    EXPECT_NE(pageDifference(page, stabilityPage({row, row})), "");
    EXPECT_NE(pageDifference("", page), "");
}
