// X38: normals where the points are squeezed flat.
#include <glm/gtc/matrix_inverse.hpp>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/math/transform.h"

using namespace mv;
using namespace mv::test;

namespace {

// The angle between the image of a normal and the true one.
double off(const vec3& image, const vec3& truth) {
    const Wide3 a = wide(image), b = wide(truth);
    return static_cast<double>(length(cross(normalized(a), normalized(b))));
}

[[maybe_unused]] const bool x38 = addRow([] {
    const mat4 m = rotateX(30) * scale(1, 0, 1);
    const vec3 up(0, 1, 0), truth(mat3(rotateX(30)) * up);
    return Row{.id = "X38",
               .input = "a model flattened by scale(1, 0, 1), turned by 30°",
               .measured = "angle between its floor's normal and the true one (rad)",
               .naive = "glm::inverseTranspose in double",
               .naiveError = off(glm::inverseTranspose(mat3(m)) * up, truth),
               .ours = "normalMatrix: cofactors",
               .ourError = off(normalMatrix(m) * up, truth),
               .tolerance = 1e-15,
               .reason = "some roundings of a unit vector"};
});

[[maybe_unused]] const bool x38small = addRow([] {
    const mat4 m = scale(1e-16) * rotateX(30);
    const vec3 up(0, 1, 0), truth(mat3(rotateX(30)) * up);
    return Row{.id = "X38 small",
               .input = "a model scaled by 1e-16",
               .measured = "angle between its floor's normal and the true one (rad)",
               .naive = "glm::inverseTranspose in float",
               .naiveError = off(vec3(glm::inverseTranspose(fmat3(mat3(m))) * fvec3(up)), truth),
               .ours = "normalMatrix",
               .ourError = off(normalMatrix(m) * up, truth),
               .tolerance = 1e-6,
               .reason = "a float normal's own roundings; here the determinant of 1e-48 has vanished"};
});

// Two edges of a face nearly parallel: the plain product of them loses the angle's digits.
[[maybe_unused]] const bool x38thin = addRow([] {
    double naive = 0, ours = 0;
    for (const double apart : {0x1p-8, 0x1p-13, 0x1p-20, 0x1p-30}) {
        mat4 m(1);
        m[0] = vec4(0.3, 0.7, 0.9, 0);
        m[1] = vec4(0.3, 0.7 + apart, 0.9, 0);
        m[2] = vec4(0.3, 0.7, 0.9 + apart, 0);
        const Wide3 truth = cross(wide(vec3(m[0])), wide(vec3(m[1])));
        const auto angle = [&](const mat3& normals) {
            return static_cast<double>(length(cross(normalized(wide(normals[2])), normalized(truth))));
        };
        naive = worse(naive, angle(glm::inverseTranspose(mat3(m))));
        ours = worse(ours, angle(normalMatrix(m)));
    }
    return Row{.id = "X38 thin",
               .input = "a model sheared until its edges are 4e-3 to 1e-9 apart",
               .measured = "angle between a normal and the true one (rad)",
               .naive = "glm::inverseTranspose in double",
               .naiveError = naive,
               .ours = "normalMatrix",
               .ourError = ours,
               .tolerance = 2e-15,
               .reason = "some roundings of a unit vector, since each product is good to its last place"};
});

}  // namespace
