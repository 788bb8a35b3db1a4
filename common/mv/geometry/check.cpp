#include "mv/geometry/check.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <string>
#include <utility>

#include "mv/error.h"

namespace mv {
namespace {

std::size_t verticesDrawn(const MeshData& mesh) {
    return mesh.indices.empty() ? mesh.positions.size() : mesh.indices.size();
}

template <typename V>
void requireArray(const std::vector<V>& values, const std::string& name, std::size_t positions) {
    if (!values.empty() && values.size() != positions) {
        throw Error("mesh", name + " must be absent or as many as positions, " + std::to_string(positions),
                    std::to_string(values.size()));
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        for (int k = 0; k < V::length(); ++k) {
            if (std::isfinite(values[i][k])) continue;
            throw Error("mesh", name + "[" + std::to_string(i) + "] must be finite",
                        numberText(static_cast<double>(values[i][k])));
        }
    }
}

void requireVertexCount(Primitive primitive, std::size_t count) {
    const std::string value = std::to_string(count);
    switch (primitive) {
        case Primitive::triangles:
            if (count % 3 != 0) throw Error("mesh", "triangles need a multiple of 3 vertices", value);
            break;
        case Primitive::triangleStrip:
        case Primitive::triangleFan:
            if (count < 3) throw Error("mesh", "a strip or fan needs at least 3 vertices", value);
            break;
        case Primitive::lines:
            if (count % 2 != 0) throw Error("mesh", "lines need a multiple of 2 vertices", value);
            break;
        case Primitive::points:
            break;
    }
}

}  // namespace

void validate(const MeshData& mesh) {
    if (mesh.positions.empty()) throw Error("mesh", "there must be at least 1 position", "0");
    const std::size_t positions = mesh.positions.size();
    requireArray(mesh.positions, "positions", positions);
    requireArray(mesh.normals, "normals", positions);
    requireArray(mesh.colors, "colors", positions);
    requireArray(mesh.texCoords, "texCoords", positions);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        if (mesh.indices[i] < positions) continue;
        throw Error("mesh", "indices[" + std::to_string(i) + "] must be less than " + std::to_string(positions),
                    std::to_string(mesh.indices[i]));
    }
    requireVertexCount(mesh.primitive, verticesDrawn(mesh));
}

std::vector<std::array<std::uint32_t, 3>> trianglesOf(const MeshData& mesh) {
    const std::size_t count = triangleCount(mesh);
    const auto vertex = [&mesh](std::size_t i) {
        return mesh.indices.empty() ? static_cast<std::uint32_t>(i) : mesh.indices[i];
    };
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangles.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (mesh.primitive == Primitive::triangles) {
            triangles.push_back({vertex(3 * i), vertex(3 * i + 1), vertex(3 * i + 2)});
        } else if (mesh.primitive == Primitive::triangleFan) {
            triangles.push_back({vertex(0), vertex(i + 1), vertex(i + 2)});
        } else {
            const std::size_t odd = i % 2;
            triangles.push_back({vertex(i + odd), vertex(i + 1 - odd), vertex(i + 2)});
        }
    }
    return triangles;
}

std::size_t triangleCount(const MeshData& mesh) {
    validate(mesh);
    const std::size_t count = verticesDrawn(mesh);
    switch (mesh.primitive) {
        case Primitive::triangles:
            return count / 3;
        case Primitive::triangleStrip:
        case Primitive::triangleFan:
            return count - 2;
        case Primitive::lines:
        case Primitive::points:
            break;
    }
    return 0;
}

std::vector<std::uint32_t> weldByPosition(const std::vector<fvec3>& positions) {
    // Compared as numbers: -0 equals 0. NaN, which would break the order, is for validate() to refuse.
    std::map<std::array<float, 3>, std::uint32_t> firstAt;
    std::vector<std::uint32_t> welded;
    welded.reserve(positions.size());
    for (const fvec3& p : positions) {
        const auto here = static_cast<std::uint32_t>(welded.size());
        welded.push_back(firstAt.try_emplace({p.x, p.y, p.z}, here).first->second);
    }
    return welded;
}

bool isClosed(const MeshData& mesh) {
    const auto triangles = trianglesOf(mesh);
    const std::vector<std::uint32_t> welded = weldByPosition(mesh.positions);

    // An edge counts +1 from its lower to its higher end and -1 the other way: matched edges sum to 0.
    std::map<std::pair<std::uint32_t, std::uint32_t>, long long> balance;
    for (const auto& triangle : triangles) {
        const std::array<std::uint32_t, 3> corner{welded[triangle[0]], welded[triangle[1]], welded[triangle[2]]};
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = corner[i];
            const std::uint32_t to = corner[(i + 1) % 3];
            if (from < to) {
                ++balance[{from, to}];
            } else {
                --balance[{to, from}];
            }
        }
    }
    for (const auto& [edge, sum] : balance) {
        if (sum != 0) return false;
    }
    return !balance.empty();
}

double signedVolume(const MeshData& mesh) {
    if (!isClosed(mesh)) throw Error("signedVolume", "the mesh must be closed");

    // Seen from a point of the mesh itself, so that a small solid far away loses nothing to cancellation.
    const vec3 base(mesh.positions.front());
    double sum = 0;
    for (const auto& [i, j, k] : trianglesOf(mesh)) {
        const vec3 a = vec3(mesh.positions[i]) - base;
        const vec3 b = vec3(mesh.positions[j]) - base;
        const vec3 c = vec3(mesh.positions[k]) - base;
        sum += glm::dot(a, glm::cross(b, c));
    }
    return sum / 6;
}

}  // namespace mv
