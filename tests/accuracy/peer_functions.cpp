// depth_range.h, shear.h, reflect.h, color_difference.h, motion/turn.h and motion/usual_eases.h.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "accuracy/function.h"
#include "mv/math/color.h"
#include "mv/math/color_difference.h"
#include "mv/math/depth_range.h"
#include "mv/math/reflect.h"
#include "mv/math/shear.h"
#include "mv/motion/turn.h"
#include "mv/motion/usual_eases.h"

namespace mv::accuracy {
namespace {

using test::wide;
using test::Wide3;
using test::Wide4;
using test::WideMatrix;

// One of three, by an argument from 0 to below 3, whatever a search makes of it.
std::size_t oneOfThree(double number) { return static_cast<std::size_t>(std::clamp(std::floor(number), 0.0, 2.0)); }

// ---- depth_range.h: the depth of the three ranges

DepthRange rangeAt(const Arguments& a, std::size_t i) { return static_cast<DepthRange>(oneOfThree(a[i])); }
struct Ends {
    Wide near, far;
};
Ends endsOf(DepthRange range) {
    if (range == DepthRange::zeroToOne) return {0, 1};
    if (range == DepthRange::oneToZero) return {1, 0};
    return {1, -1};
}

// fovy, aspect, near, far, range.
Arguments peerViews(Random& random, Domain domain) {
    Arguments a{};
    const bool isWhole = domain == Domain::whole;
    const double fovy = isWhole ? random.logarithmic(1e-9, 90) : random.number(10, 90);
    a[0] = random.sign() < 0 ? fovy : 180 - fovy;
    a[1] = isWhole ? random.logarithmic(1e-9, 1e9) : random.number(0.5, 2);
    a[2] = isWhole ? random.logarithmic(1e-280, 1e270) : random.logarithmic(0.01, 1);
    a[3] = isWhole ? a[2] * (1 + random.logarithmic(1e-12, 1e12)) : random.logarithmic(10, 1000);
    a[4] = random.number(0, 3);
    return a;
}
Truth perspectiveTruth(const Arguments& a) {
    const Wide half = test::wideRadians(a[0]) / 2, f = cos(half) / sin(half), n = a[2], far = a[3];
    const Ends end = endsOf(rangeAt(a, 4));
    WideMatrix m = wide(mat4(0));
    m.column[0][0] = f / a[1];
    m.column[1][1] = f;
    // z = p (-d) + q is end.near n at d = n, and end.far far at d = far
    m.column[2][2] = (end.near * n - end.far * far) / (far - n);
    m.column[3][2] = (end.near - end.far) * n * far / (far - n);
    m.column[2][3] = -1;
    return entrywise(valuesOf(m));
}
Arguments boxes(Random& random, Domain domain) {
    Arguments a{};
    const double scale = anyScale(random, domain, 140);
    for (std::size_t i = 0; i < 6; i += 2) {
        a[i] = scale * random.number(-1, 1);
        const double sign = random.sign();
        a[i + 1] = a[i] + scale * sign * (domain == Domain::whole ? random.logarithmic(1e-12, 10) : 2);
    }
    a[6] = random.number(0, 3);
    return a;
}
Truth orthoTruth(const Arguments& a) {
    const Ends end = endsOf(rangeAt(a, 6));
    WideMatrix m = wide(mat4(0));
    for (std::size_t i = 0; i < 2; ++i) {
        const Wide low = a[2 * i], high = a[2 * i + 1];
        m.column[i][i] = 2 / (high - low);
        m.column[3][i] = -(high + low) / (high - low);
    }
    const Wide n = a[4], f = a[5];
    m.column[2][2] = (end.near - end.far) / (f - n);
    m.column[3][2] = (end.near * f - end.far * n) / (f - n);
    m.column[3][3] = 1;
    return entrywise(valuesOf(m));
}
Arguments windows(Random& random, Domain domain) {
    Arguments a = boxes(random, domain);
    a[4] = domain == Domain::whole ? random.logarithmic(1e-150, 1e150) : random.logarithmic(0.01, 1);
    a[5] = a[6] = 0;
    return a;
}
Truth infiniteFrustumTruth(const Arguments& a) {
    WideMatrix m = wide(mat4(0));
    for (std::size_t i = 0; i < 2; ++i) {
        const Wide low = a[2 * i], high = a[2 * i + 1];
        m.column[i][i] = 2 * Wide(a[4]) / (high - low);
        m.column[2][i] = (high + low) / (high - low);
    }
    m.column[2][2] = m.column[2][3] = -1;
    m.column[3][2] = -2 * Wide(a[4]);
    return entrywise(valuesOf(m));
}

// ---- shear.h

Function shearFunction(const std::string& name, int axis, mat4 (*shear)(double, double)) {
    return withForms({.name = name,
                      .header = "shear.h",
                      .returns = "the shear by one coordinate",
                      .measured = "entrywise",
                      .domain = "1e-300 to 1e300",
                      .bound = 0,
                      .reason = "",
                      .sample =
                          [](Random& random, Domain domain) {
                              return Arguments{anyNumber(random, domain, 300), anyNumber(random, domain, 300)};
                          },
                      .truth =
                          [axis](const Arguments& a) {
                              mat4 m(1);
                              m[axis][axis == 0 ? 1 : 0] = a[0];
                              m[axis][axis == 2 ? 1 : 2] = a[1];
                              return entrywise(valuesOf(wide(m)));
                          }},
                     [shear](const Arguments& a) { return shear(a[0], a[1]); });
}

// ---- reflect.h: way, normal, index

Arguments meetings(Random& random, Domain domain) {
    Arguments a{};
    const vec3 normal = random.direction(), across = glm::normalize(glm::cross(normal, random.direction()));
    const double index = domain == Domain::whole ? random.logarithmic(1e-3, 1e3) : random.number(0.5, 2.5);
    // In the whole domain as near as 1e-12 to grazing, or to the angle of total reflection
    const double apart = domain == Domain::whole ? random.logarithmic(1e-12, 1) : random.number(0, 1);
    const double sine = random.sign() < 0 ? 1 - apart : std::min(1.0, index) * (1 - apart);
    put(a, 0, sine * across - std::sqrt(1 - sine * sine) * normal);
    put(a, 3, normal);
    a[6] = index;
    return a;
}
// The formulas hold for vectors of any length.
bool areMeetings(const Arguments& a) {
    return std::all_of(a.begin(), a.begin() + 6, [](double x) { return std::abs(x) <= 1; }) && a[6] >= 1e-3 &&
           a[6] <= 1e3;
}
const std::string meetingLimits = "coordinates up to 1 in size, indices 1e-3 to 1e3";

Wide termsOf(const Wide3& a, const Wide3& b) { return abs(a[0] * b[0]) + abs(a[1] * b[1]) + abs(a[2] * b[2]); }

Truth reflectedTruth(const Arguments& a) {
    const Wide3 way = wide(vectorAt(a, 0)), n = wide(vectorAt(a, 3));
    const Wide3 off = way - 2 * dot(way, n) * n;
    return {{off[0], off[1], off[2]}, {3}, {}, false, {sizeOf(length(way) + 2 * termsOf(way, n) * length(n))}};
}
// Whether there is light behind, and where it goes; 0 where there is none.
Truth refractedTruth(const Arguments& a) {
    const Wide3 way = wide(vectorAt(a, 0)), n = wide(vectorAt(a, 3));
    const Wide index = a[6], cosine = -dot(way, n), square = index * index - 1 + cosine * cosine;
    Truth truth = entrywise({square >= 0 ? Wide(1) : Wide(0), 0, 0, 0});
    truth.blocks = {1, 3};
    const Wide products = termsOf(way, n), terms = abs(index * index - 1) + products * products,
               root = sqrt(abs(square));
    // At the limiting angle, but for roundings, there may be light or not
    const bool isOpen = abs(square) < Wide(1e-14) * terms;
    truth.sizes = {isOpen ? anySize : Wide(1),
                   isOpen ? anySize : sizeOf((length(way) + (products + root + terms / root) * length(n)) / index)};
    if (square < 0) return truth;
    const Wide3 on = way / index + (cosine - root) / index * n;
    for (std::size_t i = 0; i < 3; ++i) truth.values[1 + i] = on[i];
    return truth;
}

// ---- color_difference.h

// As color_functions.cpp has them, from the same primaries and white.
std::array<Wide3, 3> partsOfWhite() {
    const auto xyz = [](const char* x, const char* y) {
        return Wide3{{Wide(x) / Wide(y), 1, (1 - Wide(x) - Wide(y)) / Wide(y)}};
    };
    const Wide3 r = xyz("0.64", "0.33"), g = xyz("0.30", "0.60"), b = xyz("0.15", "0.06"),
                white = xyz("0.3127", "0.3290");
    const Wide whole = dot(r, cross(g, b));
    const Wide3 amounts{
        {dot(white, cross(g, b)) / whole, dot(white, cross(b, r)) / whole, dot(white, cross(r, g)) / whole}};
    std::array<Wide3, 3> rows;
    for (std::size_t i = 0; i < 3; ++i) {
        rows[i] = {{amounts[0] * r[i] / white[i], amounts[1] * g[i] / white[i], amounts[2] * b[i] / white[i]}};
    }
    return rows;
}

Truth labTruth(const Arguments& a) {
    static const std::array<Wide3, 3> rows = partsOfWhite();
    const Wide3 light = wide(vectorAt(a, 0));
    const Wide kappa = Wide(24389) / 27;
    std::array<Wide, 3> root, size;
    for (std::size_t i = 0; i < 3; ++i) {
        const Wide part = dot(rows[i], light);
        Wide terms = 0;
        for (std::size_t k = 0; k < 3; ++k) terms += abs(rows[i][k] * light[k]);
        const bool isCurved = part > Wide(216) / 24389;
        root[i] = isCurved ? Wide(cbrt(part)) : Wide((kappa * part + 16) / 116);
        // The effect of a rounding of the terms
        size[i] = root[i] + (isCurved ? Wide(root[i] / part / 3) : Wide(kappa / 116)) * terms;
    }
    const Wide part = dot(rows[1], light);
    Truth truth = entrywise({part > Wide(216) / 24389 ? Wide(116 * root[1] - 16) : Wide(kappa * part),
                             500 * (root[0] - root[1]), 200 * (root[1] - root[2])});
    truth.sizes = {116 * size[1], 500 * (size[0] + size[1]), 200 * (size[1] + size[2])};
    return truth;
}

// The formula as the paper has it.
struct WideHue {
    Wide chroma, hue;  // degrees, 0 up to 360
};
WideHue hueOf(const Wide& a, const Wide& b) {
    if (a == 0 && b == 0) return {0, 0};
    Wide hue = atan2(b, a) * 180 / test::widePi();
    if (hue < 0) hue += 360;
    return {sqrt(a * a + b * b), hue};
}
Truth differenceTruth(const Arguments& arguments) {
    const Wide3 one = wide(vectorAt(arguments, 0)), two = wide(vectorAt(arguments, 3));
    const auto seventh = [](const Wide& c) {
        const Wide x = pow(c / 25, 7);
        return Wide(sqrt(x / (x + 1)));
    };
    const auto cosine = [](const Wide& degrees) { return Wide(cos(test::wideRadians(degrees))); };
    const Wide mean = (hueOf(one[1], one[2]).chroma + hueOf(two[1], two[2]).chroma) / 2;
    const Wide stretch = 1 + (1 - seventh(mean)) / 2;
    const WideHue p = hueOf(stretch * one[1], one[2]), q = hueOf(stretch * two[1], two[2]);
    Wide turn = q.hue - p.hue;
    if (turn > 180) turn -= 360;
    if (turn < -180) turn += 360;
    const bool hasGrey = p.chroma == 0 || q.chroma == 0;
    if (hasGrey) turn = 0;
    Wide hue = p.hue + q.hue;
    if (!hasGrey) {
        if (abs(p.hue - q.hue) <= 180) {
            hue /= 2;
        } else {
            hue = hue < 360 ? (hue + 360) / 2 : (hue - 360) / 2;
        }
    }
    const Wide chroma = (p.chroma + q.chroma) / 2, middle = (one[0] + two[0]) / 2 - 50, squared = middle * middle;
    const Wide t = 1 - Wide("0.17") * cosine(hue - 30) + Wide("0.24") * cosine(2 * hue) +
                   Wide("0.32") * cosine(3 * hue + 6) - Wide("0.20") * cosine(4 * hue - 63);
    const Wide l = (two[0] - one[0]) / (1 + Wide("0.015") * squared / sqrt(20 + squared));
    const Wide byC = 1 + Wide("0.045") * chroma, byH = 1 + Wide("0.015") * chroma * t;
    const Wide c = (q.chroma - p.chroma) / byC;
    const Wide h = 2 * sqrt(p.chroma * q.chroma) * sin(test::wideRadians(turn / 2)) / byH;
    const Wide blue = 30 * exp(-pow((hue - 275) / 25, 2));
    const Wide rotation = -2 * seventh(chroma) * sin(test::wideRadians(2 * blue));
    const Wide sum = l * l + c * c + h * h + rotation * c * h;
    Truth truth = entrywise({sum <= 0 ? Wide(0) : Wide(sqrt(sum))});
    // The terms of C2 - C1, of which the difference may be small; and of the whole, where rotation takes from squares
    const Wide chromas = p.chroma + q.chroma;
    const Wide ofC = chromas == 0 ? Wide(0)
                                  : Wide((abs((q.chroma * cosine(q.hue) - p.chroma * cosine(p.hue)) *
                                              (q.chroma * cosine(q.hue) + p.chroma * cosine(p.hue))) +
                                          abs((two[2] - one[2]) * (two[2] + one[2]))) /
                                         chromas / byC);
    truth.sizes = {sqrt(l * l + ofC * ofC + h * h) + leastSize};
    // Half a turn apart, but for a rounding: either mean. A mean of 0 is one of 360, too, where the weight of blue jumps
    const Wide apart = abs(p.hue - q.hue);
    const bool isAtZero = apart > 180 && abs(p.hue + q.hue - 360) < Wide(1e-9);
    if (!hasGrey && (abs(apart - 180) < Wide(1e-9) || isAtZero)) truth.sizes = {anySize};
    return truth;
}
Arguments twoColors(Random& random, Domain domain) {
    Arguments a{};
    const vec3 one = vec3(50, 0, 0) + vec3(50, 80, 80) * random.point(1);
    const double apart = domain == Domain::whole ? random.logarithmic(1e-9, 1) : 1.0;
    const double grey = domain == Domain::whole && random.sign() < 0 ? random.logarithmic(1e-6, 1) : 1.0;
    const vec3 two =
        apart == 1.0 ? vec3(50, 0, 0) + vec3(50, 80, 80) * random.point(1) : one + 50 * apart * random.point(1);
    put(a, 0, vec3(1, grey, grey) * one);
    put(a, 3, vec3(1, grey, grey) * two);
    return a;
}

// ---- motion/turn.h

quat quatAt(const Arguments& a) { return {a[0], a[1], a[2], a[3]}; }
Wide4 unitAt(const Arguments& a) { return normalized(wide(pointAt(a, 0))); }
bool isQuaternion(const Arguments& a) { return pointAt(a, 0) != vec4(0); }
vec4 vectorOf(const quat& q) { return {q.w, q.x, q.y, q.z}; }

Arguments quaternions(Random& random, Domain domain) {
    Arguments a{};
    const vec3 axis = random.direction();
    const double sine = domain == Domain::whole ? random.logarithmic(1e-100, 1) : random.number(0, 1);
    const vec4 q(random.sign() * std::sqrt(1 - sine * sine), sine * axis);
    put(a, 0, anyScale(random, domain, 140) * q);
    const double scale = anyScale(random, domain, 100);
    put(a, 4, scale * random.point(1));
    return a;
}
Arguments directions(Random& random, Domain domain) {
    Arguments a{};
    const vec3 from = random.direction();
    const double apart = domain == Domain::whole ? random.logarithmic(1e-100, 1) : 1.0;
    const bool isNear = domain == Domain::whole && random.sign() < 0;
    const vec3 aside = apart * random.point(1);
    put(a, 0, anyScale(random, domain, 100) * from);
    put(a, 3, anyScale(random, domain, 100) * ((isNear ? 1.0 : -1.0) * from + aside));
    return a;
}
bool areDirections(const Arguments& a) {
    for (const std::size_t i : {0U, 3U}) {
        const vec3 v = vectorAt(a, i);
        const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
        if (!(largest >= 1e-100 && largest <= 1e100)) return false;
        for (int k = 0; k < 3; ++k) {
            if (v[k] != 0 && std::abs(v[k]) < 1e-40 * largest) return false;
        }
    }
    return true;
}
// Ours is one of many where the two are exactly opposite.
Truth turnBetweenTruth(const Arguments& a) {
    const Wide3 from = normalized(wide(vectorAt(a, 0))), to = normalized(wide(vectorAt(a, 3)));
    const Wide3 axis = cross(from, to);
    const Wide sine = length(axis), half = atan2(sine, dot(from, to)) / 2;
    const Wide3 v = sine == 0 ? axis : sin(half) / sine * axis;
    Truth truth = oneBlock({cos(half), v[0], v[1], v[2]});
    truth.sizes = {Wide(1)};
    // The unit vectors' roundings turn the axis, near opposite directions by any angle
    if (dot(from, to) < 0) truth.sizes = {sine < Wide(1e-12) ? anySize : 1 + 2 / sine};
    return truth;
}

WideMatrix about(std::size_t axis, const Wide& radians) {
    WideMatrix m = wide(mat4(1));
    const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
    m.column[j][j] = m.column[k][k] = cos(radians);
    m.column[j][k] = sin(radians);
    m.column[k][j] = -sin(radians);
    return m;
}
WideMatrix times(const WideMatrix& a, const WideMatrix& b) {
    return {{a * b.column[0], a * b.column[1], a * b.column[2], a * b.column[3]}};
}
// Of three angles in degrees about x, y and z.
WideMatrix ofAngles(const std::array<Wide, 3>& radians, EulerOrder order) {
    const WideMatrix x = about(0, radians[0]), y = about(1, radians[1]), z = about(2, radians[2]);
    if (order == EulerOrder::xyz) return times(times(x, y), z);
    if (order == EulerOrder::zyx) return times(times(z, y), x);
    return times(times(y, x), z);
}
EulerOrder orderAt(const Arguments& a, std::size_t i) { return static_cast<EulerOrder>(oneOfThree(a[i])); }
// The sine of the middle angle is not 1.
bool isUnlocked(const Arguments& a) {
    if (!isQuaternion(a)) return false;
    const Wide4 q = unitAt(a);
    const EulerOrder order = orderAt(a, 4);
    const Wide sine = order == EulerOrder::yxz   ? q[0] * q[1] - q[2] * q[3]
                      : order == EulerOrder::xyz ? q[0] * q[2] + q[1] * q[3]
                                                 : q[0] * q[2] - q[1] * q[3];
    return 1 - abs(2 * sine) > Wide(1e-24);
}
Truth ofUnit(const WideMatrix& m) {
    Truth truth = oneBlock(valuesOf(m));
    truth.sizes = {Wide(1)};
    return truth;
}

// ---- motion/usual_eases.h

EaseSide sideAt(const Arguments& a) { return static_cast<EaseSide>(oneOfThree(a[1])); }
using Curve = Wide (*)(const Wide&);
Wide sided(Curve in, const Wide& t, EaseSide side) {
    if (side == EaseSide::in) return in(t);
    if (side == EaseSide::out) return 1 - in(1 - t);
    return t < Wide(0.5) ? in(2 * t) / 2 : 1 - in(2 - 2 * t) / 2;
}
Wide slopeSided(Curve slope, const Wide& t, EaseSide side) {
    if (side == EaseSide::in) return slope(t);
    if (side == EaseSide::out) return slope(1 - t);
    return slope(t < Wide(0.5) ? 2 * t : 2 - 2 * t);
}
const Wide& overshoot() {
    static const Wide s("1.70158");
    return s;
}
Wide bounceOut(const Wide& t) {
    const Wide time = t * 11 / 4;
    if (time < 1) return time * time;
    if (time < 2) return (time - Wide(1.5)) * (time - Wide(1.5)) + Wide(0.75);
    if (time < Wide(2.5)) return (time - Wide(2.25)) * (time - Wide(2.25)) + Wide(0.9375);
    return (time - Wide(2.625)) * (time - Wide(2.625)) + Wide(0.984375);
}
Wide elasticAngle(const Wide& t) { return (10 * t - Wide(10.75)) * 2 * test::widePi() / 3; }

Function easeFunction(const std::string& name, const std::string& returns, double (*ease)(double, EaseSide), Curve in,
                      bool isSlope, const Wide& largest, double bound = 4, const std::string& reason = "") {
    return withForms(
        {.name = name,
         .header = "motion/usual_eases.h",
         .returns = returns,
         .measured = isSlope ? "ulp of the steepest slope" : "ulp of 1",
         .domain = "t from 1e-9 from 0 and 1, at any side",
         .bound = bound,
         .reason = reason,
         .sample =
             [](Random& random, Domain domain) {
                 const double t = domain == Domain::whole ? random.logarithmic(1e-9, 1) : random.number(0, 1);
                 return Arguments{random.sign() < 0 ? t : 1 - t, random.number(0, 3)};
             },
         .truth =
             [=](const Arguments& a) {
                 const Wide t = a[0];
                 const bool isEnd = a[0] == 0 || a[0] == 1;  // where the elastic curve jumps
                 Truth truth = entrywise({isSlope ? slopeSided(in, t, sideAt(a))
                                          : isEnd ? t
                                                  : sided(in, t, sideAt(a))});
                 truth.sizes = {largest};
                 return truth;
             },
         .limits = "t 0, or from 1e-150 to 1",
         .within =
             [](const Arguments& a) { return (a[0] == 0 || a[0] >= 1e-150) && a[0] <= 1 && a[1] >= 0 && a[1] < 3; }},
        [ease](const Arguments& a) { return ease(a[0], sideAt(a)); });
}

}  // namespace

std::vector<Function> viewFormFunctions() {
    std::vector<Function> list;
    list.push_back(withForms({.name = "perspective (depth ranges)",
                              .header = "depth_range.h",
                              .returns = "the same view with depth 0 to 1, 1 to 0 or 1 to -1",
                              .measured = "entrywise",
                              .domain = "near 1e-280 to 1e270, far/near − 1 from 1e-12 to 1e12",
                              .reason = "",
                              .sample = peerViews,
                              .truth = perspectiveTruth,
                              .limits = "fovy at least 1e-290; far up to 1e290, near at least 1e-290 and 1e-100 of it",
                              .within =
                                  [](const Arguments& a) {
                                      return a[0] >= 1e-290 && a[3] <= 1e290 && a[2] >= 1e-290 && a[2] >= 1e-100 * a[3];
                                  }},
                             [](const Arguments& a) { return perspective(a[0], a[1], a[2], a[3], rangeAt(a, 4)); }));
    list.push_back(
        withForms({.name = "ortho (depth ranges)",
                   .header = "depth_range.h",
                   .returns = "the same box with depth 0 to 1, 1 to 0 or 1 to -1",
                   .measured = "entrywise",
                   .domain = "bounds 1e-150 to 1e150, 1e-12 to 10 of their size apart",
                   .reason = "",
                   .sample = boxes,
                   .truth = orthoTruth},
                  [](const Arguments& a) { return ortho(a[0], a[1], a[2], a[3], a[4], a[5], rangeAt(a, 6)); }));
    list.push_back(withForms({.name = "infiniteFrustum",
                              .header = "depth_range.h",
                              .returns = "an off-centre view without a far plane",
                              .measured = "entrywise",
                              .domain = "bounds 1e-150 to 1e150, 1e-12 to 10 of their size apart",
                              .reason = "",
                              .sample = windows,
                              .truth = infiniteFrustumTruth,
                              .limits = quotientLimits,
                              .within = quotientSizes()},
                             [](const Arguments& a) { return infiniteFrustum(a[0], a[1], a[2], a[3], a[4]); }));
    list.push_back(shearFunction("shearX", 0, shearX));
    list.push_back(shearFunction("shearY", 1, shearY));
    list.push_back(shearFunction("shearZ", 2, shearZ));
    list.push_back(withForms(
        {.name = "reflected",
         .header = "reflect.h",
         .returns = "the direction after a mirror",
         .measured = "ulp of 1",
         .domain = "unit vectors, as near as 1e-12 to grazing",
         .bound = 5,
         .reason = "roundings: three of the dot product, whose terms are up to 1, doubled; a product and a difference",
         .sample = meetings,
         .truth = reflectedTruth,
         .limits = meetingLimits,
         .within = areMeetings},
        [](const Arguments& a) { return reflected(vectorAt(a, 0), vectorAt(a, 3)); },
        []<typename T>(const ArgumentsOf<T>& a) { return glm::reflect(vectorAt(a, 0), vectorAt(a, 3)); }));
    list.push_back(
        withForms({.name = "refracted",
                   .header = "reflect.h",
                   .returns = "the direction behind a surface, and whether there is one",
                   .measured = "ulp of the terms, of the root's too, without their signs",
                   .domain = "unit vectors, as near as 1e-12 to grazing and to total reflection; indices 1e-3 to 1e3",
                   .reason = "",
                   .sample = meetings,
                   .truth = refractedTruth,
                   .limits = meetingLimits,
                   .within = areMeetings},
                  [](const Arguments& a) {
                      const auto on = refracted(vectorAt(a, 0), vectorAt(a, 3), a[6]);
                      return on ? std::array<double, 4>{1, on->x, on->y, on->z} : std::array<double, 4>{0, 0, 0, 0};
                  }));
    return list;
}

std::vector<Function> colorDifferenceFunctions() {
    std::vector<Function> list;
    list.push_back(
        withForms({.name = "labFromLinear",
                   .header = "color_difference.h",
                   .returns = "CIELAB of light",
                   .measured = "ulp of the terms, without their signs, of the roots' too",
                   .domain = "components 1e-12 to 1",
                   .bound = 8,
                   .reason = "glibc's cube root is off by up to 3.67 ulp, and its argument by 4 roundings of terms",
                   .sample =
                       [](Random& random, Domain domain) {
                           Arguments a{};
                           for (std::size_t i = 0; i < 3; ++i) {
                               a[i] = domain == Domain::whole ? random.logarithmic(1e-12, 1) : random.number(0, 1);
                           }
                           return a;
                       },
                   .truth = labTruth,
                   .limits = "components 0, or from 1e-150 to 1",
                   .within =
                       [](const Arguments& a) {
                           return std::all_of(a.begin(), a.begin() + 3,
                                              [](double part) { return part == 0 || (part >= 1e-150 && part <= 1); });
                       }},
                  [](const Arguments& a) { return labFromLinear(vectorAt(a, 0)); }));
    list.push_back(withForms(
        {.name = "colorDifference",
         .header = "color_difference.h",
         .returns = "CIEDE2000 of two colours",
         .measured = "ulp of lightness', chroma's and hue's terms together, without their signs",
         .domain = "L* 0 to 100, a* and b* down to 1e-6 of 80, colours as near as 1e-8",
         .bound = 132,
         .reason =
             "in 2^-53: the mean hue has 19 roundings of a radian, two of each atan2, six of its degrees, nine of "
             "what adds up to 720; near 292 degrees the term T is off by 44 from them and is 0.37, which divides the "
             "hue's term; 132 with the rotation",
         .sample = twoColors,
         .truth = differenceTruth,
         .limits = "coordinates 0, or from 1e-9 to 1e3 in size",
         .within = sizesBetween(1e-9, 1e3)},
        [](const Arguments& a) { return colorDifference(vectorAt(a, 0), vectorAt(a, 3)); }));
    list.push_back(withForms(
        {.name = "contrast",
         .header = "color_difference.h",
         .returns = "the contrast of letters on a ground",
         .measured = "entrywise",
         .domain = "components 1e-12 to 1",
         .bound = 12,
         .reason = "in 2^-53: 4.8 of each weight of the luminance, 3 of its sum, in both colours; and of the quotient",
         .sample =
             [](Random& random, Domain domain) {
                 Arguments a{};
                 for (std::size_t i = 0; i < 6; ++i) {
                     a[i] = domain == Domain::whole ? random.logarithmic(1e-12, 1) : random.number(0, 1);
                 }
                 return a;
             },
         .truth =
             [](const Arguments& a) {
                 static const std::array<Wide3, 3> rows = partsOfWhite();
                 const Wide one = dot(rows[1], wide(vectorAt(a, 0))) + Wide("0.05");
                 const Wide two = dot(rows[1], wide(vectorAt(a, 3))) + Wide("0.05");
                 return entrywise({std::max<Wide>(one, two) / std::min<Wide>(one, two)});
             },
         .limits = "components 0, or from 1e-150 to 1",
         .within =
             [](const Arguments& a) {
                 return std::all_of(a.begin(), a.begin() + 6,
                                    [](double part) { return part == 0 || (part >= 1e-150 && part <= 1); });
             }},
        [](const Arguments& a) { return contrast(vectorAt(a, 0), vectorAt(a, 3)); }));
    return list;
}

std::vector<Function> turnFunctions() {
    std::vector<Function> list;
    const std::string turnsDomain = "turns from 1e-100 rad, quaternions 1e-140 to 1e140 long";
    list.push_back(withForms({.name = "inverse",
                              .header = "motion/turn.h",
                              .returns = "the turn back",
                              .measured = "ulp of the largest component",
                              .domain = turnsDomain,
                              .reason = "",
                              .sample = quaternions,
                              .truth =
                                  [](const Arguments& a) {
                                      const Wide4 q = unitAt(a);
                                      return oneBlock({q[0], -q[1], -q[2], -q[3]});
                                  },
                              .limits = "any but 0",
                              .within = isQuaternion},
                             [](const Arguments& a) { return vectorOf(inverse(quatAt(a))); }));
    list.push_back(withForms(
        {.name = "axisAngleOf",
         .header = "motion/turn.h",
         .returns = "the angle and the axis of a turn",
         .measured = "the angle entrywise, ulp of the axis' largest component",
         .domain = turnsDomain,
         .bound = 8,
         .reason = "roundings: three of the length, two of a quotient each, of the arc tangent and of the degrees",
         .sample = quaternions,
         .truth =
             [](const Arguments& a) {
                 const Wide4 q = unitAt(a);
                 const Wide3 v{{q[1], q[2], q[3]}};
                 const Wide sine = length(v);
                 if (sine == 0) return Truth{{0, 1, 0, 0}, {1, 3}};
                 const Wide3 axis = (q[0] < 0 ? Wide(-1) : Wide(1)) / sine * v;
                 return Truth{{2 * atan2(sine, abs(q[0])) * 180 / test::widePi(), axis[0], axis[1], axis[2]}, {1, 3}};
             },
         .limits = "components 0, or from 1e-150 to 1e150, and of 1e-140 of the largest",
         .within =
             [](const Arguments& a) {
                 const double largest = std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2]), std::abs(a[3])});
                 return largest > 0 && std::all_of(a.begin(), a.begin() + 4, [=](double x) {
                            const double size = std::abs(x);
                            return size == 0 || (size >= 1e-150 && size <= 1e150 && size >= 1e-140 * largest);
                        });
             }},
        [](const Arguments& a) {
            const AxisAngle turn = axisAngleOf(quatAt(a));
            return vec4(turn.degrees, turn.axis);
        }));
    list.push_back(withForms(
        {.name = "turned",
         .header = "motion/turn.h",
         .returns = "a vector turned by a quaternion",
         .measured = "ulp of the vector's length",
         .domain = turnsDomain + ", vectors 1e-100 to 1e100 long",
         .bound = 32,
         .reason = "in 2^-53 of the length, by the sine s and the cosine c of half the turn: four of the unit "
                   "quaternion and two of a cross product, twice: 12 s of the first product; with w 22 s c, "
                   "of the second 25 s^2, together 29 at most; and the two sums 3",
         .sample = quaternions,
         .truth =
             [](const Arguments& a) {
                 const Wide4 q = unitAt(a);
                 const Wide3 u{{q[1], q[2], q[3]}}, v = wide(vectorAt(a, 4));
                 const Wide3 t = Wide(2) * cross(u, v), result = v + q[0] * t + cross(u, t);
                 return Truth{{result[0], result[1], result[2]}, {3}, {}, false, {sizeOf(length(v))}};
             },
         .limits = "any quaternion but 0; coordinates 0, or from 1e-150 to 1e150 in size",
         .within =
             [](const Arguments& a) {
                 static const auto areCoordinates = sizesBetween(1e-150, 1e150);
                 return isQuaternion(a) && areCoordinates(a);
             }},
        [](const Arguments& a) { return turned(quatAt(a), vectorAt(a, 4)); }));
    list.push_back(withForms(
        {.name = "turnBetween",
         .header = "motion/turn.h",
         .returns = "the smallest turn from one direction to another",
         .measured = "ulp of 1, and near opposite directions of what roundings of the unit vectors turn the axis by",
         .domain = "directions 1e-100 to 1e100 long, as near to the same and to opposite as 1e-100",
         .bound = 10,
         .reason = "roundings: three of each unit vector, of their cross product and sum, of the sum's length, and a "
                   "quotient",
         .sample = directions,
         .truth = turnBetweenTruth,
         .limits = "largest components 1e-100 to 1e100, the others 0 or from 1e-40 of them",
         .within = areDirections},
        [](const Arguments& a) { return vectorOf(turnBetween(vectorAt(a, 0), vectorAt(a, 3))); }));
    const std::string ordersReason =
        "roundings: three of the sine or cosine of each of three angles, two of their product, a sum; and six of a "
        "matrix' entry, of which the components are squares";
    list.push_back(withForms(
        {.name = "quatFromEuler",
         .header = "motion/turn.h",
         .returns = "the orientation of three angles in one of three orders (measured: its matrix)",
         .measured = "ulp of 1",
         .domain = "angles 1e-300 to 1e300 degrees",
         .bound = 8,
         .reason = ordersReason,
         .sample =
             [](Random& random, Domain domain) {
                 Arguments a{};
                 for (std::size_t i = 0; i < 3; ++i) {
                     a[i] = domain == Domain::ordinary ? random.number(-360, 360) : anyNumber(random, domain, 300);
                 }
                 a[3] = random.number(0, 3);
                 return a;
             },
         .truth =
             [](const Arguments& a) {
                 return ofUnit(
                     ofAngles({reducedRadians(a[0]), reducedRadians(a[1]), reducedRadians(a[2])}, orderAt(a, 3)));
             },
         .limits = "angles 0, or at least 1e-300",
         .within = sizesBetween(1e-300, std::numeric_limits<double>::max())},
        [](const Arguments& a) { return rotationMatrix(quatFromEuler(vectorAt(a, 0), orderAt(a, 3))); }));
    Function anglesOf{
        .name = "eulerAnglesOf",
        .header = "motion/turn.h",
        .returns = "the three angles of an orientation in one of three orders",
        .measured = "how far the matrix of the angles is off, ulp of 1",
        .domain = turnsDomain,
        .bound = 24,
        .reason = "as yawPitchRollOf, whose bound is 12 of the quaternion's, each of which a matrix has twice",
        .sample =
            [](Random& random, Domain domain) {
                Arguments a = quaternions(random, domain);
                a[4] = random.number(0, 3);
                a[5] = a[6] = 0;
                return a;
            },
        .truth =
            [](const Arguments& a) {
                const Wide4 q = unitAt(a);
                const Wide &w = q[0], &x = q[1], &y = q[2], &z = q[3];
                WideMatrix m = wide(mat4(1));
                m.column[0] = {{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), Wide(0)}};
                m.column[1] = {{2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x), Wide(0)}};
                m.column[2] = {{2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y), Wide(0)}};
                return ofUnit(m);
            },
        .limits = "any but 0, and those within 1e-12 rad of gimbal lock",
        .within = isUnlocked};
    anglesOf.forms.push_back(
        {"mv", false,
         [](const Arguments& a) {
             const EulerOrder order = orderAt(a, 4);
             const vec3 degrees = eulerAnglesOf(quatAt(a), order).degrees;
             return valuesOf(ofAngles(
                 {test::wideRadians(degrees.x), test::wideRadians(degrees.y), test::wideRadians(degrees.z)}, order));
         },
         makeForm<double>("mv", [](const Arguments& a) {
             return eulerAnglesOf(quatAt(a), orderAt(a, 4)).degrees;
         }).run});
    list.push_back(std::move(anglesOf));
    return list;
}

std::vector<Function> usualEaseFunctions() {
    std::vector<Function> list;
    const std::string elasticReason =
        "the angle, up to 22 rad, has three roundings, each 16 ulp of 1, and the swing is a tenth there; of a slope "
        "also five "
        "of two terms";
    list.push_back(easeFunction(
        "cubicEase", "t³, in, out or both", cubicEase, [](const Wide& t) { return t * t * t; }, false, 1));
    list.push_back(easeFunction(
        "cubicEaseSlope", "its slope", cubicEaseSlope, [](const Wide& t) { return 3 * t * t; }, true, 3));
    list.push_back(easeFunction(
        "sineEase", "1 − cos(90° t)", sineEase, [](const Wide& t) { return 1 - cos(test::widePi() / 2 * t); }, false,
        1));
    list.push_back(easeFunction(
        "sineEaseSlope", "its slope", sineEaseSlope,
        [](const Wide& t) { return test::widePi() / 2 * sin(test::widePi() / 2 * t); }, true, Wide(1.5)));
    list.push_back(easeFunction(
        "backEase", "a way that goes back first", backEase,
        [](const Wide& t) { return t * t * ((overshoot() + 1) * t - overshoot()); }, false, 1));
    list.push_back(easeFunction(
        "backEaseSlope", "its slope", backEaseSlope,
        [](const Wide& t) { return t * (3 * (overshoot() + 1) * t - 2 * overshoot()); }, true, 4));
    list.push_back(easeFunction(
        "elasticEase", "a way that swings first", elasticEase,
        [](const Wide& t) { return -pow(Wide(2), 10 * t - 10) * sin(elasticAngle(t)); }, false, 1, 8, elasticReason));
    list.push_back(easeFunction(
        "elasticEaseSlope", "its slope", elasticEaseSlope,
        [](const Wide& t) {
            return -10 * pow(Wide(2), 10 * t - 10) *
                   (log(Wide(2)) * sin(elasticAngle(t)) + 2 * test::widePi() / 3 * cos(elasticAngle(t)));
        },
        true, 16, 12, elasticReason));
    list.push_back(easeFunction(
        "bounceEase", "a ball that bounces", bounceEase, [](const Wide& t) { return 1 - bounceOut(1 - t); }, false, 1));
    return list;
}

}  // namespace mv::accuracy
