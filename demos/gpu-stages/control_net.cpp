#include "control_net.h"

#include <array>
#include <glm/geometric.hpp>

#include "mv/geometry/shapes.h"

namespace mv {
namespace {

constexpr std::array<float, 16> heights{0.2F,  0.9F, -0.5F, 0.1F, 0.6F, 2.0F,  0.5F, -0.6F,
                                        -0.6F, 0.6F, 1.6F,  0.7F, 0.1F, -0.8F, 0.4F, 1.1F};

}  // namespace

MeshData controlNet() {
    MeshData net = withoutTexCoords(grid(3, 3, 3, 3));
    for (std::size_t i = 0; i < heights.size(); ++i) net.positions[i].y = heights.at(i);
    // Take the normal from the neighbours in row and column. At the border one of the neighbours is the point itself
    const auto across = [&](std::size_t i, std::size_t place, std::size_t step) {
        return net.positions[place < 3 ? i + step : i] - net.positions[place > 0 ? i - step : i];
    };
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const fvec3 normal = glm::cross(across(i, i % 4, 1), across(i, i / 4, 4));
        net.normals[i] = normal.y < 0 ? -normal : normal;
    }
    return net;
}

MeshData controlPoints() {
    MeshData points = controlNet();
    points.primitive = Primitive::points;
    points.indices.clear();
    return points;
}

}  // namespace mv
