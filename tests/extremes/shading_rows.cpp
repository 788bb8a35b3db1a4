// X46, X47, X50: highlights and normals where the usual forms divide 0 by 0, or raise what has no power.
#include <cmath>
#include <glm/geometric.hpp>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/geometry/teapot.h"
#include "shading/reflection.h"

using namespace mv;
using namespace mv::test;

namespace {

const vec3 up(0, 0, 1);
vec3 at(double degrees) { return {std::sin(radians(degrees)), 0, std::cos(radians(degrees))}; }

// The lecture's (r . v)^exponent as it stands.
double plainPhong(const vec3& n, const vec3& l, const vec3& v, double exponent) {
    return std::pow(glm::dot(2 * glm::dot(n, l) * n - l, v), exponent);
}

[[maybe_unused]] const bool x46dark = addRow([] {
    // The lamp is behind the surface, and the eye at right angles to the mirrored light: 0^0.
    const vec3 l(0, 0, -1), v(1, 0, 0);
    return Row{
        .id = "X46 0^0",
        .input =
            "a highlight with exponent 0, the lamp behind the surface, the eye at right angles to the mirrored light",
        .measured = "light, of which there is none",
        .naive = "(r . v)^exponent",
        .naiveError = plainPhong(up, l, v, 0),
        .ours = "highlight: 0 where n . l or the cosine is not above 0",
        .ourError = highlight(Lobe::phong, up, l, v, 0),
        .tolerance = 0,
        .reason = "the lamp does not reach the surface"};
});

[[maybe_unused]] const bool x46negative = addRow([] {
    const vec3 l = at(-80), v = at(-60);  // the eye is 140 degrees from the mirrored light
    return Row{.id = "X46 negative",
               .input = "a highlight with exponent 1.5, the eye 140° from the mirrored light",
               .measured = "light, of which there is none",
               .naive = "(r . v)^exponent",
               .naiveError = plainPhong(up, l, v, 1.5),
               .ours = "highlight",
               .ourError = highlight(Lobe::phong, up, l, v, 1.5),
               .tolerance = 0,
               .reason = "a highlight reaches 90° from the mirrored light at most"};
});

[[maybe_unused]] const bool x47 = addRow([] {
    const vec3 l = at(30);
    return Row{.id = "X47",
               .input = "Blinn's highlight, the eye opposite the light",
               .measured = "light, of which there is none",
               .naive = "(n . normalize(l + v))^exponent",
               .naiveError = std::pow(glm::dot(up, glm::normalize(l - l)), 20.0),
               .ours = "highlight",
               .ourError = highlight(Lobe::blinn, up, l, -l, 20),
               .tolerance = 0,
               .reason = "an eye below the surface sees none of it"};
});

[[maybe_unused]] const bool x50 = addRow([] {
    double naive = 0, ours = 0;
    for (const BezierPatch& patch : teapot()) {
        for (const double v : {0.0, 1.0}) {
            const SurfacePoint tip = pointOf(patch, 0.5, v);
            if (tip.alongU != vec3(0)) continue;
            // Tip of the lid and middle of the bottom: level, by their symmetry.
            const vec3 truth(0, tip.position.y > 1 ? 1 : -1, 0);
            naive = worse(naive, glm::distance(glm::normalize(glm::cross(tip.alongU, tip.alongV)), truth));
            ours = worse(ours, glm::distance(tip.normal, truth));
        }
    }
    return Row{.id = "X50",
               .input = "the tip of the teapot's lid and the middle of its bottom, where one derivative is 0",
               .measured = "how far the normal is from the true one (rad)",
               .naive = "normalize(cross(alongU, alongV))",
               .naiveError = naive,
               .ours = "pointOf: the limit, by the mixed derivative",
               .ourError = ours,
               .tolerance = 1e-15,
               .reason = "some roundings of a unit vector"};
});

}  // namespace
