#include "color-models/chromaticity_diagram.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "mv/math/color.h"

using namespace mv;

TEST(ChromaticityDiagrams, the_matrix_is_the_formula) {
    const FrameInfo frame(1, 960, 640);
    for (const Diagram which : {Diagram::xy, Diagram::uv}) {
        const ChromaticityDiagram diagram{which};
        const Plot plot = diagram.plotIn(frame);
        for (const vec2& xy : spectralLocus()) {
            const vec4 clip =
                ChromaticityDiagram::clipFromPlace(plot, frame) * diagram.placeFromXy() * vec4(xy.x, xy.y, 0, 1);
            const vec2 pixel((clip.x / clip.w + 1) / 2 * 960, (clip.y / clip.w + 1) / 2 * 640);
            EXPECT_LE(glm::distance(pixel, plot.pixel(diagram.place(xy))), 1e-10);  // of 1000, 1e-13
        }
    }
}

TEST(ChromaticityDiagrams, primaries_and_black) {
    for (const Diagram which : {Diagram::xy, Diagram::uv}) {
        const ChromaticityDiagram diagram{which};
        EXPECT_LE(glm::distance(diagram.placeOf(vec3(1, 0, 0)).value(), diagram.place(srgbPrimaries[0])), 1e-14);
        EXPECT_LE(glm::distance(diagram.placeOf(vec3(0.5)).value(), diagram.place(srgbWhite)), 1e-14);
        EXPECT_FALSE(diagram.placeOf(vec3(0)));
    }
}

// The triangle and what is beyond its sides is all; beyond two of them lie the three corners' wedges.
TEST(ChromaticityDiagrams, parts_make_up_the_whole) {
    for (const Diagram which : {Diagram::xy, Diagram::uv}) {
        const ChromaticityDiagram diagram{which};
        const auto& [red, green, blue] = srgbPrimaries;
        const double sides =
            diagram.beyondSide(red, green) + diagram.beyondSide(green, blue) + diagram.beyondSide(blue, red);
        EXPECT_GT(sides + diagram.heldBySrgb(), 100);
        EXPECT_LT(sides + diagram.heldBySrgb(), 110);
        // Either way round, it is what the third primary is not in.
        EXPECT_NEAR(diagram.beyondSide(red, green), diagram.beyondSide(green, red), 1e-12);
    }
}
