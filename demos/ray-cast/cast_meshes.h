// The objects that ray-cast's rays meet, as triangles.
#pragma once
#include <vector>

#include "cast_objects.h"
#include "mv/geometry/bvh.h"
#include "mv/geometry/scene.h"

namespace mv {

// The objects as triangles, named by their kinds, each placed in the world but for the scale; not the teapot.
SceneObject castMesh(CastKind kind, double scale);
// And as they stand in the world at scale 1; the teapot with `teapotCells` cells a side on each patch. SceneTriangle::object is
// the kind.
std::vector<SceneTriangle> castTriangles(const std::vector<CastKind>& kinds, int teapotCells);

}  // namespace mv
