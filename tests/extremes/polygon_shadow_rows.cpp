// X60: shadows of polygons on polygons, and which pairs a sphere round the light tells to try.
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <vector>

#include "extremes/row.h"
#include "mv/geometry/ray.h"
#include "mv/math/clip.h"
#include "shadow-polygons/polygon_shadows.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

using Shadow =
    std::function<std::vector<vec3>(const FlatPolygon& receiver, const FlatPolygon& caster, const vec3& light)>;

std::vector<vec3> ours(const FlatPolygon& receiver, const FlatPolygon& caster, const vec3& light) {
    const auto made = receiverOf(receiver, light);
    return made ? shadowOn(*made, caster) : std::vector<vec3>();
}

// As the slide has it: each corner of the caster moved along its ray onto the receiver's plane, and the polygon clipped there.
std::vector<vec3> textbookShadow(const FlatPolygon& receiver, const FlatPolygon& caster, const vec3& light) {
    const std::vector<vec3>& on = receiver.corners;
    const vec3 normal = glm::normalize(glm::cross(on[1] - on[0], on[2] - on[0]));
    std::vector<vec4> corners, edges;
    for (const vec3& corner : caster.corners) {
        const vec3 at = light + glm::dot(normal, on[0] - light) / glm::dot(normal, corner - light) * (corner - light);
        if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(at.z)) return {};
        corners.emplace_back(at, 1);
    }
    for (std::size_t i = 0; i < on.size(); ++i) {
        const vec3 inwards = glm::cross(normal, on[(i + 1) % on.size()] - on[i]);
        edges.emplace_back(inwards, -glm::dot(inwards, on[i]));
    }
    std::vector<vec3> dark;
    for (const vec4& corner : clipPolygon(corners, edges)) dark.emplace_back(corner);
    return dark.size() < 3 ? std::vector<vec3>() : dark;
}

FlatPolygon quadrilateral(const vec3& middle, const vec3& u, const vec3& v) {
    return {{middle - u - v, middle + u - v, middle + u + v, middle - u + v}};
}

bool holds(const std::vector<vec3>& corners, const vec3& point) {
    if (corners.empty()) return false;
    vec3 normal(0);
    for (std::size_t i = 2; i < corners.size(); ++i)
        normal += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const vec3 along = corners[(i + 1) % corners.size()] - corners[i];
        if (glm::dot(normal, glm::cross(along, point - corners[i])) < 0) return false;
    }
    return true;
}

bool isHidden(const FlatPolygon& caster, const vec3& point, const vec3& light) {
    const TriangleTest<double> ray({point, light - point});
    for (std::size_t i = 2; i < caster.corners.size(); ++i) {
        const auto hit = ray(caster.corners[0], caster.corners[i - 1], caster.corners[i]);
        if (hit && hit->t < 1) return true;
    }
    return false;
}

const vec3 light(0.3, 4, -0.2);

// Points of a floor that are dark and ought to be lit, or the other way round, by rays: 100 for each of 200 casters, whose middles
// have their heights from `low` to `high`.
double wrongPoints(const Shadow& shadow, double low, double high) {
    const FlatPolygon floor = quadrilateral(vec3(0), vec3(9, 0, 0), vec3(0, 0, -9));
    Random random(60);
    double wrong = 0;
    for (int i = 0; i < 200; ++i) {
        const vec3 u = random.direction(), v = glm::normalize(glm::cross(u, random.direction()));
        const vec3 middle(random.number(-3, 3), random.number(low, high), random.number(-3, 3));
        const FlatPolygon caster = quadrilateral(middle, u, v);
        const std::vector<vec3> dark = shadow(floor, caster, light);
        for (int k = 0; k < 100; ++k) {
            const vec3 point(random.number(-9, 9), 0, random.number(-9, 9));
            wrong += holds(dark, point) == isHidden(caster, point, light) ? 0 : 1;
        }
    }
    return wrong;
}

Row cut(const std::string& id, const std::string& where, double low, double high) {
    return {.id = id,
            .input = "200 squares " + where + ", a light at 4 over a floor",
            .measured = "points of the floor, of 20 000, that are lit or dark against their ray to the light",
            .naive = "each corner moved along its ray onto the plane",
            .naiveError = wrongPoints(textbookShadow, low, high),
            .ours = "shadowOn: cut off at the plane and at the light's height first",
            .ourError = wrongPoints(ours, low, high),
            .tolerance = 0,
            .reason = "no point is as near to an edge as roundings are large"};
}
[[maybe_unused]] const bool beyond =
    addRow([] { return cut("X60 beyond", "half below and half above the light", 3.2, 4.8); });
[[maybe_unused]] const bool through =
    addRow([] { return cut("X60 cutting", "that cut through the floor", -0.8, 0.8); });
[[maybe_unused]] const bool behind = addRow([] { return cut("X60 under", "under the floor", -5, -1.5); });

// Squares that overlap in one plane, turned anyhow, 1 to 10 from the origin.
double shadowsInPlane(const Shadow& shadow) {
    Random random(61);
    double shadows = 0;
    for (int i = 0; i < 1000; ++i) {
        const vec3 u = random.direction(), v = glm::normalize(glm::cross(u, random.direction())),
                   middle = random.point(10);
        const FlatPolygon one = quadrilateral(middle, u, v), other = quadrilateral(middle + 0.3 * u + 0.7 * v, u, v);
        shadows += shadow(one, other, random.point(10)).empty() ? 0 : 1;
    }
    return shadows;
}
[[maybe_unused]] const bool inPlane = addRow([] {
    return Row{.id = "X60 in plane",
               .input = "1000 pairs of squares that overlap in one plane, but for the roundings of their corners",
               .measured = "pairs of which one throws a shadow on the other",
               .naive = "each corner moved along its ray onto the plane",
               .naiveError = shadowsInPlane(textbookShadow),
               .ours = "shadowOn: what is nearer to the plane than some roundings is in it",
               .ourError = shadowsInPlane(ours),
               .tolerance = 0,
               .reason = "they touch; neither stands before the other"};
});

// The light in the plane of receiver and caster, but for its rounding, 2 to 6 beside the receiver.
double litFromTheSide(const Shadow& shadow) {
    Random random(62);
    double shadows = 0;
    for (int i = 0; i < 1000; ++i) {
        const vec3 u = random.direction(), v = glm::normalize(glm::cross(u, random.direction())),
                   middle = random.point(3);
        const FlatPolygon receiver = quadrilateral(middle, u, v);
        const vec3 beside = middle + random.number(2, 6) * u + random.number(-1, 1) * v;
        const FlatPolygon caster = quadrilateral((middle + beside) / 2.0, 0.3 * u, 0.5 * v);
        shadows += shadow(receiver, caster, beside).empty() ? 0 : 1;
    }
    return shadows;
}
[[maybe_unused]] const bool fromTheSide = addRow([] {
    return Row{.id = "X60 side",
               .input = "1000 lights in the plane of receiver and caster, but for their rounding",
               .measured = "receivers with a dark part and a lit one, though no side is lit",
               .naive = "each corner moved along its ray onto the plane",
               .naiveError = litFromTheSide(textbookShadow),
               .ours = "receiverOf: no side is lit",
               .ourError = litFromTheSide(ours),
               .tolerance = 0,
               .reason = "the light lies in the plane"};
});

using Overlap = std::function<bool(const FlatPolygon& receiver, const FlatPolygon& caster, const vec3& light)>;

bool bySphere(const FlatPolygon& receiver, const FlatPolygon& caster, const vec3& from) {
    const Pairs pairs = pairsOnSphere({capOf(receiver, from), capOf(caster, from)});
    return std::ranges::find(pairs.kept, CasterOn{0, 1}) != pairs.kept.end();
}

// Angles between directions by the inverse cosine.
bool byCosines(const FlatPolygon& receiver, const FlatPolygon& caster, const vec3& from) {
    const Cap a = capOf(receiver, from), b = capOf(caster, from);
    const auto radius = [&](const FlatPolygon& polygon, const Cap& cap) {
        double most = 0;
        for (const vec3& corner : polygon.corners)
            most = std::max(most, std::acos(std::min(1.0, glm::dot(cap.axis, glm::normalize(corner - from)))));
        return most;
    };
    return std::acos(std::min(1.0, glm::dot(a.axis, b.axis))) <= radius(receiver, a) + radius(caster, b);
}

// Pairs that are left out though they have a shadow: the ray to the light from a point of the receiver meets the caster.
double lostFarAway(const Overlap& overlap) {
    Random random(63);
    double lost = 0;
    for (int i = 0; i < 1000; ++i) {
        const vec3 from = 1e8 * random.direction();
        const vec3 u = random.direction(), v = glm::normalize(glm::cross(u, random.direction())),
                   middle = random.point(3);
        const FlatPolygon receiver = quadrilateral(middle, u, v);
        const vec3 point = middle + 0.9 * u - 0.9 * v;
        const vec3 w = random.direction(), towards = glm::normalize(from - point);
        const FlatPolygon caster =
            quadrilateral(point + 3.0 * towards + 0.6 * w, 0.7 * w, 0.1 * glm::cross(w, towards));
        if (isHidden(caster, point, from) && !overlap(receiver, caster, from)) ++lost;
    }
    return lost;
}
[[maybe_unused]] const bool farAway = addRow([] {
    return Row{.id = "X60 far light",
               .input = "1000 pairs of polygons, of which one stands before a point of the other, a light 1e8 away",
               .measured = "pairs that the sphere leaves out",
               .naive = "angles by the inverse cosine, which has steps of 1.5e-8 at 0",
               .naiveError = lostFarAway(byCosines),
               .ours = "pairsOnSphere: chords",
               .ourError = lostFarAway(bySphere),
               .tolerance = 0,
               .reason = "a bound loses none"};
});

// A corner of the one between the planes through the light and the other's edges.
bool byCorners(const FlatPolygon& receiver, const FlatPolygon& caster, const vec3& from) {
    const auto hasCornerIn = [&](const FlatPolygon& one, const FlatPolygon& other) {
        return std::ranges::any_of(one.corners, [&](const vec3& corner) {
            int positive = 0;
            for (std::size_t i = 0; i < other.corners.size(); ++i) {
                const vec3 a = other.corners[i] - from, b = other.corners[(i + 1) % other.corners.size()] - from;
                positive += glm::dot(glm::cross(a, b), corner - from) > 0 ? 1 : 0;
            }
            return positive == 0 || positive == int(other.corners.size());
        });
    };
    return hasCornerIn(receiver, caster) || hasCornerIn(caster, receiver);
}

double lostSlivers(const Overlap& overlap, bool drawn) {
    Random random(64);
    double lost = 0;
    for (int i = 0; i < 1000; ++i) {
        const vec3 d = random.direction(), u = glm::normalize(glm::cross(d, random.direction()));
        const vec3 v = glm::normalize(u + random.number(0.5, 2) * glm::cross(d, u));
        const auto sliver = [&](const vec3& middle, const vec3& along) {
            return quadrilateral(middle, along, 1e-9 * glm::normalize(glm::cross(along, d)));
        };
        const FlatPolygon caster = sliver(d, 0.5 * u), receiver = sliver(2.0 * d, 0.5 * v);
        const bool found = overlap(receiver, caster, vec3(0)) && (!drawn || !ours(receiver, caster, vec3(0)).empty());
        lost += found ? 0 : 1;
    }
    return lost;
}
[[maybe_unused]] const bool slivers = addRow([] {
    return Row{.id = "X60 slivers",
               .input = "1000 pairs of slivers, 1 long and 2e-9 wide, one across the other as the light sees them",
               .measured = "pairs that have no shadow",
               .naive = "a corner of the one within the other on the sphere",
               .naiveError = lostSlivers(byCorners, false),
               .ours = "pairsOnSphere and shadowOn",
               .ourError = lostSlivers(bySphere, true),
               .tolerance = 0,
               .reason = "they cross, so that the nearer throws a shadow on the other"};
});

}  // namespace
