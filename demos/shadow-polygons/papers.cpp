// The polygons of shadow-polygons, and the camera.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <string>
#include <utility>

#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shadow-polygons.h"

namespace mv::shadow_polygons {

static const std::array<vec3, 6> hues{vec3(0.90, 0.45, 0.30), vec3(0.35, 0.62, 0.85), vec3(0.95, 0.80, 0.35),
                                      vec3(0.50, 0.75, 0.45), vec3(0.75, 0.55, 0.80), vec3(0.90, 0.90, 0.86)};

static FlatPolygon floorOf(double half) {
    return {{{-half, 0, -half}, {-half, 0, half}, {half, 0, half}, {half, 0, -half}}, {0.80, 0.78, 0.72}};
}

// A regular polygon about a middle, in the plane of two unit vectors that are perpendicular.
static FlatPolygon regular(int corners, const vec3& middle, const vec3& u, const vec3& v, double radius,
                           const vec3& color) {
    FlatPolygon polygon{{}, color};
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * pi * i / corners;
        polygon.corners.push_back(middle + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    return polygon;
}

// Papers of three to six corners that hang over a floor, turned and placed by chance; the same ones come first for any number.
static std::vector<FlatPolygon> papers(int count, double size) {
    std::vector<FlatPolygon> polygons{floorOf(4.5)};
    std::mt19937 engine(1970);
    const auto chance = [&engine](double low, double high) {
        return low + (high - low) * double(engine()) / 4294967296.0;
    };
    const double radius = size * 2.4 / std::sqrt(double(count));
    for (int i = 1; i < count; ++i) {
        const double x = chance(-3.2, 3.2), y = chance(0.7, 3.2), z = chance(-3.2, 3.2);
        const double yaw = chance(0, 360), pitch = chance(-60, 60), roll = chance(-60, 60);
        const mat3 turned(rotateY(yaw) * rotateX(pitch) * rotateZ(roll));
        polygons.push_back(
            regular(3 + i % 4, {x, y, z}, turned[0], turned[2], radius, hues.at(std::size_t(i) % hues.size())));
    }
    return polygons;
}

// Three squares with one middle, each in the plane of two of the others' normals, over a floor.
static std::vector<FlatPolygon> crossing(double size) {
    const mat3 turned(rotateX(20) * rotateY(-30) * rotateZ(35));
    std::vector<FlatPolygon> polygons{floorOf(3.5)};
    for (int i = 0; i < 3; ++i) {
        const vec3 u(turned[i]), v(turned[(i + 1) % 3]);
        polygons.push_back(regular(4, {-0.5, 1.7, 0}, u, v, size * 1.5, hues.at(std::size_t(i))));
    }
    return polygons;
}

std::vector<FlatPolygon> polygonsOf(const Settings& s) {
    return s.scene == Which::papers ? papers(s.polygons, s.size) : crossing(s.size);
}

// What rays see: each polygon an object.
Scene sceneOf(const Settings& s, const FrameInfo& frame) {
    Scene scene;
    for (const FlatPolygon& polygon : polygonsOf(s)) {
        const std::string name = "polygon " + std::to_string(scene.objects.size());
        MeshData mesh;
        addPolygon(mesh, polygon, s.light);
        scene.objects.push_back({name, std::move(mesh), mat4(1), polygon.color});
    }
    scene.lights = {{.position = vec4(s.light, 1)}};
    scene.viewFromWorld = seenFrom(s.orbit, lookAt({1.4, 6.8, 10.8}, {0, 0.8, 0}, {0, 1, 0}));
    const double aspect = frame.aspect(), fovy = 42;
    const double across = std::max(1.0, 1.3 / aspect);
    scene.clipFromView = perspective(2 * degrees(std::atan(across * std::tan(radians(fovy / 2)))), aspect, 1, 60);
    return scene;
}

// Left of the sphere, or all of the picture.
Pane scenePane(const Settings& s, const FrameInfo& frame) {
    if (s.show == Show::scene) return {0, 0, frame.width(), frame.height()};
    const int high = std::max(1, frame.height() * 9 / 16);
    if (frame.isUpright()) return {0, frame.height() - high, frame.width(), high};
    return {0, 0, std::max(1, frame.width() * 9 / 16), frame.height()};
}
Pane drawnPane(const Settings& s, const Frame& frame) {
    return frame.measuring() ? Pane{0, 0, frame.width(), frame.height()} : scenePane(s, frame);
}

}  // namespace mv::shadow_polygons
