// What a ray meets first, where the next ray begins, and what of a lamp's light comes through to a place.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "mv/geometry/ray_forms.h"
#include "shared/fresnel.h"
#include "whitted.h"

namespace mv {

static Met metAt(const TriangleHit<double>& hit, const SceneTriangle& in, const Ray& ray) {
    const vec3 normal = glm::normalize(glm::cross(in.b - in.a, in.c - in.a));
    return Met{.t = hit.t,
               // The corners' weights give a point nearer to the triangle than ray.at(t)
               .point = hit.a * in.a + hit.b * in.b + hit.c * in.c,
               .normal = glm::dot(normal, ray.direction) > 0 ? -normal : normal,
               .triangle = &in};
}

std::optional<Met> firstMet(const TracedScene& scene, const Ray& ray, const SceneTriangle* left) {
    if (left != nullptr && scene.leave != Leave::bounded) {
        if (const auto again = metAgain(*left, ray, scene.leave)) return metAt(*again, *left, ray);
    }
    Met met{.t = HUGE_VAL};
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        const TracedBall& ball = scene.balls[i];
        const auto inside = intersectSphere(ray, ball.center, ball.radius);
        if (!inside) continue;
        const double t = inside->near > 0 ? inside->near : inside->far;
        if (t > 0 && t < met.t) met = {.t = t, .ball = static_cast<int>(i)};
    }
    if (scene.floor) {
        const auto t = intersectPlane(ray, vec4(0, 1, 0, -scene.floor->height));
        if (t && *t > 0 && *t < met.t) {
            met = {.t = *t, .point = ray.at(*t)};
            met.point.y = scene.floor->height;
        }
    }
    if (scene.mesh) {
        const auto hit = scene.mesh->nearest(ray);
        if (hit && hit->hit.t < met.t) return metAt(hit->hit, *hit->triangle, ray);
    }
    if (met.t == HUGE_VAL) return {};
    if (met.ball >= 0) {
        const TracedBall& ball = scene.balls[static_cast<std::size_t>(met.ball)];
        met.normal = glm::normalize(ray.at(met.t) - ball.center);
        met.point = ball.center + ball.radius * met.normal;  // nearer to the ball than ray.at(t)
    }
    return met;
}

vec3 startFrom(const TracedScene& scene, const Met& met, const vec3& direction) {
    if (met.triangle != nullptr) return startOff(*met.triangle, met.point, met.normal, direction, scene.leave);
    if (met.ball >= 0) {
        // The point has the roundings of the middle and of radius times normal. The next ray's test has those of the
        // radius' square, which are half as many of the radius
        const TracedBall& ball = scene.balls[static_cast<std::size_t>(met.ball)];
        return besideSurface(met.point, met.normal, direction, glm::abs(ball.center) + ball.radius, 8);
    }
    return besideSurface(met.point, met.normal, direction, vec3(std::abs(scene.floor->height)), 8);
}

double letThrough(const TracedScene& scene, const vec3& start, const vec3& lamp, const SceneTriangle* left) {
    double through = 1;
    Ray ray{start, lamp - start};
    for (;;) {
        const auto met = firstMet(scene, ray, std::exchange(left, nullptr));
        if (!met || met->t >= 1) return through;  // each ray ends in the lamp, at t = 1
        if (met->ball < 0) return 0;              // the floor and triangles are opaque
        const Surface& surface = scene.balls[static_cast<std::size_t>(met->ball)].surface;
        if (surface.index <= 0) return 0;
        const double cosine = glm::dot(glm::normalize(ray.direction), met->normal);
        // The ray goes straight on, so its angles inside and outside are equal. Each surface takes away the part that it
        // reflects of light from outside
        through *= fresnel(std::min(1.0, std::abs(cosine)), surface.index).transmitted;
        ray.origin = startFrom(scene, *met, ray.direction);
        ray.direction = lamp - ray.origin;
    }
}

}  // namespace mv
