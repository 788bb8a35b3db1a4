// Y31 to Y37: what peers' libraries have, too, where their usual forms lose their digits.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_projection.hpp>
#include <glm/geometric.hpp>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/geometry/closest.h"
#include "mv/geometry/quadric_ray.h"
#include "mv/math/color_difference.h"
#include "mv/math/depth_range.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "mv/math/unproject.h"
#include "mv/motion/turn.h"
#include "mv/motion/usual_eases.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

// Points before a camera, at parts of far; from their pixels and depths, as exactly as doubles have them, and back.
[[maybe_unused]] const bool y31 = addRow([] {
    constexpr int width = 1024, height = 768;
    const double near = 0.1, far = 1e5;
    const mat4 lens = perspective(50, 4 / 3.0, near, far), view = lookAt(vec3(3, 2, 1), vec3(0), vec3(0, 1, 0));
    double naive = 0, ours = 0;
    Random random(31);
    for (int i = 0; i < 200; ++i) {
        const double distance = far * random.number(0.2, 1);
        const vec3 seen = distance * vec3(random.number(-0.5, 0.5), random.number(-0.4, 0.4), -1);
        const vec3 point(glm::transpose(mat3(view)) * (seen - vec3(view[3])));
        const WideMatrix clipFromWorld = wide(lens * view);
        const Wide3 ndc = divided(clipFromWorld * homogeneous(wide(point), 1));
        const vec2 pixel((ndc[0] + 1) / 2 * width, (ndc[1] + 1) / 2 * height);
        const double depth = static_cast<double>((ndc[2] + 1) / 2);
        const vec3 back = unProject(pixel, depth, lens * view, width, height);
        const fvec3 glms = glm::unProject(fvec3(pixel, depth), fmat4(view), fmat4(lens), fvec4(0, 0, width, height));
        ours = worse(ours, glm::distance(back, point) / distance);
        naive = worse(naive, glm::distance(vec3(glms), point) / distance);
    }
    return Row{.id = "Y31",
               .input = "pixels and depths of points from a fifth of far to far, far/near = 1e6",
               .measured = "largest error of the point that they give back, by its distance",
               .naive = "glm::unProject in float",
               .naiveError = naive,
               .ours = "unProject",
               .ourError = ours,
               .tolerance = 4e-9,
               .reason = "a rounding of the depth, and some of the matrix, are worth far/near of themselves there"};
});

// The usual quaternion, (1 + dot, cross), made a unit one.
double offBy(const quat& turn, const vec3& from, const vec3& to) {
    const double length = std::sqrt(turn.w * turn.w + turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
    const vec3 u = vec3(turn.x, turn.y, turn.z) / length;
    const double w = turn.w / length;
    const vec3 twice = 2.0 * glm::cross(u, from);
    return glm::distance(from + w * twice + glm::cross(u, twice), to);
}
quat usualTurn(const vec3& from, const vec3& to) {
    const vec3 v = glm::cross(from, to);
    return {1 + glm::dot(from, to), v.x, v.y, v.z};
}

[[maybe_unused]] const bool y32 = addRow([] {
    double naive = 0, ours = 0;
    for (const double little : {1e-7, 1e-8, 1e-9}) {
        const vec3 from(1, 0, 0), to = glm::normalize(vec3(-1, little, 0));
        naive = worse(naive, offBy(usualTurn(from, to), from, to));
        ours = worse(ours, offBy(turnBetween(from, to), from, to));
    }
    return Row{.id = "Y32",
               .input = "the turn from a direction to one that is 1e-7 to 1e-9 rad short of opposite",
               .measured = "how far from the second it leads the first",
               .naive = "(1 + dot, cross), of unit length",
               .naiveError = naive,
               .ours = "turnBetween",
               .ourError = ours,
               .tolerance = 1e-15,
               .reason = "roundings of unit vectors"};
});

[[maybe_unused]] const bool y32opposite = addRow([] {
    const vec3 from(0.6, 0.8, 0);
    return Row{.id = "Y32 opposite",
               .input = "the turn from a direction to the opposite one",
               .measured = "how far from the second it leads the first",
               .naive = "(1 + dot, cross), of unit length",
               .naiveError = worse(0, offBy(usualTurn(from, -from), from, -from)),
               .ours = "turnBetween, about an axis of its choice",
               .ourError = offBy(turnBetween(from, -from), from, -from),
               .tolerance = 1e-15,
               .reason = "roundings of unit vectors"};
});

// How far twice a step in chroma is from twice the difference. Steps are doubled exactly; what is left is what the weights
// change by, a hundredth of the step.
[[maybe_unused]] const bool y33 = addRow([] {
    double naive = 0, ours = 0;
    const vec3 color(50, 30, -40);
    for (const double apart : {1e-6, 1e-9, 1e-12}) {
        const vec3 other = color + apart * vec3(0, 3, -4), twice = 2.0 * other - color;
        const auto printed = [&](const vec3& to) { return std::hypot(to.y, to.z) - std::hypot(color.y, color.z); };
        naive = worse(naive, std::abs(printed(twice) / printed(other) / 2 - 1));
        ours = worse(ours, std::abs(colorDifference(color, twice) / colorDifference(color, other) / 2 - 1));
    }
    return Row{.id = "Y33",
               .input = "colours whose chromas differ by 5e-6 to 5e-12",
               .measured = "how far the difference of twice the step is from twice the difference, as a part of it",
               .naive = "sqrt(a2^2 + b2^2) - sqrt(a1^2 + b1^2), as CIEDE2000 is printed",
               .naiveError = naive,
               .ours = "colorDifference",
               .ourError = ours,
               .tolerance = 1e-6,
               .reason = "CIEDE2000's weights change by up to a tenth of the step"};
});

// A cylinder of radius 1 from 1e4 away, in float.
[[maybe_unused]] const bool y34 = addRow([] {
    Random random(34);
    int naive = 0, ours = 0, count = 0;
    for (int i = 0; i < 2000; ++i) {
        const vec3 way = random.direction();
        const RayOf<float> ray{fvec3(random.point(1.3) - 1e4 * way), fvec3(way)};
        const double dx = ray.direction.x, dz = ray.direction.z, ox = ray.origin.x, oz = ray.origin.z;
        const double off = std::abs(ox * dz - oz * dx) / std::hypot(dx, dz);
        if (std::abs(off - 1) < 0.01) continue;  // within what the coordinates are rounded by
        ++count;
        const float a = ray.direction.x * ray.direction.x + ray.direction.z * ray.direction.z;
        const float b = 2 * (ray.origin.x * ray.direction.x + ray.origin.z * ray.direction.z);
        const float c = ray.origin.x * ray.origin.x + ray.origin.z * ray.origin.z - 1;
        naive += (b * b - 4 * a * c >= 0) == (off < 1) ? 0 : 1;
        ours += intersectCylinder(ray, 1.0F, -1e6F, 1e6F).has_value() == (off < 1) ? 0 : 1;
    }
    return Row{.id = "Y34",
               .input = "2000 rays in float that pass a cylinder of radius 1, from 1e4 away",
               .measured = "part of them with the wrong answer",
               .naive = "b^2 - 4ac",
               .naiveError = double(naive) / count,
               .ours = "intersectCylinder",
               .ourError = double(ours) / count,
               .tolerance = 0,
               .reason = "none within a hundredth of the outline is asked"};
});

[[maybe_unused]] const bool y35 = addRow([] {
    const double near = 1e-3, far = 1e9;
    const mat4 usual = perspective(50, 1, near, far), ours = perspective(50, 1, near, far, DepthRange::oneToZero);
    const Wide right = Wide(near) / (Wide(far) - near);
    const auto off = [&](double element) { return static_cast<double>(abs((element - right) / right)); };
    return Row{.id = "Y35",
               .input = "a reversed depth for far/near = 1e12",
               .measured = "relative error of the matrix' element that tells distances apart",
               .naive = "OpenGL's third row, taken from the fourth and halved",
               .naiveError = off((-1 - usual[2][2]) / 2),
               .ours = "perspective(..., DepthRange::oneToZero)",
               .ourError = off(ours[2][2]),
               .tolerance = 3e-16,
               .reason = "a difference and a quotient"};
});

[[maybe_unused]] const bool y36 = addRow([] {
    double naive = 0, ours = 0;
    for (const double t : {1e-7, 1e-8, 1e-9}) {
        const Wide right = 1 - cos(widePi() / 2 * t);
        const auto off = [&](double value) { return static_cast<double>(abs((value - right) / right)); };
        naive = worse(naive, off(1 - std::cos(pi / 2 * t)));
        ours = worse(ours, off(sineEase(t, EaseSide::in)));
    }
    return Row{.id = "Y36",
               .input = "the sine ease at t = 1e-7 to 1e-9",
               .measured = "relative error",
               .naive = "1 - cos(90 t degrees)",
               .naiveError = naive,
               .ours = "sineEase",
               .ourError = ours,
               .tolerance = 1e-15,
               .reason = "roundings of a sine, doubled by its square"};
});

[[maybe_unused]] const bool y37 = addRow([] {
    const vec3 point(1, 2, 3), end(4, 5, 6);
    const double t = glm::dot(point - end, vec3(0)) / glm::dot(vec3(0), vec3(0));
    return Row{.id = "Y37",
               .input = "the nearest point of a segment whose ends are the same",
               .measured = "distance from that point",
               .naive = "a + dot(p - a, b - a)/dot(b - a, b - a) (b - a)",
               .naiveError = worse(0, glm::distance(end + std::clamp(t, 0.0, 1.0) * vec3(0), end)),
               .ours = "closestOnSegment",
               .ourError = glm::distance(closestOnSegment(point, end, end), end),
               .tolerance = 0,
               .reason = "it is that point"};
});

}  // namespace
