// geometry/ray.h, in double and in float.
//
// Each function says, for a ray that meets nothing, how that is written as numbers, so that a wrong verdict is an error of the
// size by which it is wrong: a ray that misses a sphere by a rounding is one that touches it.
#include "mv/geometry/ray.h"

#include <algorithm>
#include <limits>

#include "accuracy/function.h"

namespace mv::accuracy {
namespace {

using test::wide;
using test::Wide3;

// Where a ray's origin and direction are, and what follows them.
constexpr std::size_t originAt = 0, directionAt = 3, solidAt = 6;

template <typename T>
RayOf<T> rayOf(const ArgumentsOf<T>& a) {
    return {vectorAt(a, originAt), vectorAt(a, directionAt)};
}

// The sum of the sizes of a dot product's terms.
Wide termsOf(const Wide3& a, const Wide3& b) {
    Wide sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += abs(a[i] * b[i]);
    return sum;
}

// A quotient by a number that may be 0: then so large that no error counts.
Wide over(const Wide& a, const Wide& b) { return b == 0 ? anySize : std::min<Wide>(a / abs(b), anySize); }

// Sizes of which products of four leave the range of neither float nor double, without their square roots being rough.
const std::string ordinarySizes = "numbers 0, or from 1e-4 to 1e4 in size";

// A ray from up to 10 away towards somewhere near the origin, with a direction of any length.
void putRay(Random& random, Domain domain, Arguments& a) {
    const double away = 10 * random.number(0, 1);
    const vec3 origin = away * random.direction();
    const double aside = domain == Domain::whole ? random.logarithmic(1e-3, 2) : 1.0;
    const vec3 towards = aside * random.point(1);
    put(a, originAt, origin);
    put(a, directionAt, random.logarithmic(0.1, 10) * (towards - origin));
}

// ---- plane: t, or 0 where there is none

Truth planeTruth(const Arguments& a) {
    const Wide3 origin = wide(vectorAt(a, originAt)), direction = wide(vectorAt(a, directionAt));
    const Wide3 normal = wide(vectorAt(a, solidAt));
    const Wide along = dot(normal, direction), height = dot(normal, origin) + a[solidAt + 3];
    const Wide t = along == 0 ? Wide(0) : Wide(-height / along);
    Truth truth = entrywise({std::max<Wide>(t, 0)});
    truth.sizes = {
        over(termsOf(normal, origin) + std::abs(a[solidAt + 3]) + abs(t) * termsOf(normal, direction), along)};
    return truth;
}

// ---- sphere: both ends of the interval; where there is none, where the line is nearest to the centre, twice

struct Chord {
    Wide middle = 0, half = 0, halfRounding = 0, middleRounding = 0;
    bool isMet = false, isOpen = false;
};
Chord chordOf(const Arguments& a) {
    const Wide3 origin = wide(vectorAt(a, originAt)), d = wide(vectorAt(a, directionAt));
    const Wide3 center = wide(vectorAt(a, solidAt)), f = origin - center;
    const Wide radius = a[solidAt + 3], squares = dot(d, d);
    Chord chord;
    if (squares == 0 || radius <= 0) return chord;
    const Wide3 miss = cross(f, d);
    const Wide discriminant = squares * radius * radius - dot(miss, miss);
    Wide missTerms = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t k = (i + 1) % 3, l = (i + 2) % 3;
        missTerms += abs(miss[i]) * (abs(f[k] * d[l]) + abs(f[l] * d[k]));
    }
    const Wide terms = squares * radius * radius + missTerms, root = sqrt(abs(discriminant));
    chord.middle = -dot(f, d) / squares;
    chord.half = root / squares;
    chord.isMet = discriminant >= 0;
    chord.halfRounding = over(terms, root * squares);
    chord.middleRounding = termsOf(f, d) / squares;
    // The end that is found by c/q, whose c is the difference of two squares
    const Wide q = abs(dot(f, d)) + root;
    chord.middleRounding += over(dot(f, f) + radius * radius, q);
    return chord;
}

Truth sphereTruth(const Arguments& a) {
    const Chord chord = chordOf(a);
    const Wide size = chord.middleRounding + chord.halfRounding;
    const Wide half = chord.isMet && chord.middle + chord.half >= 0 ? chord.half : Wide(0);
    Truth truth = entrywise({chord.middle - half, chord.middle + half});
    // Behind, but for a rounding: met or not
    const bool isOpen = chord.isMet && abs(chord.middle + chord.half) <= size * 1e-5;
    truth.sizes = {isOpen ? anySize : size, isOpen ? anySize : size};
    return truth;
}

// ---- box: met, near and far; 0, 0, 0 where there is none

Truth boxTruth(const Arguments& a) {
    Wide near = -anySize, far = anySize;
    bool isBox = true, isBeside = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Wide from = a[originAt + axis], along = a[directionAt + axis];
        const Wide low = a[solidAt + axis], high = a[solidAt + 3 + axis];
        isBox = isBox && low <= high;
        if (along == 0) {
            isBeside = isBeside || from < low || from > high;
            continue;
        }
        const Wide first = (low - from) / along, last = (high - from) / along;
        near = std::max<Wide>(near, std::min<Wide>(first, last));
        far = std::min<Wide>(far, std::max<Wide>(first, last));
    }
    const bool hasDirection = far < anySize;
    const bool isMet = isBox && !isBeside && hasDirection && near <= far && far >= 0;
    Truth truth = entrywise(isMet ? std::vector<Wide>{1, near, far} : std::vector<Wide>{0, 0, 0});
    // Through an edge or a corner, but for a rounding
    const bool isOpen = isBox && !isBeside && hasDirection && abs(far - near) <= 1e-6 * (abs(far) + abs(near));
    truth.sizes = isOpen ? std::vector<Wide>(3, anySize) : std::vector<Wide>{1, abs(near), abs(far)};
    return truth;
}

// ---- triangle: met, t and the weights; all 0 where there is none

struct Volumes {
    std::array<Wide, 3> value{},
        terms{};  // of the ray and each edge, by the corner across it; and of what they are sums
    Wide sum = 0, sumOfTerms = 0;
};
// The coordinates are those of the corners from the ray's origin, so their roundings are parts of them.
Volumes volumesOf(const Wide3& origin, const Wide3& d, const std::array<Wide3, 3>& corners) {
    std::size_t z = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (abs(d[i]) >= abs(d[z])) z = i;  // of equal ones the last, as ours
    }
    const std::size_t x = (z + 1) % 3, y = (z + 2) % 3;
    std::array<std::array<Wide, 4>, 3> flat;  // x, y, and their sizes
    for (std::size_t i = 0; i < 3; ++i) {
        const Wide3 p = corners[i] - origin;
        const Wide shearX = d[x] / d[z] * p[z], shearY = d[y] / d[z] * p[z];
        flat[i] = {p[x] - shearX, p[y] - shearY, abs(p[x]) + abs(shearX), abs(p[y]) + abs(shearY)};
    }
    Volumes volumes;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto &p = flat[(i + 1) % 3], &q = flat[(i + 2) % 3];
        volumes.value[i] = q[0] * p[1] - q[1] * p[0];
        volumes.terms[i] = q[2] * abs(p[1]) + abs(q[0]) * p[3] + q[3] * abs(p[0]) + abs(q[1]) * p[2];
        volumes.sum += volumes.value[i];
        volumes.sumOfTerms += volumes.terms[i];
    }
    return volumes;
}

Truth triangleTruth(const Arguments& a, double part) {
    const Wide3 origin = wide(vectorAt(a, originAt)), d = wide(vectorAt(a, directionAt));
    Truth truth = entrywise(std::vector<Wide>(5, 0));
    truth.sizes = std::vector<Wide>(5, anySize);
    if (dot(d, d) == 0) return truth;
    const std::array<Wide3, 3> corners{wide(vectorAt(a, solidAt)), wide(vectorAt(a, solidAt + 3)),
                                       wide(vectorAt(a, solidAt + 6))};
    const Volumes volumes = volumesOf(origin, d, corners);
    const Wide3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (volumes.sum == 0) return truth;  // without area, or seen from the side
    std::size_t positive = 0, negative = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        // Beside a corner or an edge, but for a rounding
        if (abs(volumes.value[i]) <= part * volumes.terms[i]) return truth;
        ++(volumes.value[i] > 0 ? positive : negative);
    }
    const Wide t = dot(normal, corners[0] - origin) / dot(normal, d);
    // A corner's distance along the ray, times the volumes' rounding
    Wide tTerms = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Wide3 p = corners[i] - origin;
        Wide largest = 0, along = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            if (abs(d[k]) >= largest) {
                largest = abs(d[k]);
                along = abs(p[k]) / largest;
            }
        }
        tTerms += volumes.terms[i] * along;
    }
    const Wide size = over(tTerms + abs(t) * volumes.sumOfTerms, volumes.sum);
    if (abs(t) <= part * size) return truth;  // starts in it, but for a rounding
    truth.sizes = {Wide(1), size};
    if ((positive == 0 || negative == 0) && t > 0) {
        truth.values = {1, t};
        for (std::size_t i = 0; i < 3; ++i) truth.values.push_back(volumes.value[i] / volumes.sum);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        truth.sizes.push_back(over(volumes.terms[i] + abs(truth.values[2 + i]) * volumes.sumOfTerms, volumes.sum));
    }
    return truth;
}

// ---- the edge that two triangles share: 1 where at least one of them is met

// A ray towards the common edge p, q of the triangles p, left, q and p, q, right, well within both outlines.
Arguments sharedEdges(Random& random, Domain domain) {
    Arguments a{};
    const vec3 p = random.point(1), q = p + random.point(1), middle = 0.5 * (p + q);
    const double width = domain == Domain::whole ? random.logarithmic(1e-2, 1) : 1.0;
    const vec3 aside = width * random.point(1);
    const vec3 origin = 4.0 * random.direction();
    put(a, originAt, origin);
    put(a, directionAt, p + random.number(0.2, 0.8) * (q - p) - origin);
    put(a, solidAt, p);
    put(a, solidAt + 3, q);
    put(a, solidAt + 6, middle + aside);
    put(a, solidAt + 9, middle - aside + 0.3 * width * random.point(1));
    return a;
}

Truth sharedEdgeTruth(const Arguments& a) {
    const Wide3 origin = wide(vectorAt(a, originAt)), d = wide(vectorAt(a, directionAt));
    const Wide3 p = wide(vectorAt(a, solidAt)), q = wide(vectorAt(a, solidAt + 3));
    const Wide3 left = wide(vectorAt(a, solidAt + 6)), right = wide(vectorAt(a, solidAt + 9));
    Truth truth = entrywise({Wide(1)});
    truth.sizes = {anySize};
    if (dot(d, d) == 0) return truth;
    const Volumes ofLeft = volumesOf(origin, d, {p, left, q}), ofRight = volumesOf(origin, d, {p, q, right});
    // Clearly within the outer edges of both, which are across p and across q; seen from one side; before the eye
    const auto clear = [](const Volumes& volumes, std::size_t i, const Wide& sign) {
        return sign * volumes.value[i] > Wide(1e-3) * volumes.terms[i];
    };
    const Wide sign = ofLeft.sum > 0 ? 1 : -1;
    if (!clear(ofLeft, 0, sign) || !clear(ofLeft, 2, sign) || !clear(ofRight, 0, sign) || !clear(ofRight, 1, sign)) {
        return truth;
    }
    if (sign * ofLeft.sum <= 0 || sign * ofRight.sum <= 0) return truth;
    for (const Wide3& corner : {p, q, left, right}) {
        if (dot(corner - origin, d) <= Wide(1e-3) * length(corner - origin) * length(d)) return truth;
    }
    truth.sizes = {Wide(1)};
    // The nearer the ray is to the common edge, the harder it is to tell on which side of it.
    const Wide off = abs(ofLeft.value[1]) / ofLeft.terms[1];
    truth.closeness = off == 0 ? 1e3 : -static_cast<double>(log2(off));
    return truth;
}

template <typename Call>
Function inBothTypes(Function function, Call call) {
    function.header = "../geometry/ray.h";
    function.limits = ordinarySizes;
    function.within = sizesBetween(1e-4, 1e4);
    function.forms.push_back(makeForm<double>("mv", call));
    function.forms.push_back(makeForm<float>("mv float", call));
    return function;
}

}  // namespace

Form withMissesOfSphere(Form form) {
    form.values = [values = form.values](const Arguments& a) {
        const auto found = values(a);
        return isfinite(found[0]) ? found : std::vector<Wide>(2, chordOf(a).middle);
    };
    return form;
}

std::vector<Function> intersectionFunctions() {
    std::vector<Function> list;
    list.push_back(inBothTypes({.name = "intersectPlane",
                                .header = "",
                                .returns = "where a ray meets a plane",
                                .measured = "ulp of the terms of t, without their signs",
                                .domain = "rays from up to 10 away",
                                .bound = 6,
                                .reason = "roundings: four of the dot products' terms each, and a quotient",
                                .sample =
                                    [](Random& random, Domain domain) {
                                        Arguments a{};
                                        putRay(random, domain, a);
                                        put(a, solidAt, vec4{random.direction(), random.number(-1, 1)});
                                        return a;
                                    },
                                .truth = planeTruth},
                               []<typename T>(const ArgumentsOf<T>& a) {
                                   return intersectPlane(rayOf(a), pointAt(a, solidAt)).value_or(T(0));
                               }));
    Function sphere =
        inBothTypes({.name = "intersectSphere",
                     .header = "",
                     .returns = "where a ray is within a sphere",
                     .measured = "ulp of the terms of both ends, and of those of the discriminant over its root",
                     .domain = "rays from up to 10 away, radii 1e-3 to 3",
                     .bound = 8,
                     .reason = "roundings: of coordinates, the cross product, its square, both roots and quotients",
                     .sample =
                         [](Random& random, Domain domain) {
                             Arguments a{};
                             putRay(random, domain, a);
                             put(a, solidAt, random.point(0.5));
                             a[solidAt + 3] = random.logarithmic(1e-3, 3);
                             return a;
                         },
                     .truth = sphereTruth},
                    []<typename T>(const ArgumentsOf<T>& a) {
                        const auto met = intersectSphere(rayOf(a), vectorAt(a, solidAt), a[solidAt + 3]);
                        constexpr T none = std::numeric_limits<T>::infinity();
                        return met ? std::array<T, 2>{met->near, met->far} : std::array<T, 2>{none, none};
                    });
    for (Form& form : sphere.forms) form = withMissesOfSphere(std::move(form));
    list.push_back(std::move(sphere));
    list.push_back(inBothTypes({.name = "intersectBox",
                                .header = "",
                                .returns = "where a ray is within a box",
                                .measured = "entrywise",
                                .domain = "rays from up to 10 away",
                                .reason = "",
                                .sample =
                                    [](Random& random, Domain domain) {
                                        Arguments a{};
                                        putRay(random, domain, a);
                                        const vec3 low = random.point(1);
                                        put(a, solidAt, low);
                                        put(a, solidAt + 3, low + glm::abs(random.point(1)));
                                        return a;
                                    },
                                .truth = boxTruth},
                               []<typename T>(const ArgumentsOf<T>& a) {
                                   const auto met =
                                       intersectBox(rayOf(a), vectorAt(a, solidAt), vectorAt(a, solidAt + 3));
                                   return met ? std::array<T, 3>{1, met->near, met->far} : std::array<T, 3>{0, 0, 0};
                               }));
    list.push_back(inBothTypes(
        {.name = "intersectTriangle",
         .header = "",
         .returns = "where a ray meets a triangle",
         .measured = "ulp of the terms of t and of each weight, without their signs",
         .domain = "rays from up to 10 away",
         .bound = 29,
         .reason = "roundings: 4 of a sheared coordinate, 10 of a weight, 12 of their sum, 16 of the distance, and a "
                   "quotient",
         .sample =
             [](Random& random, Domain domain) {
                 Arguments a{};
                 putRay(random, domain, a);
                 for (const std::size_t i : {0U, 3U, 6U}) put(a, solidAt + i, random.point(1));
                 return a;
             },
         .truth = [](const Arguments& a) { return triangleTruth(a, 1e-5); }},
        []<typename T>(const ArgumentsOf<T>& a) {
            const auto met =
                intersectTriangle(rayOf(a), vectorAt(a, solidAt), vectorAt(a, solidAt + 3), vectorAt(a, solidAt + 6));
            return met ? std::array<T, 5>{1, met->t, met->a, met->b, met->c} : std::array<T, 5>{0, 0, 0, 0, 0};
        }));
    list.push_back(inBothTypes({.name = "TriangleTest (common edge)",
                                .header = "",
                                .returns = "whether a ray towards the edge of two triangles meets one of them",
                                .measured = "wrong verdicts (0: none)",
                                .domain = "rays from 4 away",
                                .reason = "",
                                .sample = sharedEdges,
                                .truth = sharedEdgeTruth},
                               []<typename T>(const ArgumentsOf<T>& a) {
                                   const TriangleTest<T> test(rayOf(a));
                                   const auto p = vectorAt(a, solidAt), q = vectorAt(a, solidAt + 3);
                                   const auto left = vectorAt(a, solidAt + 6), right = vectorAt(a, solidAt + 9);
                                   return test(p, left, q) || test(p, q, right);
                               }));
    return list;
}

}  // namespace mv::accuracy
