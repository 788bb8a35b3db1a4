// What is said where a volume of view has another shape than the picture.
#pragma once
#include <string>
#include <vector>

#include "support/demo_run.h"

namespace mv::test {

// `square` and `wide` are values of the knob for a volume as wide as high, and one and a half times as wide.
inline void expectStretchIsSaid(const std::string& demo, const std::string& knob, double square, double wide) {
    const auto said = [&](int width, int height, double value) {
        DemoRun run(demo, width, height);
        (void)run.set(knob, value).picture();
        const std::vector<std::string> messages = run.messages();
        return messages.empty() ? "" : messages.at(0);
    };
    EXPECT_EQ(said(300, 300, square), "");
    EXPECT_EQ(said(300, 200, wide), "") << "a window of the volume's shape";
    EXPECT_EQ(
        said(300, 200, square),
        "Shapes are shown 1.50 times as wide as they are: the picture is 1.50 times as wide as high, the volume of "
        "view 1.00.");
    EXPECT_EQ(
        said(200, 200, wide),
        "Shapes are shown 1.50 times as high as they are: the picture is 1.00 times as wide as high, the volume of "
        "view 1.50.");
    EXPECT_EQ(said(300, 297, square), "") << "a pixel or two are a rounding";
}

}  // namespace mv::test
