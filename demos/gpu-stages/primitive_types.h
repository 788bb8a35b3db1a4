// The ten primitive types of the lecture: the number of primitives for a number of vertices, and the places of the vertices in
// a figure.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "mv/gl/functions.h"
#include "mv/math/types.h"

namespace mv {

struct PrimitiveType {
    const char* name;
    GLenum mode;  // as glDrawArrays takes it, or took it
    bool inCore;  // of OpenGL 3.1 and later; the others are GL_INVALID_ENUM there
};

// The types in the lecture's order. The last three are no names of the core's header any more.
inline constexpr std::array<PrimitiveType, 10> primitiveTypes{{
    {"GL_POINTS", GL_POINTS, true},
    {"GL_LINES", GL_LINES, true},
    {"GL_LINE_STRIP", GL_LINE_STRIP, true},
    {"GL_LINE_LOOP", GL_LINE_LOOP, true},
    {"GL_TRIANGLES", GL_TRIANGLES, true},
    {"GL_TRIANGLE_STRIP", GL_TRIANGLE_STRIP, true},
    {"GL_TRIANGLE_FAN", GL_TRIANGLE_FAN, true},
    {"GL_QUADS", 0x0007, false},
    {"GL_QUAD_STRIP", 0x0008, false},
    {"GL_POLYGON", 0x0009, false},
}};

// The number of primitives that this many vertices make. Left-over vertices make none.
long primitivesOf(const PrimitiveType& type, int vertices);

// The separate triangles by which a type that has left the core is drawn today: three of the vertices each, wound as the type
// winds them, and last the vertex whose colour the primitive has. Refused: a type of the core.
std::vector<std::uint32_t> asTriangles(const PrimitiveType& type, int vertices);

// Whether the vertices stand in a ring, at 0.75 from the middle, or in two rows.
bool standsInRing(const PrimitiveType& type);

// The places of the vertices, within -1 .. 1. The primitives do not overlap, and each has an area.
std::vector<vec2> placesOf(const PrimitiveType& type, int vertices);

}  // namespace mv
