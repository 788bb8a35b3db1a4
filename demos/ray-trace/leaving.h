// How a ray leaves a triangle, so that it does not meet it again: four ways, three of which are not enough.
#pragma once
#include <algorithm>
#include <glm/common.hpp>
#include <optional>
#include <vector>

#include "mv/geometry/bvh.h"
#include "mv/geometry/ray.h"

namespace mv {

// Where a ray begins that leaves a triangle: at the point itself; off it by 8 roundings of each coordinate along the normal, which are 0 in
// the plane y = 0; by as many of the largest coordinate, as besideSurface(). And bounded: so, and asked by TriangleTest, which passes over a
// triangle in whose plane the ray begins. The others are asked by the same test as it was published.
enum class Leave { point, components, largest, bounded };

// Woop, Benthin and Wald's as published (2013), in double: t by the weights of the corners, and a hit where it is above 0.
inline std::optional<TriangleHit<double>> publishedWatertight(const Ray& ray, const vec3& a, const vec3& b,
                                                              const vec3& c) {
    const vec3 d = glm::abs(ray.direction);
    const int z = d.x > d.y ? (d.x > d.z ? 0 : 2) : (d.y > d.z ? 1 : 2), x = (z + 1) % 3, y = (z + 2) % 3;
    const auto sheared = [&](const vec3& corner) {
        const vec3 way = corner - ray.origin;
        const double along = way[z] / ray.direction[z];
        return vec3(way[x] - ray.direction[x] * along, way[y] - ray.direction[y] * along, along);
    };
    const vec3 ofA = sheared(a), ofB = sheared(b), ofC = sheared(c);
    const double u = ofC.x * ofB.y - ofC.y * ofB.x, v = ofA.x * ofC.y - ofA.y * ofC.x,
                 w = ofB.x * ofA.y - ofB.y * ofA.x, sum = u + v + w;
    if ((std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0) || sum == 0) return {};
    const double t = (u * ofA.z + v * ofB.z + w * ofC.z) / sum;
    if (!(t > 0)) return {};
    return TriangleHit<double>{t, u / sum, v / sum, w / sum};
}

// Where a ray in that direction begins, which leaves the triangle at the point; the normal is a unit vector.
vec3 startOff(const SceneTriangle& triangle, const vec3& point, const vec3& normal, const vec3& direction, Leave leave);

// What a ray meets of the triangle that it has left: nothing, if all is right.
std::optional<TriangleHit<double>> metAgain(const SceneTriangle& left, const Ray& ray, Leave leave);

// A floor y = 0 from -10 to 10 of so many triangles, along x, in pairs side by side: each half as many times as long as wide.
std::vector<SceneTriangle> floorOfStrips(int triangles);

// 1 for each of 100 000 rays upwards, in any direction from any point of that floor, that meets again the triangle that it leaves, else 0.
std::vector<double> againOffStrips(int triangles, Leave leave);

}  // namespace mv
