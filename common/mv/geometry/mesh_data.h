// The data of a mesh, before any GL: the shapes make it, gl/Mesh uploads it, the ray caster reads it.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "mv/math/types.h"

namespace mv {

// How vertices form triangles, lines or points: GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_LINES, GL_POINTS.
enum class Primitive { triangles, triangleStrip, triangleFan, lines, points };

// A mesh in model space, in float as the GPU stores it. Fronts are counter-clockwise.
// normals, colors and texCoords are empty (absent) or have one entry for each position. indices are empty (the vertices
// are taken in order) or name a position each. validate() in mv/geometry/check.h holds a mesh to this.
struct MeshData {
    Primitive primitive = Primitive::triangles;
    std::vector<fvec3> positions = {};
    std::vector<fvec3> normals = {};
    std::vector<fvec4> colors = {};
    std::vector<fvec2> texCoords = {};
    std::vector<std::uint32_t> indices = {};
    bool operator==(const MeshData&) const = default;
};

// The mesh without what a program does not read: it would be stored and fetched for nothing, and the audit names it.
inline MeshData withoutTexCoords(MeshData mesh) {
    mesh.texCoords.clear();
    return mesh;
}
inline MeshData withoutNormals(MeshData mesh) {
    mesh.normals.clear();
    return mesh;
}
inline MeshData positionsOnly(MeshData mesh) {
    mesh.colors.clear();
    return withoutTexCoords(withoutNormals(std::move(mesh)));
}

}  // namespace mv
