// X55, X56: mirrors seen from their own plane, or from very near it.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "extremes/row.h"
#include "mirror/mirrors.h"
#include "mv/math/projection.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

[[maybe_unused]] const bool x55 = addRow([] {
    Random random(55);
    double naive = 0, ours = 0;
    for (int i = 0; i < 1000; ++i) {
        const vec3 normal = random.direction(), right = glm::normalize(glm::cross(normal, random.direction()));
        const Mirror mirror{random.point(5), right, glm::cross(normal, right)};
        // Beside it, and in its plane but for rounding
        const vec3 eye = mirror.middle + random.number(2, 4) * mirror.halfU + random.number(-1, 1) * mirror.halfV;
        if (glm::dot(mirror.plane(), vec4(eye, 1)) > 0) ++naive;
        const mat4 clipFromWorld = perspective(60, 1, 0.1, 100) * lookAtAnyRoll(eye, mirror.middle);
        ours += double(mirrorChains({&mirror, 1}, clipFromWorld, 1).size());
    }
    return Row{.id = "X55",
               .input = "1000 mirrors, the eye in the plane of each",
               .measured = "mirrors for which the world is drawn, though they are seen from the side",
               .naive = "n . eye + d > 0",
               .naiveError = naive,
               .ours = "mirrorChains, by lightSide",
               .ourError = ours,
               .tolerance = 0,
               .reason = "a plane seen from the side has no area"};
});

// The part of 1000 pairs of points on one line of sight in what the mirror shows, 1 % apart: how many are in the wrong order, or at
// the same depth, in a depth buffer of 24 bits and with the floats of the GPU.
double confused(const mat4& clipFromView, const vec4& plane) {
    const fmat4 rounded(clipFromView);
    const auto depth = [&](const vec3& point) {
        const fvec4 clip = rounded * fvec4(fvec3(point), 1);
        return std::round((0.5 * double(clip.z / clip.w) + 0.5) * (std::exp2(24) - 1));
    };
    Random random(56);
    double count = 0;
    for (int i = 0; i < 1000;) {
        const vec3 near(random.number(-0.5, 0.5), random.number(-0.5, 0.5), -1);
        const vec3 point = random.number(1, 10) * near;
        if (glm::dot(plane, vec4(point, 1)) < 0.01) continue;  // behind the mirror, or hardly in front
        if (!(depth(point) < depth(1.01 * point))) ++count;
        ++i;
    }
    return count;
}

[[maybe_unused]] const bool x56 = addRow([] {
    const mat4 clipFromView = perspective(60, 1, 0.1, 100);
    const vec4 plane(glm::normalize(vec3(1, 0.2, -0.1)), -1e-6);
    return Row{.id = "X56",
               .input = "an eye 1e-6 from a mirror's plane, points of what it shows 1 to 10 away",
               .measured = "pairs on one line of sight, 1 % apart, of 1000, that a depth buffer of 24 bits confuses",
               .naive = "the near plane laid into the mirror",
               .naiveError = confused(withNearPlane(clipFromView, plane), plane),
               .ours = "the near plane kept, what is behind cut off by gl_ClipDistance",
               .ourError = confused(clipFromView, plane),
               .tolerance = 0,
               .reason = "at 10 away a step of 24 bits is 6e-5, and 1 % is 0.1"};
});

}  // namespace
