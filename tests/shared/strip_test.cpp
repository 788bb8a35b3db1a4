#include "shared/strip.h"

#include <gtest/gtest.h>

#include "../math/support.h"

using namespace mv;
using namespace mv::test;

namespace {

TEST(Strip, PanesLieSideBySideAboveIt) {
    const FrameInfo frame(1, 960, 560);
    const Pane left = paneAboveStrip(frame, 0, 0.5), right = paneAboveStrip(frame, 0.5, 1);
    EXPECT_EQ(left.x, 0);
    EXPECT_EQ(left.x + left.width, right.x);
    EXPECT_EQ(right.x + right.width, 960);
    EXPECT_EQ(left.y + left.height, 560);
    const Box graph = graphInStrip(frame, 0, 0.5);
    EXPECT_GE(graph.low.x, 40) << "room for numbers";
    EXPECT_GE(graph.low.y, 40);
    EXPECT_LT(graph.high.x, 480);
    EXPECT_LT(graph.high.y + 14, left.y) << "room for a title";
}

TEST(Strip, HasPanesAndGraphsInAPixel) {
    for (const auto& [width, height] : {std::pair(1, 1), {3, 2}, {64, 64}}) {
        const FrameInfo frame(1, width, height);
        const Pane pane = paneAboveStrip(frame, 1 / 3.0, 2 / 3.0);
        EXPECT_GE(pane.width, 1);
        EXPECT_GE(pane.height, 1);
        const Box graph = graphInStrip(frame, 0, 1);
        EXPECT_GT(graph.size().x, 0);
        EXPECT_GT(graph.size().y, 0);
    }
}

TEST(Strip, RoundsUpToATick) {
    EXPECT_EQ(roundAbove(1), 1);
    EXPECT_EQ(roundAbove(1.01), 2);
    EXPECT_EQ(roundAbove(35.7), 50);
    EXPECT_EQ(roundAbove(51), 100);
    EXPECT_NEAR(roundAbove(0.0012), 0.002, 1e-18);
    EXPECT_EQ(refusal([] { roundAbove(0); }), "roundAbove: must be above 0, 0");
}

}  // namespace
