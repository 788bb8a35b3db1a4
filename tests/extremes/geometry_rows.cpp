// Solids far from the origin.
#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/geometry/check.h"
#include "mv/geometry/shapes.h"

using namespace mv;
using namespace mv::test;

namespace {

[[maybe_unused]] const bool y06 = addRow([] {
    const vec3 corner(1048576, -2097152, 4194304);  // whole numbers, so that the box is exact in float: its volume is 1
    const MeshData mesh = box(corner, corner + vec3(1));
    double naive = 0;
    for (const auto& [i, j, k] : trianglesOf(mesh)) {
        const fvec3 &a = mesh.positions[i], &b = mesh.positions[j], &c = mesh.positions[k];
        naive += static_cast<double>(glm::dot(a, glm::cross(b, c)));
    }
    return Row{.id = "Y06",
               .input = "a unit box 5e6 from the origin",
               .measured = "error of its volume",
               .naive = "the sum of det(a, b, c)/6, from the origin, determinants in float",
               .naiveError = std::abs(naive / 6 - 1),
               .ours = "signedVolume: seen from the box itself",
               .ourError = std::abs(signedVolume(mesh) - 1),
               .tolerance = 1e-15,
               .reason = "differences of the corners are exact; a division by 6 is rounded once"};
});

}  // namespace
