#include "leaving.h"

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "mv/demo/made_for.h"

namespace mv {

vec3 startOff(const SceneTriangle& triangle, const vec3& point, const vec3& normal, const vec3& direction,
              Leave leave) {
    const vec3 size = glm::max(glm::abs(triangle.a), glm::max(glm::abs(triangle.b), glm::abs(triangle.c)));
    if (leave == Leave::point) return point;
    if (leave == Leave::components) {
        const double off = 8 * std::numeric_limits<double>::epsilon() * glm::dot(glm::abs(normal), size);
        return glm::dot(normal, direction) < 0 ? point - off * normal : point + off * normal;
    }
    return besideSurface(point, normal, direction, size, 8);
}

std::optional<TriangleHit<double>> metAgain(const SceneTriangle& left, const Ray& ray, Leave leave) {
    if (leave == Leave::bounded) return intersectTriangle(ray, left.a, left.b, left.c);
    return publishedWatertight(ray, left.a, left.b, left.c);
}

std::vector<SceneTriangle> floorOfStrips(int triangles) {
    const int strips = triangles / 2;
    std::vector<SceneTriangle> floor;
    for (int i = 0; i < strips; ++i) {
        const double front = -10 + 20.0 * i / strips, back = -10 + 20.0 * (i + 1) / strips;
        const vec3 a(-10, 0, front), b(-10, 0, back), c(10, 0, back), d(10, 0, front);
        floor.push_back({a, b, c, 0, 2 * i});
        floor.push_back({a, c, d, 0, 2 * i + 1});
    }
    return floor;
}

namespace {

struct Departure {
    SceneTriangle triangle;
    vec3 point, way;
};

// Kept, so that a measured time is that of leaving.
const std::vector<Departure>& departures(int triangles) {
    static MadeFor<int> keptFor;
    static std::vector<Departure> kept;
    if (!keptFor.changed(triangles)) return kept;
    const std::vector<SceneTriangle> floor = floorOfStrips(triangles);
    std::mt19937_64 bits(27);
    const auto number = [&] { return double(bits() >> 11) * 0x1p-53; };  // 0 .. 1
    kept.clear();
    for (int i = 0; i < 100'000; ++i) {
        const SceneTriangle& from = floor[static_cast<std::size_t>(number() * double(floor.size()))];
        double v = number(), w = number();
        if (v + w > 1) v = 1 - v, w = 1 - w;
        const double x = 2 * number() - 1, y = number(), z = 2 * number() - 1;
        kept.push_back({from, (1 - v - w) * from.a + v * from.b + w * from.c, {x, y, z}});
    }
    return kept;
}

}  // namespace

std::vector<double> againOffStrips(int triangles, Leave leave) {
    std::vector<double> again;
    for (const Departure& one : departures(triangles)) {
        const Ray ray{startOff(one.triangle, one.point, {0, 1, 0}, one.way, leave), one.way};
        again.push_back(metAgain(one.triangle, ray, leave) ? 1 : 0);
    }
    return again;
}

}  // namespace mv
