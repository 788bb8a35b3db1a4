#include "primitive_types.h"

#include <cmath>

#include "mv/error.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

constexpr GLenum quads = 0x0007, quadStrip = 0x0008, polygon = 0x0009;

}  // namespace

long primitivesOf(const PrimitiveType& type, int vertices) {
    switch (type.mode) {
        case GL_POINTS:
            return vertices;
        case GL_LINES:
            return vertices / 2;
        case GL_LINE_STRIP:
            return vertices < 2 ? 0 : vertices - 1;
        case GL_LINE_LOOP:
            return vertices < 2 ? 0 : vertices;
        case GL_TRIANGLES:
            return vertices / 3;
        case quads:
            return vertices / 4;
        case quadStrip:
            return vertices < 4 ? 0 : (vertices - 2) / 2;
        case polygon:
            return vertices < 3 ? 0 : 1;
        default:  // strip and fan
            return vertices < 3 ? 0 : vertices - 2;
    }
}

std::vector<std::uint32_t> asTriangles(const PrimitiveType& type, int vertices) {
    if (type.inCore) throw Error("asTriangles", "is for types that have left the core", type.name);
    std::vector<std::uint32_t> indices;
    const auto count = static_cast<std::uint32_t>(vertices);
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t last) {
        indices.insert(indices.end(), {a, b, last});
    };
    if (type.mode == polygon) {
        for (std::uint32_t i = 1; i + 1 < count; ++i) add(i, i + 1, 0);
    } else if (type.mode == quads) {
        for (std::uint32_t i = 0; i + 3 < count; i += 4) {
            add(i, i + 1, i + 3);
            add(i + 1, i + 2, i + 3);
        }
    } else {  // (0, 1, 3, 2), (2, 3, 5, 4) ...
        for (std::uint32_t i = 0; i + 3 < count; i += 2) {
            add(i, i + 1, i + 3);
            add(i + 2, i, i + 3);
        }
    }
    return indices;
}

bool standsInRing(const PrimitiveType& type) {
    return type.mode == GL_LINE_LOOP || type.mode == GL_TRIANGLE_FAN || type.mode == polygon;
}

std::vector<vec2> placesOf(const PrimitiveType& type, int vertices) {
    const bool pairs = type.mode == GL_LINES || type.mode == quadStrip;
    std::vector<vec2> places;
    for (int i = 0; i < vertices; ++i) {
        if (standsInRing(type)) {
            const double angle = radians(360.0 * i / vertices);
            places.emplace_back(0.75 * std::cos(angle), 0.75 * std::sin(angle));
        } else if (type.mode == quads) {  // two beside each other, each counter-clockwise
            const double left = i < 4 ? -0.95 : 0.2;
            places.emplace_back(left + (i % 4 == 1 || i % 4 == 2 ? 0.75 : 0), i % 4 < 2 ? -0.5 : 0.5);
        } else if (pairs) {
            const int pair = i / 2, last = (vertices - 1) / 2;
            places.emplace_back(-0.85 + 1.7 * pair / last, i % 2 == 0 ? -0.5 : 0.5);
        } else {
            places.emplace_back(-0.85 + 1.7 * i / (vertices - 1), i % 2 == 0 ? -0.5 : 0.5);
        }
    }
    return places;
}

}  // namespace mv
