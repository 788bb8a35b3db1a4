#include "mv/geometry/in_view.h"

#include <gtest/gtest.h>

#include "mv/geometry/shapes.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

using namespace mv;

namespace {

const mat4 lens = perspective(50, 1, 0.2, 100);

TEST(InView, WhatIsAheadIsSeenAndWhatIsBehindIsNot) {
    for (const MeshData& mesh : {colorCube(), wireCube()}) {
        EXPECT_TRUE(isInView(mesh, lens * translate(0, 0, -3)));
        EXPECT_FALSE(isInView(mesh, lens * translate(0, 0, 3)));
        EXPECT_FALSE(isInView(mesh, lens * translate(9, 0, -3)));
        EXPECT_FALSE(isInView(mesh, lens * translate(0, 0, -102)));
    }
}

// All ends of all edges are outside, and something is seen all the same; and the other way round: from inside the wire
// cube no edge comes into the picture, though they are all round it.
TEST(InView, IsNotDecidedByTheEnds) {
    const mat4 large = lens * translate(0.3, 0.3, -3) * scale(8, 0.1, 0.1);
    EXPECT_TRUE(isInView(wireCube(), large));
    EXPECT_FALSE(isInView(wireCube(), lens));
    EXPECT_TRUE(isInView(colorCube(), lens));  // its face is there
}

// A box round the view volume must not count as seen where no line crosses it: two planes cross it, no line does.
TEST(InView, TouchingIsNotSeeing) {
    MeshData line;
    line.primitive = Primitive::lines;
    line.positions = {fvec3(1, 1, 0), fvec3(2, 2, 0)};
    EXPECT_FALSE(isInView(line, mat4(1)));
    line.positions[0] = fvec3(0.99F, 0.99F, 0);
    EXPECT_TRUE(isInView(line, mat4(1)));
    line.primitive = Primitive::points;
    EXPECT_TRUE(isInView(line, mat4(1)));
    line.positions = {fvec3(2, 0, 0)};
    EXPECT_FALSE(isInView(line, mat4(1)));
}

}  // namespace
