// Shadow volumes: the space that a solid keeps from a light, as a closed surface for the stencil buffer to count.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mv/geometry/mesh_data.h"

namespace mv {

// A closed mesh as its triangles and the edges between them: what a silhouette is found in. Made once for a mesh, asked
// again each time the light moves.
class ClosedMesh {
  public:
    // An edge between two triangles: triangle[0] runs it from vertex[0] to vertex[1], triangle[1] the other way.
    struct Edge {
        std::array<std::uint32_t, 2> vertex;
        std::array<std::uint32_t, 2> triangle;
    };

    // Vertices at exactly the same position become one, so that seams and hard edges, which repeat them for the sake of
    // normals and texture coordinates, do not tear the surface; triangles of which two corners coincide are left out.
    // Refused, as Error("mesh <name>", ...): a mesh in which an edge is not shared by exactly two triangles, which run it
    // in opposite directions (a hole, a third leaf, a triangle wound the wrong way); one without triangles; and what
    // validate() refuses.
    explicit ClosedMesh(const MeshData& mesh, const std::string& name = "");

    // Each different position once, as the mesh has it.
    const std::vector<fvec3>& positions() const { return positions_; }
    // Three of those each, in the order in which GL draws them; counter-clockwise from outside.
    const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return triangles_; }
    // Half as many again as there are triangles.
    const std::vector<Edge>& edges() const { return edges_; }

  private:
    std::vector<fvec3> positions_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<Edge> edges_;
};

// For each triangle, whether its front is turned towards the light, (x, y, z, w) in the space of the mesh: a point for
// w > 0, the direction towards a light at infinity for w = 0. A triangle in whose plane the light lies is not. Refused:
// a light (0, 0, 0, 0) or with w < 0, NaN, infinity.
std::vector<bool> facesLight(const ClosedMesh& mesh, const vec4& light);

// The edges at which a triangle that faces the light meets one that does not, from vertex[0] to vertex[1] as the facing
// one, triangle[0], runs them. The edges form closed loops. Refuses what facesLight refuses.
std::vector<ClosedMesh::Edge> silhouette(const ClosedMesh& mesh, const vec4& light);

// Which edges a volume is drawn out from: those of the silhouette, or all three of each triangle that faces the light.
enum class Extrude { silhouette, everyTriangle };

// A closed surface of triangles in homogeneous coordinates, in the space of the mesh: points with w = 1, and with w = 0
// the points at infinity (directions) that the light throws them to. Fronts are counter-clockwise from outside. The
// indices are those of the sides, then of the light cap, then of the dark cap.
struct ShadowVolume {
    std::vector<fvec4> positions;
    std::vector<std::uint32_t> indices;
    std::size_t sides = 0, lightCap = 0, darkCap = 0;  // how many indices each has
    std::size_t edges = 0;                             // drawn out to infinity
};

// The volume that the mesh keeps from the light. A point outside the solid is in shadow exactly where the surface winds
// round it: as often as the way to the light leaves the solid. Its parts:
// - sides: each edge drawn out to infinity, two triangles (one, when the light is at infinity: all edges end in one
//   point there);
// - light cap: the triangles that face the light, with the corners, and in the order, in which GL draws them, so that
//   drawn through the same matrix they have exactly the depth of the solid itself;
// - dark cap, at infinity: with Extrude::silhouette the triangles that do not face the light, thrown there (so a light
//   inside the solid darkens everything); with everyTriangle each facing one's own, turned over. None for a light at
//   infinity, where it would be a point.
// Draw it with infinitePerspective(): a far plane cuts off what is at infinity. Between the eye and a surface there are
// never caps that the surface's own solid does not hide, so counting by z-pass needs only the sides.
// With everyTriangle the volume is one prism for each facing triangle, the same shadow for much more work.
// Refuses what facesLight refuses, and a light so far away that a direction overflows a float.
// Source: Everitt and Kilgard, "Practical and Robust Stenciled Shadow Volumes" (2002).
ShadowVolume shadowVolume(const ClosedMesh& mesh, const vec4& light, Extrude extrude = Extrude::silhouette);

// How often the volume that the mesh keeps from the light winds round a point: the number of facing triangles between
// the point and the light. The number of volumes that an eye is in is the one at which z-pass starts counting. A point
// exactly on the volume's surface may get either answer. Refuses what facesLight refuses.
int volumesAround(const ClosedMesh& mesh, const vec4& light, const vec3& point);

}  // namespace mv
