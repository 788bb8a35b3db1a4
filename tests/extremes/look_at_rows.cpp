// X01 to X05: cameras.
#include <glm/gtc/matrix_transform.hpp>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/math/transform.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

// The demand E of the plan on a camera that is uploaded: a shear of a millionth is far below a pixel.
constexpr double usable = 1e-6;
const std::string usableReason = "a millionth of shear moves nothing by a pixel; rounding to float takes 1e-7 of it";
const std::string shear = "largest element of RᵀR − I, as uploaded in float";

[[maybe_unused]] const bool x01 = addRow([] {
    return Row{.id = "X01",
               .input = "eye (0, 5, 0) looks at the origin, up (0, 1, 0)",
               .measured = shear,
               .naive = "glm::lookAt in float",
               .naiveError = orthogonality(glm::lookAt(fvec3(0, 5, 0), fvec3(0), fvec3(0, 1, 0))),
               .ours = "lookAt refuses; lookAtAnyRoll",
               .ourError = orthogonality(fmat4(lookAtAnyRoll({0, 5, 0}, {0, 0, 0}))) +
                           accepted([] { lookAt(vec3(0, 5, 0), vec3(0), vec3(0, 1, 0)); }),
               .tolerance = usable,
               .reason = usableReason};
});

// Poses whose up is `angle` off the view; on both sides of it in turn.
struct Pose {
    vec3 eye, at, up;
};
Pose nearlyParallel(Random& random, double angle, int i) {
    const vec3 eye = random.point(5);
    const vec3 at = eye + random.number(0.1, 10) * random.direction();
    const vec3 view = glm::normalize(at - eye);
    const vec3 aside = glm::normalize(glm::cross(view, random.direction()));
    return {eye, at, (i % 2 == 0 ? 1.0 : -1.0) * view + angle * aside};
}

[[maybe_unused]] const bool x02 = addRow([] {
    Random random(5);
    double naive = 0, ours = 0;
    for (const double angle : {0.0, 1e-11, 1e-9, 1e-7, 1e-5, 1e-3, 1e-2, 0.11}) {
        for (int i = 0; i < 250; ++i) {
            const Pose p = nearlyParallel(random, angle, i);
            naive = worse(naive, orthogonality(glm::lookAt(fvec3(p.eye), fvec3(p.at), fvec3(p.up))));
            ours = worse(ours, orthogonality(angle > 0 ? lookAt(p.eye, p.at, p.up) : lookAtAnyRoll(p.eye, p.at)));
        }
    }
    return Row{.id = "X02",
               .input = "2000 random poses, up 0 to 0.11 rad off the view",
               .measured = "largest element of RᵀR − I, before the upload",
               .naive = "glm::lookAt in float",
               .naiveError = naive,
               .ours = "lookAt; lookAtAnyRoll at 0",
               .ourError = ours,
               .tolerance = 2e-15,
               .reason = "a few roundings of 1, at 1.1e-16 each: there is nothing to cancel in what is kept"};
});

// The roll, which is all that is left of up. Its truth is computed wide from the same arguments.
[[maybe_unused]] const bool x02roll = addRow([] {
    Random random(6);
    double naive = 0, ours = 0;
    for (const double angle : {1e-11, 1e-9, 1e-7, 1e-5, 1e-3, 1e-2, 0.11}) {
        for (int i = 0; i < 250; ++i) {
            const Pose p = nearlyParallel(random, angle, i);
            const Wide3 right = normalized(cross(wide(p.at) - wide(p.eye), wide(p.up)));
            const auto error = [&](const mat4& camera) {
                return distance(right, {{camera[0].x, camera[1].x, camera[2].x}});
            };
            naive = worse(naive, error(glm::lookAt(p.eye, p.at, p.up)));
            ours = worse(ours, error(lookAt(p.eye, p.at, p.up)));
        }
    }
    return Row{.id = "X02 roll",
               .input = "1750 random poses, up 1e-11 to 0.11 rad off the view",
               .measured = "how far the camera's right is from the true one (rad)",
               .naive = "glm::lookAt in double",
               .naiveError = naive,
               .ours = "lookAt",
               .ourError = ours,
               .tolerance = 1e-14,
               .reason = "the plain product, used from 0.1 rad on, loses 1.1e-16/angle, and a few roundings more"};
});

[[maybe_unused]] const bool x03 = addRow([] {
    const vec3 eye(0, 0, 5), at(0), up(0, 1, 0);
    const Pose poses[] = {{eye, eye, up},
                          {eye, at, vec3(0)},
                          {eye, at, eye},
                          {vec3(notANumber, 0, 5), at, up},
                          {eye, vec3(0, infinite, 0), up},
                          {eye, at, vec3(0, 0, -infinite)},
                          {vec3(1e301, 0, 5), vec3(-1e308, 0, 0), up}};
    double naive = 0, ours = 0;
    for (const Pose& p : poses) {
        naive += allFinite(glm::lookAt(p.eye, p.at, p.up)) ? 0 : 1;
        ours += accepted([&] { lookAt(p.eye, p.at, p.up); });
    }
    return Row{.id = "X03",
               .input = "7 impossible cameras: eye = at, up 0 or along the view, NaN, infinity, beyond 1e300",
               .measured = "how many end as NaN or pass unrefused",
               .naive = "glm::lookAt in double",
               .naiveError = naive,
               .ours = "lookAt: each an Error in words",
               .ourError = ours,
               .tolerance = 0,
               .reason = "one NaN in a matrix is an empty picture"};
});

// Eyes at a distance that is all right and whose square is not, against the same direction at distance 1.
template <typename T>
Row distances(const std::string& id, const std::string& input, const std::string& naiveForm, double large,
              double small) {
    const vec3 direction = glm::normalize(vec3(1, 2, 3));
    double naive = 0, ours = 0;
    for (const double size : {large, small}) {
        const glm::vec<3, T> eye(size * direction);
        naive = worse(naive, orthogonality(glm::lookAt(eye, glm::vec<3, T>(0), glm::vec<3, T>(0, 1, 0))));
        ours = worse(ours, orthogonality(lookAt(vec3(eye), vec3(0), vec3(0, 1, 0))));
    }
    return {.id = id,
            .input = input,
            .measured = "largest element of RᵀR − I",
            .naive = naiveForm,
            .naiveError = naive,
            .ours = "lookAt",
            .ourError = ours,
            .tolerance = usable,
            .reason = usableReason};
}
[[maybe_unused]] const bool x04float = addRow([] {
    return distances<float>("X04 float", "eye 1e20 and 1e-23 from the target", "glm::lookAt in float", 1e20, 1e-23);
});
[[maybe_unused]] const bool x04double = addRow([] {
    return distances<double>("X04 double", "eye 1e200 and 1e-200 from the target", "glm::lookAt in double", 1e200,
                             1e-200);
});

// A scene far out; the vertex is given relative to its base, as in a vertex buffer.
Row farScene(const std::string& id, double size) {
    const fvec3 vertex(12, -3, 5);
    const vec3 base(size, -0.7 * size, 0.3 * size), eye = base + vec3(1, 2, 3), at = base + vec3(12, 0, 4);
    const vec3 up(0, 0, 1);
    const Wide3 forward = normalized(wide(at) - wide(eye)), right = normalized(cross(forward, wide(up)));
    const Wide3 seen = wide(base) + wide(vertex) - wide(eye);
    const Wide3 truth{{dot(right, seen), dot(cross(right, forward), seen), -dot(forward, seen)}};

    const fmat4 twin = glm::lookAt(fvec3(eye), fvec3(at), fvec3(up)) * glm::translate(fmat4(1), fvec3(base));
    const fmat4 cameraFromModel(lookAt(eye, at, up) * translate(base));
    return {.id = id,
            .input = "a scene about 12 units large, " + id.substr(4) + " from the origin",
            .measured = "how far a vertex is off in camera space",
            .naive = "all in float",
            .naiveError = distance(truth, firstThree(wide(twin * fvec4(vertex, 1)))),
            .ours = "cameraFromModel in double, then float",
            .ourError = distance(truth, firstThree(wide(cameraFromModel * fvec4(vertex, 1)))),
            .tolerance = 1e-5,
            .reason = "a thousandth of a pixel of 1 cm; float coordinates of 12 end at 1e-6"};
}
[[maybe_unused]] const bool x05a = addRow([] { return farScene("X05 1e6", 1e6); });
[[maybe_unused]] const bool x05b = addRow([] { return farScene("X05 1e7", 1e7); });
[[maybe_unused]] const bool x05c = addRow([] { return farScene("X05 1e8", 1e8); });

// An animation's angle after a day or a year of whole turns.
[[maybe_unused]] const bool y01 = addRow([] {
    const auto error = [](const mat4& m) {
        const Wide c = cos(wideRadians(30)), s = sin(wideRadians(30));
        return std::max(static_cast<double>(abs(m[0][0] - c)), static_cast<double>(abs(m[2][0] - s)));
    };
    const double angle = 30 + 360e6;
    return Row{
        .id = "Y01",
        .input = "30° after a million turns about y",
        .measured = "largest error of an element",
        .naive = "glm::rotate in float",
        .naiveError = error(mat4(glm::rotate(fmat4(1), glm::radians(static_cast<float>(angle)), fvec3(0, 1, 0)))),
        .ours = "rotateY",
        .ourError = error(rotateY(angle)),
        .tolerance = 1e-15,
        .reason = "whole turns are taken off exactly; a rounded sine of 30° is left"};
});

}  // namespace
