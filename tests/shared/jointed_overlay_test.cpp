#include "robot-arm/jointed_overlay.h"

#include <gtest/gtest.h>

#include "mv/math/projection.h"

using namespace mv;

TEST(JointedOverlay, numbers_are_short_and_never_minus_nothing) {
    EXPECT_EQ(shortNumber(0.5), "0.500");
    EXPECT_EQ(shortNumber(-1), "-1");
    EXPECT_EQ(shortNumber(-1e-17), "0");
    EXPECT_EQ(shortNumber(-0.0004), "0");
    EXPECT_EQ(shortNumber(0.9999), "1");
    EXPECT_EQ(shortNumber(1.0 / 3), "0.333");
}

TEST(JointedOverlay, pixels_are_those_of_its_pane) {
    JointedOverlay overlay;
    overlay.look({100, 50, 200, 100}, ortho(-2, 2, -1, 1, -1, 1));
    EXPECT_EQ(overlay.pixel({0, 0, 0}), vec2(100, 50));
    EXPECT_EQ(overlay.pixel({2, -1, 0}), vec2(200, 0));
}

// Neighbours in the product match, and it is what it says.
TEST(JointedOverlay, factors_are_shown_by_their_names_and_their_product_last) {
    for (const bool isArm : {false, true}) {
        const Jointed thing = isArm ? arm(1.2, 0.8, true) : legs(1.2, 0.8, {0.5, 1.5});
        const std::vector<double> degrees = isArm ? armStart(3) : std::vector<double>{0, -60, -20, -110, -30};
        const auto worldFromPart = thing.tree.worldFromJoints(degrees);
        FrameNotes notes;
        const Frame frame(FrameInfo(1, 960, 560), notes, {});
        JointedOverlay overlay;
        overlay.begin(frame);
        overlay.product(frame, thing, worldFromPart, degrees, {576, 0, 384, 560}, !isArm);
        std::vector<std::string> names;
        mat4 product(1);
        for (const auto& [name, matrix] : notes.matrices) {
            names.push_back(name);
            if (names.size() < notes.matrices.size()) product = product * matrix;
        }
        EXPECT_EQ(names, isArm ? (std::vector<std::string>{"worldFromTurret", "turretFromUpper", "upperFromLower",
                                                           "lowerFromHand", "worldFromHand"})
                               : (std::vector<std::string>{"worldFromBody", "bodyFromThigh", "thighFromShank",
                                                           "worldFromShank"}));
        EXPECT_EQ(product, notes.matrices.back().second);
    }
}
