// The world of deferred: balls on a floor, and lamps between them.
#include <array>
#include <cmath>

#include "deferred.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/lamp_reach.h"

namespace mv::deferred {

constexpr double halfX = 5.4, halfZ = 3.6;  // of the floor, m

static std::vector<SceneObject> objects() {
    std::vector<SceneObject> all{
        {"floor", withoutTexCoords(grid(20, 14, 2 * halfX, 2 * halfZ)), mat4(1), {0.75, 0.73, 0.7}}};
    const std::array colors{vec3(0.8, 0.75, 0.65), vec3(0.75, 0.4, 0.3), vec3(0.35, 0.55, 0.75), vec3(0.5, 0.65, 0.35)};
    for (int i = 0; i < 35; ++i) {
        const vec3 middle(1.35 * (i % 7 - 3), ballRadius, 1.3 * (i / 7 - 2));
        all.push_back({"ball", withoutTexCoords(sphere(ballRadius, 24, 16)), translate(middle),
                       colors.at(static_cast<std::size_t>(i * 5 % 7) % colors.size())});
    }
    return all;
}

MeshData Gpu::worldOf() {
    Scene world;
    world.objects = objects();
    return meshOf(world);
}

Scene cameraOf(const Settings& s, const FrameInfo& frame) {
    Scene scene;
    scene.clipFromView = perspective(36, frame.aspect(), 1, 40);
    scene.viewFromWorld = seenFrom(s.orbit, lookAt(vec3(0, 3.9, 8.6), vec3(0, -0.15, 0.75), vec3(0, 1, 0)));
    return scene;
}

Scene sceneOf(const Settings& s, const FrameInfo& frame) {
    Scene scene = cameraOf(s, frame);
    scene.objects = objects();
    return scene;
}

// Scatter the lamps evenly: the parts after the point of the multiples of three numbers that no fraction is near
// (Roberts 2018). They hang 10 cm above the balls at least: right beside a lamp the least error of a place would be all that counts.
Lamps lampsOf(const Settings& s) {
    constexpr std::array<vec3, 6> hues{vec3(1, 0.75, 0.45), vec3(0.45, 0.7, 1), vec3(1, 0.45, 0.35),
                                       vec3(0.5, 1, 0.6),   vec3(0.8, 0.55, 1), vec3(1, 0.95, 0.85)};
    const auto part = [](double x) { return x - std::floor(x); };
    Lamps lamps{{}, {}, s.lamps};
    for (std::size_t i = 0; i < mostLamps; ++i) {
        const double n = double(i) + 1;
        lamps.place.emplace_back(halfX * (2 * part(0.8191725134 * n) - 1), 0.95 + 0.4 * part(0.6710436067 * n),
                                 halfZ * (2 * part(0.5497004779 * n) - 1));
        lamps.power.push_back(s.power * hues.at(i % hues.size()));
    }
    return lamps;
}

// Leave out the lamps that nothing in view is within reach of.
Lamps reaching(const Settings& s, const Scene& camera) {
    Scene bounds;
    bounds.objects = {{"bounds", box(vec3(-halfX, -0.01, -halfZ), vec3(halfX, 2 * ballRadius, halfZ))}};
    const Lamps all = lampsOf(s);
    Lamps left{{}, {}, 0};
    for (std::size_t i = 0; i < static_cast<std::size_t>(all.count); ++i) {
        if (!canReach(bounds, camera.clipFromWorld(), all.place[i], s.reach)) continue;
        left.place.push_back(all.place[i]);
        left.power.push_back(all.power[i]);
        ++left.count;
    }
    left.place.resize(mostLamps);
    left.power.resize(mostLamps);
    return left;
}

}  // namespace mv::deferred
