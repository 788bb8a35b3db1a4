// The bodies of cube-cull: a cube, and a teapot with its lid or without.
#include <utility>
#include <vector>

#include "cube-cull.h"
#include "mv/geometry/bezier_patch.h"
#include "mv/geometry/teapot.h"

namespace mv::cube_cull {

// The teapot's colours are its normals': red to +x, green to +y, blue to +z. Without its lid one looks into it.
MeshData bodyOf(const Settings& s) {
    if (s.body == Body::cube) return colorCube();
    std::vector<BezierPatch> patches = teapot();
    constexpr int firstOfLid = 12, patchesOfLid = 8;
    if (s.body == Body::openTeapot)
        patches.erase(patches.begin() + firstOfLid, patches.begin() + firstOfLid + patchesOfLid);
    MeshData mesh = tessellated(patches, s.divisions);
    for (fvec3& position : mesh.positions) position = 0.45F * (position - fvec3(0.25, 1.5, 0));
    for (const fvec3& normal : mesh.normals) mesh.colors.emplace_back(0.5F + 0.5F * normal, 1);
    return withoutTexCoords(withoutNormals(std::move(mesh)));
}

// Where the corners of the body's triangles are for OpenGL, three of each.
std::vector<fvec4> clipCorners(const MeshData& mesh, const Settings& s, double aspect) {
    const fmat4 clipFromModel(clipFromView(aspect) * viewFromModel(s));
    std::vector<fvec4> corners;
    const std::size_t count = mesh.indices.empty() ? mesh.positions.size() : mesh.indices.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t corner = mesh.indices.empty() ? i : mesh.indices[i];
        corners.push_back(clipFromModel * fvec4(mesh.positions[corner], 1));
    }
    return corners;
}

}  // namespace mv::cube_cull
