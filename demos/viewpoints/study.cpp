// The readouts of viewpoints.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "mv/math/transform.h"
#include "viewpoints.h"

namespace mv::viewpoints {

// Measure the matrix that was used, whichever way it was made. Its inverse has the eye's place and axes as columns.
void readOut(Gpu&, const Settings& s, const Frame& frame, Numbers& numbers) {
    const Car car = carAt(frame.index());
    const mat4 worldFromView = inverse(lookFrom(s, car).viewFromWorld);
    const vec3 eye(worldFromView[3]), right(worldFromView[0]), upwards(worldFromView[1]), ahead(-worldFromView[2]);
    numbers.set("direction", car.direction);
    numbers.set("eye-height", eye.z);
    if (s.view != View::house) return;
    const vec3 wanted = watchedPlace(s) - eye;
    numbers.set("miss", degrees(std::atan2(length(cross(ahead, wanted)), dot(ahead, wanted))));
    numbers.set("roll", degrees(std::abs(std::atan2(right.z, upwards.z))));
}

}  // namespace mv::viewpoints
