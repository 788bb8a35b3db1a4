// The small pictures whose numbers the study of ray-trace compares: values.cpp; and the right numbers: reference.cpp.
#pragma once
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/study.h"
#include "passes.h"

namespace mv::ray_trace {

constexpr int valueColumns = 24, valueRows = 16, seeds = 8;

// All passes that count, one after the other.
TracePicture whole(const TracePicture::Plan& plan);
// The colours of the plan's picture, one ray for each pixel.
std::vector<double> colorsByOneRay(TracePicture::Plan plan);
inline double grey(const vec3& light) { return (light.x + light.y + light.z) / 3; }

Reference referenceOf(const Demo& demo);

}  // namespace mv::ray_trace
