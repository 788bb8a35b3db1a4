#include "relief_patches.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>

#include "mv/error.h"
#include "mv/geometry/tessellation.h"

namespace mv {
namespace {

constexpr double side = 0.75;  // of the wall's patches
constexpr int acrossFace = 4;

// A face of the cube -1..1: its middle, and two directions along the face whose cross product is the middle.
struct Face {
    vec3 middle, alongU, alongV;
};
const std::array<Face, 6> faces{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                 {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}},
                                 {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                 {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                 {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                 {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}}};

vec3 smoothAt(ReliefBody body, const ReliefPatch& patch, double u, double v) {
    const vec3 at = (patch[0] * (1 - u) + patch[1] * u) * (1 - v) + (patch[2] * (1 - u) + patch[3] * u) * v;
    return body == ReliefBody::orange ? glm::normalize(at) : at;
}

vec3 middleOf(const ReliefPatch& patch) { return glm::normalize(patch[0] + patch[1] + patch[2] + patch[3]); }

// The texture coordinates of the maps: smoothPoint() is the inverse. A pole, where u has no meaning, takes that of the patch's
// middle.
vec2 texCoordOf(ReliefBody body, const ReliefPatch& patch, const vec3& p) {
    if (body == ReliefBody::wall) return {p.x / 2, (p.y + 1) / 2};
    const auto around = [](const vec3& at) { return std::atan2(-at.z, at.x) / (2 * pi); };
    const double middle = around(middleOf(patch)), across = std::hypot(p.x, p.z);
    const double u = across < 1e-9 ? middle : around(p);
    return {u - std::round(u - middle), 0.5 + std::atan2(p.y, across) / pi};
}

}  // namespace

std::vector<ReliefPatch> reliefPatches(ReliefBody body) {
    std::vector<ReliefPatch> patches;
    if (body == ReliefBody::wall) {
        const auto columns = static_cast<int>((wallEnd - wallStart) / side),
                   rows = static_cast<int>(2 * wallTop / side);
        patches.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
        for (int j = 0; j < rows; ++j) {
            for (int i = 0; i < columns; ++i) {
                const auto corner = [&](int x, int y) {
                    return vec3(wallStart + side * (i + x), -wallTop + side * (j + y), 0);
                };
                patches.push_back({corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)});
            }
        }
        return patches;
    }
    patches.reserve(faces.size() * acrossFace * acrossFace);
    for (const Face& face : faces) {
        for (int j = 0; j < acrossFace; ++j) {
            for (int i = 0; i < acrossFace; ++i) {
                // Sums of halves are exact, so two faces have the same corners.
                const auto corner = [&](int x, int y) {
                    return glm::normalize(face.middle + (2.0 * (i + x) / acrossFace - 1) * face.alongU +
                                          (2.0 * (j + y) / acrossFace - 1) * face.alongV);
                };
                patches.push_back({corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)});
            }
        }
    }
    return patches;
}

std::vector<MeshData> patchCorners(const std::vector<ReliefPatch>& patches, int parts) {
    if (parts < 1) throw Error("patchCorners", "must be in one part at least", std::to_string(parts));
    std::vector<MeshData> made(static_cast<std::size_t>(parts), {.primitive = Primitive::points});
    for (std::size_t i = 0; i < patches.size(); ++i) {
        for (const vec3& corner : patches[i]) made[i % made.size()].positions.emplace_back(corner);
    }
    return made;
}

MeshData cutPatches(ReliefBody body, int cells) {
    if (cells < 1 || cells > largestLevel)
        throw Error("cutPatches", "must have cells in 1 .. 64", std::to_string(cells));
    MeshData mesh;
    for (const ReliefPatch& patch : reliefPatches(body)) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (int j = 0; j <= cells; ++j) {
            for (int i = 0; i <= cells; ++i) {
                const vec3 at = smoothAt(body, patch, double(i) / cells, double(j) / cells);
                mesh.positions.emplace_back(at);
                mesh.normals.emplace_back(body == ReliefBody::orange ? at : vec3(0, 0, 1));
                mesh.texCoords.emplace_back(texCoordOf(body, patch, at));
            }
        }
        const auto at = [&](int i, int j) { return first + static_cast<std::uint32_t>(j * (cells + 1) + i); };
        for (int j = 0; j < cells; ++j) {
            for (int i = 0; i < cells; ++i) {
                for (const std::uint32_t vertex :
                     {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)})
                    mesh.indices.push_back(vertex);
            }
        }
    }
    return mesh;
}

long PatchLevels::triangles() const { return isLeftOut() ? 0 : trianglesOfSquare(inner, outer); }

long PatchLevels::vertices() const {
    if (isLeftOut()) return 0;
    const double within = std::ceil(inner) - 1;
    double around = 0;
    for (const double level : outer) around += std::ceil(level);
    return static_cast<long>(around + within * within);
}

PatchLevels patchLevels(const Relief& relief, const ReliefPatch& patch, const LevelRule& rule,
                        const mat4& clipFromBody) {
    if (rule.leavesOut && isOutsideView(relief, patch, clipFromBody)) return {};
    const auto level = [&](std::size_t a, std::size_t b) {
        if (rule.fixedLevel > 0) return levelInRange(rule.fixedLevel);
        // Without edge levels the whole patch has one level: that of a line between the middles of two sides
        const vec3 from = rule.agrees ? patch.at(a) : 0.5 * (patch[0] + patch[2]);
        const vec3 to = rule.agrees ? patch.at(b) : 0.5 * (patch[1] + patch[3]);
        return edgeLevel(from, to, rule.eye, rule.fineness);
    };
    PatchLevels levels{{level(0, 2), level(0, 1), level(1, 3), level(2, 3)}};
    levels.inner = *std::max_element(levels.outer.begin(), levels.outer.end());
    return levels;
}

bool isOutsideView(const Relief& relief, const ReliefPatch& patch, const mat4& clipFromBody) {
    // A body with flat faces that holds the moved patch: of the wall a box; of the orange the pyramid from its middle through
    // the corners, between the plane that touches the sphere in the patch's middle and one that is as deep as the corners and
    // the relief.
    const bool isRound = relief.body == ReliefBody::orange;
    const vec3 middle = isRound ? middleOf(patch) : vec3(0, 0, 1);
    double least = 1;
    for (const vec3& corner : patch) least = std::min(least, glm::dot(corner, middle));
    std::array<vec4, 8> ends;
    for (std::size_t i = 0; i < 4; ++i) {
        const vec3 top = isRound ? patch.at(i) / glm::dot(patch.at(i), middle) : patch.at(i);
        const vec3 bottom = isRound ? (1 - relief.depth) * least * top : top - relief.depth * middle;
        ends.at(2 * i) = clipFromBody * vec4(top, 1);
        ends.at(2 * i + 1) = clipFromBody * vec4(bottom, 1);
    }
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            if (std::all_of(ends.begin(), ends.end(), [&](const vec4& end) { return sign * end[axis] > end.w; }))
                return true;
        }
    }
    return false;
}

PatchCount countPatches(const std::vector<ReliefPatch>& patches, const Relief& relief, const LevelRule& rule,
                        const mat4& clipFromBody) {
    PatchCount count{.patches = static_cast<long>(patches.size())};
    for (const ReliefPatch& patch : patches) {
        const PatchLevels levels = patchLevels(relief, patch, rule, clipFromBody);
        count.leftOut += levels.isLeftOut() ? 1 : 0;
        count.outside += isOutsideView(relief, patch, clipFromBody) ? 1 : 0;
        count.triangles += levels.triangles();
        count.vertices += levels.vertices();
    }
    return count;
}

double heightMapError(const Relief& relief, int size) {
    const bool isRound = relief.body == ReliefBody::orange;
    const int width = isRound ? 2 * size : size;
    const auto texel = [&](int x, int y) {
        const int row = isRound ? std::clamp(y, 0, size - 1) : y;
        return reliefHeight(relief, smoothPoint(relief.body, {(x + 0.5) / width, (row + 0.5) / size}));
    };
    // Samples of places that fill the map evenly, between its texels.
    constexpr int places = 2000;
    double squares = 0, weights = 0;
    for (int i = 0; i < places; ++i) {
        const double u = (i + 0.5) / places, golden = 0.6180339887498949 * i, v = golden - std::floor(golden);
        const double x = u * width - 0.5, y = v * size - 0.5;
        const auto left = static_cast<int>(std::floor(x)), low = static_cast<int>(std::floor(y));
        const double across = x - left, up = y - low;
        const double between = (texel(left, low) * (1 - across) + texel(left + 1, low) * across) * (1 - up) +
                               (texel(left, low + 1) * (1 - across) + texel(left + 1, low + 1) * across) * up;
        const double weight = isRound ? std::sin(pi * v) : 1;  // of the area
        squares += weight * std::pow(between - reliefHeight(relief, smoothPoint(relief.body, {u, v})), 2);
        weights += weight;
    }
    return relief.depth * std::sqrt(squares / weights);
}

}  // namespace mv
