// X30, X31, X37: interpolating, multiplying and taking apart orientations.
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtx/matrix_decompose.hpp>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/math/transform.h"
#include "mv/motion/decomposition.h"
#include "mv/motion/orientation.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

// ---- X30: slerp

const std::string acosForm = "Shoemake's slerp in float: acos of the dot product";
const double slerpTolerance = 2e-15;
const std::string slerpReason = "some roundings of 1.1e-16: two lengths, a sum, a difference, a sine and a cosine";

glm::vec4 acosSlerp(const glm::vec4& from, glm::vec4 to, float t) {
    float dot = glm::dot(from, to);
    if (dot < 0) {
        to = -to;
        dot = -dot;
    }
    const float angle = std::acos(dot);
    return (std::sin((1 - t) * angle) * from + std::sin(t * angle) * to) / std::sin(angle);
}

Wide4 wideOf(const quat& q) { return {{q.w, q.x, q.y, q.z}}; }
glm::vec4 floatOf(const quat& q) { return glm::vec4(vec4(q.w, q.x, q.y, q.z)); }
quat orientation(Random& random) { return quatFromAxis(random.number(0, 360), random.direction()); }

// How far a quaternion is off the true one, of the two of its orientation the nearer.
double off(const Wide4& is, const Wide4& truth) {
    const double same = static_cast<double>(length(is - truth)), other = static_cast<double>(length(is + truth));
    return std::isnan(same) ? infinite : std::min(same, other);
}

// The error a third of the way from each of 1000 orientations to one `angle` rad farther, of quaternions `size` long.
struct SlerpErrors {
    double naive = 0, ours = 0;
};
SlerpErrors slerpErrors(double angle, double size) {
    Random random(30);
    SlerpErrors errors;
    for (int i = 0; i < 1000; ++i) {
        const vec3 axis = random.direction();
        const quat from = orientation(random), turn = quatFromAxis(degrees(angle), axis);
        quat to = turn * from;
        quat first = from;
        for (quat* q : {&first, &to}) *q = {size * q->w, size * q->x, size * q->y, size * q->z};
        // From the middle, in 50 digits of which a difference of 1e-7 leaves 43
        const Wide4 a = normalized(wideOf(first)), b = normalized(wideOf(to));
        const Wide4 sum = a + b, difference = b - a;
        const Wide half = atan2(length(difference), length(sum)), third = -half / 3;
        const Wide4 truth =
            length(difference) == 0 ? a : cos(third) / length(sum) * sum + sin(third) / length(difference) * difference;
        errors.naive = worse(errors.naive, off(wide(acosSlerp(floatOf(first), floatOf(to), 1.0f / 3)), truth));
        errors.ours = worse(errors.ours, off(wideOf(slerp(first, to, 1.0 / 3)), truth));
    }
    return errors;
}

[[maybe_unused]] const bool x30none = addRow([] {
    const auto [naive, ours] = slerpErrors(0, 1);
    return Row{.id = "X30 0°",
               .input = "1000 orientations, interpolated with themselves",
               .measured = "how far the quaternion is off",
               .naive = acosForm,
               .naiveError = naive,
               .ours = "slerp: atan2 of sum and difference",
               .ourError = ours,
               .tolerance = slerpTolerance,
               .reason = slerpReason};
});

[[maybe_unused]] const bool x30small = addRow([] {
    const auto [naive, ours] = slerpErrors(1e-7, 1);
    return Row{.id = "X30 1e-7",
               .input = "1000 pairs of orientations 1e-7 rad apart",
               .measured = "how far the quaternion is off a third of the way",
               .naive = acosForm,
               .naiveError = naive,
               .ours = "slerp: atan2 of sum and difference",
               .ourError = ours,
               .tolerance = slerpTolerance,
               .reason = slerpReason};
});

[[maybe_unused]] const bool x30long = addRow([] {
    const auto [naive, ours] = slerpErrors(1e-3, 1 + 1e-6);
    return Row{.id = "X30 q·q > 1",
               .input = "1000 pairs of orientations 1e-3 rad apart, quaternions 1e-6 longer than 1",
               .measured = "how far the quaternion is off a third of the way",
               .naive = acosForm,
               .naiveError = naive,
               .ours = "slerp, which takes any lengths",
               .ourError = ours,
               .tolerance = slerpTolerance,
               .reason = slerpReason};
});

[[maybe_unused]] const bool x30half = addRow([] {
    Random random(30);
    double naive = 0, ours = 0;
    for (int i = 0; i < 1000; ++i) {
        const quat from = orientation(random), to = quatFromAxis(180, random.direction()) * from;
        const quat other{-to.w, -to.x, -to.y, -to.z};
        const auto apart = [&](const quat& a, const quat& b) { return radians(angleBetween(a, b)); };
        const auto asQuat = [](const glm::vec4& v) { return quat{v[0], v[1], v[2], v[3]}; };
        naive = worse(naive, apart(asQuat(acosSlerp(floatOf(from), floatOf(to), 0.5f)),
                                   asQuat(acosSlerp(floatOf(from), floatOf(other), 0.5f))));
        naive = worse(naive, apart(asQuat(acosSlerp(floatOf(from), floatOf(to), 0.5f)),
                                   asQuat(acosSlerp(floatOf(to), floatOf(from), 0.5f))));
        ours = worse(ours, apart(slerp(from, to, 0.5), slerp(from, other, 0.5)));
        ours = worse(ours, apart(slerp(from, to, 0.5), slerp(to, from, 0.5)));
    }
    return Row{.id = "X30 180°",
               .input = "1000 pairs of orientations half a turn apart, from either end and with either sign of one",
               .measured = "how far apart the middles are (rad)",
               .naive = acosForm + ", of which rounding chooses the way",
               .naiveError = naive,
               .ours = "slerp: a way chosen by the orientations alone",
               .ourError = ours,
               .tolerance = 1e-14,
               .reason = "some roundings of 1.1e-16, four times that as an angle"};
});

// ---- X31: a million turns, one after the other

constexpr int turns = 1'000'000;
constexpr double stepDegrees = 1.2345;
const vec3 stepAxis(1, 2, 3);

struct Turned {
    glm::mat4 matrix{1};
    quat quaternion;
};
const Turned& turned() {
    static const Turned all = [] {
        Turned result;
        const glm::mat4 step(rotate(stepDegrees, stepAxis));
        const quat stepTurn = quatFromAxis(stepDegrees, stepAxis);
        for (int i = 0; i < turns; ++i) {
            result.matrix = step * result.matrix;
            result.quaternion = stepTurn * result.quaternion;
        }
        return result;
    }();
    return all;
}

// How far a turned vector is off the one that is turned by all degrees at once, reduced in whole numbers.
double offVector(const mat4& m) {
    const Wide angle = Wide(stepDegrees) * turns, turn = fmod(angle, Wide(360)) * widePi() / 180;
    const Wide3 axis = normalized(wide(stepAxis)), v{{Wide(1), Wide(0), Wide(0)}};
    const Wide3 truth = cos(turn) * v + sin(turn) * cross(axis, v) + dot(axis, v) * (1 - cos(turn)) * axis;
    return distance(wide(vec3(m[0])), truth);
}

[[maybe_unused]] const bool x31 = addRow([] {
    return Row{.id = "X31",
               .input = "a million turns by 1.2345°, each times the last",
               .measured = "largest element of RᵀR − I",
               .naive = "matrices in float",
               .naiveError = orthogonality(turned().matrix),
               .ours = "quaternions, whose product is a unit quaternion",
               .ourError = orthogonality(rotationMatrix(turned().quaternion)),
               .tolerance = 1e-14,
               .reason = "the roundings of one matrix: there is nothing to add up"};
});

[[maybe_unused]] const bool x31angle = addRow([] {
    return Row{.id = "X31 angle",
               .input = "a million turns by 1.2345°, each times the last",
               .measured = "how far a vector of length 1 is off",
               .naive = "matrices in float",
               .naiveError = offVector(mat4(turned().matrix)),
               .ours = "quaternions",
               .ourError = offVector(rotationMatrix(turned().quaternion)),
               .tolerance = 1e-9,
               .reason = "a million turns whose angle is off by 2.5e-16, all the same way: 2.5e-10, twice as a turn"};
});

[[maybe_unused]] const bool x31parameter = addRow([] {
    return Row{.id = "X31 parameter",
               .input = "a million turns by 1.2345°, at once",
               .measured = "how far a vector of length 1 is off",
               .naive = "matrices in float, one after the other",
               .naiveError = offVector(mat4(turned().matrix)),
               .ours = "quatFromAxis(1e6 · 1.2345)",
               .ourError = offVector(rotationMatrix(quatFromAxis(turns * stepDegrees, stepAxis))),
               .tolerance = 1e-11,
               .reason = "the product of 1.2e6 degrees has a rounding of 1.2e-10 degrees, 2e-12 rad"};
});

// ---- X37: matrices taken apart

// The largest error of an entry of the rebuilt matrix, as a part of its column's largest.
double rebuildError(const mat4& m, const mat4& rebuilt) {
    double worst = 0;
    for (int column = 0; column < 4; ++column) {
        double size = 0, difference = 0;
        for (int row = 0; row < 4; ++row) {
            size = std::max(size, std::abs(m[column][row]));
            difference = worse(difference, std::abs(rebuilt[column][row] - m[column][row]));
        }
        worst = worse(worst, difference == 0 ? 0 : difference / size);
    }
    return worst;
}

// Scales are the lengths of the columns, and the rest is a rotation.
mat4 lengthsForm(const mat4& m) {
    glm::mat4 rest(m);
    glm::vec3 scales;
    for (int i = 0; i < 3; ++i) {
        scales[i] = glm::length(glm::vec3(rest[i]));
        rest[i] /= scales[i];
    }
    const glm::mat4 turn = glm::mat4_cast(glm::normalize(glm::quat_cast(glm::mat3(rest))));
    return {glm::translate(glm::mat4(1), glm::vec3(m[3])) * turn * glm::scale(glm::mat4(1), scales)};
}

mat4 gtxForm(const mat4& m) {
    glm::vec3 scales, offset, skew;
    glm::vec4 perspective;
    glm::quat turn;
    if (!glm::decompose(glm::mat4(m), scales, turn, offset, skew, perspective)) return mat4(notANumber);
    return {glm::translate(glm::mat4(1), offset) * glm::mat4_cast(turn) * glm::scale(glm::mat4(1), scales)};
}

mat4 ourForm(const mat4& m) {
    const Decomposition parts = decompose(m);
    return translate(parts.translation) * rotationMatrix(parts.rotation) * mv::scale(parts.scale);
}

template <typename Naive>
SlerpErrors decomposeErrors(const vec3& scales, Naive naive) {
    Random random(37);
    SlerpErrors errors;
    for (int i = 0; i < 1000; ++i) {
        const mat4 m = translate(random.point(10)) * rotationMatrix(orientation(random)) * mv::scale(scales);
        errors.naive = worse(errors.naive, rebuildError(m, naive(m)));
        errors.ours = worse(errors.ours, rebuildError(m, ourForm(m)));
    }
    return errors;
}

const std::string rebuilt = "largest error of an entry of the rebuilt matrix, as a part of its column's largest";
const std::string textbook = "columns' lengths and glm::quat_cast, in float";
const double rebuiltTolerance = 4e-15;
const std::string rebuiltReason = "a dozen roundings of 1.1e-16 and more: quaternion from matrix, and back";

[[maybe_unused]] const bool x37small = addRow([] {
    const auto [naive, ours] = decomposeErrors(vec3(1e-3), gtxForm);
    return Row{.id = "X37 1e-3",
               .input = "1000 random placements, scaled by 1e-3",
               .measured = rebuilt,
               .naive = "glm::decompose in float, which finds no inverse",
               .naiveError = naive,
               .ours = "decompose",
               .ourError = ours,
               .tolerance = rebuiltTolerance,
               .reason = rebuiltReason};
});

[[maybe_unused]] const bool x37zero = addRow([] {
    const auto [naive, ours] = decomposeErrors(vec3(2, 0, 1), lengthsForm);
    return Row{.id = "X37 0",
               .input = "1000 random placements, one axis scaled by 0",
               .measured = rebuilt,
               .naive = textbook,
               .naiveError = naive,
               .ours = "decompose: the axis that is missing is completed",
               .ourError = ours,
               .tolerance = rebuiltTolerance,
               .reason = rebuiltReason};
});

[[maybe_unused]] const bool x37mirror = addRow([] {
    const auto [naive, ours] = decomposeErrors(vec3(2, -3, 1), lengthsForm);
    return Row{.id = "X37 mirror",
               .input = "1000 random placements, one axis mirrored",
               .measured = rebuilt,
               .naive = textbook + ": the sign is lost",
               .naiveError = naive,
               .ours = "decompose: scale.x < 0",
               .ourError = ours,
               .tolerance = rebuiltTolerance,
               .reason = rebuiltReason};
});

[[maybe_unused]] const bool x37shear = addRow([] {
    mat4 shear(1);
    shear[1] = vec4(0.1, 1, 0, 0);
    return Row{.id = "X37 shear",
               .input = "a shear by a tenth",
               .measured = rebuilt + "; 0 where it is refused",
               .naive = textbook + ": the shear is lost",
               .naiveError = rebuildError(shear, lengthsForm(shear)),
               .ours = "decompose refuses it, and says by how much",
               .ourError = accepted([&] { decompose(shear); }),
               .tolerance = 0,
               .reason = "no three parts make a shear"};
});

}  // namespace
