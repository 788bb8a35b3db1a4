#include "neighbours.h"

#include <cstdint>
#include <map>
#include <utility>

namespace mv {

MeshData withNeighbours(const ClosedMesh& closed) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> farCorner;  // of the triangle that runs a side so
    for (const auto& [a, b, c] : closed.triangles()) {
        farCorner[{a, b}] = c;
        farCorner[{b, c}] = a;
        farCorner[{c, a}] = b;
    }
    MeshData mesh{.positions = closed.positions()};
    for (const auto& [a, b, c] : closed.triangles())
        mesh.indices.insert(mesh.indices.end(),
                            {a, farCorner.at({b, a}), b, farCorner.at({c, b}), c, farCorner.at({a, c})});
    return mesh;
}

}  // namespace mv
