#include "vanishing.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "mv/error.h"
#include "mv/math/projection.h"
#include "mv/math/require.h"
#include "mv/math/transform.h"

namespace mv {

MeshData linesToInfinity(std::span<const vec3> points) {
    MeshData lines;
    lines.primitive = Primitive::lines;
    for (int axis = 0; axis < 3; ++axis) {
        fvec3 direction(0);
        direction[axis] = 1;
        for (const vec3& point : points) {
            requireFitsFloat("linesToInfinity", "a point", point);
            lines.positions.insert(lines.positions.end(), {fvec3(point), direction});
            lines.texCoords.insert(lines.texCoords.end(), {fvec2(0), fvec2(1)});
        }
    }
    return lines;
}

MeshData horizonLines() {
    constexpr int parts = 64;
    MeshData lines;
    lines.primitive = Primitive::lines;
    for (int i = 0; i < parts; ++i) {
        for (const int end : {i, i + 1}) {
            lines.positions.emplace_back(rotateY(end * 360.0 / parts) * vec4(1, 0, 0, 0));
            lines.texCoords.emplace_back(1);
        }
    }
    return lines;
}

std::optional<vec2> vanishingPoint(const mat4& clipFromWorld, const vec3& direction, int width, int height) {
    requireFinite("vanishingPoint", "the matrix", clipFromWorld);
    requireFinite("vanishingPoint", "the direction", direction);
    if (direction == vec3(0)) throw Error("vanishingPoint", "the direction must not be 0");
    const vec4 image = clipFromWorld * vec4(direction, 0);
    // w is the distance before the eye that the direction gains, in units of the matrix
    const vec3 towardsPicture(clipFromWorld[0].w, clipFromWorld[1].w, clipFromWorld[2].w);
    if (std::abs(image.w) <= 1e-12 * glm::length(towardsPicture) * glm::length(direction)) return std::nullopt;
    return pixelFromNdc(vec2(image) / image.w, width, height);
}

double missOfVanishingPoint(const vec2& point, const std::array<vec3, 2>& edge, const mat4& clipFromWorld, int width,
                            int height) {
    std::array<vec2, 2> ends;
    for (std::size_t i = 0; i < 2; ++i) {
        const fvec4 clip = fmat4(clipFromWorld) * fvec4(fvec3(edge[i]), 1);
        ends[i] = pixelFromNdc(ndcFromClip(vec4(clip)), width, height);
    }
    const vec2 along = point - ends[0], drawn = ends[1] - ends[0];
    const double length = glm::length(along);
    // An edge on the line through the eye is drawn as one point, which is the vanishing point itself
    if (length == 0) return glm::length(drawn);
    return std::abs(along.x * drawn.y - along.y * drawn.x) / length;
}

}  // namespace mv
