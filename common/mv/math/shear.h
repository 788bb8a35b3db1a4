// Shears: what leans a thing without turning it.
#pragma once
#include "mv/math/types.h"

namespace mv {

// The matrix that moves a point along two axes by its coordinate on the third: shearX(y, z) adds y x to a point's y and z x to its z,
// and shearY and shearZ alike. Lines stay straight and volumes the same; angles do not. Any finite factors; NaN and infinity are
// refused. Oblique projections are a shearZ before an ortho(): cavalier shears by 1, cabinet by 1/2.
// Equals glm::shearX3D and so on; MV.js has none. Trap: the inverse has the negative factors, and normals go by normalMatrix().
mat4 shearX(double y, double z);
mat4 shearY(double x, double z);
mat4 shearZ(double x, double y);

}  // namespace mv
