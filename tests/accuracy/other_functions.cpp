// clip.h, stereo.h and robust.h.
#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "accuracy/function.h"
#include "mv/error.h"
#include "mv/math/clip.h"
#include "mv/math/robust.h"
#include "mv/math/stereo.h"
#include "mv/math/transform.h"

namespace mv::accuracy {
namespace {

using test::wide;
using test::Wide3;
using test::Wide4;
using test::WideMatrix;

// A segment from inside a half space to outside it: two points and the bound.
Arguments cuts(Random& random, Domain domain) {
    for (;;) {
        const double scale = anyScale(random, domain, 70);
        const double boundScale = anyScale(random, domain, 70);
        const vec4 bound = boundScale * vec4{random.direction(), random.number(-1, 1)};
        const vec4 a = scale * vec4{random.point(1), random.number(-1, 1)};
        const double apart = domain == Domain::whole ? random.logarithmic(1e-9, 1e3) : 1.0;
        const vec4 b = a + scale * apart * vec4{random.point(1), random.number(-1, 1)};
        if ((glm::dot(bound, a) >= 0) == (glm::dot(bound, b) >= 0)) continue;
        Arguments arguments{};
        put(arguments, 0, a);
        put(arguments, 4, b);
        put(arguments, 8, bound);
        return arguments;
    }
}

std::vector<vec4> cutOf(const Arguments& a) {
    const vec4 bound[] = {pointAt(a, 8)};
    return clipPolygon({pointAt(a, 0), pointAt(a, 4)}, bound);
}

bool isOnBothSides(const Arguments& a) {
    const Wide4 bound = wide(pointAt(a, 8));
    return (dot(bound, wide(pointAt(a, 0))) >= 0) != (dot(bound, wide(pointAt(a, 4))) >= 0);
}

// How far inside the half space the corner is that was not there before. Where there is none, rounding has judged one of
// the two ends wrongly, and it is that one.
Wide insideAtCut(const Arguments& a) {
    const auto cut = cutOf(a);
    const vec4 first = pointAt(a, 0), second = pointAt(a, 4);
    const Wide4 bound = wide(pointAt(a, 8));
    const auto inside = [&](const vec4& p) { return dot(bound, wide(p)); };
    for (const vec4& corner : cut) {
        if (corner != first && corner != second) return inside(corner);
    }
    const bool isFirstKept = std::count(cut.begin(), cut.end(), first) > 0;
    const bool isSecondKept = std::count(cut.begin(), cut.end(), second) > 0;
    if (isFirstKept != (inside(first) >= 0)) return inside(first);
    if (isSecondKept != (inside(second) >= 0)) return inside(second);
    return isFirstKept ? inside(first) : inside(second);  // the cut is that very end
}

Function clipping() {
    Function function = withForms(
        {.name = "clipPolygon",
         .header = "clip.h",
         .returns = "the part of a polygon in half spaces (timed: a segment, one half space)",
         .measured = "how far the new corner is off the bound, ulp of the ends' larger product with it",
         .domain = "segments 1e-70 to 1e70 large, as close to the bound as 1e-9",
         .bound = 10,
         .reason =
             "roundings: four of each dot product, one of their difference, and three of the way along the segment",
         .sample = cuts,
         .truth =
             [](const Arguments& a) {
                 const Wide4 bound = wide(glm::abs(pointAt(a, 8)));
                 Truth truth = entrywise({Wide(0)});
                 truth.sizes = {std::max<Wide>(dot(bound, wide(glm::abs(pointAt(a, 0)))),
                                               dot(bound, wide(glm::abs(pointAt(a, 4)))))};
                 return truth;
             },
         .limits = quotientLimits + "; ends on both sides",
         .within = [sizes = quotientSizes()](const Arguments& a) { return sizes(a) && isOnBothSides(a); }},
        cutOf);
    function.forms[0].values = [](const Arguments& a) { return std::vector<Wide>{insideAtCut(a)}; };
    return function;
}

// Four corners of a flat, convex polygon.
Arguments polygons(Random& random, Domain domain) {
    const double scale = anyScale(random, domain, 70);
    const vec3 across = random.direction(), along = glm::normalize(glm::cross(across, random.direction()));
    const double thin = domain == Domain::whole ? random.logarithmic(1e-6, 1) : 1.0;
    const double away = domain == Domain::whole ? random.logarithmic(1e-3, 1e3) : 1.0;
    const vec3 base = away * random.point(1);
    Arguments a{};
    put(a, 0, scale * base);
    put(a, 3, scale * (base + random.number(0.5, 1) * along));
    const vec3 beyond = base + random.number(0.5, 1) * along;
    put(a, 6, scale * (beyond + thin * random.number(0.5, 1) * across));
    put(a, 9, scale * (base + thin * random.number(0.5, 1) * across));
    return a;
}

// A point before two eyes that look through one window, and the pictures' size.
Arguments eyes(Random& random, Domain domain) {
    const bool isWhole = domain == Domain::whole;
    const double scale = anyScale(random, domain, 60);
    const double apart = isWhole ? random.logarithmic(1e-6, 1) : random.number(0.05, 0.1);
    const double convergence = isWhole ? random.logarithmic(0.1, 1e4) : random.number(0.5, 10);
    const FrustumBounds window = frustumBounds(random.number(10, 120), 4.0 / 3, 0.1, 1e5);
    Arguments a{};
    for (const double side : {-0.5, 0.5}) {
        FrustumBounds shifted = window;
        shifted.left -= side * apart * 0.1 / convergence;
        shifted.right -= side * apart * 0.1 / convergence;
        put(a, side < 0 ? 0 : 16, frustum(shifted) * translate(-side * apart, 0, 0) * mv::scale(1 / scale));
    }
    const double away = isWhole ? random.logarithmic(0.1, 1e5) : random.number(0.2, 50);
    put(a, 32, scale * away * vec3{random.number(-1, 1), random.number(-1, 1), -1});
    a[35] = std::floor(random.logarithmic(1, 16385));
    a[36] = std::floor(random.logarithmic(1, 16385));
    return a;
}

Truth parallaxTruth(const Arguments& a) {
    const Wide4 point = homogeneous(wide(vectorAt(a, 32)), 1);
    const Wide3 left = divided(wide(matrixAt(a, 0)) * point), right = divided(wide(matrixAt(a, 16)) * point);
    const Wide across = (right[0] - left[0]) / 2 * a[35], up = abs((right[1] - left[1]) / 2 * a[36]);
    // A pixel's position has the roundings of the products that x and w are sums of.
    const auto position = [&](std::size_t axis) {
        Wide worst = 0;
        for (const std::size_t eye : {std::size_t{0}, std::size_t{16}}) {
            const WideMatrix m = wide(matrixAt(a, eye));
            const Wide4 clip = m * point;
            Wide terms = 0, ofW = 0;
            for (std::size_t i = 0; i < 4; ++i) {
                terms += abs(m.column[i][axis] * point[i]);
                ofW += abs(m.column[i][3] * point[i]);
            }
            worst = std::max<Wide>(worst, 1 + (terms + ofW * abs(clip[axis] / clip[3])) / abs(clip[3]));
        }
        return worst / 2 * a[35 + axis];
    };
    return {{across, across, up}, {2, 1}, {}, false, {position(0), position(1)}};
}

bool isUsualProduct(double a, double b) {
    if (a == 0 || b == 0) return true;
    const double size = std::abs(a * b);
    return size >= 1e-290 && size <= 1e300;
}

Arguments nearlyEqualProducts(Random& random, Domain domain) {
    Arguments a{};
    for (std::size_t i = 0; i < 3; ++i) a[i] = anyNumber(random, domain, 60);
    const double sign = random.sign();
    a[3] = a[0] * a[1] / a[2] * (1 + sign * random.logarithmic(domain == Domain::whole ? 1e-17 : 0.1, 1));
    return a;
}

Arguments nearlyParallel(Random& random, Domain domain) {
    const double least = domain == Domain::whole ? 1e-16 : 0.1;
    const vec3 first = random.direction();
    const double apart = random.logarithmic(least, 10);
    const vec3 second = first + apart * random.direction();
    Arguments a{};
    const double scale = anyScale(random, domain, 60);
    put(a, 0, scale * random.number(1, 2) * first);
    const double otherScale = anyScale(random, domain, 60);
    put(a, 3, otherScale * random.number(1, 2) * second);
    return a;
}

Arguments vectors(Random& random, Domain domain) {
    Arguments a{};
    const double scale = anyScale(random, domain, 290);
    for (std::size_t i = 0; i < 3; ++i) {
        if (domain == Domain::ordinary) {
            a[i] = random.number(-10, 10);
        } else {
            const double sign = random.sign();
            a[i] = scale * sign * random.logarithmic(1e-9, 1);
        }
    }
    return a;
}

Truth vectorTruth(const Wide3& v) { return entrywise({v[0], v[1], v[2]}); }

int trueExponent(double size) {
    return size == 0 || (size >= 0x1p-100 && size <= 0x1p100) ? 0 : static_cast<int>(ilogb(Wide(size)));
}
double largestOf(const Arguments& a) { return std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])}); }

}  // namespace

std::vector<Function> otherFunctions() {
    std::vector<Function> list;
    list.push_back(clipping());
    list.push_back(
        withForms({.name = "polygonArea",
                   .header = "clip.h",
                   .returns = "the area of a flat polygon",
                   .measured = "ulp of the diagonal times the other edges of the first corner",
                   .domain = "four corners, 1e-70 to 1e70 large, as thin as 1e-6, 1e3 of that away",
                   .bound = 8,
                   .reason = "roundings: of edges, of cross products, their sum and its length",
                   .sample = polygons,
                   .truth =
                       [](const Arguments& a) {
                           const auto edge = [&](std::size_t i) { return wide(vectorAt(a, i)) - wide(vectorAt(a, 0)); };
                           const Wide3 first = cross(edge(3), edge(6)), second = cross(edge(6), edge(9));
                           Truth truth = entrywise({length(first + second) / 2});
                           truth.sizes = {length(edge(6)) * (length(edge(3)) + length(edge(9)))};
                           return truth;
                       },
                   .limits = "coordinates 0, or at least 1e-290",
                   .within = sizesBetween(1e-290, std::numeric_limits<double>::max())},
                  [](const Arguments& a) {
                      const std::array<vec3, 4> corners{vectorAt(a, 0), vectorAt(a, 3), vectorAt(a, 6), vectorAt(a, 9)};
                      return polygonArea(corners);
                  }));
    list.push_back(withForms(
        {.name = "parallaxOf",
         .header = "stereo.h",
         .returns = "how far apart two eyes see a point",
         .measured = "ulp of the terms of the pixels' positions, without their signs",
         .domain = "scenes 1e-60 to 1e60 large, eyes 1e-6 to 1 apart that meet 0.1 to 1e4 away",
         .bound = 8,
         .reason = "roundings: four of each row's product with the point, two quotients, a product and a difference",
         .sample = eyes,
         .truth = parallaxTruth,
         .limits = "pictures 1 to 16384 pixels wide and high, points before both eyes",
         .within = [](const Arguments& a) { return isPictureSize(a[35]) && isPictureSize(a[36]); }},
        [](const Arguments& a) {
            const vec3 point = vectorAt(a, 32);
            const auto parallax = parallaxOf(std::span(&point, 1), matrixAt(a, 0), matrixAt(a, 16),
                                             static_cast<int>(a[35]), static_cast<int>(a[36]), 1e-100);
            if (!parallax) throw Error("parallaxOf", "the point must lie before both eyes");
            return parallax;
        }));
    return list;
}

std::vector<Function> robustFunctions() {
    std::vector<Function> list;
    list.push_back(withForms(
        {.name = "scalingExponent",
         .header = "robust.h",
         .returns = "the exponent that brings a size to 1..2",
         .measured = "entrywise",
         .domain = "1e-300 to 1e300",
         .bound = 0,
         .reason = "",
         .sample = [](Random& random, Domain domain) { return Arguments{std::abs(anyNumber(random, domain, 300))}; },
         .truth = [](const Arguments& a) { return entrywise({trueExponent(a[0])}); }},
        [](const Arguments& a) { return scalingExponent(a[0]); }));
    list.push_back(withForms({.name = "largestComponent",
                              .header = "robust.h",
                              .returns = "the size of the largest component",
                              .measured = "entrywise",
                              .domain = "1e-290 to 1e290",
                              .bound = 0,
                              .reason = "",
                              .sample = vectors,
                              .truth = [](const Arguments& a) { return entrywise({largestOf(a)}); }},
                             [](const Arguments& a) { return largestComponent(vectorAt(a, 0)); }));
    list.push_back(
        withForms({.name = "timesPowerOfTwo",
                   .header = "robust.h",
                   .returns = "a vector times 2^exponent (timed and measured: 2^-7)",
                   .measured = "entrywise",
                   .domain = "1e-290 to 1e290",
                   .bound = 0.5,
                   .reason = "",
                   .sample = vectors,
                   .truth = [](const Arguments& a) { return vectorTruth(Wide(0x1p-7) * wide(vectorAt(a, 0))); }},
                  [](const Arguments& a) { return timesPowerOfTwo(vectorAt(a, 0), -7); }));
    list.push_back(withForms({.name = "scaledForSquares",
                              .header = "robust.h",
                              .returns = "a vector whose squares neither overflow nor vanish",
                              .measured = "entrywise",
                              .domain = "1e-290 to 1e290",
                              .bound = 0.5,
                              .reason = "",
                              .sample = vectors,
                              .truth =
                                  [](const Arguments& a) {
                                      return vectorTruth(ldexp(Wide(1), -trueExponent(largestOf(a))) *
                                                         wide(vectorAt(a, 0)));
                                  }},
                             [](const Arguments& a) { return scaledForSquares(vectorAt(a, 0)); }));
    list.push_back(withForms(
        {.name = "unit",
         .header = "robust.h",
         .returns = "a vector divided by its length",
         .measured = "entrywise",
         .domain = "1e-290 to 1e290",
         .reason = "",
         .sample = vectors,
         .truth = [](const Arguments& a) { return vectorTruth(normalized(wide(vectorAt(a, 0)))); },
         .limits = "any but 0",
         .within = [](const Arguments& a) { return vectorAt(a, 0) != vec3(0); }},
        [](const Arguments& a) { return unit(vectorAt(a, 0)); },
        []<typename T>(const ArgumentsOf<T>& a) { return glm::normalize(vectorAt(a, 0)); }));
    list.push_back(withForms(
        {.name = "differenceOfProducts",
         .header = "robust.h",
         .returns = "a b − c d",
         .measured = "entrywise",
         .domain = "1e-60 to 1e60, products 1e-17 to 1 of their size apart",
         .bound = 1.5,
         .reason = "",
         .sample = nearlyEqualProducts,
         .truth = [](const Arguments& a) { return entrywise({Wide(a[0]) * a[1] - Wide(a[2]) * a[3]}); },
         .limits = "products 0, or from 1e-290 to 1e300",
         .within = [](const Arguments& a) { return isUsualProduct(a[0], a[1]) && isUsualProduct(a[2], a[3]); }},
        [](const Arguments& a) { return differenceOfProducts(a[0], a[1], a[2], a[3]); },
        []<typename T>(const ArgumentsOf<T>& a) {
            return glm::determinant(glm::mat<2, 2, T>(a[0], a[2], a[3], a[1]));
        }));
    list.push_back(withForms(
        {.name = "accurateCross",
         .header = "robust.h",
         .returns = "a × b",
         .measured = "entrywise",
         .domain = "1e-60 to 1e60, 1e-16 to 1.5 rad apart",
         .bound = 1.5,
         .reason = "",
         .sample = nearlyParallel,
         .truth = [](const Arguments& a) { return vectorTruth(cross(wide(vectorAt(a, 0)), wide(vectorAt(a, 3)))); },
         .limits = "products 0, or from 1e-290 to 1e300",
         .within =
             [](const Arguments& a) {
                 for (std::size_t i = 0; i < 3; ++i) {
                     const std::size_t k = (i + 1) % 3, l = (i + 2) % 3;
                     if (!isUsualProduct(a[k], a[3 + l]) || !isUsualProduct(a[l], a[3 + k])) return false;
                 }
                 return true;
             }},
        [](const Arguments& a) { return accurateCross(vectorAt(a, 0), vectorAt(a, 3)); },
        []<typename T>(const ArgumentsOf<T>& a) { return glm::cross(vectorAt(a, 0), vectorAt(a, 3)); }));
    return list;
}

}  // namespace mv::accuracy
