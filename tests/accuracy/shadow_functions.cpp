// shadow.h and shadow_caster.h.
#include "accuracy/function.h"
#include "mv/math/robust.h"
#include "mv/math/shadow.h"
#include "mv/math/shadow_caster.h"

namespace mv::accuracy {
namespace {

using test::wide;
using test::Wide3;
using test::Wide4;
using test::WideMatrix;

// Where light, plane, origin, the unit of the scene and the caster's corners are.
constexpr std::size_t lightAt = 0, planeAt = 4, originAt = 8, unitAt = 11, cornersAt = 12;

// A plane up to 1e3 scene units away from the origin, a light 1e-5 to 1e3 of them above or below it.
Arguments scenes(Random& random, Domain domain) {
    const bool isWhole = domain == Domain::whole;
    const double unit = anyScale(random, domain, 60), normalSize = anyScale(random, domain, 60);
    const vec3 up = random.direction();
    const double away = isWhole ? random.logarithmic(1e-3, 1e3) : random.number(0, 10);
    const vec3 onPlane = unit * away * up;
    const vec3 aside = unit * random.number(0, 3) * (isWhole ? random.logarithmic(1e-3, 1e2) : 1.0) *
                       glm::normalize(glm::cross(up, random.direction()));
    const double height = random.sign() * (isWhole ? random.logarithmic(1e-2, 1e3) : random.number(1, 10));
    const vec3 position = onPlane + aside + unit * height * up;
    const double w = random.sign() < 0 ? 1 : isWhole ? random.logarithmic(1e-3, 1e3) : random.number(0.5, 2);
    Arguments a{};
    put(a, lightAt, random.sign() < 0 && random.sign() < 0 ? vec4(position - onPlane, 0) : vec4(position, 1) * w);
    put(a, planeAt, normalSize * vec4(up, -glm::dot(up, onPlane)));
    put(a, originAt, onPlane);
    a[unitAt] = unit;
    const vec3 middle = onPlane + unit * std::abs(height) * random.number(-0.5, 1.5) * up;
    for (std::size_t i = 0; i < 4; ++i) put(a, cornersAt + 3 * i, middle + 0.3 * unit * random.point(1));
    return a;
}

Wide4 unitPlane(const Arguments& a) {
    const Wide4 plane = wide(pointAt(a, planeAt));
    return plane / length(firstThree(plane));
}
Wide4 turnedTo(const Wide4& light, const Wide4& plane) { return dot(plane, light) < 0 ? Wide(-1) * plane : plane; }

// In units of the scene, so that a coordinate and a direction are of one size: columns as in valuesOf.
std::vector<double> inUnits(double unit) {
    std::vector<double> weights(16, 1);
    for (std::size_t column = 0; column < 4; ++column) {
        for (std::size_t row = 0; row < 4; ++row) {
            if (column == 3 && row < 3) weights[4 * column + row] = 1 / unit;
            if (column < 3 && row == 3) weights[4 * column + row] = unit;
        }
    }
    return weights;
}

Truth projectionTruth(const Wide4& light, const Wide4& plane, double unit) {
    const Wide4 n = turnedTo(light, plane);
    const Wide height = dot(n, light);
    WideMatrix m;
    for (std::size_t column = 0; column < 4; ++column) {
        for (std::size_t row = 0; row < 4; ++row) {
            m.column[column][row] = (row == column ? height : Wide(0)) - n[column] * light[row];
        }
    }
    Truth truth = oneBlock(valuesOf(m));
    truth.weights = inUnits(unit);
    return truth;
}

const std::string inScene = "ulp of the largest entry, in units of the scene";
const std::string sceneDomain = "scenes 1e-60 to 1e60 large, planes up to 1e3 of that away";

}  // namespace

std::vector<Function> shadowFunctions() {
    std::vector<Function> list;
    list.push_back(withForms(
        {.name = "shadowProjection",
         .header = "shadow.h",
         .returns = "the shadow on a plane",
         .measured = inScene,
         .domain = sceneDomain,
         .reason = "",
         .sample = scenes,
         .truth =
             [](const Arguments& a) { return projectionTruth(wide(pointAt(a, lightAt)), unitPlane(a), a[unitAt]); }},
        [](const Arguments& a) { return shadowProjection(pointAt(a, lightAt), pointAt(a, planeAt)); }));
    list.push_back(withForms({.name = "shadowProjection (origin)",
                              .header = "shadow.h",
                              .returns = "the same, relative to a point on the plane",
                              .measured = inScene,
                              .domain = sceneDomain,
                              .reason = "",
                              .sample = scenes,
                              .truth =
                                  [](const Arguments& a) {
                                      const Wide4 light = wide(pointAt(a, lightAt));
                                      const Wide3 local = firstThree(light) - light[3] * wide(vectorAt(a, originAt));
                                      return projectionTruth(homogeneous(local, light[3]),
                                                             homogeneous(firstThree(unitPlane(a)), 0), a[unitAt]);
                                  }},
                             [](const Arguments& a) {
                                 return shadowProjection(pointAt(a, lightAt), pointAt(a, planeAt),
                                                         vectorAt(a, originAt));
                             }));
    list.push_back(withForms(
        {.name = "shadowCasterBounds",
         .header = "shadow.h",
         .returns = "where a caster has to be",
         .measured =
             "ulp of the largest entry, for [1] of the light's distance if that is larger, in units of the scene",
         .domain = sceneDomain,
         .reason = "",
         .sample = scenes,
         .truth =
             [](const Arguments& a) {
                 const Wide4 light = wide(pointAt(a, lightAt)), n = turnedTo(light, unitPlane(a));
                 Wide4 lower = Wide(-1) * (light[3] * n);
                 lower[3] += dot(n, light);
                 Truth truth{{}, {4, 4}, {}, false, {Wide(0), Wide(0)}};
                 truth.sizes[0] = std::max<Wide>(a[unitAt], abs(n[3]));
                 truth.sizes[1] = std::max<Wide>(a[unitAt] * light[3], length(firstThree(light)));
                 for (const Wide4& bound : {n, lower}) {
                     truth.values.insert(truth.values.end(), bound.element.begin(), bound.element.end());
                     truth.weights.insert(truth.weights.end(), {a[unitAt], a[unitAt], a[unitAt], 1.0});
                 }
                 return truth;
             }},
        [](const Arguments& a) { return shadowCasterBounds(pointAt(a, lightAt), pointAt(a, planeAt)); }));
    list.push_back(
        withForms({.name = "lightSide",
                   .header = "shadow.h",
                   .returns = "which side of the plane the light is on",
                   .measured = "wrong verdicts (0: none)",
                   .domain = sceneDomain,
                   .reason = "",
                   .sample = scenes,
                   .truth =
                       [](const Arguments& a) {
                           const Wide4 light = wide(pointAt(a, lightAt)), plane = unitPlane(a);
                           const Wide height = dot(plane, light);
                           const Wide size = length(firstThree(light)) + abs(plane[3]) * light[3];
                           const Wide least = light[3] == 0 ? Wide(1e-12) : Wide(1e-6);
                           return entrywise({abs(height) <= least * size ? Wide(0) : height > 0 ? Wide(1) : Wide(-1)});
                       }},
                  [](const Arguments& a) { return lightSide(pointAt(a, lightAt), pointAt(a, planeAt)); }));
    list.push_back(withForms({.name = "reflection",
                              .header = "shadow.h",
                              .returns = "mirrors in a plane",
                              .measured = inScene,
                              .domain = sceneDomain,
                              .reason = "",
                              .sample = scenes,
                              .truth =
                                  [](const Arguments& a) {
                                      const Wide4 n = unitPlane(a);
                                      WideMatrix m = wide(mat4(1));
                                      for (std::size_t column = 0; column < 4; ++column) {
                                          for (std::size_t row = 0; row < 3; ++row) {
                                              m.column[column][row] -= 2 * n[column] * n[row];
                                          }
                                      }
                                      Truth truth = oneBlock(valuesOf(m));
                                      truth.weights = inUnits(a[unitAt]);
                                      return truth;
                                  }},
                             [](const Arguments& a) { return reflection(pointAt(a, planeAt)); }));
    list.push_back(
        withForms({.name = "judgeCaster",
                   .header = "shadow_caster.h",
                   .returns = "whether a caster throws a shadow, and why not",
                   .measured = "wrong verdicts (0: none)",
                   .domain = sceneDomain,
                   .reason = "",
                   .sample = scenes,
                   .truth =
                       [](const Arguments& a) {
                           const Wide4 light = wide(pointAt(a, lightAt)), plane = unitPlane(a);
                           const Wide height = dot(plane, light);
                           bool above = false, below = false;
                           for (std::size_t i = 0; i < 4; ++i) {
                               const Wide at = dot(plane, homogeneous(wide(vectorAt(a, cornersAt + 3 * i)), 1));
                               above |= at > 0;
                               below |= height > light[3] * at;
                           }
                           const Wide size = length(firstThree(light)) + abs(plane[3]) * light[3];
                           const bool isLit = height > (light[3] == 0 ? Wide(1e-12) : Wide(1e-6)) * size;
                           return entrywise({isLit && above && below ? Wide(1) : Wide(0)});
                       }},
                  [](const Arguments& a) {
                      const std::array<vec3, 4> corners{vectorAt(a, cornersAt), vectorAt(a, cornersAt + 3),
                                                        vectorAt(a, cornersAt + 6), vectorAt(a, cornersAt + 9)};
                      return judgeCaster("caster", corners, pointAt(a, lightAt), pointAt(a, planeAt)).casts;
                  }));
    return list;
}

}  // namespace mv::accuracy
