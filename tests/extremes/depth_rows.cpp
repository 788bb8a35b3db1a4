// X08: the depth buffer.
#include <numeric>

#include "extremes/row.h"
#include "mv/math/projection.h"
#include "z-buffer/depth_order.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr double near = 0.1, far = 1e4;

// Percent of 100 000 pairs 1e-4 apart. Which of a pair is nearer is known: it was made so.
double misordered(const mat4& clipFromView, DepthFormat format, bool reversed) {
    const fmat4 uploaded(clipFromView);
    const auto pairs = misorderedPairs(near, far, 1e-4, 100000, [&](float distance) {
        return (reversed ? -1 : 1) * keptDepth(format, windowDepth(uploaded, distance, reversed));
    });
    return std::accumulate(pairs.begin(), pairs.end(), 0.0) / 1000;
}

[[maybe_unused]] const bool x08 = addRow([] {
    const mat4 standard = perspective(50, 1, near, far);
    mat4 reversed = standard;  // z/w = 1 at near, 0 at far
    reversed[2][2] = near / (far - near);
    reversed[3][2] = far * near / (far - near);
    return Row{.id = "X08",
               .input = "pairs of points, one 1e-4 of its distance nearer than the other; near 0.1, far 1e4",
               .measured = "percent of the pairs that the depth buffer has not in order",
               .naive = "perspective, 24 bits (32 of a float: the same)",
               .naiveError = misordered(standard, DepthFormat::d24, false),
               .ours = "z-buffer: reversed depth by glClipControl, in a float",
               .ourError = misordered(reversed, DepthFormat::d32f, true),
               .tolerance = 0,
               .reason = "two depths are in order or they are not"};
});

}  // namespace
