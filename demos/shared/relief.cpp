#include "shared/relief.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

#include "mv/error.h"

namespace mv {
namespace {

// 0..1, the same for the same number. Source: Steele, Lea, Flood, SplitMix (2014).
double scattered(std::int64_t n) {
    std::uint64_t z = (static_cast<std::uint64_t>(n) + 1) * 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

// 0 up to 0, 1 from 1 on, with two continuous derivatives; and its derivative.
vec2 stepped(double t) {
    if (t <= 0) return {0, 0};
    if (t >= 1) return {1, 0};
    return {t * t * t * (t * (t * 6 - 15) + 10), 30 * t * t * (t - 1) * (t - 1)};
}

// ---- bricks: mortar, an edge that rises, and a face that is slightly rough

constexpr double mortar = 0.03, bevel = 0.07, roughness = 0.12;  // half its width; units; heights

// Across one side of a brick of that length: its height there, and how that changes.
vec2 riseAcross(double at, double length) {
    const double within = at - length * std::floor(at / length), low = std::min(within, length - within);
    const vec2 rise = stepped((low - mortar) / bevel);
    return {rise.x, (within < length / 2 ? 1 : -1) * rise.y / bevel};
}

// The shift of the bricks of its row, 0 or 1/2.
double shiftOf(double row) { return 0.5 * (row - 2 * std::floor(row / 2)); }

double brickHeight(double x, double y) {
    const double brick = riseAcross(x + shiftOf(std::floor(2 * y)), 1).x * riseAcross(y, 0.5).x;
    if (brick == 0) return 0;
    return brick * (1 - roughness * (0.5 + 0.5 * std::sin(5 * pi * x) * std::sin(7 * pi * y)));
}

ReliefPoint brickAt(double x, double y) {
    const double row = std::floor(2 * y), shift = shiftOf(row);
    const vec2 across = riseAcross(x + shift, 1), up = riseAcross(y, 0.5);
    const double inX = 5 * pi * x, inY = 7 * pi * y;
    const double face = 1 - roughness * (0.5 + 0.5 * std::sin(inX) * std::sin(inY));
    const vec2 ofFace =
        -0.5 * roughness * pi * vec2(5 * std::cos(inX) * std::sin(inY), 7 * std::sin(inX) * std::cos(inY));
    const double brick = across.x * up.x;
    const auto column = static_cast<std::int64_t>(std::floor(x + shift));
    const double shade = scattered(4 * (column & 1) + (static_cast<std::int64_t>(row) & 3));
    const double body = stepped((brick - 0.1) / 0.4).x;
    return {.smooth = vec3(x, y, 0),
            .out = vec3(0, 0, 1),
            .height = brick * face,
            .slope = vec3(across.y * up.x * face + brick * ofFace.x, across.x * up.y * face + brick * ofFace.y, 0),
            .color = glm::mix(vec3(0.55, 0.52, 0.48), vec3(0.50, 0.13, 0.07) * (0.7 + 0.6 * shade), body)};
}

// ---- peel: pores about points that are scattered, one in each cell of space and well within it

constexpr double cellSide = 0.17, poreRadius = 0.62 * cellSide, poreDepth = 1.5;

vec3 poreIn(std::int64_t i, std::int64_t j, std::int64_t k) {
    const std::int64_t cell = ((k + 512) * 1024 + (j + 512)) * 1024 + (i + 512);
    const vec3 part(scattered(3 * cell), scattered(3 * cell + 1), scattered(3 * cell + 2));
    return cellSide * (vec3(double(i), double(j), double(k)) + 0.5 + 0.6 * (part - 0.5));
}

// All pores at p together, and how that changes.
struct Pores {
    double sum = 0;
    vec3 change{0};
};
Pores poresAt(const vec3& p) {
    const auto cellOf = [](double x) { return static_cast<std::int64_t>(std::floor(x / cellSide)); };
    Pores pores;
    for (std::int64_t k = cellOf(p.z - poreRadius); k <= cellOf(p.z + poreRadius); ++k) {
        for (std::int64_t j = cellOf(p.y - poreRadius); j <= cellOf(p.y + poreRadius); ++j) {
            for (std::int64_t i = cellOf(p.x - poreRadius); i <= cellOf(p.x + poreRadius); ++i) {
                const vec3 away = p - poreIn(i, j, k);
                const double left = 1 - glm::dot(away, away) / (poreRadius * poreRadius);
                if (left <= 0) continue;
                pores.sum += left * left * left;
                pores.change -= 6 * left * left / (poreRadius * poreRadius) * away;
            }
        }
    }
    return pores;
}

ReliefPoint peelAt(const vec3& p) {
    const Pores pores = poresAt(p);
    const double height = std::exp(-poreDepth * pores.sum);
    const vec3 slope = -poreDepth * height * pores.change;
    return {.smooth = p,
            .out = p,
            .height = height,
            .slope = slope - glm::dot(slope, p) * p,
            .color = glm::mix(vec3(0.62, 0.20, 0.01), vec3(0.90, 0.36, 0.03), height)};
}

// ---- a height map

// The texture coordinates of a point of the smooth surface, or beside it.
vec2 texCoordOf(ReliefBody body, const vec3& near) {
    if (body == ReliefBody::wall) return {near.x / 2, (near.y + 1) / 2};
    const vec3 out = glm::normalize(near);
    return {std::atan2(-out.z, out.x) / (2 * pi), 0.5 + std::asin(std::clamp(out.y, -1.0, 1.0)) / pi};
}

// Between the four texels around, of which those of the far edges are neighbours but at poles, as GL_REPEAT and the clamp have it.
float heightIn(const FloatPicture& map, int x, int y, bool isRound) {
    const auto wrapped = [](int i, int n) { return (i % n + n) % n; };
    const int row = isRound ? std::clamp(y, 0, map.height - 1) : wrapped(y, map.height);
    return map.values[4 * pixelIndex(wrapped(x, map.width), row, map.width) + 3];
}
double heightIn(const FloatPicture& map, const vec2& texCoord, bool isRound) {
    const vec2 at = texCoord * vec2(map.width, map.height) - 0.5, low = glm::floor(at), part = at - low;
    const int x = static_cast<int>(low.x), y = static_cast<int>(low.y);
    const auto height = [&](int i, int j) { return double(heightIn(map, x + i, y + j, isRound)); };
    return glm::mix(glm::mix(height(0, 0), height(1, 0), part.x), glm::mix(height(0, 1), height(1, 1), part.x), part.y);
}

ReliefPoint ownAt(const FloatPicture& map, ReliefBody body, const vec3& near) {
    const bool isRound = body == ReliefBody::orange;
    const vec2 at = texCoordOf(body, near), texel = 1.0 / vec2(map.width, map.height);
    const vec3 smooth = isRound ? glm::normalize(near) : vec3(near.x, near.y, 0);
    const vec3 out = isRound ? smooth : vec3(0, 0, 1);
    // The slope is by the difference of the two neighbours, as normalMap() has it; at a pole all ways lead along u, and
    // the slope is 0
    const vec2 change =
        vec2(heightIn(map, at + vec2(texel.x, 0), isRound) - heightIn(map, at - vec2(texel.x, 0), isRound),
             heightIn(map, at + vec2(0, texel.y), isRound) - heightIn(map, at - vec2(0, texel.y), isRound)) /
        (2.0 * texel * unitsOfRepeat(body));
    const double around = isRound ? glm::length(vec2(smooth.x, smooth.z)) : 1;
    const vec3 alongU = isRound && around > 0 ? vec3(smooth.z, 0, -smooth.x) / around : vec3(1, 0, 0);
    const double alongLatitude = isRound ? std::max(around, texel.y * pi) : 1;
    return {.smooth = smooth,
            .out = out,
            .height = heightIn(map, at, isRound),
            .slope = change.x / alongLatitude * alongU + change.y * glm::cross(out, alongU),
            .color = vec3(map.values[0], map.values[1], map.values[2])};
}

}  // namespace

ReliefPoint reliefAt(const Relief& relief, const vec3& near) {
    const auto plain = [&](double x) {
        return relief.own ? ownAt(*relief.own, relief.body, {x, near.y, near.z}) : brickAt(x, near.y);
    };
    if (relief.body == ReliefBody::orange) return relief.own ? plain(near.x) : peelAt(glm::normalize(near));
    if (!relief.isMirrored || near.x >= 0) return plain(near.x);
    ReliefPoint mirrored = plain(-near.x);
    mirrored.smooth.x = near.x;
    mirrored.slope.x = -mirrored.slope.x;
    return mirrored;
}

double reliefHeight(const Relief& relief, const vec3& near) {
    if (relief.own) return reliefAt(relief, near).height;
    if (relief.body == ReliefBody::orange) return std::exp(-poreDepth * poresAt(glm::normalize(near)).sum);
    return brickHeight(relief.isMirrored ? std::abs(near.x) : near.x, near.y);
}

double steepest(ReliefBody body) { return body == ReliefBody::wall ? 29 : 20; }

vec3 displacedPoint(const Relief& relief, const ReliefPoint& at) {
    return at.smooth - relief.depth * (1 - at.height) * at.out;
}

vec3 displacedNormal(const Relief& relief, const ReliefPoint& at) {
    // Along the orange a unit of the smooth surface is shorter below it.
    const double size = relief.body == ReliefBody::orange ? 1 - relief.depth * (1 - at.height) : 1;
    return glm::normalize(at.out - relief.depth / size * at.slope);
}

MeshData displaced(const Relief& relief, const MeshData& smooth) {
    MeshData moved = smooth;
    for (std::size_t i = 0; i < smooth.positions.size(); ++i) {
        const ReliefPoint at = reliefAt(relief, vec3(smooth.positions[i]));
        moved.positions[i] = fvec3(displacedPoint(relief, at));
        moved.normals[i] = fvec3(displacedNormal(relief, at));
    }
    return moved;
}

MeshData wallPiece(const Relief& relief, double fromX, double toX, int cellsX, int cellsY) {
    if (!(fromX < toX) || cellsX < 1 || cellsY < 1)
        throw Error("wallPiece", "must have a length and cells", numberText(toX - fromX));
    MeshData mesh;
    for (int j = 0; j <= cellsY; ++j) {
        for (int i = 0; i <= cellsX; ++i) {
            const double x = fromX + (toX - fromX) * i / cellsX, y = -1 + 2.0 * j / cellsY;
            mesh.positions.emplace_back(x, y, 0);
            mesh.normals.emplace_back(0, 0, 1);
            mesh.texCoords.emplace_back((relief.isMirrored ? std::abs(x) : x) / 2, (y + 1) / 2);
        }
    }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cellsX + 1) + i); };
    for (int j = 0; j < cellsY; ++j) {
        for (int i = 0; i < cellsX; ++i) {
            for (const std::uint32_t vertex :
                 {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)})
                mesh.indices.push_back(vertex);
        }
    }
    return mesh;
}

vec3 smoothPoint(ReliefBody body, const vec2& texCoord) {
    if (body == ReliefBody::wall) return {2 * texCoord.x, 2 * texCoord.y - 1, 0};
    const double around = 2 * pi * texCoord.x, up = pi * (texCoord.y - 0.5);
    return {std::cos(up) * std::cos(around), std::sin(up), -std::cos(up) * std::sin(around)};
}

vec2 unitsOfRepeat(ReliefBody body) { return body == ReliefBody::wall ? vec2(2, 2) : vec2(2 * pi, pi); }

vec2 parallaxShift(const vec3& view, double depth, double height) {
    return -depth * (1 - height) / std::max(view.z, flattestSight) * vec2(view);
}

vec3 reliefLight(const vec3& color, const vec3& normal, const vec3& light, const vec3& view) {
    const double diffuse = std::max(glm::dot(normal, light), 0.0);
    const vec3 both = light + view;
    const double cosine = diffuse > 0 && both != vec3(0) ? std::max(glm::dot(normal, glm::normalize(both)), 0.0) : 0;
    return (0.2 + 0.8 * diffuse) * color + 0.15 * std::pow(cosine, 40);
}

}  // namespace mv
