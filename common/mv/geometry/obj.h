// Meshes from Wavefront OBJ files, as modelling programs write them.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "mv/geometry/mesh_data.h"

namespace mv {

struct ObjMesh {
    // Indexed triangles with positions and unit normals, and with texCoords where the file has any: a vertex for each position,
    // texture coordinate and normal that some corner has together, in the order in which they first occur.
    MeshData mesh;
    // Points and lines, which the mesh leaves out.
    std::size_t leftOut = 0;
};

// The triangles of a file's text. Polygons of any number of corners are cut from their first one, which suits convex ones. A corner
// without a normal gets that of its face, so a file without normals is faceted; one without texture coordinates, in a file that has
// some, gets (0, 0). Indices count from 1, or backwards from -1; names may have any bytes (Windows-1252, UTF-8); lines end in
// LF, CRLF or CR, and a \ at the end of one continues it; a byte order mark is skipped. Materials, groups and smoothing are not
// read, nor a position's fourth number or its colour.
// Refused, with `name` and the line: a number that is none, is not finite or does not fit into floats; an index of 0 or of what the
// file has not; a face with fewer than 3 corners; curves and surfaces (vp, cstype, curv, surf and what belongs to them);
// statements that are none of OBJ's; a file without faces.
// Trap: a polygon that is not convex comes out wrong, and one without area has the normal (0, 1, 0).
// Source: Wavefront, "Advanced Visualizer" manual, appendix B1, "Object files".
ObjMesh meshFromObj(std::string_view text, const std::string& name);

}  // namespace mv
