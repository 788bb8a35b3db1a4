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

}  // namespace mv
