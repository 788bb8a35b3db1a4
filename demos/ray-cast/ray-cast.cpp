// ray-cast: a picture made of rays, one for each pixel, and how each of the lecture's objects meets one.
#include "ray-cast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/demo/seen.h"
#include "mv/gl/text.h"
#include "shared/in_rows.h"

namespace mv::ray_cast {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    constexpr std::array ofMaker{drawCast, drawCast, drawByGl};  // in the order of Maker

    const Scene scene = seen(sceneOf(s, frame), frame);
    beginTriangles(gpu, scene);  // triangles.cpp
    drawFromSide(gpu, s, scene, frame);
    ofMaker.at(std::size_t(s.by))(gpu, s, scene, frame);
}

// Show the picture that the processor makes, of rays, or of triangles that it fills.
void drawCast(Gpu& gpu, const Settings& s, const Scene&, const Frame& frame) {
    const int width = picturePane(frame).width;
    const Picture& picture =
        gpu.picture.of({withoutPixel(s), width}, [&] { return pictureOf(s, keptSeen(gpu, s), width); });
    showImage(frame, 0, frame.height() - width, picture);
}

// Send a ray through the middle of each pixel, and keep the first object that it meets.
Seen castRays(const Settings& s) {
    Seen seen(static_cast<std::size_t>(s.rows) * static_cast<std::size_t>(s.rows));
    const Shown shown = shownBy(s);
    inRows(s.rows, s.threads, [&](int row) {
        for (int column = 0; column < s.rows; ++column) {
            const std::vector<CastCandidate> met = candidates(s, shown, rayOf(s, column, row));
            if (!met.empty()) seen[pixelIndex(column, row, s.rows)] = met.front();
        }
    });
    return seen;
}

// The eye looks along -w. Its frame u, v, w is right-handed and of unit length.
CastEye eyeOf(const Settings& s) {
    const vec3 up(0, 1, 0);
    const vec3 w = glm::normalize(vec3(0.32, 0.42, 1));
    const vec3 u = glm::normalize(glm::cross(up, w));
    const vec3 v = glm::cross(w, u);
    return {s.size * (vec3(0, 0.2, 0) + s.distance * w), u, v, w, opening * opens / s.distance};
}

// The ray through the middle of a pixel. Rows count from the top.
Ray rayOf(const Settings& s, int column, int row) {
    const CastEye eye = eyeOf(s);
    const double middle = s.rows / 2.0;
    const double alpha = eye.half * (column + 0.5 - middle) / middle;
    const double beta = eye.half * (middle - (row + 0.5)) / middle;
    return {eye.at, glm::normalize(alpha * eye.u + beta * eye.v - eye.w)};
}

// Find the nearest triangle of the teapot by its tree.
static std::vector<CastCandidate> candidatesOfTeapot(const Triangles& teapot, const Ray& ray, double size) {
    const auto hit = teapot.tree->nearest({ray.origin / size, ray.direction / size});
    if (!hit) return {};
    return {{{hit->hit.t, normalOf(*hit->triangle)}, CastKind::teapot}};
}

// All objects that the ray meets, nearest first.
std::vector<CastCandidate> candidates(const Settings& s, const Shown& shown, const Ray& ray) {
    if (shown.teapot) return candidatesOfTeapot(*shown.teapot, ray, s.size);
    const CastWay way{s.form, s.plane, s.starts};
    const RayOf<float> inFloat{fvec3(ray.origin), fvec3(ray.direction)};
    std::vector<CastCandidate> met;
    for (const CastKind kind : shown.kinds) {
        const auto hit =
            s.precision == Precision::single ? castAt(kind, s.size, inFloat, way) : castAt(kind, s.size, ray, way);
        if (hit) met.push_back({*hit, kind});
    }
    std::ranges::stable_sort(met, {}, [](const CastCandidate& one) { return one.hit.t; });
    return met;
}

// Shade from either side, as the fragment shader does.
static vec3 shaded(const vec3& color, const vec3& normal) {
    const vec3 toLight = glm::normalize(vec3(0.5, 0.8, 0.35));
    return color * (0.35 + 0.65 * std::abs(glm::dot(glm::normalize(normal), toLight)));
}

// Enlarge the pixels to a picture of this width.
Picture pictureOf(const Settings& s, const Seen& seen, int width) {
    Picture picture(width, width);
    const auto byte = [](double value) { return static_cast<std::uint8_t>(std::lround(255 * value)); };
    for (int y = 0; y < width; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto& first = seen[pixelIndex(x * s.rows / width, y * s.rows / width, s.rows)];
            const vec3 color =
                first ? shaded(castColors.at(static_cast<std::size_t>(first->kind)), first->hit.normal) : vec3(sky);
            picture.set(x, y, {byte(color.x), byte(color.y), byte(color.z)});
        }
    }
    return picture;
}

}  // namespace mv::ray_cast
