#include "shared/relief_maps.h"

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "mv/image/normal_map.h"

namespace mv {

// How long a circle of latitude is, by the equator: that of the middle of a row of texels.
static double cosineOfRow(int row, int rows) { return std::sin(pi * (row + 0.5) / rows); }

FloatPicture paintedMap(ReliefBody body, int size) {
    const int width = body == ReliefBody::wall ? size : 2 * size;
    FloatPicture painted(width, size, 4);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < width; ++x) {
            const ReliefPoint at = reliefAt({body}, smoothPoint(body, {(x + 0.5) / width, (y + 0.5) / size}));
            float* const texel = &painted.values[4 * pixelIndex(x, y, width)];
            for (int i = 0; i < 3; ++i) texel[i] = static_cast<float>(at.color[i]);
            texel[3] = static_cast<float>(at.height);
        }
    }
    return painted;
}

FloatPicture reliefNormals(const Relief& relief, const FloatPicture& painted) {
    const vec2 texel = unitsOfRepeat(relief.body) / vec2(painted.width, painted.height);
    const bool isRound = relief.body == ReliefBody::orange;
    return normalMap(painted,
                     {.depth = relief.depth,
                      .texel = [=, rows = painted.height](
                                   int row) { return isRound ? texel * vec2(cosineOfRow(row, rows), 1) : texel; },
                      .repeatsV = !isRound,
                      .channel = 3});
}

// In the middle of a texel, in the frame along u, along v, out.
static vec3 trueNormal(const Relief& relief, int x, int y, int size) {
    const bool isRound = relief.body == ReliefBody::orange;
    const double u = (x + 0.5) / (isRound ? 2 * size : size), around = 2 * pi * u;
    const ReliefPoint at = reliefAt(relief, smoothPoint(relief.body, {u, (y + 0.5) / size}));
    const vec3 alongU = isRound ? vec3(-std::sin(around), 0, -std::cos(around)) : vec3(1, 0, 0);
    const vec3 alongV = glm::cross(at.out, alongU);
    return glm::normalize(
        vec3(-relief.depth * glm::dot(at.slope, alongU), -relief.depth * glm::dot(at.slope, alongV), 1));
}

double normalMapError(const Relief& relief, int size, bool inBytes) {
    const auto round = [&](FloatPicture& picture) {
        for (float& value : picture.values) value = std::round(255 * value) / 255;
    };
    FloatPicture painted = paintedMap(relief.body, size);
    if (inBytes) round(painted);
    FloatPicture normals = reliefNormals(relief, painted);
    if (inBytes) round(normals);
    double squares = 0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < normals.width; ++x) {
            const vec3 kept = normalOf(&normals.values[4 * pixelIndex(x, y, normals.width)]),
                       truth = trueNormal(relief, x, y, size);
            squares += std::pow(degrees(std::atan2(glm::length(glm::cross(kept, truth)), glm::dot(kept, truth))), 2);
        }
    }
    return std::sqrt(squares / (double(normals.width) * size));
}

}  // namespace mv
