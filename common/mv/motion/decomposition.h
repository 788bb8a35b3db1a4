// A model matrix taken apart into translation, rotation and scale.
#pragma once
#include "mv/math/types.h"
#include "mv/motion/orientation.h"

namespace mv {

// m = translate(translation) * rotationMatrix(rotation) * scale(scale).
struct Decomposition {
    vec3 translation{0};
    quat rotation;
    vec3 scale{1};
};

// The parts of m, which takes points of a model to its parent's space. Any scales, 1e-200 and 0 included, so that
// things can be keyed to grow from nothing: the direction of an axis of scale 0 is not in the matrix, and is completed
// to perpendicular axes, right-handed (without any axis left: no rotation). A mirror has scale.x < 0: which axis was
// mirrored is not in the matrix either, and scale(1, -1, 1) comes back as scale (-1, 1, 1) and half a turn about z, the
// same matrix.
// Refused: NaN, infinity, a last row other than 0 0 0 1 (a projection), axes that are not perpendicular to 1e-6 (shear,
// of which the amount is said; these three parts cannot make it), overflow.
// GLM's gtx decompose takes shear and perspective off, too, and returns false where the determinant is below its
// epsilon: in float for a scale of 4e-3.
// Trap: the parts of a product of matrices are not the products of parts: a scale that is not uniform under a rotation
// shears.
Decomposition decompose(const mat4& m);

}  // namespace mv
