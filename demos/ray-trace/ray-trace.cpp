// ray-trace: rays that are followed through mirrors and glass, as Whitted did in 1980, with a lamp that has an area.
#include "ray-trace.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "mv/geometry/ray_forms.h"
#include "mv/gl/text.h"
#include "shared/fresnel.h"

namespace mv::ray_trace {

void draw(Gpu&, const Settings& s, const Made& made, const Frame& frame) { showImage(frame, 0, 0, shown(s, made)); }

// Make the picture in passes (passes.cpp): blocks first, then one more sample for each pixel. traceRay() computes a sample.
void refine(Made& made, const Settings& s, const FrameInfo& frame, int pass) {
    if (made.finderFor.changed(s.room, s.structure, s.triangles)) made.finder = finderOf(s);
    made.picture.pass(planOf(s, frame.width(), frame.height(), made.finder), pass);
}

}  // namespace mv::ray_trace

namespace mv {
namespace {

vec3 skyAlong(const TracedScene& scene, const vec3& direction) {
    const double up = std::max(0.0, glm::normalize(direction).y);
    return glm::mix(scene.skyBelow, scene.skyAbove, std::sqrt(up));
}

// One ray of a path, in which rays follow each other.
struct Following {
    Ray ray;
    double radius = 0, spread = 0;  // of the ray's cone at its start, and how it widens
    double weight = 1;
    int left = 0;  // rays that may follow
    const SceneTriangle* from = nullptr;
};

class Tracer {
  public:
    Tracer(const TracedScene& scene, const LampPlace& place, const TraceOptions& options)
        : scene_(scene), place_(place), options_(options) {}

    vec3 along(const Following& path) {
        ++traced.rays;
        const auto met = firstMet(scene_, path.ray, path.from);
        if (const TracedLamp* lamp = lampBefore(path.ray, met ? met->t : HUGE_VAL)) return lamp->emitted;
        if (!met) return skyAlong(scene_, path.ray.direction);
        const double radius = path.radius + path.spread * met->t * glm::length(path.ray.direction);
        const Surface surface = surfaceAt(*met, radius, path.ray.direction);
        if (surface.index > 0) return surface.emitted + throughGlass(path, *met, surface.index, radius);
        vec3 light = surface.emitted;
        if (surface.mirrored < 1) {
            const LampLight lamps = lampsAt(*met, path.ray.direction);
            light += (1 - surface.mirrored) * surface.color * lamps.diffuse;
            light += (1 - surface.mirrored) * lamps.highlight;
        }
        if (surface.mirrored > 0) light += follow(path, *met, mirrored(path, *met), surface.mirrored, radius);
        return light;
    }

    Traced traced;

  private:
    Surface surfaceAt(const Met& met, double radius, const vec3& direction) const {
        // The flatter the cone meets the surface, the longer is its cut through it
        const double slant = std::max(std::abs(glm::dot(glm::normalize(direction), met.normal)), 1e-3);
        if (met.ball >= 0) return ballSurface(scene_.balls[static_cast<std::size_t>(met.ball)], met, radius, slant);
        if (met.triangle != nullptr) return scene_.meshSurface;
        const TracedScene::Floor& floor = *scene_.floor;
        const double width = options_.filtered ? 2 * radius / slant : 0;
        const double part = squaresAround(met.point.x, met.point.z, floor.square, width);
        Surface mixed = floor.dark;
        mixed.color = glm::mix(floor.dark.color, floor.light.color, part);
        mixed.mirrored = glm::mix(floor.dark.mirrored, floor.light.mirrored, part);
        return mixed;
    }

    // The colour of a ball with a texture is looked up there: from the world to the model, and from the model to the texture. The mean is over a
    // circle with the area of the cone's cut.
    Surface ballSurface(const TracedBall& ball, const Met& met, double radius, double slant) const {
        Surface surface = ball.surface;
        const double width = options_.filtered ? 2 * radius / std::sqrt(slant) : 0;
        if (ball.texture) surface.color = textureAround(*ball.texture, met.normal, width / ball.radius);
        return surface;
    }

    const TracedLamp* lampBefore(const Ray& ray, double end) const {
        for (const TracedLamp& lamp : scene_.lamps) {
            const auto hit = intersectPlane(ray, lamp.middle, lamp.halfU, lamp.halfV);
            if (hit && hit->t > 0 && hit->t < end && std::abs(hit->u) <= 1 && std::abs(hit->v) <= 1) return &lamp;
        }
        return nullptr;
    }

    // The light of the lamps at a place, and their highlight towards the eye by Phong's lobe.
    struct LampLight {
        vec3 diffuse, highlight;
    };
    LampLight lampsAt(const Met& met, const vec3& direction) {
        LampLight light{scene_.ambient, vec3(0)};
        for (const TracedLamp& lamp : scene_.lamps) {
            const vec3 onLamp = lamp.middle + place_.x * lamp.halfU + place_.y * lamp.halfV,
                       toLamp = onLamp - met.point;
            const double cosine = glm::dot(met.normal, glm::normalize(toLamp));
            if (!(cosine > 0)) continue;
            double through = 1;
            if (options_.shadows) {
                ++traced.rays;
                through = letThrough(scene_, startFrom(scene_, met, toLamp), onLamp, met.triangle);
                traced.glass |= through > 0 && through < 1;
            }
            const double falloff = options_.falloff ? glm::dot(lamp.middle, lamp.middle) / glm::dot(toLamp, toLamp) : 1;
            light.diffuse += cosine * through * falloff * lamp.light;
            if (options_.highlight > 0)
                light.highlight += lobe(met, direction, glm::normalize(toLamp)) * through * falloff * lamp.light;
        }
        return light;
    }
    // Phong's lobe about the mirrored direction of the light, half as strong as the lamp at its middle.
    double lobe(const Met& met, const vec3& direction, const vec3& toLamp) const {
        const vec3 mirrored = 2 * glm::dot(toLamp, met.normal) * met.normal - toLamp;
        return 0.5 * std::pow(std::max(0.0, -glm::dot(mirrored, glm::normalize(direction))), options_.highlight);
    }

    static vec3 mirrored(const Following& path, const Met& met) {
        const vec3& d = path.ray.direction;
        return d - 2 * glm::dot(d, met.normal) * met.normal;
    }

    // Follow the ray in a direction. The surface passes on a part of its light.
    vec3 follow(const Following& path, const Met& met, const vec3& direction, double part, double radius) {
        if (part == 0) return vec3(0);
        if (path.left == 0) {
            traced.cut += path.weight * part;
            return vec3(0);
        }
        return part * along({{startFrom(scene_, met, direction), direction},
                             radius,
                             path.spread,
                             path.weight * part,
                             path.left - 1,
                             met.triangle});
    }

    vec3 throughGlass(const Following& path, const Met& met, double index, double radius) {
        traced.glass = true;
        const vec3 direction = glm::normalize(path.ray.direction);
        const bool enters = glm::dot(direction, met.normal) < 0;
        const vec3 normal = enters ? met.normal : -met.normal;
        const double behind = enters ? index : 1 / index, cosine = std::min(1.0, -glm::dot(direction, normal));
        const auto on = refracted(direction, normal, behind);
        Split split = fresnel(std::max(0.0, cosine), behind);
        if (options_.schlick && on) {
            // Use Schlick's curve with the angle on the ray's side, as many programs do. Total reflection stays exact
            const double headOn = std::pow((index - 1) / (index + 1), 2);
            split.reflected = schlick(std::max(0.0, cosine), headOn);
            split.transmitted = 1 - split.reflected;
        }
        vec3 light = follow(path, met, direction - 2 * glm::dot(direction, normal) * normal, split.reflected, radius);
        if (on) light += follow(path, met, *on, split.transmitted, radius);
        return light;
    }

    const TracedScene& scene_;
    const LampPlace& place_;
    const TraceOptions& options_;
};

}  // namespace

Traced traceRay(const TracedScene& scene, const Ray& ray, double spread, const LampPlace& place,
                const TraceOptions& options) {
    Tracer tracer(scene, place, options);
    tracer.traced.light = tracer.along({ray, 0, spread, 1, options.depth, nullptr});
    return tracer.traced;
}

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
