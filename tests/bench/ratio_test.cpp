#include "bench/ratio.h"

#include <gtest/gtest.h>

#include <sstream>
#include <thread>

#include "mv/error.h"

namespace mv::bench {
namespace {

void pause(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

TEST(Median, IsTheMiddle) {
    EXPECT_EQ(median({3}), 3);
    EXPECT_EQ(median({5, 1, 3}), 3);
    EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
    EXPECT_EQ(median({1, 1, 1, 1000}), 1);
    EXPECT_THROW((void)median({}), Error);
}

TEST(Median, DeviationIgnoresOneOutlier) {
    EXPECT_EQ(medianDeviation({2, 2, 2}), 0);
    EXPECT_EQ(medianDeviation({1, 2, 3, 4, 1000}), 1);
}

TEST(Interleaved, AlternatesTheOrder) {
    std::string order;
    (void)interleaved([&] { order += 'a'; },
                      [&] {
                          order += 'b';
                          pause(1);
                      },
                      7);
    EXPECT_EQ(order, "abbaabbaabbaabba");  // 8 pairs, of which the first is dropped
}

TEST(Interleaved, MeasuresTheRatio) {
    const Ratio ratio = interleaved([] { pause(6); }, [] { pause(3); }, 7);
    // A sleep is never shorter than asked for; a busy machine makes it longer, by a millisecond at most in the median.
    EXPECT_NEAR(ratio.median, 2, 0.6);
    EXPECT_GE(ratio.medianA, 6);
    EXPECT_GE(ratio.medianB, 3);
}

TEST(Interleaved, DropsTheFirstPair) {
    int calls = 0;
    const Ratio ratio = interleaved([&] { pause(calls++ == 0 ? 100 : 2); }, [] { pause(2); }, 7);
    EXPECT_LT(ratio.medianA, 50);
    EXPECT_EQ(calls, 8);
}

TEST(Interleaved, RefusesTooFewRounds) {
    EXPECT_THROW((void)interleaved([] {}, [] {}, 6), Error);
}

TEST(Rows, NoiseIsNeitherSuccessNorFailure) {
    EXPECT_EQ(verdict({"within", {1.0, 0, 0, 0}, 1.0}), Verdict::pass);
    EXPECT_EQ(verdict({"beyond", {1.1, 0.01, 0, 0}, 1.0}), Verdict::fail);
    EXPECT_EQ(verdict({"in the noise", {1.1, 0.05, 0, 0}, 1.0}), Verdict::unclear);
    EXPECT_EQ(verdict({"far beyond in much noise", {9.7, 2.8, 0, 0}, 2.0}), Verdict::unclear);
}

TEST(Rows, PrintOneLineEach) {
    const auto printed = [](const Row& row) {
        std::ostringstream out;
        printRow(out, row);
        return out.str();
    };
    EXPECT_NE(printed({"name", {1.1, 0.05, 12.5, 25}, 1.0}).find("12.500"), std::string::npos);
    EXPECT_NE(printed({"name", {1.1, 0.05, 1, 1}, 1.0}).find("  unclear\n"), std::string::npos);
    EXPECT_NE(printed({"name", {2, 0, 1, 1}, 1.0}).find("  fail\n"), std::string::npos);
    EXPECT_NE(printed({"name", {1, 0, 1, 1}, 1.0}).find("  pass\n"), std::string::npos);
}

}  // namespace
}  // namespace mv::bench
