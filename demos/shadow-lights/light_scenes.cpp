#include "light_scenes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "mv/geometry/shapes.h"
#include "mv/math/transform.h"
#include "shared/scenes.h"

namespace mv {
namespace {

// The matrix that lays the box -0.5..0.5 between two points, `thickness` across.
mat4 between(const vec3& from, const vec3& to, double thickness) {
    const vec3 y = to - from, x = glm::normalize(glm::cross(y, vec3(0.1, 0.2, 1))),
               z = glm::normalize(glm::cross(x, y));
    return {vec4(thickness * x, 0), vec4(y, 0), vec4(thickness * z, 0), vec4((from + to) / 2.0, 1)};
}

// A reading lamp: a foot, two arms of equal length, and a shade with a light in it, at `head`, that looks at `target`.
void addLamp(Scene& scene, const vec3& foot, const vec3& head, const vec3& target, double size, const vec3& color,
             const vec3& lightColor) {
    const std::vector<vec2> shade{{0, 0}, {0.09, 0}, {0.12, 0.08}, {0.27, 0.34}, {0.25, 0.34}, {0.10, 0.09}, {0, 0.05}};
    const std::vector<vec2> disc{{0, 0}, {0.3, 0}, {0.3, 0.03}, {0.05, 0.06}, {0, 0.06}};
    const vec3 aim = glm::normalize(target - head), shoulder = foot + vec3(0, 0.06 * size, 0);
    const vec3 along = head - shoulder, middle = (shoulder + head) / 2.0;
    const vec3 sideways = glm::normalize(glm::cross(glm::cross(along, vec3(0, 1, 0)), along));
    const double arm = 0.85 * size;
    const vec3 elbow = middle + std::sqrt(std::max(arm * arm - glm::dot(along, along) / 4, 0.0)) * sideways;
    const vec3 x = glm::normalize(glm::cross(aim, vec3(0.1, 0.2, 1)));
    const mat4 worldFromShade(vec4(size * x, 0), vec4(size * aim, 0), vec4(size * glm::cross(x, aim), 0),
                              vec4(head, 1));
    auto& objects = scene.objects;
    objects.push_back({"foot", lathe(disc, 48), translate(foot) * rotateY(20) * scale(size), 0.7 * color});
    objects.push_back({"lower arm", box(vec3(-0.5), vec3(0.5)), between(shoulder, elbow, 0.05 * size), 0.8 * color});
    objects.push_back({"upper arm", box(vec3(-0.5), vec3(0.5)), between(elbow, head, 0.05 * size), 0.9 * color});
    objects.push_back({"shade", lathe(shade, 48), worldFromShade, color});
    scene.lights.push_back({.position = vec4(head + 0.13 * size * aim, 1), .color = lightColor, .aim = aim});
}

}  // namespace

Scene lampsAndBall(double aspect, int index) {
    Scene scene = floorAlone(aspect);
    scene.viewFromWorld = lookAt({0.3, 2.6, 4.3}, {0.25, 0.5, 0}, {0, 1, 0});
    scene.objects.front().color = vec3(0.75, 0.62, 0.48);
    scene.lights = {{.position = vec4(0.5, 6, 3, 1), .color = vec3(0.35, 0.38, 0.45)}};
    const double t = radians(2.0 * index);
    const vec3 ball(0.35 + 0.35 * std::sin(t), 0.22, 0.7);
    addLamp(scene, {-1.1, 0, -0.4}, {-0.55, 1.35 + 0.06 * std::cos(t), 0.1}, ball, 1, {0.80, 0.82, 0.85},
            {0.55, 0.50, 0.40});
    addLamp(scene, {1.6, 0, 0.3}, {1.15, 0.75 + 0.05 * std::sin(2 * t), 0.5}, ball, 0.55, {0.85, 0.70, 0.66},
            {0.52, 0.50, 0.45});
    scene.objects.push_back(
        {"ball", sphere(0.22, 64, 32), translate(ball) * rotateZ(-degrees(ball.x / 0.22)), {0.90, 0.75, 0.20}});
    return scene;
}

Scene lightsOverStillLife(double aspect, const std::vector<vec3>& places) {
    Scene scene = stillLife(aspect);
    scene.lights.clear();
    const double count = double(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double turn = double(i) / count;
        vec3 color(0.9);
        for (int k = 0; k < 3 && count > 1; ++k) {
            color[k] = 2.2 / count *
                       std::clamp(1.5 - 6 * std::abs(turn - k / 3.0 - std::round(turn - k / 3.0)) + 0.5, 0.0, 1.0);
        }
        scene.lights.push_back({.position = vec4(places[i], 1), .color = color});
    }
    return scene;
}

Scene circleOfLights(double aspect, int index, int count) {
    std::vector<vec3> places;
    for (int i = 0; i < count; ++i) {
        const double turn = double(i) / count, angle = 2 * pi * turn + radians(1.0 * index) + 2.4;
        places.emplace_back(0.3 + 3.4 * std::cos(angle), 3.8, 2.6 + 2.6 * std::sin(angle));
    }
    return lightsOverStillLife(aspect, places);
}

}  // namespace mv
