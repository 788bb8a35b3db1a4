// The smooth surface below which a relief lies (shared/relief.h), in square patches: as the GPU's tessellator cuts them, and
// cut by the processor.
#pragma once
#include <array>
#include <vector>

#include "mv/geometry/mesh_data.h"
#include "shared/relief.h"

namespace mv {

// Corners at (u, v) = (0, 0), (1, 0), (0, 1), (1, 1), counter-clockwise seen from outside. Between the corners the wall's patch is
// flat; the orange's is the bilinear patch of the corners, drawn out to the sphere. Patches that share an edge have the same
// corners there, bit for bit.
using ReliefPatch = std::array<vec3, 4>;

// The wall's are squares from x = wallStart to wallEnd and y = -wallTop to wallTop, so that its upper and lower edges run
// through the middle of bricks; the orange's are 4 x 4 on each face of a cube.
inline constexpr double wallStart = -3, wallEnd = 33, wallTop = 0.75;
std::vector<ReliefPatch> reliefPatches(ReliefBody body);

// For GL_PATCHES with 4 vertices each: positions alone, in so many parts, each with patches from everywhere. Refused: no part.
std::vector<MeshData> patchCorners(const std::vector<ReliefPatch>& patches, int parts);

// All patches cut into cells x cells squares, as triangles: positions on the smooth surface, its normals and texture
// coordinates, which go on beyond 0..1 where the orange's seam is. Refused: cells outside 1 .. 64.
MeshData cutPatches(ReliefBody body, int cells);

// How finely a patch is cut: by the levels of its edges u = 0, v = 0, u = 1, v = 1, and of its inside.
struct PatchLevels {
    std::array<double, 4> outer{};
    double inner = 0;
    bool isLeftOut() const { return inner == 0; }
    // The triangles that the tessellator makes: 0 for a patch that is left out.
    long triangles() const;
    long vertices() const;
};
struct LevelRule {
    double fixedLevel = 0;  // of all edges; 0: by distance
    double fineness = 64;   // as edgeLevel() has it
    bool agrees = true;     // false: each patch has one level, by the distance of its middle
    vec3 eye{0};            // in the body's space
    bool leavesOut = true;  // a patch that nothing is seen of gets level 0
};
// shaders/displacement/patch.tesc has the same rule.
PatchLevels patchLevels(const Relief& relief, const ReliefPatch& patch, const LevelRule& rule,
                        const mat4& clipFromBody);

// Whether all of the patch, however its points are moved from the smooth surface down to the relief's depth, lies outside of
// one of the six planes of the view. Careful: near a corner of the view it may say no where nothing is seen.
bool isOutsideView(const Relief& relief, const ReliefPatch& patch, const mat4& clipFromBody);

struct PatchCount {
    long patches = 0, leftOut = 0;
    long outside = 0;                  // of the view, left out or not
    long triangles = 0, vertices = 0;  // that are made

    // Mesa's software renderers number the vertices that the tessellator makes in one draw with 16 bits, and lose triangles
    // where there are more. A part of eight has 12 patches of the 96, and 12 x 65 x 65 vertices at most.
    int partsToDraw() const { return vertices > 65536 ? 8 : 1; }
};
PatchCount countPatches(const std::vector<ReliefPatch>& patches, const Relief& relief, const LevelRule& rule,
                        const mat4& clipFromBody);

// How far heights between the texels of a map are off, as a root mean square, in units.
double heightMapError(const Relief& relief, int size);

}  // namespace mv
