#include "traced_mirrors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "mirror.h"
#include "mv/demo/lesson.h"
#include "mv/geometry/bounds.h"
#include "mv/geometry/check.h"
#include "mv/geometry/ray_caster.h"

namespace mv::mirror {
namespace {

// A mirror as a ray meets it: a rectangle, nothing of the matrices that draw it.
struct Rectangle {
    vec3 middle, right, up, normal;  // right and up are half its sides

    // How far along a ray meets it from the front.
    std::optional<double> meets(const Ray& ray) const {
        const double towards = glm::dot(ray.direction, normal);
        if (towards >= 0) return {};
        const double t = glm::dot(middle - ray.origin, normal) / towards;
        const vec3 at = ray.at(t) - middle;
        const bool within =
            std::abs(glm::dot(at, right)) <= glm::dot(right, right) && std::abs(glm::dot(at, up)) <= glm::dot(up, up);
        return t > 0 && within ? std::optional(t) : std::nullopt;
    }
};

std::vector<Rectangle> rectangles(const MirrorRoom& room) {
    std::vector<Rectangle> all;
    for (const Mirror& mirror : room.mirrors()) {
        all.push_back(
            {mirror.middle, mirror.halfU, mirror.halfV, glm::normalize(glm::cross(mirror.halfU, mirror.halfV))});
    }
    return all;
}

// A ray's sight, as shaders/include/seen.glsl tells it, and a number for each way: objects and bounces.
struct TracedPixel {
    double value = -1;
    int region = -1;
};

class TracedMirrors {
  public:
    explicit TracedMirrors(const TracedScene& traced)
        : scene_(traced.scene),
          caster_(scene_),
          worldFromClip_(glm::inverse(scene_.clipFromWorld())),
          bounces_(traced.bounces),
          reflectance_(traced.reflectance),
          mirrors_(rectangles(traced.room)) {
        for (const SceneObject& object : scene_.objects) triangles_.push_back(trianglesOf(object.mesh));
    }

    // x and y from -1 to 1 over the picture.
    TracedPixel at(double x, double y) const {
        const vec4 near = worldFromClip_ * vec4(x, y, -1, 1), far = worldFromClip_ * vec4(x, y, 1, 1);
        Ray ray{vec3(near) / near.w, vec3(far) / far.w - vec3(near) / near.w};
        ray.direction = glm::normalize(ray.direction);
        double part = 1;
        for (int bounce = 0;; ++bounce) {
            const auto hit = nearestFront(ray);
            const Rectangle* mirror = nullptr;
            double first = hit ? hit->t : HUGE_VAL;
            for (const Rectangle& one : mirrors_) {
                const auto t = one.meets(ray);
                if (!t || *t >= first) continue;
                first = *t;
                mirror = &one;
            }
            if (mirror == nullptr) {
                if (!hit && bounce == 0) return {};
                if (!hit) return seen(part * sky, 0, bounce);
                return seen(part * lit(*hit), hit->object + 1, bounce);
            }
            part *= reflectance_;
            if (bounce == bounces_) return seen(part * sky, 0, bounce + 1);
            // The lecture's v - 2 n (n . v)
            ray.origin = ray.at(first);
            ray.direction -= 2 * glm::dot(mirror->normal, ray.direction) * mirror->normal;
        }
    }

  private:
    static TracedPixel seen(const vec3& light, int object, int bounce) {
        return {object + 0.3 * (light.x + light.y + light.z), 16 * bounce + object};
    }

    // Backs are not drawn.
    std::optional<SceneHit> nearestFront(Ray ray) const {
        double passed = 0;
        for (;;) {
            auto hit = caster_.nearest(ray);
            if (!hit) return {};
            hit->t += passed;
            if (glm::dot(hit->normal, ray.direction) < 0) return hit;
            ray.origin = hit->point + 1e-9 * ray.direction;
            passed = hit->t + 1e-9;
        }
    }

    // Light the hit by the normal of the triangle's corners, as the GPU interpolates it.
    vec3 lit(const SceneHit& hit) const {
        const auto number = static_cast<std::size_t>(hit.object);
        const SceneObject& object = scene_.objects[number];
        const auto& corners = triangles_[number][static_cast<std::size_t>(hit.triangle)];
        mat3 places(1), normals(1);
        for (int i = 0; i < 3; ++i) {
            const auto corner = corners[static_cast<std::size_t>(i)];
            places[i] = vec3(object.worldFromObject * vec4(vec3(object.mesh.positions[corner]), 1));
            normals[i] = mat3(object.worldFromObject) * vec3(object.mesh.normals[corner]);
        }
        // The weights of the corners, by the areas opposite them
        const vec3 whole = glm::cross(places[1] - places[0], places[2] - places[0]);
        vec3 weights(0);
        for (int i = 0; i < 3; ++i) {
            const vec3 &b = places[(i + 1) % 3], &c = places[(i + 2) % 3];
            weights[i] = glm::dot(glm::cross(b - hit.point, c - hit.point), whole) / glm::dot(whole, whole);
        }
        const vec3 normal = glm::normalize(normals * weights);
        const vec3 towardsLight = glm::normalize(vec3(scene_.lights.front().position));
        vec3 color = object.color;
        const double tile = std::floor(hit.point.x / MirrorRoom::tile) + std::floor(hit.point.z / MirrorRoom::tile);
        if (number == 0 && tile - 2 * std::floor(tile / 2) == 1) color *= 0.6;
        return color * (0.3 + 0.7 * std::max(glm::dot(normal, towardsLight), 0.0));
    }

    const Scene& scene_;
    RayCaster caster_;
    mat4 worldFromClip_;
    int bounces_;
    double reflectance_;
    std::vector<Rectangle> mirrors_;
    std::vector<std::vector<std::array<std::uint32_t, 3>>> triangles_;
};

}  // namespace

TracedScene tracedScene(const Demo& demo, const FrameInfo& frame) {
    const auto s = settingsOf<Settings>(demo);
    return {demo.scene(frame), roomOf(s), s.bounces, s.reflectance};
}

Reference traced(const TracedScene& scene, int width, int height) {
    const TracedMirrors mirrors(scene);
    Reference reference;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const TracedPixel seen = mirrors.at(2 * (column + 0.5) / width - 1, 1 - 2 * (row + 0.5) / height);
            reference.values.push_back(seen.value);
            reference.regions.push_back(seen.region);
        }
    }
    return reference;
}

std::vector<bool> behindFirst(const TracedScene& scene) {
    const Rectangle mirror = rectangles(scene.room).front();
    std::vector<bool> behind{false};
    for (const SceneObject& object : scene.scene.objects) {
        const auto corners = boundsOf(object.mesh, object.worldFromObject).corners();
        behind.push_back(std::all_of(corners.begin(), corners.end(), [&](const vec3& corner) {
            return glm::dot(corner - mirror.middle, mirror.normal) < 0;
        }));
    }
    return behind;
}

}  // namespace mv::mirror
