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
std::optional<RayInterval<T>> intersectSphere(const RayOf<T>& ray, const glm::vec<3, T>& center, T radius) {
    const glm::vec<3, T> fromCenter = ray.origin - center;
    const T a = glm::dot(ray.direction, ray.direction);
    const T b = -glm::dot(fromCenter, ray.direction);
    // From the centre to the nearest point of the line: as long as the miss distance, however far the origin is.
    const glm::vec<3, T> miss = fromCenter + (b / a) * ray.direction;
    const T missLength = std::sqrt(glm::dot(miss, miss));
    const T discriminant = a * (radius - missLength) * (radius + missLength);
    if (!(discriminant >= 0 && radius > 0)) return {};
    // The root that adds numbers of one sign, and the other one by the product of both.
    const T length = std::sqrt(glm::dot(fromCenter, fromCenter));
    const T q = b + std::copysign(std::sqrt(discriminant), b);
    T near = (length - radius) * (length + radius) / q;
    T far = q / a;
    if (b < 0) std::swap(near, far);
    if (q == 0) near = far = 0;  // touches the sphere at its own origin
    if (!(far >= 0) || !isNumber(near) || !isNumber(far)) return {};
    return RayInterval<T>{near, far};
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
template std::optional<RayInterval<float>> intersectSphere(const RayOf<float>&, const fvec3&, float);
template std::optional<RayInterval<double>> intersectSphere(const RayOf<double>&, const vec3&, double);
template std::optional<RayInterval<float>> intersectBox(const RayOf<float>&, const fvec3&, const fvec3&);
template std::optional<RayInterval<double>> intersectBox(const RayOf<double>&, const vec3&, const vec3&);

}  // namespace mv
