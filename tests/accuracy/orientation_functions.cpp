// motion/orientation.h, motion/decomposition.h and motion/path_frame.h.
#include <glm/gtc/quaternion.hpp>

#include "accuracy/function.h"
#include "mv/math/transform.h"
#include "mv/motion/decomposition.h"
#include "mv/motion/orientation.h"
#include "mv/motion/path_frame.h"

namespace mv::accuracy {
namespace {

using test::wide;
using test::Wide3;
using test::Wide4;
using test::WideMatrix;

// Quaternions as vectors (w, x, y, z).
vec4 vectorOf(const quat& q) { return {q.w, q.x, q.y, q.z}; }
quat quatAt(const Arguments& a, std::size_t i) { return {a[i], a[i + 1], a[i + 2], a[i + 3]}; }
Wide4 unitAt(const Arguments& a, std::size_t i) { return normalized(wide(pointAt(a, i))); }
template <typename T>
glm::qua<T> glmAt(const ArgumentsOf<T>& a, std::size_t i) {
    return glm::normalize(glm::qua<T>(a[i], a[i + 1], a[i + 2], a[i + 3]));
}
template <typename T>
glm::vec<4, T> glmVector(const glm::qua<T>& q) {
    return {q.w, q.x, q.y, q.z};
}

Truth quaternionTruth(const Wide4& q) { return oneBlock({q[0], q[1], q[2], q[3]}); }

Wide4 hamilton(const Wide4& a, const Wide4& b) {
    const Wide3 u{{a[1], a[2], a[3]}}, v{{b[1], b[2], b[3]}};
    const Wide3 part = a[0] * v + b[0] * u + cross(u, v);
    return {{a[0] * b[0] - dot(u, v), part[0], part[1], part[2]}};
}
Wide4 turnAbout(std::size_t axis, const Wide& radians) {
    Wide4 q{{cos(radians / 2), Wide(0), Wide(0), Wide(0)}};
    q[axis + 1] = sin(radians / 2);
    return q;
}
Wide4 fromAngles(const Wide& yaw, const Wide& pitch, const Wide& roll) {
    return hamilton(hamilton(turnAbout(1, yaw), turnAbout(0, pitch)), turnAbout(2, roll));
}

WideMatrix matrixOf(const Wide4& q) {
    const Wide &w = q[0], &x = q[1], &y = q[2], &z = q[3];
    const Wide zero = 0, one = 1;
    return {{{{{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), zero}},
              {{2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x), zero}},
              {{2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y), zero}},
              {{zero, zero, zero, one}}}}};
}

// Of any length, with components of any sizes.
vec4 anyQuaternion(Random& random, Domain domain) {
    const vec3 axis = random.direction();
    const double w = random.number(-1, 1), rest = std::sqrt(1 - w * w);
    if (domain == Domain::ordinary) return {w, rest * axis};
    const vec4 factors{random.logarithmic(1e-9, 1), random.logarithmic(1e-9, 1), random.logarithmic(1e-9, 1),
                       random.logarithmic(1e-9, 1)};
    const double scale = anyScale(random, domain, 290);
    return scale * (random.sign() < 0 ? factors : vec4(1)) * vec4(w, rest * axis);
}
double largestPart(const vec4& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2]), std::abs(v[3])}); }
bool isQuaternion(const Arguments& a, std::size_t i) { return pointAt(a, i) != vec4(0); }

Arguments quaternions(Random& random, Domain domain) {
    Arguments a{};
    put(a, 0, anyQuaternion(random, domain));
    return a;
}
// Two, and a part of the way: the whole domain has them as close as 1e-16.
Arguments pairs(Random& random, Domain domain) {
    Arguments a{};
    put(a, 0, anyQuaternion(random, domain));
    if (domain == Domain::whole && random.sign() < 0) {
        const vec4 first = pointAt(a, 0) / largestPart(pointAt(a, 0));
        const vec4 aside{random.number(-1, 1), random.point(1)};
        const double scale = anyScale(random, domain, 290), sign = random.sign();
        put(a, 4, scale * sign * (first + random.logarithmic(1e-16, 1) * aside));
    } else {
        put(a, 4, anyQuaternion(random, domain));
    }
    a[8] = random.number(0, 1);
    return a;
}

// The ends of the shorter way; nothing of it is exact where it is half a turn, between two ways.
struct WideEnds {
    Wide4 from, to;
};
WideEnds endsAt(const Arguments& a) {
    const Wide4 from = unitAt(a, 0), to = unitAt(a, 4);
    return {from, dot(from, to) < 0 ? Wide(-1) * to : to};
}
bool areEnds(const Arguments& a) {
    if (!isQuaternion(a, 0) || !isQuaternion(a, 4) || !(a[8] >= 0 && a[8] <= 1)) return false;
    return abs(dot(unitAt(a, 0), unitAt(a, 4))) > Wide(1e-14);
}
const std::string endsLimits = "any quaternions but 0, ends not within 2e-14 rad of half a turn, t from 0 to 1";

Truth slerpTruth(const Arguments& a) {
    const WideEnds ends = endsAt(a);
    const Wide4 sum = ends.from + ends.to, difference = ends.to - ends.from;
    const Wide along = length(sum), across = length(difference), angle = (2 * Wide(a[8]) - 1) * atan2(across, along);
    if (across == 0) return quaternionTruth(ends.from);
    return quaternionTruth(cos(angle) / along * sum + sin(angle) / across * difference);
}

Arguments angles(Random& random, Domain domain) {
    Arguments a{};
    for (std::size_t i = 0; i < 3; ++i) {
        a[i] = domain == Domain::ordinary ? random.number(-360, 360) : anyNumber(random, domain, 300);
    }
    return a;
}

// The orientation of the three angles that are returned, of its two quaternions that nearer to the true one.
Function anglesOf() {
    Function function =
        withForms({.name = "yawPitchRollOf",
                   .header = "motion/orientation.h",
                   .returns = "yaw, pitch and roll of an orientation",
                   .measured = "how far the orientation of the angles is off, ulp of the largest component",
                   .domain = "quaternions 1e-290 to 1e290 long, components as small as 1e-9 of that",
                   .bound = 12,
                   .reason = "roundings: six of each of two half angles, of which each angle is a sum; three angles; "
                             "and one of 180 degrees, "
                             "1.4e-14, is 1.1 ulp of half the turn",
                   .sample = quaternions,
                   .truth = [](const Arguments& a) { return quaternionTruth(unitAt(a, 0)); },
                   .limits = "any but 0, and those within 1e-12 rad of gimbal lock",
                   .within =
                       [](const Arguments& a) {
                           if (!isQuaternion(a, 0)) return false;
                           const Wide4 q = unitAt(a, 0);
                           return 1 - abs(2 * (q[0] * q[1] - q[2] * q[3])) > Wide(1e-24);
                       }},
                  [](const Arguments& a) {
                      const YawPitchRoll is = yawPitchRollOf(quatAt(a, 0));
                      return vec3(is.yaw, is.pitch, is.roll);
                  });
    function.forms[0].values = [](const Arguments& a) {
        const YawPitchRoll is = yawPitchRollOf(quatAt(a, 0));
        const Wide4 truth = unitAt(a, 0);
        Wide4 q = fromAngles(test::wideRadians(is.yaw), test::wideRadians(is.pitch), test::wideRadians(is.roll));
        if (dot(q, truth) < 0) q = Wide(-1) * q;
        return std::vector<Wide>{q[0], q[1], q[2], q[3]};
    };
    return function;
}

// Offset, quaternion and scales of a matrix.
Arguments placements(Random& random, Domain domain) {
    Arguments a{};
    for (std::size_t i = 0; i < 3; ++i) a[i] = anyNumber(random, domain, 100);
    put(a, 3, anyQuaternion(random, domain));
    for (std::size_t i = 7; i < 10; ++i) a[i] = anyNumber(random, domain, 100);
    return a;
}
mat4 matrixOfParts(const Arguments& a) {
    return translate(vectorAt(a, 0)) * rotationMatrix(quatAt(a, 3)) * mv::scale(vectorAt(a, 7));
}

// The matrix again, made with 50 digits of the parts that are returned.
Function partsOf() {
    Function function = withForms(
        {.name = "decompose",
         .header = "motion/decomposition.h",
         .returns = "translation, rotation and scale of a matrix",
         .measured = "how far the matrix of the parts is off, ulp of each column's largest entry",
         .domain = "scales and offsets 1e-100 to 1e100, of any signs",
         .bound = 16,
         .reason = "roundings: nine of each entry of the given matrix, by which its columns are not perpendicular, and "
                   "five of each of a quaternion's components, of which an entry has products of two",
         .sample = placements,
         .truth =
             [](const Arguments& a) {
                 return Truth{valuesOf(wide(matrixOfParts(a))), {4, 4, 4, 4}};
             },
         .limits = "offsets and scales 0, or from 1e-100 to 1e100 in size; quaternions any but 0",
         .within =
             [](const Arguments& a) {
                 for (const std::size_t i : {0U, 1U, 2U, 7U, 8U, 9U}) {
                     const double size = std::abs(a[i]);
                     if (size != 0 && !(size >= 1e-100 && size <= 1e100)) return false;
                 }
                 return isQuaternion(a, 3);
             }},
        [](const Arguments& a) {
            const Decomposition parts = decompose(matrixOfParts(a));
            return std::array{parts.translation, parts.scale};
        });
    function.forms[0].values = [](const Arguments& a) {
        const Decomposition parts = decompose(matrixOfParts(a));
        WideMatrix m = matrixOf(normalized(wide(vectorOf(parts.rotation))));
        for (std::size_t column = 0; column < 3; ++column) {
            m.column[column] = Wide(parts.scale[static_cast<int>(column)]) * m.column[column];
        }
        m.column[3] = homogeneous(wide(parts.translation), 1);
        return valuesOf(m);
    };
    return function;
}

Arguments velocitiesAndUps(Random& random, Domain domain) {
    Arguments a{};
    const vec3 forward = random.direction(), aside = glm::normalize(glm::cross(forward, random.direction()));
    const double off = domain == Domain::whole ? random.logarithmic(2e-12, 10) : random.number(0.2, 2);
    const double scale = anyScale(random, domain, 290);
    put(a, 0, scale * random.number(1, 2) * forward);
    const double otherScale = anyScale(random, domain, 290);
    put(a, 3, otherScale * (random.sign() * forward + off * aside));
    return a;
}
struct WideAxes {
    Wide3 forward, sideways;
};
WideAxes axesAt(const Arguments& a) {
    const Wide3 forward = normalized(wide(vectorAt(a, 0)));
    return {forward, cross(forward, normalized(wide(vectorAt(a, 3))))};
}

}  // namespace

std::vector<Function> orientationFunctions() {
    std::vector<Function> list;
    list.push_back(withForms(
        {.name = "quatFromAxis",
         .header = "motion/orientation.h",
         .returns = "the quaternion of an axis and an angle",
         .measured = "ulp of the largest component",
         .domain = "angles 1e-300 to 1e300 degrees, axes 1e-150 to 1e150 long",
         .bound = 6,
         .reason = "roundings: two of the angle, one of its sine, three of the axis' length, a quotient and a product",
         .sample =
             [](Random& random, Domain domain) {
                 Arguments a{};
                 a[0] = domain == Domain::ordinary ? random.number(-360, 360) : anyNumber(random, domain, 300);
                 const double scale = anyScale(random, domain, 150), length = random.number(0.1, 10);
                 put(a, 1, scale * length * random.direction());
                 return a;
             },
         .truth =
             [](const Arguments& a) {
                 const Wide half = reducedRadians(a[0] / 2);
                 const Wide3 v = sin(half) * normalized(wide(vectorAt(a, 1)));
                 return oneBlock({cos(half), v[0], v[1], v[2]});
             },
         .limits = "any axis but 0; angles 0, or at least 1e-300",
         .within =
             [](const Arguments& a) { return vectorAt(a, 1) != vec3(0) && (a[0] == 0 || std::abs(a[0]) >= 1e-300); }},
        [](const Arguments& a) { return vectorOf(quatFromAxis(a[0], vectorAt(a, 1))); },
        []<typename T>(const ArgumentsOf<T>& a) {
            return glmVector(glm::angleAxis(glm::radians(a[0]), glm::normalize(vectorAt(a, 1))));
        }));
    list.push_back(withForms(
        {.name = "rotationMatrix",
         .header = "motion/orientation.h",
         .returns = "the matrix of a quaternion",
         .measured = "ulp of 1",
         .domain = "quaternions 1e-290 to 1e290 long, components as small as 1e-9 of that",
         .bound = 6,
         .reason = "roundings: three of the squared length, a quotient, three of two products' sum, of size 2, "
                   "a product and a difference",
         .sample = quaternions,
         .truth = [](const Arguments& a) { return oneBlock(valuesOf(matrixOf(unitAt(a, 0)))); },
         .limits = "any but 0",
         .within = [](const Arguments& a) { return isQuaternion(a, 0); }},
        [](const Arguments& a) { return rotationMatrix(quatAt(a, 0)); },
        []<typename T>(const ArgumentsOf<T>& a) { return glm::mat4_cast(glmAt(a, 0)); }));
    list.push_back(withForms(
        {.name = "quatFromMatrix",
         .header = "motion/orientation.h",
         .returns = "the quaternion of a rotation matrix (timed and measured: of rotationMatrix's, and with that)",
         .measured = "ulp of the largest component, of the two quaternions the nearer",
         .domain = "as rotationMatrix",
         .bound = 8,
         .reason = "roundings: nine of each entry of the matrix, whose sums are four times a component and its largest",
         .sample = quaternions,
         .truth =
             [](const Arguments& a) {
                 const quat is = quatFromMatrix(rotationMatrix(quatAt(a, 0)));
                 const Wide4 truth = unitAt(a, 0);
                 return quaternionTruth(dot(wide(vectorOf(is)), truth) < 0 ? Wide(-1) * truth : truth);
             },
         .limits = "any but 0",
         .within = [](const Arguments& a) { return isQuaternion(a, 0); }},
        [](const Arguments& a) { return vectorOf(quatFromMatrix(rotationMatrix(quatAt(a, 0)))); }));
    list.push_back(withForms(
        {.name = "operator*",
         .header = "motion/orientation.h",
         .returns = "two turns, one after the other, as a unit quaternion",
         .measured = "ulp of the largest component",
         .domain = "quaternions 1e-290 to 1e290 long, components as small as 1e-9 of that",
         .bound = 8,
         .reason = "roundings: a product and two sums in each component, whose terms' sizes sum up to 1, three of the "
                   "squared length, a root and a quotient",
         .sample = pairs,
         .truth = [](const Arguments& a) { return quaternionTruth(normalized(hamilton(unitAt(a, 0), unitAt(a, 4)))); },
         .limits = "any but 0",
         .within = [](const Arguments& a) { return isQuaternion(a, 0) && isQuaternion(a, 4); }},
        [](const Arguments& a) { return vectorOf(quatAt(a, 0) * quatAt(a, 4)); },
        []<typename T>(const ArgumentsOf<T>& a) { return glmVector(glmAt(a, 0) * glmAt(a, 4)); }));
    list.push_back(withForms(
        {.name = "angleBetween",
         .header = "motion/orientation.h",
         .returns = "the angle between two orientations, in degrees",
         .measured = "ulp of 180 degrees",
         .domain = "quaternions 1e-290 to 1e290 long, as close as 1e-16",
         .reason = "",
         .sample = pairs,
         .truth =
             [](const Arguments& a) {
                 const WideEnds ends = endsAt(a);
                 Truth truth = entrywise(
                     {4 * atan2(length(ends.to - ends.from), length(ends.to + ends.from)) * 180 / test::widePi()});
                 truth.sizes = {Wide(180)};
                 return truth;
             },
         .limits = "any but 0",
         .within = [](const Arguments& a) { return isQuaternion(a, 0) && isQuaternion(a, 4); }},
        [](const Arguments& a) { return angleBetween(quatAt(a, 0), quatAt(a, 4)); }));
    list.push_back(withForms(
        {.name = "slerp",
         .header = "motion/orientation.h",
         .returns = "a part of the turn from one orientation to another",
         .measured = "ulp of the largest component",
         .domain = "quaternions 1e-290 to 1e290 long, as close as 1e-16",
         .bound = 10,
         .reason =
             "roundings: five of either end's length, one of their sum and difference, four of the lengths of those, "
             "four of the angle, of its sine and its cosine, two products and a sum",
         .sample = pairs,
         .truth = slerpTruth,
         .limits = endsLimits,
         .within = areEnds},
        [](const Arguments& a) { return vectorOf(slerp(quatAt(a, 0), quatAt(a, 4), a[8])); },
        []<typename T>(const ArgumentsOf<T>& a) { return glmVector(glm::slerp(glmAt(a, 0), glmAt(a, 4), a[8])); }));
    list.push_back(withForms(
        {.name = "nlerp",
         .header = "motion/orientation.h",
         .returns = "the straight line between two orientations, as a unit quaternion",
         .measured = "ulp of the largest component",
         .domain = "quaternions 1e-290 to 1e290 long, as close as 1e-16",
         .bound = 10,
         .reason =
             "roundings: five of either end's length, one of their sum and difference, two of t's product, a sum, "
             "and five of the length of the result",
         .sample = pairs,
         .truth =
             [](const Arguments& a) {
                 const WideEnds ends = endsAt(a);
                 return quaternionTruth(normalized((1 - Wide(a[8])) * ends.from + Wide(a[8]) * ends.to));
             },
         .limits = endsLimits,
         .within = areEnds},
        [](const Arguments& a) { return vectorOf(nlerp(quatAt(a, 0), quatAt(a, 4), a[8])); }));
    list.push_back(withForms(
        {.name = "quatFromYawPitchRoll",
         .header = "motion/orientation.h",
         .returns = "the orientation of yaw, pitch and roll",
         .measured = "ulp of the largest component",
         .domain = "angles 1e-300 to 1e300 degrees",
         .bound = 10,
         .reason = "roundings: three of the sine or cosine of each of three angles, two of their product, and a sum",
         .sample = angles,
         .truth =
             [](const Arguments& a) {
                 // Half angles, so that the sign is the one of whole turns of 720 degrees
                 return quaternionTruth(fromAngles(2 * reducedRadians(a[0] / 2), 2 * reducedRadians(a[1] / 2),
                                                   2 * reducedRadians(a[2] / 2)));
             },
         .limits = "angles 0, or at least 1e-300",
         .within = sizesBetween(1e-300, std::numeric_limits<double>::max())},
        [](const Arguments& a) { return vectorOf(quatFromYawPitchRoll(a[0], a[1], a[2])); }));
    list.push_back(anglesOf());
    list.push_back(partsOf());
    list.push_back(withForms(
        {.name = "frameByUp",
         .header = "motion/path_frame.h",
         .returns = "the frame along a velocity with its up towards a vector",
         .measured = "ulp of each vector's largest entry",
         .domain = "velocities and ups 1e-290 to 1e290 long, 2e-12 to 1.5 rad apart",
         .bound = 10,
         .reason = "roundings: five of a unit vector; up has those of two, a cross product's and of its own length",
         .sample = velocitiesAndUps,
         .truth =
             [](const Arguments& a) {
                 const WideAxes axes = axesAt(a);
                 const Wide3 right = normalized(axes.sideways), up = cross(right, axes.forward);
                 std::vector<Wide> values;
                 for (const Wide3& v : {axes.forward, up, right}) {
                     values.insert(values.end(), v.element.begin(), v.element.end());
                 }
                 return Truth{values, {3, 3, 3}};
             },
         .limits = "neither 0, components 0 or from 1e-70 of the largest, at least 1.1e-12 rad apart",
         .within =
             [](const Arguments& a) {
                 for (const std::size_t i : {0U, 3U}) {
                     const double largest = std::max({std::abs(a[i]), std::abs(a[i + 1]), std::abs(a[i + 2])});
                     if (largest == 0) return false;
                     for (std::size_t k = i; k < i + 3; ++k) {
                         if (a[k] != 0 && std::abs(a[k]) < 1e-70 * largest) return false;
                     }
                 }
                 return length(axesAt(a).sideways) > Wide(1.1e-12);
             }},
        [](const Arguments& a) {
            const PathFrame frame = frameByUp(vectorAt(a, 0), vectorAt(a, 3));
            return std::array{frame.forward, frame.up, frame.right};
        }));
    return list;
}

}  // namespace mv::accuracy
