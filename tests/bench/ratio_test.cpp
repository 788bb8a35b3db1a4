#include "bench/ratio.h"

#include <gtest/gtest.h>

#include <chrono>
#include <sstream>
#include <string>
#include <thread>

#include "mv/error.h"

namespace mv::bench {
namespace {

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

// Work that takes as long as the test says, by a clock of the test's own.
class Interleaved : public testing::Test {
  protected:
    std::function<void()> lasting(double milliseconds) {
        return [this, milliseconds] { time_ += milliseconds; };
    }
    const std::function<double()> clock_ = [this] { return time_; };
    double time_ = 0;
};

TEST_F(Interleaved, AlternatesTheOrder) {
    std::string order;
    const auto work = [&](char name) {
        return [&, name] {
            order += name;
            time_ += 1;
        };
    };
    (void)interleaved(work('a'), work('b'), 7, clock_);
    EXPECT_EQ(order, "abbaabbaabbaabba");  // 8 pairs, of which the first is dropped
}

TEST_F(Interleaved, MeasuresTheRatio) {
    const Ratio ratio = interleaved(lasting(6), lasting(3), 7, clock_);
    EXPECT_EQ(ratio.median, 2);
    EXPECT_EQ(ratio.mad, 0);
    EXPECT_EQ(ratio.medianA, 6);
    EXPECT_EQ(ratio.medianB, 3);
}

TEST_F(Interleaved, DropsTheFirstPairAndTellsHowFarTheOthersLieApart) {
    double next = 0;  // 1, 2 .. 8, of which 1 is dropped
    const Ratio ratio = interleaved([&] { time_ += ++next; }, lasting(1), 7, clock_);
    EXPECT_EQ(ratio.median, 5);
    EXPECT_EQ(ratio.mad, 2);
}

TEST_F(Interleaved, RefusesTooFewRoundsAndWorkWithoutATime) {
    EXPECT_THROW((void)interleaved(lasting(1), lasting(1), 6, clock_), Error);
    EXPECT_THROW((void)interleaved(lasting(1), lasting(0), 7, clock_), Error);
}

TEST(SteadyMilliseconds, AreMilliseconds) {
    const double before = steadyMilliseconds();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));  // never shorter than asked for
    EXPECT_GE(steadyMilliseconds() - before, 5);
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
