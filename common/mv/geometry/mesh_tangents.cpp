#include "mv/geometry/mesh_tangents.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <string>
#include <utility>

#include "mv/error.h"
#include "mv/geometry/check.h"
#include "mv/math/robust.h"

namespace mv {
namespace {

using Corners = std::array<std::uint32_t, 3>;

// A triangle's contribution at one of its corners: where u grows there, times the angle of the corner.
struct Saying {
    std::uint32_t vertex;
    vec3 along;
};

// 1, -1 where the texture is mirrored, 0 where it has no area; and where u grows.
struct Growth {
    int sign = 0;
    vec3 along{0};
};
Growth growthOf(const MeshData& mesh, const Corners& corners) {
    const auto position = [&](std::size_t i) { return vec3(mesh.positions[corners[i]]); };
    const auto texCoord = [&](std::size_t i) { return vec2(mesh.texCoords[corners[i]]); };
    const vec3 a = position(1) - position(0), b = position(2) - position(0);
    const vec2 ofA = texCoord(1) - texCoord(0), ofB = texCoord(2) - texCoord(0);
    const double area = differenceOfProducts(ofA.x, ofB.y, ofB.x, ofA.y);
    if (area == 0) return {};
    const vec3 normals =
        vec3(mesh.normals[corners[0]]) + vec3(mesh.normals[corners[1]]) + vec3(mesh.normals[corners[2]]);
    const bool turned = glm::dot(scaledForSquares(glm::cross(scaledForSquares(a), scaledForSquares(b))), normals) < 0;
    return {(area < 0) == turned ? 1 : -1, (area < 0 ? -1.0 : 1.0) * (ofB.y * a - ofA.y * b)};
}

double angleBetween(const vec3& a, const vec3& b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

// The part of v across the unit vector n, as a unit vector; 0 where there is none.
vec3 across(const vec3& v, const vec3& n) {
    if (v == vec3(0)) return v;
    const vec3 way = unit(v), part = way - glm::dot(way, n) * n;
    return glm::length(part) > 1e-9 ? unit(part) : vec3(0);
}

vec3 anyAcross(const vec3& n) {
    const vec3 size = glm::abs(n);
    const vec3 axis = size.x <= size.y && size.x <= size.z ? vec3(1, 0, 0)
                      : size.y <= size.z                   ? vec3(0, 1, 0)
                                                           : vec3(0, 0, 1);
    return unit(glm::cross(axis, n));
}

// Gives each vertex one sign: those with triangles of both get a second vertex for the mirrored ones. Triangles without
// a sign take the vertex that is there.
class Splitting {
  public:
    Splitting(MeshTangents& made, const std::vector<Corners>& triangles, const std::vector<Growth>& growths)
        : made_(made), signs_(made.mesh.positions.size(), 0) {
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            Corners corners = triangles[t];
            if (growths[t].sign != 0) {
                for (std::uint32_t& vertex : corners) vertex = withSign(vertex, growths[t].sign);
            }
            corners_.push_back(corners);
        }
    }
    const std::vector<Corners>& corners() const { return corners_; }
    const std::vector<int>& signs() const { return signs_; }

  private:
    std::uint32_t withSign(std::uint32_t vertex, int sign) {
        if (signs_[vertex] == 0) signs_[vertex] = sign;
        if (signs_[vertex] == sign) return vertex;
        const auto [at, isNew] = second_.try_emplace(vertex, static_cast<std::uint32_t>(signs_.size()));
        if (isNew) {
            const auto repeat = [vertex](auto& values) {
                if (values.empty()) return;
                const auto value = values[vertex];  // a copy: push_back may move what it refers to
                values.push_back(value);
            };
            repeat(made_.mesh.positions);
            repeat(made_.mesh.normals);
            repeat(made_.mesh.colors);
            repeat(made_.mesh.texCoords);
            signs_.push_back(sign);
            ++made_.split;
        }
        return at->second;
    }

    MeshTangents& made_;
    std::vector<int> signs_;
    std::map<std::uint32_t, std::uint32_t> second_;
    std::vector<Corners> corners_;
};

// Vertices at one place, with one normal and sign.
using Place = std::array<float, 7>;

}  // namespace

MeshTangents meshTangents(const MeshData& mesh) {
    const std::vector<Corners> triangles = trianglesOf(mesh);
    if (triangles.empty()) throw Error("mesh", "must be made of triangles to have tangents");
    if (mesh.normals.empty() || mesh.texCoords.empty())
        throw Error("mesh", "must have normals and texCoords to have tangents");
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        if (mesh.normals[i] == fvec3(0)) throw Error("mesh", "normals[" + std::to_string(i) + "] must not be 0");
    }

    MeshTangents made{.mesh = mesh, .tangents = {}};
    made.mesh.primitive = Primitive::triangles;
    made.mesh.indices.clear();
    std::vector<Growth> growths;
    growths.reserve(triangles.size());
    for (const Corners& corners : triangles) growths.push_back(growthOf(mesh, corners));
    const Splitting splitting(made, triangles, growths);
    const std::size_t count = made.mesh.positions.size();

    // Each triangle's contributions at its corners
    std::vector<vec3> normals;
    normals.reserve(count);
    for (const fvec3& normal : made.mesh.normals) normals.push_back(unit(vec3(normal)));
    std::vector<Saying> sayings;
    std::vector<vec3> own(count, vec3(0));
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Corners& corners = splitting.corners()[t];
        for (std::size_t i = 0; i < 3; ++i) {
            made.mesh.indices.push_back(corners[i]);
            const std::uint32_t vertex = corners[i];
            const vec3 here(made.mesh.positions[vertex]);
            const vec3 next = vec3(made.mesh.positions[corners[(i + 1) % 3]]) - here,
                       last = vec3(made.mesh.positions[corners[(i + 2) % 3]]) - here;
            const vec3 along = across(growths[t].along, normals[vertex]);
            if (along == vec3(0) || next == vec3(0) || last == vec3(0)) continue;
            sayings.push_back({vertex, angleBetween(unit(next), unit(last)) * along});
            own[vertex] += sayings.back().along;
        }
    }

    // Shared among the vertices of a place
    std::map<Place, std::vector<Saying>> at;
    const auto placeOf = [&](std::uint32_t vertex) {
        const fvec3 p = made.mesh.positions[vertex] + fvec3(0), n = made.mesh.normals[vertex] + fvec3(0);  // no -0
        return Place{p.x, p.y, p.z, n.x, n.y, n.z, static_cast<float>(splitting.signs()[vertex])};
    };
    for (const Saying& saying : sayings) at[placeOf(saying.vertex)].push_back(saying);
    for (std::uint32_t vertex = 0; vertex < count; ++vertex) {
        const vec3 alone = across(own[vertex], normals[vertex]);
        vec3 sum(0);
        if (alone != vec3(0)) {
            for (const Saying& saying : at[placeOf(vertex)]) {
                if (glm::dot(saying.along, alone) >= 0.5 * glm::length(saying.along)) sum += saying.along;
            }
        }
        vec3 tangent = across(sum, normals[vertex]);
        if (tangent == vec3(0)) {
            tangent = anyAcross(normals[vertex]);
            ++made.free;
        }
        made.tangents.emplace_back(fvec3(tangent), splitting.signs()[vertex] < 0 && sum != vec3(0) ? -1.0F : 1.0F);
    }
    return made;
}

}  // namespace mv
