#include "cast_objects.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "mv/geometry/quadric_ray.h"
#include "mv/math/transform.h"
#include "textbook_forms.h"

namespace mv {

std::array<vec3, 10> cast::star() {
    std::array<vec3, 10> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double angle = radians(90 + 36 * double(i)), radius = i % 2 == 0 ? 0.8 : 0.35;
        corners.at(i) = vec3(0.6 + radius * std::cos(angle), 0.85 + radius * std::sin(angle), 2);
    }
    return corners;
}

mat4 cast::worldFromEllipsoid() {
    return translate(2.75, 0.75, 1) * rotateY(35) * rotateZ(30) * mv::scale(1, 0.5, 0.6);
}

template <typename T>
SurfaceAt<T> cast::flag(T u, T v, T scale) {
    const T turn = static_cast<T>(flagTurn), high = static_cast<T>(flagWave), corner = static_cast<T>(0.25);
    const glm::vec<3, T> point(3 * u + corner, static_cast<T>(1.75) * v + 5 * corner, high * std::sin(turn * u) - 3);
    return {scale * point, scale * glm::vec<3, T>(3, 0, high * turn * std::cos(turn * u)),
            scale * glm::vec<3, T>(0, static_cast<T>(1.75), 0)};
}

namespace {

template <typename T>
using Vec = glm::vec<3, T>;

bool isStable(const CastWay& way) { return way.form == CastForm::stable; }
textbook::Print printOf(const CastWay& way) {
    return way.form == CastForm::printed ? textbook::Print::asPrinted : textbook::Print::mended;
}

template <typename T>
CastHit hitAt(T t, const Vec<T>& normal) {
    return {static_cast<double>(t), vec3(normal)};
}

template <typename T>
std::optional<CastHit> castPlane(T scale, const RayOf<T>& ray, const CastWay& way) {
    const Vec<T> corner = scale * Vec<T>(cast::floorCorner), along = scale * Vec<T>(cast::floorAlong),
                 up = scale * Vec<T>(cast::floorUp), normal(0, 1, 0);
    const glm::vec<4, T> abcd(normal, -glm::dot(normal, corner));
    std::optional<T> t;
    if (way.plane == PlaneForm::parametric) {
        if (const auto hit = intersectPlane(ray, corner, along, up)) t = hit->t;
    } else if (way.plane == PlaneForm::normal) {
        t = isStable(way) ? intersectPlane(ray, corner, normal) : textbook::plane(ray, corner, normal);
    } else {
        t = isStable(way) ? intersectPlane(ray, abcd) : textbook::plane(ray, abcd, printOf(way));
    }
    if (!t) return {};
    const Vec<T> from = ray.at(*t) - corner;  // the floor ends: u and v in 0..1
    if (std::min(from.x, from.z) < 0 || std::max(from.x, from.z) > 8 * scale) return {};
    return hitAt(*t, normal);
}

template <typename T>
std::optional<T> castBall(const RayOf<T>& ray, const Vec<T>& center, T radius, const CastWay& way) {
    if (!isStable(way)) return textbook::sphere(ray, center, radius);
    const auto inside = intersectSphere(ray, center, radius);
    if (!inside) return {};
    return inside->near > 0 ? inside->near : inside->far;
}

template <typename T>
std::optional<CastHit> castBox(T scale, const RayOf<T>& ray, const CastWay& way) {
    const Vec<T> low = scale * Vec<T>(cast::boxLow), high = scale * Vec<T>(cast::boxHigh);
    const auto inside = isStable(way) ? intersectBox(ray, low, high) : textbook::box(ray, low, high);
    if (!inside) return {};
    const T t = inside->near > 0 ? inside->near : inside->far;
    // The face whose plane is nearest to the point
    const Vec<T> point = ray.at(t), off = glm::min(glm::abs(point - low), glm::abs(point - high));
    const int axis = off.x <= off.y && off.x <= off.z ? 0 : off.y <= off.z ? 1 : 2;
    Vec<T> normal(0);
    normal[axis] = 1;
    return hitAt(t, normal);
}

template <typename T>
std::optional<CastHit> castTriangle(T scale, const RayOf<T>& ray, const CastWay& way) {
    const auto [pointA, pointB, pointC] = cast::triangle;
    const Vec<T> a = scale * Vec<T>(pointA), b = scale * Vec<T>(pointB), c = scale * Vec<T>(pointC);
    const auto hit = isStable(way) ? intersectTriangle(ray, a, b, c) : textbook::triangle(ray, a, b, c, printOf(way));
    if (!hit) return {};
    return hitAt(hit->t, glm::cross(b - a, c - a) / (scale * scale));
}

template <typename T>
std::optional<CastHit> castPolygon(T scale, const RayOf<T>& ray, const CastWay& way) {
    static const std::array<vec3, 10> star = cast::star();
    std::array<Vec<T>, 10> corners;
    for (std::size_t i = 0; i < star.size(); ++i) corners[i] = scale * Vec<T>(star[i]);
    const Vec<T> normal(0, 0, 1);
    if (isStable(way)) {
        const auto t = intersectPolygon(ray, std::span<const Vec<T>>(corners));
        return t ? std::optional(hitAt(*t, normal)) : std::nullopt;
    }
    const auto t = textbook::plane(ray, corners[0], normal);
    if (!t) return {};
    std::array<glm::vec<2, T>, 10> flat;
    for (std::size_t i = 0; i < star.size(); ++i) flat[i] = without(2, corners[i]);
    if (!textbook::isInside(std::span<const glm::vec<2, T>>(flat), without(2, ray.at(*t)))) return {};
    return hitAt(*t, normal);
}

template <typename T>
std::optional<CastHit> castEllipsoid(double scale, const RayOf<T>& ray, const CastWay& way) {
    static const mat4 inverse = glm::inverse(cast::worldFromEllipsoid());
    const glm::mat<4, 4, T> objectFromWorld(inverse * mv::scale(1 / scale, 1 / scale, 1 / scale));
    const RayOf<T> inside = transformed(ray, objectFromWorld);
    const auto t = castBall(inside, Vec<T>(0), static_cast<T>(1), way);
    if (!t) return {};
    return hitAt(*t, normalToWorld(inside.at(*t), objectFromWorld) * static_cast<T>(scale));
}

template <typename T>
std::optional<CastHit> castSurface(T scale, const RayOf<T>& ray, const CastWay& way) {
    const auto surface = [scale](T u, T v) { return cast::flag(u, v, scale); };
    const T half = static_cast<T>(0.5);
    const Vec<T> low(0.125, 1, -4), high(3.375, 3.25, -2);  // round all of it
    if (isStable(way) && !intersectBox(ray, scale * low, scale * high)) return {};
    const auto hit = isStable(way) ? intersectSurfaceFromGrid(ray, surface, way.cells)
                                   : intersectSurface(ray, surface, SurfaceHit<T>{0, half, half});
    if (!hit) return {};
    const SurfaceAt<T> at = cast::flag(hit->u, hit->v, static_cast<T>(1));
    return hitAt(hit->t, glm::cross(at.alongU, at.alongV));
}

// The normals of bodies of revolution, at a point on them.
template <typename T>
Vec<T> cylinderNormal(const Vec<T>& point, T radius, T height) {
    const T side = std::abs(std::hypot(point.x, point.z) - radius);
    const T lid = std::min(std::abs(point.y), std::abs(point.y - height));
    return side <= lid ? Vec<T>(point.x, 0, point.z) / radius : Vec<T>(0, 1, 0);
}
template <typename T>
Vec<T> coneNormal(const Vec<T>& point, T radius, T height) {
    const T out = std::hypot(point.x, point.z), slope = radius / height;
    if (point.y < std::abs(slope * (height - point.y) - out)) return {0, -1, 0};
    return {point.x, slope * out, point.z};
}
template <typename T>
Vec<T> torusNormal(const Vec<T>& point, T major) {
    const T out = std::hypot(point.x, point.z), inwards = major / out;
    return {point.x - inwards * point.x, point.y, point.z - inwards * point.z};
}

template <typename T>
std::optional<T> entryOf(const std::optional<RayInterval<T>>& inside) {
    if (!inside) return {};
    return inside->near > 0 ? inside->near : inside->far;
}

template <typename T>
std::optional<CastHit> castRound(CastKind kind, T scale, const RayOf<T>& ray) {
    const auto size = [scale](double length) { return scale * static_cast<T>(length); };
    const Vec<T> above = scale * Vec<T>(cast::aboveOrigin);
    const RayOf<T> fromAbove{ray.origin - above, ray.direction};
    std::optional<T> t;
    if (kind == CastKind::cylinder) {
        const T radius = size(cast::cylinderRadius), height = size(cast::cylinderHeight);
        t = entryOf(intersectCylinder(ray, radius, T(0), height));
        if (t) return hitAt(*t, cylinderNormal(ray.at(*t), radius, height));
    } else if (kind == CastKind::cone) {
        const T radius = size(cast::coneRadius), height = size(cast::coneHeight);
        t = entryOf(intersectCone(ray, radius, height));
        if (t) return hitAt(*t, coneNormal(ray.at(*t), radius, height) / scale);
    } else if (kind == CastKind::disk) {
        const Vec<T> normal(cast::diskNormal);
        t = intersectDisk(ray, above, normal, size(cast::diskRadius));
        if (t) return hitAt(*t, normal);
    } else {
        t = intersectTorus(fromAbove, size(cast::torusMajor), size(cast::torusMinor));
        if (t) return hitAt(*t, torusNormal(fromAbove.at(*t), size(cast::torusMajor)) / scale);
    }
    return {};
}

}  // namespace

template <typename T>
std::optional<CastHit> castAt(CastKind kind, double scale, const RayOf<T>& ray, const CastWay& way) {
    const T size = static_cast<T>(scale);
    std::optional<CastHit> hit;
    switch (kind) {
        case CastKind::plane:
            hit = castPlane(size, ray, way);
            break;
        case CastKind::sphere: {
            const Vec<T> center = size * Vec<T>(cast::sphereCenter);
            const auto t = castBall(ray, center, size * static_cast<T>(cast::sphereRadius), way);
            if (t) hit = hitAt(*t, (ray.at(*t) - center) / size);
            break;
        }
        case CastKind::box:
            hit = castBox(size, ray, way);
            break;
        case CastKind::triangle:
            hit = castTriangle(size, ray, way);
            break;
        case CastKind::polygon:
            hit = castPolygon(size, ray, way);
            break;
        case CastKind::transformed:
            hit = castEllipsoid(scale, ray, way);
            break;
        case CastKind::surface:
            hit = castSurface(size, ray, way);
            break;
        case CastKind::teapot:
            break;
        case CastKind::cylinder:
        case CastKind::cone:
        case CastKind::disk:
        case CastKind::torus:
            hit = castRound(kind, size, ray);
            break;
    }
    if (!hit || !(hit->t > 0) || !std::isfinite(hit->t)) return {};
    return hit;
}
template std::optional<CastHit> castAt(CastKind, double, const RayOf<float>&, const CastWay&);
template std::optional<CastHit> castAt(CastKind, double, const RayOf<double>&, const CastWay&);
template SurfaceAt<float> cast::flag(float, float, float);
template SurfaceAt<double> cast::flag(double, double, double);
template SurfaceAt<long double> cast::flag(long double, long double, long double);

}  // namespace mv
