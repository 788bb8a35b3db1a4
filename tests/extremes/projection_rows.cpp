// X06, X07: projections and the planes of their views.
#include <glm/gtc/matrix_transform.hpp>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/math/projection.h"

using namespace mv;
using namespace mv::test;

namespace {

// A picture can be made of a projection if it is finite, and tells the near half of its depth range from the far one.
bool isOfUse(const glm::mat4& clipFromCamera, double near, double far) {
    if (!allFinite(clipFromCamera)) return false;
    const auto ndc = [&](double z) {
        const glm::vec4 clip = clipFromCamera * glm::vec4(1, 1, -z, 1);
        return glm::vec3(clip) / clip.w;
    };
    const glm::vec3 first = ndc(near + (far - near) / 4), second = ndc(near + (far - near) / 2);
    return std::abs(first.x) > 1e-6f && second.z > first.z;
}

[[maybe_unused]] const bool x06 = addRow([] {
    const double fifty = radians(50);
    double naive = 0, ours = 0;
    const auto view = [&](double fovy, double near, double far) {
        const glm::mat4 m =
            glm::perspective(static_cast<float>(fovy), 1.0f, static_cast<float>(near), static_cast<float>(far));
        naive += isOfUse(m, near, far) ? 0 : 1;
        ours += accepted([&] { perspective(degrees(fovy), 1, near, far); });
    };
    view(fifty, 0, 10);  // finite, and every depth is 1
    view(fifty, 2, 2);
    view(fifty, 3, 2);
    view(0, 1, 10);
    view(pi, 1, 10);  // finite, and everything is in one column of pixels
    naive += isOfUse(glm::ortho(1.0f, 1.0f, -1.0f, 1.0f, 1.0f, 3.0f), 1, 3) ? 0 : 1;
    ours += accepted([] { ortho(1, 1, -1, 1, 1, 3); });
    naive += isOfUse(glm::ortho(-1.0f, 1.0f, -1.0f, 1.0f, 3.0f, 3.0f), 3, 3) ? 0 : 1;
    ours += accepted([] { ortho(-1, 1, -1, 1, 3, 3); });
    naive += isOfUse(glm::frustum(-1.0f, 1.0f, 2.0f, 2.0f, 1.0f, 2.0f), 1, 2) ? 0 : 1;
    ours += accepted([] { frustum(-1, 1, 2, 2, 1, 2); });
    return Row{.id = "X06",
               .input = "8 impossible projections: near 0, near ≥ far, fovy 0° and 180°, equal bounds",
               .measured = "how many return a matrix of which no picture can be made",
               .naive = "GLM in float",
               .naiveError = naive,
               .ours = "each an Error in words",
               .ourError = ours,
               .tolerance = 0,
               .reason = "some of them are finite, so that nobody notices"};
});

Row planesAt(const std::string& id, double ratio) {
    const double near = 0.1, far = near * ratio;
    const glm::mat4 rows =
        glm::transpose(glm::perspective(glm::radians(50.0f), 1.5f, static_cast<float>(near), static_cast<float>(far)));
    const glm::vec4 plane = rows[3] - rows[2];
    const auto relative = [&](double distance) { return static_cast<double>(abs(Wide(distance) / Wide(far) - 1)); };
    const double fromMatrix = relative(planesFromClip(perspective(50, 1.5, near, far))[mv::farPlane].w);
    const double fromArguments = relative(perspectivePlanes(50, 1.5, near, far)[mv::farPlane].w);
    return {.id = id,
            .input = "far/near = " + id.substr(4),
            .measured = "relative error of the far plane's distance",
            .naive = "Gribb and Hartmann's planes of a float matrix",
            .naiveError = relative(static_cast<double>(plane.w / glm::length(glm::vec3(plane)))),
            .ours = "planesFromClip in double; perspectivePlanes",
            .ourError = worse(fromMatrix, fromArguments),
            .tolerance = 1e-6,
            .reason = "the matrix keeps 2 near/far of the plane, known to 1.1e-16: 1.1e-8 at 1e8"};
}
// A far plane at infinity: of points far and near the smallest distance inside it, which is to be above 0.
Row planesAtInfinity() {
    const mat4 clipFromCamera = infinitePerspective(50, 1.5, 0.1), rows = glm::transpose(clipFromCamera);
    const vec4 far = rows[3] - rows[2], divided = far / glm::length(vec3(far));
    const auto outside = [](const vec4& plane) {
        double count = 0;
        for (const double distance : {0.2, 1e3, 1e12}) count += glm::dot(plane, vec4(0, 0, -distance, 1)) > 0 ? 0 : 1;
        return count;
    };
    return {.id = "X07 inf",
            .input = "far at infinity: three points before the eye, up to 1e12 away",
            .measured = "points that are beyond the far plane",
            .naive = "Gribb and Hartmann's plane, divided by its normal's length",
            .naiveError = outside(divided),
            .ours = "planesFromClip; perspectivePlanes",
            .ourError = worse(outside(planesFromClip(clipFromCamera)[mv::farPlane]),
                              outside(perspectivePlanes(50, 1.5, 0.1, infinite)[mv::farPlane])),
            .tolerance = 0,
            .reason = "the plane at infinity is (0, 0, 0, 1), exactly"};
}

[[maybe_unused]] const bool x07a = addRow([] { return planesAt("X07 1e5", 1e5); });
[[maybe_unused]] const bool x07b = addRow([] { return planesAt("X07 1e6", 1e6); });
[[maybe_unused]] const bool x07c = addRow([] { return planesAt("X07 1e7", 1e7); });
[[maybe_unused]] const bool x07d = addRow([] { return planesAt("X07 1e8", 1e8); });
[[maybe_unused]] const bool x07e = addRow([] { return planesAtInfinity(); });

// A view nearly half the sky wide: f = cot(fovy/2) is small, and the angle in radians is rounded at 3.
[[maybe_unused]] const bool y02 = addRow([] {
    double naive = 0, ours = 0;
    for (const double off : {1e-3, 1e-6, 1e-9}) {
        const double fovy = 180 - off;
        const Wide half = wideRadians(fovy) / 2, truth = cos(half) / sin(half);
        const auto relative = [&](double f) { return static_cast<double>(abs(Wide(f) / truth - 1)); };
        naive = worse(naive, relative(glm::perspective(radians(fovy), 1.0, 1.0, 2.0)[1][1]));
        ours = worse(ours, relative(perspective(fovy, 1, 1, 2)[1][1]));
    }
    return Row{.id = "Y02",
               .input = "fovy 1e-3 to 1e-9 degrees below 180",
               .measured = "relative error of cot(fovy/2)",
               .naive = "glm::perspective in double",
               .naiveError = naive,
               .ours = "perspective",
               .ourError = ours,
               .tolerance = 1e-15,
               .reason = "180 − fovy is exact, and its tangent is good to a few roundings"};
});

// Distances so small that their product vanishes though the matrix does not.
[[maybe_unused]] const bool y03 = addRow([] {
    const double near = 1e-200, far = 1e-150;
    const Wide truth = -2 * Wide(far) * Wide(near) / (Wide(far) - Wide(near));
    const auto relative = [&](double m) { return static_cast<double>(abs(Wide(m) / truth - 1)); };
    return Row{.id = "Y03",
               .input = "near 1e-200, far 1e-150",
               .measured = "relative error of −2 far near/(far − near)",
               .naive = "glm::perspective in double",
               .naiveError = relative(glm::perspective(1.0, 1.0, near, far)[3][2]),
               .ours = "perspective",
               .ourError = relative(perspective(50, 1, near, far)[3][2]),
               .tolerance = 1e-15,
               .reason = "three operations, 1.1e-16 each; 0 instead would give every point depth 1"};
});

}  // namespace
