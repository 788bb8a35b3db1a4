// The shapes the demos are made of, in model space. Unless a line says otherwise triangles are counter-clockwise seen
// from outside, and every array a shape has is as long as its positions.
#pragma once
#include <span>

#include "mv/geometry/mesh_data.h"

namespace mv {

// The cube -0.5..0.5 of the WebGL course: 36 vertices, 12 triangles, positions and colors, each face in one colour: +z
// red, +x yellow, -y green, +y cyan, -z blue, -x magenta. Closed. Equals Angel's colorCube(), in its order.
MeshData colorCube();

// The edges of the cube -0.5..0.5: 24 vertices, 12 lines, positions only; first the square at z = 0.5, then the one at
// z = -0.5, then the four edges between them.
MeshData wireCube();

// The unit square -0.5..0.5 in the plane y = 0, facing +y: 6 vertices, 2 triangles, positions, normals and texCoords,
// whose u runs along x and whose v runs along -z: seen from above with -z upwards a picture stands upright.
MeshData square();

// Three lines through the origin along x (red), y (green) and z (blue), each from -halfLength to halfLength: 6
// vertices, positions and colors. Refused: halfLength not in (0, 1e38], NaN.
MeshData axes(double halfLength);

// A flat ring about the z axis in the plane z = 0: one triangle strip of segments + 1 pairs, the outer vertex first,
// 2 segments triangles, positions only; the last pair equals the first exactly. inner = 0 makes a disc.
// Trap: in this order, the course's, fronts face -z; with faces culled it is seen from below only.
// Refused: inner < 0, outer <= inner, outer > 1e38, NaN, segments outside 3..4096.
MeshData ringStrip(double inner, double outer, int segments);

// The box from lo to hi along the axes: 36 vertices, 12 triangles in the order of colorCube, positions, outward normals
// and texCoords 0..1 on each face, upright on the four sides. Closed.
// Refused: lo not below hi in each coordinate, also after rounding to float; beyond 1e38; NaN.
MeshData box(const vec3& lo, const vec3& hi);

// A sphere about the origin with poles on the y axis: slices around, stacks from pole to pole. Indexed:
// 2 slices + (stacks - 1)(slices + 1) vertices, 2 slices (stacks - 1) triangles, positions, unit normals and texCoords,
// whose u runs eastwards (0 at +x, 0.25 at -z) and v from the south pole (0) to the north pole (1). Closed: the two
// ends of the seam, and the vertices of a pole, have bit for bit the same positions and differ in texCoords only. The
// corners lie on the sphere, so its volume is below 4/3 pi r^3. Refused: radius not in [1e-37, 1e38], NaN, slices
// outside 3..4096, stacks outside 2..4096. Equals gluSphere up to its axis (z there).
MeshData sphere(double radius, int slices, int stacks);

// A ring about the y axis: a tube of radius minor whose middle runs at the distance major. Indexed:
// (slices + 1)(stacks + 1) vertices, slices around the axis and stacks around the tube, 2 slices stacks triangles,
// positions, unit normals and texCoords, whose u runs eastwards as on a sphere and v around the tube, from the outermost
// line (0) over the top and the hole (0.5) back to it (1). Closed: both seams have bit for bit the same positions.
// Refused: minor not in [1e-37, 1e38], major not above minor or beyond 1e38, a hole or a tube that float rounds away,
// NaN, slices or stacks outside 3..4096. Equals glutSolidTorus up to its axis (z there).
MeshData torus(double major, double minor, int slices, int stacks);

// A surface of revolution about the y axis: the profile, points of radius x and height y, turned round, slices around.
// The profile starts and ends on the axis (x = 0), runs off it between, and has the outside on its right: upwards for a
// pawn, down again inside for a bowl. Indexed, with positions, unit normals and texCoords, whose u runs eastwards as on a
// sphere and v along the profile by its length, from 0 to 1. Normals are smooth, except at the points where the profile
// turns by more than crease degrees: there it has an edge, and two rows of vertices; an end turns by twice its slope
// against the horizontal. Closed, seam and poles as on a sphere. Trap: a profile that crosses itself is not noticed.
// Refused: fewer than 3 points, a radius not in [1e-37, 1e38] between the ends, a height beyond 1e38, two neighbours
// that are the same point as floats, the outside on the left, NaN, slices outside 3..4096, crease outside 0..180.
MeshData lathe(std::span<const vec2> profile, int slices, double crease = 30);

// A rectangle sizeX x sizeZ in the plane y = 0, centred at the origin and facing +y, of cellsX x cellsZ cells. Indexed:
// (cellsX + 1)(cellsZ + 1) vertices, 2 cellsX cellsZ triangles, positions, normals and texCoords 0..1 as in square().
// Refused: cells outside 1..4096, a size not in [1e-30, 1e38], NaN.
MeshData grid(int cellsX, int cellsZ, double sizeX = 1, double sizeZ = 1);

}  // namespace mv
