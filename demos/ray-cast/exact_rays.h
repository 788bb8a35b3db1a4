// ray-cast's reference: the pixels' rays and what they meet, in long double and by other forms than the technique's.
#pragma once
#include <cstddef>
#include <optional>

#include "cast_objects.h"
#include "mv/demo/demo.h"
#include "mv/demo/study.h"

namespace mv::ray_cast {

using Long = long double;
using Long3 = glm::vec<3, Long>;

struct LongRay {
    Long3 origin, direction;
};
// The ray of that column and row, the upper row first. The demo's eye is computed again, so that the reference shares
// nothing with it; the ray is rounded as the demo rounds it.
LongRay exactRay(const Demo& demo, int column, int row, int side);

// The t of the first place on the object, at that scale; none for the teapot. `isFloat`: the numbers that are no floats are rounded as the
// technique rounds them.
std::optional<Long> exactHit(const LongRay& ray, CastKind kind, Long scale, bool isFloat);

// The study's references: reference.cpp. Whether the demo shows the objects of that kind.
bool isShown(const Demo& demo, std::size_t kind);
Reference teapotReference(const Demo& demo);
Reference longDouble(const Demo& demo);

}  // namespace mv::ray_cast
