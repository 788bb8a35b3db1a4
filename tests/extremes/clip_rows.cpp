// X25: cutting before the division.
#include <boost/multiprecision/cpp_int.hpp>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/math/clip.h"
#include "mv/math/projection.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

// Segments from before the eye to behind it, cut at the near plane. The truth is a fraction, computed exactly.
[[maybe_unused]] const bool x25 = addRow([] {
    using Fraction = boost::multiprecision::cpp_rational;
    const mat4 clipFromView = perspective(90, 1, 0.5, 10);
    const vec4 nearBound[] = {clipVolume()[4]};
    Random random(25);
    double naive = 0, ours = 0;
    for (int i = 0; i < 1000; ++i) {
        const vec4 front = clipFromView * vec4(random.number(-0.5, 0.5), random.number(-0.5, 0.5), -1, 1);
        const vec4 behind = clipFromView * vec4(random.number(-2, 2), random.number(-2, 2), random.number(0.1, 5), 1);
        const Fraction in = Fraction(front.z) + Fraction(front.w), out = Fraction(behind.z) + Fraction(behind.w);
        const Fraction part = in / (in - out);
        const auto place = [&](int axis) {
            return Fraction(front[axis]) + part * (Fraction(behind[axis]) - Fraction(front[axis]));
        };
        const auto error = [&](const vec4& end) {
            double worst = 0;
            for (const int axis : {0, 1}) {
                const Fraction truth = place(axis) / place(3);
                worst = worse(worst, std::abs((Fraction(end[axis]) / Fraction(end.w) - truth).convert_to<double>()));
            }
            return worst;
        };
        const auto cut = clipPolygon({front, behind}, nearBound);
        ours = worse(ours, cut.size() == 2 ? error(cut[1]) : infinite);
        naive = worse(naive, error(behind));
    }
    return Row{.id = "X25",
               .input = "1000 segments from before the eye to behind it",
               .measured = "how far their end in the picture is from the true one, of a picture 2 wide",
               .naive = "divide by w, then clip: mirrored",
               .naiveError = naive,
               .ours = "clipPolygon, then divide",
               .ourError = ours,
               .tolerance = 1e-12,
               .reason = "some roundings of the clip coordinates, up to 6; a pixel is 1e-3"};
});

[[maybe_unused]] const bool x25outside = addRow([] {
    // Triangles that are wholly outside: behind the eye, beside the view, beyond far; and one that lies in the plane w = 0.
    const mat4 clipFromView = perspective(90, 1, 0.5, 10);
    const auto triangle = [&](const vec3& a, const vec3& b, const vec3& c) {
        return std::vector<vec4>{clipFromView * vec4(a, 1), clipFromView * vec4(b, 1), clipFromView * vec4(c, 1)};
    };
    const std::vector<std::vector<vec4>> outside{
        triangle({0, 0, 1}, {0.5, 0, 1}, {0, 0.5, 1}), triangle({-0.1, 0, 5}, {0.1, 0, 2}, {0, 0.1, 3}),
        triangle({1, 0, 0}, {0, 1, 0}, {-1, -1, 0}), triangle({20, 0, -1}, {20, 1, -2}, {30, 0, -3}),
        triangle({0, 0, -11}, {1, 0, -12}, {0, 1, -13})};
    double naive = 0, ours = 0;
    for (const auto& polygon : outside) {
        bool seen = false, broken = false;
        for (const vec4& p : polygon) {
            const vec3 ndc = vec3(p) / p.w;
            broken |= !std::isfinite(ndc.x) || !std::isfinite(ndc.y);
            seen |= std::abs(ndc.x) <= 1 && std::abs(ndc.y) <= 1 && std::abs(ndc.z) <= 1.5;
        }
        naive += seen || broken ? 1 : 0;
        ours += clipPolygon(polygon, clipVolume()).empty() ? 0 : 1;
    }
    return Row{.id = "X25 outside",
               .input = "5 triangles outside the view: behind the eye, in the plane w = 0, beside, beyond",
               .measured = "triangles of which something shows, or that are divided by 0",
               .naive = "divide by w, then compare x and y with ±1",
               .naiveError = naive,
               .ours = "clipPolygon",
               .ourError = ours,
               .tolerance = 0,
               .reason = "nothing of them is in view"};
});

// A thin triangle far from the origin: its edges are nearly parallel, and the cross product of them cancels.
[[maybe_unused]] const bool y04 = addRow([] {
    const vec3 base(1e6, -2e6, 3e6);
    const vec3 corners[] = {base, base + vec3(1, 2, 3), base + vec3(1.0009765625, 2, 3)};
    const Wide3 a = wide(corners[1]) - wide(corners[0]), b = wide(corners[2]) - wide(corners[0]);
    const Wide truth = length(cross(a, b)) / 2;
    const auto relative = [&](double area) { return static_cast<double>(abs(Wide(area) / truth - 1)); };
    const auto f = [&](int i) { return fvec3(corners[i]); };
    const fvec3 crossed = glm::cross(f(1), f(2)) + glm::cross(f(2), f(0)) + glm::cross(f(0), f(1));
    return Row{.id = "Y04",
               .input = "a triangle 4 long and 0.001 thin, 4e6 from the origin",
               .measured = "relative error of its area",
               .naive = "sum of a × b, b × c, c × a in float",
               .naiveError = relative(static_cast<double>(glm::length(crossed)) / 2),
               .ours = "polygonArea",
               .ourError = relative(polygonArea(corners)),
               .tolerance = 1e-12,
               .reason = "differences are exact here; the product of edges 3e-4 rad apart loses 1.1e-16/3e-4"};
});

}  // namespace
