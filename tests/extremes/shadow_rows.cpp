// X11 to X16: the planar shadow matrix.
#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/math/clip.h"
#include "mv/math/shadow.h"
#include "mv/math/shadow_caster.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

const vec4 ground(0, 1, 0, 0);
const vec4 light(1, 10, 0, 1);

// The textbook's matrix, dot(n, L) I - L n^T, without a look at its arguments.
template <typename T>
glm::mat<4, 4, T> textbook(const glm::vec<4, T>& from, const glm::vec<4, T>& plane) {
    glm::mat<4, 4, T> m(glm::dot(plane, from));
    for (int column = 0; column < 4; ++column) m[column] -= plane[column] * from;
    return m;
}

bool isDrawn(const vec4& clip) { return std::isfinite(clip.x / clip.w) && std::isfinite(clip.z / clip.w); }

// 1000 casters of which every second is a true one, between floor and light, and the others have their height from
// `low` to `high`: how many get a shadow and should not, or should and do not.
Row casters(const std::string& id, const std::string& where, const std::string& naiveForm, double low, double high) {
    Random random(11);
    const auto bounds = shadowCasterBounds(light, ground);
    const mat4 naive = textbook<double>(light, ground);
    double naiveWrong = 0, oursWrong = 0;
    for (int i = 0; i < 1000; ++i) {
        const bool casts = i % 2 == 0;
        const vec4 p(random.number(-9, 9), casts ? random.number(0.001, 9.999) : random.number(low, high),
                     random.number(-9, 9), 1);
        naiveWrong += isDrawn(naive * p) == casts ? 0 : 1;
        oursWrong += (glm::dot(bounds[0], p) > 0 && glm::dot(bounds[1], p) > 0) == casts ? 0 : 1;
    }
    return {.id = id,
            .input = "1000 points, half of them " + where + "; a light 10 above the floor",
            .measured = "points with a false shadow, or without their true one",
            .naive = naiveForm,
            .naiveError = naiveWrong,
            .ours = "shadowCasterBounds",
            .ourError = oursWrong,
            .tolerance = 0,
            .reason = "a half space either holds a point or does not"};
}
[[maybe_unused]] const bool x11 = addRow(
    [] { return casters("X11", "above the light", "the textbook's matrix: an anti-shadow, w < 0", 10.001, 20); });
[[maybe_unused]] const bool x13 = addRow(
    [] { return casters("X13", "below the floor", "the textbook's matrix: a false shadow, w > 0", -9, -0.001); });

[[maybe_unused]] const bool x12 = addRow([] {
    Random random(12);
    const auto bounds = shadowCasterBounds(light, ground);
    double naive = 0, ours = 0;
    for (int i = 0; i < 1000; ++i) {
        const vec4 p(random.number(-9, 9), 10, random.number(-9, 9), 1);
        naive += isDrawn(textbook<double>(light, ground) * p) ? 0 : 1;
        ours += glm::dot(bounds[1], p) > 0 ? 1 : 0;
    }
    return Row{.id = "X12",
               .input = "1000 points exactly as high as the light",
               .measured = "points that are divided by w = 0",
               .naive = "the textbook's matrix",
               .naiveError = naive,
               .ours = "shadowCasterBounds leaves them out",
               .ourError = ours,
               .tolerance = 0,
               .reason = "the shadow is at infinity: there is no near miss"};
});

[[maybe_unused]] const bool x14 = addRow([] {
    // None of these throws the shadow of something 2 above the floor onto it.
    const vec4 lights[] = {{1, 0, 0, 1}, {1, 5e-7, 0, 1}, {1, -5e-7, 0, 1}, {1, -3, 0, 1}, {1, -1e-7, 0, 0}};
    const vec3 caster(3, 2, 0);
    double naive = 0, ours = 0;
    for (const vec4& from : lights) {
        naive += isDrawn(textbook<double>(from, ground) * vec4(caster, 1)) ? 1 : 0;
        ours += judgeCaster("point", std::span(&caster, 1), from, ground).casts ? 1 : 0;
    }
    for (const vec4& from : std::span(lights).first(3)) {
        ours += accepted([&] { shadowProjection(from, ground); });
    }
    return Row{.id = "X14",
               .input = "5 lights in the floor, within 1e-6 of it, and below it",
               .measured = "lights that throw a shadow onto the floor, or are not refused",
               .naive = "the textbook's matrix: collapsed onto the light, or mirrored",
               .naiveError = naive,
               .ours = "judgeCaster: none, and a sentence why; shadowProjection refuses the first three",
               .ourError = ours,
               .tolerance = 0,
               .reason = "it is a verdict"};
});

[[maybe_unused]] const bool x15 = addRow([] {
    const mat4 m = shadowProjection({1, 1e-7, 0, 0}, ground);
    const vec4 receiver[] = {{1, 0, 0, 10}, {-1, 0, 0, 10}, {0, 0, 1, 10}, {0, 0, -1, 10}};  // -10..10
    const std::vector<vec4> shadow{m * vec4(-1, 0, -1, 1), m * vec4(-1, 0, 1, 1), m * vec4(-1, 2, 1, 1),
                                   m * vec4(-1, 2, -1, 1)};
    const auto beyond = [](const std::vector<vec4>& polygon) {
        double reach = 0;
        for (const vec4& p : polygon) {
            const Wide3 at = divided(wide(p));
            for (const std::size_t axis : {0u, 2u}) reach = worse(reach, static_cast<double>(abs(at[axis]) - 10));
        }
        return reach;
    };
    const auto cut = clipPolygon(shadow, receiver);
    return Row{.id = "X15",
               .input = "a light 1e-7 rad above the floor, a wall 2 high, a floor 20 wide",
               .measured = "how far the shadow reaches beyond the floor",
               .naive = "the shadow matrix alone",
               .naiveError = beyond(shadow),
               .ours = "cut by clipPolygon before the division",
               .ourError = cut.size() < 3 ? infinite : beyond(cut),
               .tolerance = 1e-8,
               .reason = "the cut is between points 2e7 apart, whose last place is 4e-9"};
});

// How far from their plane shadows fall, with the plane D away from the origin and everything on it of size 10.
struct PlaneErrors {
    double worldFloat = 0, worldDouble = 0, local = 0;
};
PlaneErrors planeErrors(double d) {
    PlaneErrors worst;
    Random random(9);
    const double size = 10;
    for (int i = 0; i < 200; ++i) {
        const vec3 n = random.direction(), origin = d * n;
        const vec4 plane(n, -glm::dot(n, origin));
        const vec3 aside = glm::normalize(glm::cross(n, random.direction()));
        const vec4 from(origin + size * n + 0.3 * size * aside, 1);
        const vec3 caster = origin + random.number(0.1, 0.5) * size * n + random.number(-1, 1) * size * aside;
        const Wide3 normal = normalized(wide(n));
        const Wide distanceOfPlane = dot(normal, wide(origin));
        const auto off = [&](const Wide3& p, const Wide& expected) {
            return static_cast<double>(abs(dot(normal, p) - expected));
        };
        const fvec4 inFloat = textbook<float>(fvec4(from), fvec4(plane)) * fvec4(fvec3(caster), 1);
        const vec4 inDouble = textbook<double>(from, plane) * vec4(caster, 1);
        const fvec4 inPlace =
            fmat4(shadowProjection(from, plane, origin)) * fvec4(fvec3(caster - origin), 1);  // as uploaded
        worst.worldFloat = worse(worst.worldFloat, off(divided(wide(inFloat)), distanceOfPlane));
        worst.worldDouble = worse(worst.worldDouble, off(divided(wide(inDouble)), distanceOfPlane));
        worst.local = worse(worst.local, off(divided(wide(inPlace)), 0));
    }
    return worst;
}
Row farPlane(const std::string& id, const std::string& naive, double naiveError, double ourError) {
    return {.id = id,
            .input = "a floor " + id.substr(4, 3) + " from the origin, things of size 10 on it",
            .measured = "how far shadows fall off the floor",
            .naive = naive,
            .naiveError = naiveError,
            .ours = "relative to a point on the floor, then float",
            .ourError = ourError,
            .tolerance = 1e-4,
            .reason = "1e-5 of the things' size; float coordinates of 10 end at 1e-6"};
}
[[maybe_unused]] const bool x16a = addRow([] {
    const PlaneErrors e = planeErrors(1e4);
    return farPlane("X16 1e4", "world space, float", e.worldFloat, e.local);
});
[[maybe_unused]] const bool x16b = addRow([] {
    const PlaneErrors e = planeErrors(1e6);
    return farPlane("X16 1e6", "world space, float", e.worldFloat, e.local);
});
[[maybe_unused]] const bool x16c = addRow([] {
    const PlaneErrors e = planeErrors(1e7);
    return farPlane("X16 1e7 double", "world space, even double", e.worldDouble, e.local);
});

// A homogeneous light with w other than 1: its place relative to the floor is a difference of large products.
[[maybe_unused]] const bool y07 = addRow([] {
    const vec3 n = glm::normalize(vec3(1, 2, 3)), origin = 1e8 * n;
    const double w = 0.7;
    const vec4 from(w * (origin + vec3(0.01, 0.02, 0.04)), w), plane(n, -glm::dot(n, origin));
    const Wide3 normal = normalized(wide(n)), local = firstThree(wide(from)) - Wide(w) * wide(origin);
    const auto error = [&](const mat4& m) {
        Wide worst = 0;
        for (int column = 0; column < 3; ++column) {
            for (int row = 0; row < 3; ++row) {
                const auto c = static_cast<std::size_t>(column), r = static_cast<std::size_t>(row);
                const Wide truth = (c == r ? dot(normal, local) : Wide(0)) - normal[c] * local[r];
                worst = std::max<Wide>(worst, abs(m[column][row] - truth));
            }
        }
        return static_cast<double>(worst / length(local));
    };
    return Row{.id = "Y07",
               .input = "a light 0.05 above a floor 1e8 away, given with w = 0.7",
               .measured = "largest error of an element, as a part of the light's height",
               .naive = "light − origin w, rounded twice",
               .naiveError = error(textbook<double>(vec4(vec3(from) - origin * w, w), vec4(n, 0))),
               .ours = "shadowProjection with origin",
               .ourError = error(shadowProjection(from, plane, origin)),
               .tolerance = 1e-15,
               .reason = "the difference is rounded once, a few roundings of the matrix follow"};
});

// A light near the origin over a floor far away: of its height only what lies along the normal belongs into w'.
[[maybe_unused]] const bool y08 = addRow([] {
    const vec3 n = glm::normalize(vec3(1, -2, 2.5));
    const vec4 from(0.3, 0.4, 0.5, 1), plane(n, 1e9);
    const Wide truth = dot(normalized(wide(n)), wide(vec3(from)));
    const auto error = [&](double value) { return static_cast<double>(abs(Wide(value) / truth - 1)); };
    return Row{.id = "Y08",
               .input = "a light 0.7 from the origin, a floor 1e9 away",
               .measured = "relative error of the height at which casters end, at the origin",
               .naive = "n·L + d w, less d w",
               .naiveError = error(glm::dot(plane, from) - plane.w * from.w),
               .ours = "shadowCasterBounds",
               .ourError = error(shadowCasterBounds(from, plane)[1].w),
               .tolerance = 1e-14,
               .reason = "three products, which cancel to a tenth here"};
});

}  // namespace
