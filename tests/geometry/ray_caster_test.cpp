#include "mv/geometry/ray_caster.h"

#include <glm/geometric.hpp>
#include <string>

#include "../math/support.h"
#include "mv/geometry/check.h"
#include "mv/geometry/shapes.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

using namespace mv;
using namespace mv::test;

namespace {

vec3 pointIn(Random& random, double half) {
    const double x = random.number(-half, half), y = random.number(-half, half);
    return {x, y, random.number(-half, half)};
}

// Objects of every kind, thrown about: some of them overlap.
Scene randomScene(std::uint64_t seed) {
    Random random(seed);
    Scene scene;
    for (int i = 0; i < 12; ++i) {
        SceneObject object;
        object.name = "object " + std::to_string(i);
        object.mesh = i % 3 == 0 ? colorCube() : i % 3 == 1 ? sphere(0.5, 12, 7) : grid(3, 2, 1.5, 1);
        const mat4 turned = rotate(random.number(0, 360), pointIn(random, 1));
        object.worldFromObject =
            translate(pointIn(random, 2)) * turned * scale(i % 4 == 0 ? vec3(-1, 0.3, 1) : vec3(1));
        object.casts = i % 5 != 0;
        scene.objects.push_back(object);
    }
    scene.lights.push_back({.position = vec4(2, 5, 3, 1)});
    scene.lights.push_back({.position = vec4(1, 2, -1, 0)});
    scene.viewFromWorld = lookAt({0, 1, 8}, {0, 0, 0}, {0, 1, 0});
    scene.clipFromView = perspective(40, 1, 0.1, 100);
    return scene;
}

std::vector<vec3> worldCorners(const SceneObject& object) {
    std::vector<vec3> corners;
    for (const auto& triangle : trianglesOf(object.mesh)) {
        for (const auto i : triangle) corners.emplace_back(object.worldFromObject * vec4(object.mesh.positions[i], 1));
    }
    return corners;
}

// ---- the tree of boxes

TEST(RayCaster, FindsWhatALoopOverAllTrianglesFinds) {
    int hits = 0;
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Scene scene = randomScene(seed);
        const RayCaster caster(scene);
        Random random(seed + 100);
        for (int i = 0; i < 3000; ++i) {
            // Some along an axis and some in the planes of the boxes' sides: there a slab test has 0/0.
            Ray ray{pointIn(random, 4), pointIn(random, 1)};
            if (i % 4 == 0) ray.direction = vec3(0), ray.direction[i % 3] = i % 8 == 0 ? 1 : -1;
            if (i % 16 == 0)
                ray.origin =
                    worldCorners(scene.objects[static_cast<std::size_t>(i / 16 % 12)])[1] - 3.0 * ray.direction;
            SceneHit best{.t = HUGE_VAL};
            for (std::size_t object = 0; object < scene.objects.size(); ++object) {
                const auto corners = worldCorners(scene.objects[object]);
                for (std::size_t k = 0; k < corners.size(); k += 3) {
                    const auto hit = intersectTriangle(ray, corners[k], corners[k + 1], corners[k + 2]);
                    if (!hit || hit->t >= best.t) continue;
                    best.t = hit->t;
                    best.object = static_cast<int>(object);
                    best.triangle = static_cast<int>(k / 3);
                }
            }
            const auto hit = caster.nearest(ray);
            ASSERT_EQ(hit.has_value(), best.object >= 0);
            if (!hit) continue;
            ++hits;
            EXPECT_EQ(hit->t, best.t);
            EXPECT_EQ(hit->object, best.object);
            EXPECT_EQ(hit->triangle, best.triangle);
        }
    }
    EXPECT_GT(hits, 1000);
}

}  // namespace
