#include "mv/geometry/topology.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>

#include "mv/error.h"
#include "mv/geometry/check.h"

namespace mv {

long Topology::irregular() const {
    long count = 0;
    for (std::size_t i = 0; i < degrees.size(); ++i) count += isInner[i] && degrees[i] != 6 ? 1 : 0;
    return count;
}

long Topology::missing() const {
    long sum = 0;
    for (std::size_t i = 0; i < degrees.size(); ++i) sum += (isInner[i] ? 6 : 4) - degrees[i];
    return sum;
}

Topology topologyOf(const MeshData& mesh) {
    validate(mesh);
    if (mesh.primitive != Primitive::triangles) throw Error("topologyOf", "must be given separate triangles");
    Topology found;
    std::map<std::tuple<float, float, float>, std::size_t> places;
    const auto vertexAt = [&](std::size_t corner) {
        const fvec3& p = mesh.positions[mesh.indices.empty() ? corner : mesh.indices[corner]];
        const auto [place, isNew] = places.try_emplace({p.x, p.y, p.z}, found.positions.size());
        if (isNew) found.positions.push_back(p);
        return place->second;
    };
    std::map<std::pair<std::size_t, std::size_t>, int> facesOfEdge;
    const std::size_t corners = mesh.indices.empty() ? mesh.positions.size() : mesh.indices.size();
    for (std::size_t i = 0; i + 2 < corners; i += 3) {
        const std::array<std::size_t, 3> face{vertexAt(i), vertexAt(i + 1), vertexAt(i + 2)};
        if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) continue;
        ++found.faces;
        for (std::size_t side = 0; side < 3; ++side) ++facesOfEdge[std::minmax({face[side], face[(side + 1) % 3]})];
    }
    found.degrees.assign(found.positions.size(), 0);
    found.isInner.assign(found.positions.size(), true);
    for (const auto& [ends, faces] : facesOfEdge) {
        if (faces > 2) throw Error("topologyOf", "must have two faces at most along an edge", std::to_string(faces));
        ++found.edges;
        for (const std::size_t end : {ends.first, ends.second}) {
            ++found.degrees[end];
            if (faces == 1) found.isInner[end] = false;
        }
        if (faces == 1) ++found.boundaryEdges;
    }
    return found;
}

}  // namespace mv
