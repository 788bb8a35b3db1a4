#include "gpu-stages/primitive_types.h"

#include <gtest/gtest.h>

#include <set>

#include "../math/support.h"

using namespace mv;
using namespace mv::test;

namespace {

TEST(PrimitiveTypes, OfTenThreeHaveLeftTheCore) {
    int outside = 0;
    for (const PrimitiveType& type : primitiveTypes) outside += type.inCore ? 0 : 1;
    EXPECT_EQ(outside, 3);
    EXPECT_EQ(refusal([] { asTriangles(primitiveTypes[0], 4); }),
              "asTriangles: is for types that have left the core, GL_POINTS");
}

TEST(PrimitiveTypes, WhatIsLeftOverMakesNone) {
    const std::array<std::array<long, 10>, 3> expected{
        {{0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {5, 2, 4, 5, 1, 3, 3, 1, 1, 1}, {8, 4, 7, 8, 2, 6, 6, 2, 3, 1}}};
    for (std::size_t i = 0; i < primitiveTypes.size(); ++i) {
        EXPECT_EQ(primitivesOf(primitiveTypes.at(i), 0), expected[0].at(i));
        EXPECT_EQ(primitivesOf(primitiveTypes.at(i), 5), expected[1].at(i));
        EXPECT_EQ(primitivesOf(primitiveTypes.at(i), 8), expected[2].at(i));
    }
}

// Each quad is two triangles and the polygon two less than its corners; all wound alike, none without area.
TEST(PrimitiveTypes, AreDrawnAsTriangles) {
    for (const PrimitiveType& type : primitiveTypes) {
        if (type.inCore) continue;
        for (int vertices = 4; vertices <= 8; ++vertices) {
            const std::vector<std::uint32_t> indices = asTriangles(type, vertices);
            const std::vector<vec2> places = placesOf(type, vertices);
            const long primitives = primitivesOf(type, vertices);
            EXPECT_EQ(long(indices.size()) / 3, type.mode == 0x0009 ? vertices - 2 : 2 * primitives) << type.name;
            std::set<bool> turns;
            for (std::size_t i = 0; i < indices.size(); i += 3) {
                const vec2 a = places[indices[i + 1]] - places[indices[i]];
                const vec2 b = places[indices[i + 2]] - places[indices[i]];
                const double area = a.x * b.y - a.y * b.x;
                EXPECT_GT(std::abs(area), 0.05) << type.name;
                turns.insert(area > 0);
            }
            EXPECT_EQ(turns.size(), 1U) << type.name;
        }
    }
}

TEST(PrimitiveTypes, StandWithinTheirPane) {
    for (const PrimitiveType& type : primitiveTypes) {
        for (int vertices = 4; vertices <= 8; ++vertices) {
            const std::vector<vec2> places = placesOf(type, vertices);
            EXPECT_EQ(int(places.size()), vertices);
            for (std::size_t i = 0; i < places.size(); ++i) {
                EXPECT_LE(std::abs(places[i].x), 1);
                EXPECT_LE(std::abs(places[i].y), 1);
                for (std::size_t k = 0; k < i; ++k) EXPECT_NE(places[i], places[k]) << type.name;
            }
        }
    }
}

}  // namespace
