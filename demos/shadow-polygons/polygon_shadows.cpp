#include "polygon_shadows.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "mv/error.h"
#include "mv/geometry/closest.h"
#include "mv/math/clip.h"
#include "mv/math/robust.h"
#include "mv/math/shadow.h"

namespace mv {
namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();

// Twice the area, along the normal: counter-clockwise about it. Differences of corners lose no digits to where the polygon is.
vec3 doubleAreaOf(const std::vector<vec3>& corners) {
    vec3 sum(0);
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum += accurateCross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return sum;
}

double sizeOf(const std::vector<vec3>& corners) {
    double most = 0;
    for (const vec3& corner : corners) most = std::max(most, largestComponent(corner));
    return most;
}

}  // namespace

std::optional<Receiver> receiverOf(const FlatPolygon& polygon, const vec3& light) {
    const vec3 doubled = doubleAreaOf(polygon.corners);
    if (doubled == vec3(0)) throw Error("polygon", "must have an area");
    Receiver receiver;
    receiver.origin = polygon.corners[0];
    receiver.area = polygonArea(polygon.corners);
    receiver.size = sizeOf(polygon.corners);
    const vec3 normal = unit(doubled);
    const vec4 plane(normal, 0), lightHere(light - receiver.origin, 1);
    const int side = lightSide(lightHere, plane);
    if (side == 0) return {};
    receiver.normal = double(side) * normal;
    receiver.shadowFromCaster = shadowProjection(lightHere, plane);
    receiver.bounds = shadowCasterBounds(lightHere, plane);
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const vec3 corner = polygon.corners[i] - receiver.origin;
        const vec3 along = polygon.corners[(i + 1) % polygon.corners.size()] - polygon.corners[i];
        const vec3 inwards = glm::cross(normal, along);
        receiver.edges.emplace_back(inwards, -glm::dot(inwards, corner));
    }
    return receiver;
}

std::vector<vec3> shadowOn(const Receiver& receiver, const FlatPolygon& caster) {
    // Cut off what lies behind the receiver's plane or beyond the light. The plane is known but for some roundings of the
    // coordinates: what is nearer to it than these, as a neighbour in the same plane, is in it
    std::vector<vec4> shadow;
    for (const vec3& corner : caster.corners) shadow.emplace_back(corner - receiver.origin, 1);
    std::array<vec4, 2> bounds = receiver.bounds;
    bounds[0].w -= 8 * rounding * (receiver.size + sizeOf(caster.corners));
    shadow = clipPolygon(std::move(shadow), bounds);

    // Project it, and clip it to the receiver before the division by w: a corner at the light's height has w = 0
    for (vec4& corner : shadow) corner = receiver.shadowFromCaster * corner;
    shadow = clipPolygon(std::move(shadow), receiver.edges);

    std::vector<vec3> corners;
    for (const vec4& corner : shadow) corners.push_back(receiver.origin + vec3(corner) / corner.w);
    if (corners.size() < 3 || !(polygonArea(corners) > 1e-14 * receiver.area)) return {};
    if (glm::dot(doubleAreaOf(corners), receiver.normal) < 0) std::reverse(corners.begin(), corners.end());
    return corners;
}

Cap capOf(const FlatPolygon& polygon, const vec3& light) {
    Cap cap{.nearest = std::numeric_limits<double>::infinity()};
    for (std::size_t i = 2; i < polygon.corners.size(); ++i) {
        const vec3 there = closestOnTriangle(light, polygon.corners[0], polygon.corners[i - 1], polygon.corners[i]);
        cap.nearest = std::min(cap.nearest, glm::distance(light, there));
    }
    for (const vec3& corner : polygon.corners) cap.farthest = std::max(cap.farthest, glm::distance(light, corner));
    if (cap.nearest == 0) return cap;

    // About the mean of the corners' directions
    std::vector<vec3> directions;
    vec3 sum(0);
    for (const vec3& corner : polygon.corners) sum += directions.emplace_back(unit(corner - light));
    if (glm::dot(sum, sum) < 1e-12) return cap;
    cap.axis = unit(sum);
    double chord = 0;
    for (const vec3& direction : directions) chord = std::max(chord, glm::distance(cap.axis, direction));
    // A cap of less than a half sphere that holds the corners holds all between them
    if (chord < 1.4) cap.chord = chord;
    return cap;
}

// The angle between two axes is at most the sum of the caps' angles; then the distance is at most the sum of their chords.
bool mayOverlap(const Cap& a, const Cap& b) {
    return glm::distance(a.axis, b.axis) <= a.chord + b.chord + 8 * rounding;
}

bool mayHide(const Cap& caster, const Cap& receiver) {
    return caster.nearest <= receiver.farthest * (1 + 8 * rounding);
}

Pairs allPairs(std::size_t count) {
    Pairs pairs;
    for (std::size_t receiver = 0; receiver < count; ++receiver) {
        for (std::size_t caster = 0; caster < count; ++caster) {
            if (caster != receiver) pairs.kept.push_back({receiver, caster});
        }
    }
    return pairs;
}

Pairs pairsOnSphere(const std::vector<Cap>& caps) {
    // Sort the caps by where they begin in x
    const auto begin = [&caps](std::size_t i) { return caps[i].axis.x - caps[i].chord; };
    const auto end = [&caps](std::size_t i) { return caps[i].axis.x + caps[i].chord; };
    std::vector<std::size_t> order(caps.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) { return begin(i) < begin(k); });

    // Compare each with those that begin before it ends
    Pairs pairs;
    for (std::size_t first = 0; first < order.size(); ++first) {
        const std::size_t i = order[first];
        for (std::size_t next = first + 1; next < order.size(); ++next) {
            const std::size_t k = order[next];
            if (begin(k) > end(i) + 8 * rounding) break;
            ++pairs.tested;
            if (!mayOverlap(caps[i], caps[k])) continue;
            if (mayHide(caps[i], caps[k])) pairs.kept.push_back({k, i});
            if (mayHide(caps[k], caps[i])) pairs.kept.push_back({i, k});
        }
    }
    std::sort(pairs.kept.begin(), pairs.kept.end());
    return pairs;
}

}  // namespace mv
