// ray-cast's reference: the pixels' rays and what they meet, in long double and by other forms than the technique's.
#pragma once
#include <cstddef>
#include <optional>

#include "cast_objects.h"
#include "mv/demo/study.h"
#include "ray-cast.h"

namespace mv::ray_cast {

using Long = long double;
using Long3 = glm::vec<3, Long>;

struct LongRay {
    Long3 origin, direction;
};
// The ray of that column and row, the upper row first. The technique's eye is computed again, so that the reference shares
// nothing with it; the ray is rounded as the technique rounds it.
LongRay exactRay(const Settings& s, int column, int row);

// The t of the first place on the object, at that scale; none for the teapot. `isFloat`: the numbers that are no floats are rounded as the
// technique rounds them.
std::optional<Long> exactHit(const LongRay& ray, CastKind kind, Long scale, bool isFloat);

// The study's references: reference.cpp. Whether objects of that kind are shown.
bool isShown(const Settings& s, std::size_t kind);
Reference teapotReference(const Settings& s);
Reference longDouble(const Settings& s);

}  // namespace mv::ray_cast
