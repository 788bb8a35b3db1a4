// Many triangles, and four ways to find the first that a ray meets. The structures differ in time only: the answer is
// the same, bit for bit.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "mv/geometry/bvh.h"
#include "mv/geometry/ray.h"

namespace mv {

// none: every triangle is asked. boxes: every triangle of the objects whose bounding box the ray meets. grid: the triangles of
// the equal cells along the ray, one cell after the other. tree: a bounding volume hierarchy.
enum class RayStructure { none, boxes, grid, tree };

class TriangleFinder {
  public:
    virtual ~TriangleFinder() = default;
    // The hit of smallest t; of several at the same t the one of the lowest object, then triangle.
    virtual std::optional<BvhHit> nearest(const Ray& ray) const = 0;
};

// Source of the grid's walk: Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing" (1987).
std::unique_ptr<const TriangleFinder> findTriangles(RayStructure structure, std::vector<SceneTriangle> triangles);

// The Utah teapot on the floor y = 0, 1.6 high, with cells x cells x 2 triangles for each of its 32 patches, less those
// that have collapsed; a patch is an object.
std::vector<SceneTriangle> teapotTriangles(int cells);

}  // namespace mv
