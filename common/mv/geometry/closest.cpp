#include "mv/geometry/closest.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"

namespace mv {

vec3 closestOnLine(const vec3& point, const vec3& a, const vec3& b) {
    requireFinite("closestOnLine", "the point", point);
    requireFinite("closestOnLine", "a", a);
    requireFinite("closestOnLine", "b", b);
    if (a == b) throw Error("closestOnLine", "a and b must differ", vectorText(a));
    const vec3 way = b - a;
    return a + glm::dot(point - a, way) / glm::dot(way, way) * way;
}

vec3 closestOnSegment(const vec3& point, const vec3& a, const vec3& b) {
    requireFinite("closestOnSegment", "the point", point);
    requireFinite("closestOnSegment", "a", a);
    requireFinite("closestOnSegment", "b", b);
    const vec3 way = b - a;
    const double along = glm::dot(point - a, way), whole = glm::dot(way, way);
    if (along <= 0) return a;
    if (along >= whole) return b;
    // From the nearer end, so that what is rounded is the shorter part
    return 2 * along <= whole ? a + along / whole * way : b - (whole - along) / whole * way;
}

vec3 closestOnPlane(const vec3& point, const vec4& plane) {
    requireFinite("closestOnPlane", "the point", point);
    requireFinite("closestOnPlane", "the plane", plane);
    const vec3 normal(plane);
    if (normal == vec3(0)) throw Error("closestOnPlane", "the normal must not be 0", vectorText(plane));
    return point - (glm::dot(normal, point) + plane.w) / glm::dot(normal, normal) * normal;
}

vec3 closestOnTriangle(const vec3& point, const vec3& a, const vec3& b, const vec3& c) {
    requireFinite("closestOnTriangle", "the point", point);
    for (const vec3& corner : {a, b, c}) requireFinite("closestOnTriangle", "a corner", corner);

    // Above the inside: on the inner side of all three edges, where an edge's side is told by the triangle's own normal
    const vec3 normal = accurateCross(b - a, c - a);
    const double area = glm::dot(normal, normal);
    const auto share = [&](const vec3& from, const vec3& to) {
        return glm::dot(normal, glm::cross(to - from, point - from));
    };
    const double ofA = share(b, c), ofB = share(c, a), ofC = share(a, b);
    if (area > 0 && ofA > 0 && ofB > 0 && ofC > 0) {
        const vec3 foot = point - glm::dot(normal, point - a) / area * normal;
        if (isFinite(foot)) return foot;
    }
    const vec3 edges[] = {closestOnSegment(point, a, b), closestOnSegment(point, b, c), closestOnSegment(point, c, a)};
    return *std::min_element(std::begin(edges), std::end(edges), [&](const vec3& one, const vec3& other) {
        return glm::distance(point, one) < glm::distance(point, other);
    });
}

}  // namespace mv
