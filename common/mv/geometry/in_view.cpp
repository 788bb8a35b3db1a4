#include "mv/geometry/in_view.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "mv/geometry/check.h"
#include "mv/math/clip.h"
#include "mv/math/require.h"

namespace mv {

bool isInView(const MeshData& mesh, const mat4& clipFromModel) {
    requireFinite("isInView", "the matrix", clipFromModel);
    const auto corner = [&](std::uint32_t index) { return clipFromModel * vec4(vec3(mesh.positions[index]), 1); };
    const auto left = [](std::vector<vec4> polygon) { return clipPolygon(std::move(polygon), clipVolume()).size(); };

    const auto triangles = trianglesOf(mesh);
    if (!triangles.empty()) {
        return std::any_of(triangles.begin(), triangles.end(), [&](const std::array<std::uint32_t, 3>& t) {
            return left({corner(t[0]), corner(t[1]), corner(t[2])}) >= 3;
        });
    }
    std::vector<std::uint32_t> order = mesh.indices;
    if (order.empty()) {
        order.resize(mesh.positions.size());
        std::iota(order.begin(), order.end(), 0U);
    }
    const std::size_t step = mesh.primitive == Primitive::lines ? 2 : 1;
    for (std::size_t i = 0; i < order.size(); i += step) {
        std::vector<vec4> part{corner(order[i])};
        if (step == 2) part.push_back(corner(order[i + 1]));
        if (left(std::move(part)) == step) return true;
    }
    return false;
}

}  // namespace mv
