// The surfaces of texture-map, F(u, v) for u and v from 0 to 1: a square, a cylinder and a sphere, with their cameras.
#include <cmath>
#include <cstdint>

#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "perspective_quad.h"
#include "texture-map.h"

namespace mv::texture_map {

vec3 surfacePoint(Shape shape, Formula formula, double u, double v) {
    const double around = 2 * pi * u, height = 2;
    if (shape == Shape::quad) return {u, v, 0};
    if (shape == Shape::cylinder)
        return {std::cos(around), (formula == Formula::lecture ? 1 : v) * height, std::sin(around)};
    const double up = pi * (v - 0.5), out = std::cos(up);
    return {out * std::cos(around), std::sin(up), out * std::sin(around)};
}

// A grid of cells of two triangles. At a pole one triangle of a cell is a line, so the cell has only the other.
MeshData surfaceMesh(Shape shape, const Surface& surface) {
    const int columns = shape == Shape::quad ? surface.divisions : 4 * surface.divisions;
    const int rows = shape == Shape::sphere ? 2 * surface.divisions : surface.divisions;
    MeshData made;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            const double u = double(i) / columns, v = double(j) / rows;
            made.positions.emplace_back(surfacePoint(shape, surface.formula, u, v));
            made.texCoords.emplace_back(u, v);
        }
    }
    const bool sharesSeam = shape != Shape::quad && surface.seam == Seam::shared;
    const auto corner = [&](int i, int j) {
        return static_cast<std::uint32_t>(j * (columns + 1) + (sharesSeam ? i % columns : i));
    };
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const auto a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
            if (shape != Shape::sphere || j > 0) made.indices.insert(made.indices.end(), {a, b, c});
            if (shape != Shape::sphere || j < rows - 1) made.indices.insert(made.indices.end(), {a, c, d});
        }
    }
    return made;
}

// The lecture's other order, from texels to pixels: a point for each texel, on the pixel that the texel falls on.
MeshData texelPoints(Shape shape, const Surface& surface, int texels) {
    MeshData made{.primitive = Primitive::points};
    for (int j = 0; j < texels; ++j) {
        for (int i = 0; i < texels; ++i) {
            const double u = (i + 0.5) / texels, v = (j + 0.5) / texels;
            made.positions.emplace_back(surfacePoint(shape, surface.formula, u, v));
            made.texCoords.emplace_back(u, v);
        }
    }
    return made;
}

mat4 clipFromSurface(Shape shape, const Surface& surface, const Pane& pane) {
    if (shape == Shape::quad) return clipFromQuad(surface.ratio);
    const mat4 clipFromView = perspective(50, pane.aspect(), 0.1, 20);
    const double middle = shape == Shape::cylinder ? -1 : 0;
    return clipFromView * lookAt(vec3(0, 1.8, 3.3), vec3(0), vec3(0, 1, 0)) * rotateY(surface.turn) *
           translate(0, middle, 0);
}

}  // namespace mv::texture_map
