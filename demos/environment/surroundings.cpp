#include "surroundings.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/math/projection.h"
#include "shared/procedural.h"

namespace mv {
namespace {

const vec3 proportions(1, 0.6, 1);

double smooth(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// -1..1, with soft edges between tiles of 0.2.
double tiles(double u, double v) {
    const double wave = std::sin(5 * pi * u) * std::sin(5 * pi * v);
    return wave / std::sqrt(wave * wave + 0.1);
}

// At a point of a wall of the room of size 1.
vec3 wallColor(const vec3& point) {
    const vec3 near = glm::abs(point) / proportions;
    if (near.y >= near.x && near.y >= near.z) {
        const double tile = tiles(point.x, point.z);
        if (point.y < 0) return vec3(0.55, 0.50, 0.45) * (0.75 + 0.25 * tile);
        const double lamp = 1 - smooth(0.28, 0.34, std::max(std::abs(point.x), std::abs(point.z)));
        return glm::mix(vec3(0.72, 0.72, 0.70) * (0.92 + 0.08 * tile), vec3(1, 1, 0.94), lamp);
    }
    if (near.x >= near.z) {
        const vec3 color = point.x < 0 ? vec3(0.72, 0.36, 0.30) : vec3(0.36, 0.55, 0.40);
        return color * (0.8 + 0.2 * tiles(point.z, point.y));
    }
    const vec3 color = point.z < 0 ? vec3(0.42, 0.52, 0.68) : vec3(0.80, 0.70, 0.45);
    return color * (0.8 + 0.2 * tiles(point.x, point.y));
}

// A sum of octaves about 0.5, in 0..1. The centre is the seed.
double cloudNoise(const vec3& point, int octaves) {
    return patternAt(PatternPlace{Pattern::noise, octaves, 0, {31.5, 7.25, 12.75}}, point);
}

}  // namespace

std::array<vec3, Room::ballCount> Room::ballPlaces() const {
    const double y = -0.6 * size + ballRadius(), corner = 0.8 * size;
    const double angle = radians(round);
    return {vec3(0.68 * size * std::sin(angle), y, 0.68 * size * std::cos(angle)), vec3(-corner, y, -corner),
            vec3(corner, y, -corner), vec3(corner, y, corner)};
}

std::array<vec3, Room::ballCount> Room::ballColors() {
    return {vec3(0.85, 0.20, 0.15), vec3(0.95, 0.80, 0.25), vec3(0.25, 0.35, 0.80), vec3(0.90, 0.90, 0.90)};
}

bool Room::isBallInView(std::size_t ball, const mat4& clipFromWorld) const {
    const vec3 place = ballPlaces().at(ball);
    const auto planes = planesFromClip(clipFromWorld);
    return std::all_of(planes.begin(), planes.end(),
                       [&](const vec4& plane) { return glm::dot(vec3(plane), place) + plane.w > -ballRadius(); });
}

// The ball's cone from the eye is within the sphere's cone. The sphere is taken a little smaller, since a mesh stands for it.
bool Room::isBallHidden(std::size_t ball, const vec3& eye) const {
    const vec3 to = ballPlaces().at(ball) - eye;
    const double away = glm::length(to), middle = glm::length(eye);
    const double between = std::acos(std::clamp(-glm::dot(to, eye) / (away * middle), -1.0, 1.0));
    return away > middle &&
           between + std::asin(std::min(ballRadius() / away, 1.0)) < std::asin(std::min(0.99 / middle, 1.0));
}

vec3 Room::wallAlong(const Ray& ray) const {
    double nearest = HUGE_VAL;
    for (int i = 0; i < 3; ++i) {
        const double way = ray.direction[i];
        if (way != 0) nearest = std::min(nearest, (std::copysign(halfSize()[i], way) - ray.origin[i]) / way);
    }
    return ray.at(nearest);
}

vec3 Room::seenAlong(const Ray& ray) const {
    const std::array<vec3, ballCount> places = ballPlaces(), colors = ballColors();
    vec3 light = wallColor(wallAlong(ray) / size);
    double nearest = HUGE_VAL;
    for (std::size_t i = 0; i < ballCount; ++i) {
        const auto within = intersectSphere(ray, places.at(i), ballRadius());
        if (!within || within->near < 0 || within->near > nearest) continue;
        nearest = within->near;
        light = colors.at(i) * (0.6 + 0.4 * ((ray.at(nearest) - places.at(i)) / ballRadius()).y);
    }
    return light;
}

vec3 skyAlong(const vec3& direction) {
    const vec3 way = glm::normalize(direction);
    const vec3 level = glm::length(vec2(way.x, way.z)) > 0 ? glm::normalize(vec3(way.x, 0, way.z)) : vec3(0);
    const vec3 sun = glm::normalize(vec3(0.55, 0.5, -0.5));
    // Sky, brighter towards the horizon, with clouds and the sun in it
    vec3 light = glm::mix(vec3(0.86, 0.90, 0.93), vec3(0.56, 0.66, 0.80), smooth(0, 0.8, way.y));
    const double toSun = glm::dot(way, sun);
    light += 0.25 * std::pow(std::max(toSun, 0.0), 40) * vec3(1, 0.9, 0.6);
    if (way.y > 0.03) {
        const double cover = smooth(0.47, 0.75, cloudNoise(2.5 * way, 5)) * smooth(0.03, 0.3, way.y);
        light = glm::mix(light, vec3(0.97, 0.97, 0.98), cover);
    }
    light = glm::mix(light, vec3(1, 0.98, 0.88), smooth(0.9965, 0.9985, toSun));
    // Two rows of hills, and the ground before them: none is higher, or lower, than its noise can be
    if (way.y < 0.16) {
        const double far = 0.03 + 0.12 * cloudNoise(2.0 * level, 3);
        light = glm::mix(light, vec3(0.55, 0.63, 0.66), smooth(far + 0.006, far - 0.006, way.y));
    }
    if (way.y < 0.08) {
        const double near = -0.03 + 0.10 * cloudNoise(3.0 * level + 7.0, 3);
        const vec3 ground = glm::mix(vec3(0.62, 0.58, 0.40), vec3(0.44, 0.40, 0.28), smooth(0, 0.6, -way.y));
        light =
            glm::mix(light, ground * (0.8 + 0.4 * cloudNoise(6.0 * way, 3)), smooth(near + 0.006, near - 0.006, way.y));
    }
    return glm::clamp(light, vec3(0), vec3(1));
}

std::array<FloatPicture, cubeFaces> skyCube(int size) {
    std::array<FloatPicture, cubeFaces> faces;
    for (int face = 0; face < cubeFaces; ++face) {
        FloatPicture picture(size, size, 4);
        for (int row = 0; row < size; ++row) {
            for (int column = 0; column < size; ++column) {
                const vec3 light = skyAlong(cubeDirection({face, (vec2(column, row) + 0.5) / double(size)}));
                float* const texel = &picture.values[4 * pixelIndex(column, row, size)];
                for (int i = 0; i < 3; ++i) texel[i] = static_cast<float>(light[i]);
                texel[3] = 1;
            }
        }
        faces.at(static_cast<std::size_t>(face)) = picture;
    }
    return faces;
}

}  // namespace mv
