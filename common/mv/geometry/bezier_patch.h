// Smooth surfaces made of bicubic Bezier patches: points, derivatives and normals, and the triangles that stand for them.
#pragma once
#include <array>
#include <span>

#include "mv/geometry/mesh_data.h"

namespace mv {

// 16 control points, row by row: point[4 * j + i] belongs to B_i(u) B_j(v). The surface passes through its four corners
// and stays within the convex hull of its points. Its front is where cross(alongU, alongV) points.
struct BezierPatch {
    std::array<vec3, 16> points;
};

// A point of a surface with its first derivatives by u and v.
struct SurfacePoint {
    vec3 position, alongU, alongV;
    vec3 normal;  // a unit vector to the front
};

// The patch at (u, v), by de Casteljau's algorithm. At the edges it reads no other control points than those of the edge,
// so patches that share an edge share its points bit for bit.
// The trap: where the four points of an edge are one (the tip of a lid), one derivative is 0 and their cross product says
// nothing; the normal is then the limit of the normals beside it, from the mixed derivative.
// Refused: u or v outside 0..1, NaN; a place that has no such limit, because more of it has collapsed; control points so
// large that a derivative overflows.
SurfacePoint pointOf(const BezierPatch& patch, double u, double v);

// The patches as one indexed mesh: divisions x divisions cells on each, two triangles a cell, less those that have
// collapsed to an edge; positions, unit normals, and texCoords (u, v) of each patch. Neighbours share no vertices, but
// their positions bit for bit. Refused: divisions outside 1..256, what pointOf refuses, and coordinates beyond 1e38.
MeshData tessellated(std::span<const BezierPatch> patches, int divisions);

}  // namespace mv
