// The smallest box along the axes that holds some points.
#pragma once
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "mv/geometry/mesh_data.h"

namespace mv {

// Without points it is empty, low above high: infinite, and no place to compute with.
struct Bounds {
    vec3 low{HUGE_VAL}, high{-HUGE_VAL};

    void add(const vec3& point) { add(Bounds{point, point}); }
    void add(const Bounds& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    vec3 middle() const { return 0.5 * low + 0.5 * high; }
    // Corner i is at the high end of x, y, z where bits 0, 1, 2 of i are set.
    std::array<vec3, 8> corners() const {
        std::array<vec3, 8> all{};
        for (unsigned i = 0; i < 8; ++i) {
            all[i] = {((i & 1U) != 0 ? high : low).x, ((i & 2U) != 0 ? high : low).y, ((i & 4U) != 0 ? high : low).z};
        }
        return all;
    }
};

// The bounds of a mesh's positions, each taken through the matrix (affine) first.
inline Bounds boundsOf(const MeshData& mesh, const mat4& spaceFromModel = mat4(1)) {
    Bounds bounds;
    for (const fvec3& position : mesh.positions) bounds.add(vec3(spaceFromModel * vec4(vec3(position), 1)));
    return bounds;
}

}  // namespace mv
