// shadow.h and shadow_caster.h.
#include <algorithm>
#include <cmath>

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

// Where light, plane, origin and the caster's corners are.
constexpr std::size_t lightAt = 0, planeAt = 4, originAt = 8, cornersAt = 11;

// A plane up to 1e3 scene units away from the origin, a light 1e-5 to 1e3 of them above or below it.
Arguments scenes(Random& random, Domain domain) {
    const bool isWhole = domain == Domain::whole;
    const double unit = anyScale(random, domain, 60), normalSize = anyScale(random, domain, 60);
    const vec3 up = random.direction();
    const double away = isWhole ? random.logarithmic(1e-3, 1e3) : random.number(0, 10);
    const vec3 onPlane = unit * away * up;
    const double part = random.number(0, 3), times = isWhole ? random.logarithmic(1e-3, 1e2) : 1.0;
    const vec3 aside = unit * part * times * glm::normalize(glm::cross(up, random.direction()));
    const double sign = random.sign();
    const double height = sign * (isWhole ? random.logarithmic(1e-2, 1e3) : random.number(1, 10));
    const vec3 position = onPlane + aside + unit * height * up;
    const double w = random.sign() < 0 ? 1 : isWhole ? random.logarithmic(1e-3, 1e3) : random.number(0.5, 2);
    Arguments a{};
    put(a, lightAt, random.sign() < 0 && random.sign() < 0 ? vec4(position - onPlane, 0) : vec4(position, 1) * w);
    put(a, planeAt, normalSize * vec4(up, -glm::dot(up, onPlane)));
    put(a, originAt, onPlane);
    const vec3 middle = onPlane + unit * std::abs(height) * random.number(-0.5, 1.5) * up;
    for (std::size_t i = 0; i < 4; ++i) put(a, cornersAt + 3 * i, middle + 0.3 * unit * random.point(1));
    return a;
}

Wide4 unitPlane(const Arguments& a) {
    const Wide4 plane = wide(pointAt(a, planeAt));
    return plane / length(firstThree(plane));
}
Wide4 turnedTo(const Wide4& light, const Wide4& plane) { return dot(plane, light) < 0 ? Wide(-1) * plane : plane; }

// The sum of the sizes of a product's terms, of the first `count`.
Wide termsOf(const Wide4& n, const Wide4& light, std::size_t count) {
    Wide sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += sizeOf(n[i]) * abs(light[i]);
    return sum;
}

Truth projectionTruth(const Wide4& light, const Wide4& plane) {
    const Wide4 n = turnedTo(light, plane);
    const Wide height = dot(n, light);
    Truth truth;
    for (std::size_t column = 0; column < 4; ++column) {
        for (std::size_t row = 0; row < 4; ++row) {
            // At the last place the plane's distance falls out, which not even 50 digits would do at any size.
            const bool isLast = column == 3 && row == 3;
            truth.values.push_back(isLast ? dot(firstThree(n), firstThree(light))
                                          : (row == column ? height : Wide(0)) - n[column] * light[row]);
            truth.blocks.push_back(1);
            const Wide ofHeight = row != column ? Wide(0) : termsOf(n, light, column == 3 ? 3 : 4);
            truth.sizes.push_back(ofHeight + sizeOf(n[column]) * (isLast ? Wide(0) : abs(light[row])));
        }
    }
    return truth;
}

// A verdict, 1 for yes; `isOpen`: so close to the bound that rounding decides, and either is right.
Truth verdict(const Wide& value, bool isOpen, double closeness) {
    Truth truth = entrywise({value});
    truth.sizes = {isOpen ? anySize : Wide(1)};
    truth.closeness = closeness;
    return truth;
}
// Minus the distance of a quotient from 1, in powers of two.
double closenessOf(const Wide& value, const Wide& bound) {
    if (value <= 0 || bound <= 0) return -1e4;
    return -std::abs(static_cast<double>(log2(value / bound)));
}

// The light's height, in units of the one below which it counts as lying in the plane.
Wide clearance(const Wide4& light, const Wide4& plane) {
    const Wide size = length(firstThree(light)) + abs(plane[3]) * light[3];
    return dot(plane, light) / ((light[3] == 0 ? Wide(1e-12) : Wide(1e-6)) * size);
}
// The error that rounding may make: some roundings of the terms, which are 1e6 or 1e12 times as large.
double clearanceRounding(const Wide4& light) { return light[3] == 0 ? 1e-3 : 1e-9; }

const std::string ofTerms = "ulp of the sum of each entry's terms, without their signs";
const std::string sceneDomain = "scenes 1e-60 to 1e60 large, planes up to 1e3 of that away";

}  // namespace

std::vector<Function> shadowFunctions() {
    std::vector<Function> list;
    list.push_back(withForms(
        {.name = "shadowProjection",
         .header = "shadow.h",
         .returns = "the shadow on a plane",
         .measured = ofTerms,
         .domain = sceneDomain,
         .bound = 13,
         .reason =
             "roundings: 7.5 of the plane's distance by a normal of length 1, and five of the products and their sums",
         .sample = scenes,
         .truth = [](const Arguments& a) { return projectionTruth(wide(pointAt(a, lightAt)), unitPlane(a)); }},
        [](const Arguments& a) { return shadowProjection(pointAt(a, lightAt), pointAt(a, planeAt)); }));
    list.push_back(withForms(
        {.name = "shadowProjection (origin)",
         .header = "shadow.h",
         .returns = "the same, relative to a point on the plane",
         .measured = ofTerms,
         .domain = sceneDomain,
         .bound = 13,
         .reason = "as without origin",
         .sample = scenes,
         .truth =
             [](const Arguments& a) {
                 const Wide4 light = wide(pointAt(a, lightAt));
                 const Wide3 local = firstThree(light) - light[3] * wide(vectorAt(a, originAt));
                 return projectionTruth(homogeneous(local, light[3]), homogeneous(firstThree(unitPlane(a)), 0));
             }},
        [](const Arguments& a) {
            return shadowProjection(pointAt(a, lightAt), pointAt(a, planeAt), vectorAt(a, originAt));
        }));
    list.push_back(
        withForms({.name = "shadowCasterBounds",
                   .header = "shadow.h",
                   .returns = "where a caster has to be",
                   .measured = ofTerms,
                   .domain = sceneDomain,
                   .bound = 8,
                   .reason = "roundings: 7.5 of the plane's distance by a normal of length 1",
                   .sample = scenes,
                   .truth =
                       [](const Arguments& a) {
                           const Wide4 light = wide(pointAt(a, lightAt)), n = turnedTo(light, unitPlane(a));
                           Wide4 lower = Wide(-1) * (light[3] * n);
                           lower[3] = dot(firstThree(n), firstThree(light));
                           Truth truth;
                           for (std::size_t i = 0; i < 8; ++i) {
                               truth.values.push_back(i < 4 ? n[i] : lower[i - 4]);
                               truth.blocks.push_back(1);
                               truth.sizes.push_back(i < 4    ? sizeOf(n[i])
                                                     : i == 7 ? termsOf(n, light, 3)
                                                              : light[3] * sizeOf(n[i - 4]));
                           }
                           return truth;
                       }},
                  [](const Arguments& a) { return shadowCasterBounds(pointAt(a, lightAt), pointAt(a, planeAt)); }));
    list.push_back(withForms({.name = "lightSide",
                              .header = "shadow.h",
                              .returns = "which side of the plane the light is on",
                              .measured = "wrong verdicts (0: none), but for what rounding decides",
                              .domain = sceneDomain,
                              .reason = "",
                              .sample = scenes,
                              .truth =
                                  [](const Arguments& a) {
                                      const Wide4 light = wide(pointAt(a, lightAt));
                                      const Wide clear = clearance(light, unitPlane(a));
                                      return verdict(clear > 1    ? 1
                                                     : clear < -1 ? -1
                                                                  : 0,
                                                     abs(abs(clear) - 1) <= clearanceRounding(light),
                                                     closenessOf(abs(clear), 1));
                                  }},
                             [](const Arguments& a) { return lightSide(pointAt(a, lightAt), pointAt(a, planeAt)); }));
    list.push_back(withForms({.name = "reflection",
                              .header = "shadow.h",
                              .returns = "mirrors in a plane",
                              .measured = ofTerms,
                              .domain = sceneDomain,
                              .bound = 13,
                              .reason = "roundings: 7.5 of the plane's distance, 3.5 of the normal, and two products",
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
                                      Truth truth = entrywise(valuesOf(m));
                                      for (std::size_t i = 0; i < 16; ++i) {
                                          const std::size_t column = i / 4, row = i % 4;
                                          const Wide product =
                                              row < 3 ? 2 * sizeOf(n[column]) * sizeOf(n[row]) : Wide(0);
                                          truth.sizes.push_back((row == column ? Wide(1) : Wide(0)) + product);
                                      }
                                      return truth;
                                  }},
                             [](const Arguments& a) { return reflection(pointAt(a, planeAt)); }));
    list.push_back(withForms(
        {.name = "judgeCaster",
         .header = "shadow_caster.h",
         .returns = "whether a caster throws a shadow, and why not",
         .measured = "wrong verdicts (0: none), but for what rounding decides",
         .domain = sceneDomain,
         .reason = "",
         .sample = scenes,
         .truth =
             [](const Arguments& a) {
                 const Wide4 light = wide(pointAt(a, lightAt)), plane = unitPlane(a);
                 const Wide along = dot(firstThree(plane), firstThree(light)), clear = clearance(light, plane);
                 // The most that a corner is above the floor, and below the light, in units of what counts as 0.
                 Wide above = -1e9, below = -1e9;
                 for (std::size_t i = 0; i < 4; ++i) {
                     const Wide4 corner = homogeneous(wide(vectorAt(a, cornersAt + 3 * i)), 1);
                     const Wide at = dot(plane, corner), size = termsOf(plane, corner, 4);
                     const Wide sizeBelow = termsOf(plane, light, 3) + light[3] * termsOf(plane, corner, 3);
                     above = std::max<Wide>(above, at / (Wide(1e-12) * size));
                     below = std::max<Wide>(below, (along - light[3] * dot(firstThree(plane), firstThree(corner))) /
                                                       (Wide(1e-12) * sizeBelow));
                 }
                 const bool isOpen =
                     std::min<Wide>({clear, above, below}) > 0.99 &&
                     (abs(clear - 1) <= clearanceRounding(light) || abs(above - 1) < 1e-2 || abs(below - 1) < 1e-2);
                 const double closeness =
                     std::max({closenessOf(clear, 1), closenessOf(above, 1), closenessOf(below, 1)});
                 return verdict(clear > 1 && above > 1 && below > 1 ? 1 : 0, isOpen, closeness);
             }},
        [](const Arguments& a) {
            const std::array<vec3, 4> corners{vectorAt(a, cornersAt), vectorAt(a, cornersAt + 3),
                                              vectorAt(a, cornersAt + 6), vectorAt(a, cornersAt + 9)};
            return judgeCaster("caster", corners, pointAt(a, lightAt), pointAt(a, planeAt)).casts;
        }));
    // Beyond these a plane's unit normal loses the components that decide.
    for (Function& function : list) {
        function.limits = quotientLimits;
        function.within = quotientSizes();
    }
    return list;
}

}  // namespace mv::accuracy
