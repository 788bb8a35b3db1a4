#include "mv/geometry/ray.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace mv {
namespace {

template <typename T>
bool isNumber(T x) {
    return x - x == 0;
}

}  // namespace

template <typename T>
std::optional<T> intersectPlane(const RayOf<T>& ray, const glm::vec<4, T>& plane) {
    const glm::vec<3, T> normal(plane);
    const T along = glm::dot(normal, ray.direction);
    const T t = -(glm::dot(normal, ray.origin) + plane.w) / along;
    if (along == 0 || !(t >= 0) || !isNumber(t)) return {};
    return t;
}

template <typename T>
std::optional<RayInterval<T>> intersectBox(const RayOf<T>& ray, const glm::vec<3, T>& lo, const glm::vec<3, T>& hi) {
    T near = -std::numeric_limits<T>::infinity(), far = std::numeric_limits<T>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const T from = ray.origin[axis], along = ray.direction[axis];
        if (!isNumber(from) || !isNumber(along) || !(lo[axis] <= hi[axis])) return {};
        if (along == 0) {
            // Between the two planes for ever, or never: 0/0 is not asked.
            if (from < lo[axis] || from > hi[axis]) return {};
            continue;
        }
        const T first = ((along > 0 ? lo : hi)[axis] - from) / along;
        const T last = ((along > 0 ? hi : lo)[axis] - from) / along;
        near = std::max(near, first);
        far = std::min(far, last);
    }
    if (!(near <= far && far >= 0) || !isNumber(near) || !isNumber(far)) return {};
    return RayInterval<T>{near, far};
}

template std::optional<float> intersectPlane(const RayOf<float>&, const fvec4&);
template std::optional<double> intersectPlane(const RayOf<double>&, const vec4&);
template std::optional<RayInterval<float>> intersectBox(const RayOf<float>&, const fvec3&, const fvec3&);
template std::optional<RayInterval<double>> intersectBox(const RayOf<double>&, const vec3&, const vec3&);

}  // namespace mv
