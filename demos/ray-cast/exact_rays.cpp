#include "exact_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace mv::ray_cast {

LongRay exactRay(const Settings& s, int i, int j) {
    const vec3 w = glm::normalize(vec3(0.32, 0.42, 1)), u = glm::normalize(glm::cross(vec3(0, 1, 0), w));
    const double half = 0.53 * 9 / s.distance, middle = s.rows / 2.0;
    const vec3 eye = s.size * (vec3(0, 0.2, 0) + s.distance * w);
    const double x = half * (i + 0.5 - middle) / middle, y = half * (middle - (j + 0.5)) / middle;
    const vec3 way = glm::normalize(x * u + y * glm::cross(w, u) - w);
    if (s.precision == Precision::single) return {Long3(fvec3(eye)), Long3(fvec3(way))};
    return {Long3(eye), Long3(way)};
}

namespace {

// From the foot of the perpendicular on the ray.
std::optional<Long> sphereAt(const LongRay& ray, const Long3& center, Long radius) {
    const Long long2 = glm::dot(ray.direction, ray.direction);
    const Long toFoot = glm::dot(center - ray.origin, ray.direction) / long2;
    const Long3 miss = ray.origin + toFoot * ray.direction - center;
    const Long rest = radius * radius - glm::dot(miss, miss);
    if (rest < 0) return {};
    return toFoot - std::sqrt(rest / long2);
}

// Each face's plane, and whether the point is within the face.
std::optional<Long> boxAt(const LongRay& ray, const Long3& low, const Long3& high) {
    std::optional<Long> first;
    for (int axis = 0; axis < 3; ++axis) {
        for (const Long side : {low[axis], high[axis]}) {
            const Long t = (side - ray.origin[axis]) / ray.direction[axis];
            const Long3 at = ray.origin + t * ray.direction;
            const int one = (axis + 1) % 3, two = (axis + 2) % 3;
            const bool isWithin =
                at[one] >= low[one] && at[one] <= high[one] && at[two] >= low[two] && at[two] <= high[two];
            if (isWithin && t > 0 && (!first || t < *first)) first = t;
        }
    }
    return first;
}

// The volumes of tetrahedra tell on which side of each edge the ray passes.
std::optional<Long> triangleAt(const LongRay& ray, const Long3& a, const Long3& b, const Long3& c) {
    const auto passes = [&](const Long3& p, const Long3& q) {
        return glm::dot(glm::cross(p - ray.origin, q - ray.origin), ray.direction);
    };
    const Long one = passes(a, b), two = passes(b, c), three = passes(c, a);
    if (std::min({one, two, three}) < 0 && std::max({one, two, three}) > 0) return {};
    const Long3 normal = glm::cross(b - a, c - a);
    return glm::dot(normal, a - ray.origin) / glm::dot(normal, ray.direction);
}

// The ray among points of a tenth of a pixel: a change of side between them, then halved. z - z(x) is 0 on the flag.
std::optional<Long> flagAt(const LongRay& ray, Long size) {
    const auto side = [&](Long t) {
        const Long3 at = (ray.origin + t * ray.direction) / size;
        return at.z + 3 -
               static_cast<Long>(cast::flagWave) * std::sin(static_cast<Long>(cast::flagTurn) * (at.x - 0.25L) / 3);
    };
    const Long from = (-2 * size - ray.origin.z) / ray.direction.z, to = (-4 * size - ray.origin.z) / ray.direction.z;
    constexpr int parts = 400;
    for (int k = 0; k < parts; ++k) {
        Long near = from + (to - from) * k / parts, far = from + (to - from) * (k + 1) / parts;
        if ((side(near) > 0) == (side(far) > 0)) continue;
        for (int step = 0; step < 60; ++step) {
            const Long middle = (near + far) / 2;
            ((side(middle) > 0) == (side(near) > 0) ? near : far) = middle;
        }
        const Long3 at = (ray.origin + near * ray.direction) / size;
        if (at.x >= 0.25L && at.x <= 3.25L && at.y >= 1.25L && at.y <= 3) return near;
    }
    return {};
}

// How far a place is from a body round the y axis, at scale 1; below 0 inside of it.
Long distanceTo(CastKind kind, const Long3& place) {
    const Long out = std::hypot(place.x, place.z);
    if (kind == CastKind::torus) {
        const Long3 from = place - Long3(cast::aboveOrigin);
        return std::hypot(std::hypot(from.x, from.z) - static_cast<Long>(cast::torusMajor), from.y) -
               static_cast<Long>(cast::torusMinor);
    }
    // In the half plane (out, y): a rectangle or a triangle, the largest of the distances to its sides inside
    const Long radius = static_cast<Long>(kind == CastKind::cone ? cast::coneRadius : cast::cylinderRadius);
    const Long height = static_cast<Long>(kind == CastKind::cone ? cast::coneHeight : cast::cylinderHeight);
    if (kind == CastKind::cylinder) {
        const Long beyond = out - radius, above = std::abs(place.y - height / 2) - height / 2;
        return std::min(std::max(beyond, above), 0.0L) + std::hypot(std::max(beyond, 0.0L), std::max(above, 0.0L));
    }
    const Long side = std::hypot(radius, height), along = ((radius - out) * radius + place.y * height) / side;
    const Long fromSide = ((out - radius) * height + place.y * radius) / side;
    if (fromSide <= 0 && place.y >= 0) return std::max(fromSide, -place.y);
    const Long toSide = std::hypot(fromSide, along - std::clamp(along, 0.0L, side));
    return std::min(toSide, std::hypot(place.y, std::max(out - radius, 0.0L)));
}

// Walk on as far as nothing is near: no quadratic and no quartic is solved.
std::optional<Long> walkTo(CastKind kind, const LongRay& ray, Long size) {
    const Long unit = glm::length(ray.direction);
    Long t = (glm::length(ray.origin) - 4 * size) / unit;
    const Long end = t + 8 * size / unit;
    for (int step = 0; step < 20000 && t < end; ++step) {
        const Long near = distanceTo(kind, (ray.origin + t * ray.direction) / size) * size;
        if (near < 1e-15L * size) return t;
        t += near / unit;
    }
    return {};
}

std::optional<Long> diskAt(const LongRay& ray, Long size) {
    const Long3 center = size * Long3(cast::aboveOrigin), normal(cast::diskNormal);
    const Long t = glm::dot(normal, center - ray.origin) / glm::dot(normal, ray.direction);
    if (glm::distance(ray.origin + t * ray.direction, center) > size * static_cast<Long>(cast::diskRadius)) return {};
    return t;
}

}  // namespace

std::optional<Long> exactHit(const LongRay& ray, CastKind kind, Long size, bool isFloat) {
    const auto fan = [&](const Long3& middle, const auto& corners) {
        std::optional<Long> first;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto t =
                triangleAt(ray, middle, size * Long3(corners[i]), size * Long3(corners[(i + 1) % corners.size()]));
            if (t && (!first || *t < *first)) first = t;
        }
        return first;
    };
    switch (kind) {
        case CastKind::plane: {
            const vec3 a = cast::floorCorner, b = a + cast::floorAlong, c = b + cast::floorUp, d = a + cast::floorUp;
            return fan(Long3(0), std::array{a, b, c, d});
        }
        case CastKind::sphere:
            return sphereAt(ray, size * Long3(cast::sphereCenter), size);
        case CastKind::box:
            return boxAt(ray, size * Long3(cast::boxLow), size * Long3(cast::boxHigh));
        case CastKind::triangle:
            return triangleAt(ray, size * Long3(cast::triangle[0]), size * Long3(cast::triangle[1]),
                              size * Long3(cast::triangle[2]));
        case CastKind::polygon: {
            std::array<vec3, 10> star = cast::star();
            if (isFloat) std::ranges::transform(star, star.begin(), [](const vec3& p) { return vec3(fvec3(p)); });
            return fan(size * Long3(0.6L, 0.85L, 2), star);
        }
        case CastKind::transformed: {
            mat4 inverse = glm::inverse(cast::worldFromEllipsoid());
            if (isFloat) inverse = mat4(fmat4(inverse));
            const glm::mat<4, 4, Long> exact(inverse);
            const LongRay inside{Long3(exact * glm::vec<4, Long>(ray.origin / size, 1)),
                                 Long3(exact * glm::vec<4, Long>(ray.direction / size, 0))};
            return sphereAt(inside, Long3(0), 1);
        }
        case CastKind::surface:
            return flagAt(ray, size);
        case CastKind::teapot:
            break;
        case CastKind::cylinder:
        case CastKind::cone:
        case CastKind::torus:
            return walkTo(kind, ray, size);
        case CastKind::disk:
            return diskAt(ray, size);
    }
    return {};
}

}  // namespace mv::ray_cast
