// Is this mesh what it should be: well formed, closed, facing outwards?
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mv/geometry/mesh_data.h"

namespace mv {

// Throws Error("mesh", rule, value) unless: there is a position; each optional array is empty or as long as positions;
// every index names a position; the number of vertices drawn suits the primitive (a multiple of 3 for triangles, of 2
// for lines, at least 3 for a strip or fan); every float is finite.
void validate(const MeshData& mesh);

// The triangles GL draws, as three positions' numbers each, counter-clockwise as GL counts it (every second triangle of
// a strip has its first two vertices swapped). Triangles without area are among them. Empty for lines and points.
// Refuses what validate refuses.
std::vector<std::array<std::uint32_t, 3>> trianglesOf(const MeshData& mesh);

// How many triangles GL draws; 0 for lines and points. Refuses what validate refuses.
std::size_t triangleCount(const MeshData& mesh);

// For each position the number of the first at exactly the same place (0 and -0 are the same): vertices that a seam or a
// hard edge repeats get one number. Trap: positions that differ by a rounding stay apart.
std::vector<std::uint32_t> weldByPosition(const std::vector<fvec3>& positions);

// True when the triangles enclose a volume without a gap: each directed edge is matched by as many of its reverse.
// Vertices at exactly the same position count as one (0 and -0 are the same), so a seam or a hard edge may repeat them;
// triangles of which two corners coincide are passed over. False for lines, points, and where no triangle is left.
// Trap: positions that differ by a rounding are a gap. Refuses what validate refuses.
bool isClosed(const MeshData& mesh);

// The enclosed volume: positive when the fronts (counter-clockwise) are outside, negative when they are inside.
// Source: the divergence theorem, the sum of det(a, b, c)/6. Refused: a mesh that is not closed, for which that sum
// would depend on where the origin is; and what validate refuses.
double signedVolume(const MeshData& mesh);

}  // namespace mv
