// X39: stereo by turned-in eyes.
#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/math/projection.h"
#include "mv/math/stereo.h"
#include "mv/math/transform.h"

using namespace mv;
using namespace mv::test;

namespace {

Row parallax(const std::string& id, double convergence) {
    const double half = std::tan(radians(30.0)), apart = 0.06;
    const vec3 corner = vec3(half * 4 / 3, half, -1) * convergence;
    const vec3 points[] = {corner, 1.5 * corner};
    const mat4 lens = perspective(60, 4.0 / 3, 0.1, 100);
    const auto turned = [&](double x) { return lens * lookAt({x, 0, 0}, {0, 0, -convergence}, {0, 1, 0}); };
    const auto offAxis = [&](double x) {
        FrustumBounds window = frustumBounds(60, 4.0 / 3, 0.1, 100);
        window.left -= x * 0.1 / convergence;
        window.right -= x * 0.1 / convergence;
        return frustum(window) * translate(-x, 0, 0);
    };
    const auto rows = [&](const mat4& left, const mat4& right) {
        const auto seen = parallaxOf(points, left, right, 640, 480, 0.1);
        return seen ? seen->vertical : infinite;
    };
    return {.id = id,
            .input = "eyes 6 cm apart that meet " + id.substr(4) +
                     " away, points there and behind in the corner of 640x480 pixels",
            .measured = "rows between the two pictures of a point",
            .naive = "eyes turned in by lookAt",
            .naiveError = rows(turned(-apart / 2), turned(apart / 2)),
            .ours = "parallel eyes, off-axis frustum",
            .ourError = rows(offAxis(-apart / 2), offAxis(apart / 2)),
            .tolerance = 1e-12,
            .reason = "both eyes have the same second row; a rounding of 480 rows is 6e-14"};
}
[[maybe_unused]] const bool x39a = addRow([] { return parallax("X39 0.5 m", 0.5); });
[[maybe_unused]] const bool x39b = addRow([] { return parallax("X39 1 m", 1); });
[[maybe_unused]] const bool x39c = addRow([] { return parallax("X39 3 m", 3); });
[[maybe_unused]] const bool x39d = addRow([] { return parallax("X39 10 m", 10); });

}  // namespace
