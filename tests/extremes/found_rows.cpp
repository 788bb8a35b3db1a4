// Y09 to Y19: what a search for the worst arguments (tests/adversary) found, and the forms that failed there.
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/math/clip.h"
#include "mv/math/projection.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

double relative(double value, const Wide& truth) { return static_cast<double>(abs(Wide(value) / truth - 1)); }

[[maybe_unused]] const bool y09 = addRow([] {
    double naive = 0, ours = 0;
    for (const double size : {1e200, 1e-200, 1e120}) {
        // A large corner and a small one: 3 long, 2 high
        const double high = size == 1e120 ? 1e-120 : size;
        const std::vector<vec3> corners{{0, 0, 0}, {3 * size, 0, 0}, {3 * size, 2 * high, 0}, {0, 2 * high, 0}};
        const Wide truth = Wide(3 * size) * Wide(2 * high);
        if (truth > Wide(1e308) || truth < Wide(1e-300)) {
            // No double is the area: infinity has to be refused, and 0 is right.
            naive += std::isinf(glm::length(glm::cross(corners[2], corners[3]))) ? 1 : 0;
            ours += truth > 1 ? accepted([&] { polygonArea(corners); }) : polygonArea(corners);
            continue;
        }
        const vec3 sum = glm::cross(corners[1], corners[2]) + glm::cross(corners[2], corners[3]);
        naive = worse(naive, relative(glm::length(sum) / 2, truth));
        ours = worse(ours, relative(polygonArea(corners), truth));
    }
    return Row{.id = "Y09",
               .input = "rectangles 1e200, 1e-200, and 1e120 long and 1e-120 high",
               .measured = "relative error of the area, or 1 where infinity is returned",
               .naive = "half the length of the sum of cross products",
               .naiveError = naive,
               .ours = "polygonArea",
               .ourError = ours,
               .tolerance = 1e-15,
               .reason = "products of edges of size 1, four roundings and a root: 8e-16"};
});

[[maybe_unused]] const bool y10 = addRow([] {
    double naive = 0, ours = 0;
    for (const double size : {1e200, 1e-200}) {
        const vec4 inside(size, 0, 0, 0), outside(-2 * size, 3 * size, 0, 0), bound[] = {size * vec4(1, 0, 0, 0)};
        const double in = glm::dot(bound[0], inside), out = glm::dot(bound[0], outside);
        const auto error = [&](const vec4& end) {
            return distance({{0, 1, 0}}, {{Wide(end.x) / size, Wide(end.y) / size, Wide(end.z) / size}});
        };
        const vec4 plain = inside + (in / (in - out)) * (outside - inside);
        naive = worse(naive, error(plain));
        const auto cut = clipPolygon({inside, outside}, bound);
        ours = worse(ours, cut.size() == 2 ? error(cut[1]) : infinite);
    }
    return Row{.id = "Y10",
               .input = "segments and bounds 1e200 and 1e-200 large",
               .measured = "how far the end at the cut is off, as a part of the segment",
               .naive = "in/(in − out), whose products overflow or vanish",
               .naiveError = naive,
               .ours = "clipPolygon",
               .ourError = ours,
               .tolerance = 1e-15,
               .reason = "a quotient, a product and a sum of size 3: 1.1e-16 each, times 3"};
});

[[maybe_unused]] const bool y11 = addRow([] {
    const mat4 camera = 1e-161 * perspective(50, 1.5, 0.1, 100);
    const auto off = [](const vec4& plane) {
        return std::abs(static_cast<double>(length(firstThree(wide(plane))) - 1));
    };
    double naive = 0, ours = 0;
    const mat4 rows = glm::transpose(camera);
    const auto planes = planesFromClip(camera);
    for (int i = 0; i < 6; ++i) {
        const vec4 plane = i % 2 == 0 ? rows[3] + rows[i / 2] : rows[3] - rows[i / 2];
        naive = worse(naive, off(plane / glm::length(vec3(plane))));
        ours = worse(ours, off(planes[static_cast<std::size_t>(i)]));
    }
    return Row{.id = "Y11",
               .input = "a camera's matrix times 1e-161, of which the squares have lost most digits but not all",
               .measured = "how far the planes' normals are from unit length",
               .naive = "divided by their length",
               .naiveError = naive,
               .ours = "planesFromClip: rows brought to a size of 1 first",
               .ourError = ours,
               .tolerance = 1e-15,
               .reason = "three squares, a root and a quotient: five roundings"};
});

[[maybe_unused]] const bool y12 = addRow([] {
    const double fovy = 179.9999, aspect = 1e305;
    const double tangent = std::tan(radians(fovy) / 2) * aspect, length = std::hypot(1.0, tangent);
    const auto off = [](double x, double z) {
        return std::isfinite(x) && std::isfinite(z) ? std::abs(z + 1) : infinite;
    };
    const auto plane = perspectivePlanes(fovy, aspect, 1, 2)[leftPlane];
    return Row{.id = "Y12",
               .input = "fovy 1e-4 degrees below 180 and aspect 1e305, which perspective accepts",
               .measured = "error of the left plane's normal, which points along −z",
               .naive = "(1, 0, −tan)/√(1 + tan²)",
               .naiveError = off(1 / length, -tangent / length),
               .ours = "perspectivePlanes: by the cotangent",
               .ourError = off(plane.x, plane.z),
               .tolerance = 0,
               .reason = "the other component is 1e-311: it cannot be seen in a 1"};
});

[[maybe_unused]] const bool y13 = addRow([] {
    const double fovy = 1e-9, near = 1e-300, aspect = 1e9;
    const Wide half = wideRadians(fovy) / 2, truth = Wide(near) * sin(half) / cos(half) * Wide(aspect);
    const double tangent = std::tan(radians(fovy) / 2);
    return Row{.id = "Y13",
               .input = "a window of fovy 1e-9 at near 1e-300, a billion times as wide as high",
               .measured = "relative error of its right edge",
               .naive = "the top times the aspect, though the top has but a few digits",
               .naiveError = relative(near * tangent * aspect, truth),
               .ours = "frustumBounds",
               .ourError = relative(frustumBounds(fovy, aspect, near, 1).right, truth),
               .tolerance = 1e-15,
               .reason = "a tangent and three products: 7e-16"};
});

[[maybe_unused]] const bool y14 = addRow([] {
    const double near = 1e-3, far = 1e3;
    const mat4 clipFromView = perspective(60, 1.5, near, far);
    // The corner of this very matrix at x, y, z = 1
    const Wide depth = Wide(clipFromView[3][2]) / (Wide(clipFromView[2][2]) + 1);
    const auto error = [&](const vec3& corner) {
        const Wide3 truth{{depth / Wide(clipFromView[0][0]), depth / Wide(clipFromView[1][1]), -depth}};
        return distance(truth, wide(corner)) / far;
    };
    const vec4 plain = glm::inverse(clipFromView) * vec4(1);
    return Row{.id = "Y14",
               .input = "a camera with far/near = 1e6",
               .measured = "how far a far corner is from that of the same matrix, as a part of far",
               .naive = "glm::inverse in double, divided by w",
               .naiveError = error(vec3(plain) / plain.w),
               .ours = "viewVolumeCorners: elimination, mended by the rest in twice the digits",
               .ourError = error(viewVolumeCorners(clipFromView)[7]),
               .tolerance = 1e-15,
               .reason = "the solution is rounded last, and then divided: some roundings of it"};
});

[[maybe_unused]] const bool y15 = addRow([] {
    const mat4 m = scale(1, 1e-170, 1e-170);
    const vec3 x(m[0]), y(m[1]), z(m[2]);
    const auto off = [](const vec3& normal) {
        if (normal == vec3(0)) return infinite;
        return static_cast<double>(length(cross(normalized(wide(normal)), {{1, 0, 0}})));
    };
    return Row{.id = "Y15",
               .input = "a rod: scale(1, 1e-170, 1e-170)",
               .measured = "angle between the normal of its end and the true one (rad); inf: no normal",
               .naive = "cofactors, scaled all alike",
               .naiveError = off(glm::cross(y, z)),
               .ours = "normalMatrix: each column scaled by itself",
               .ourError = off(normalMatrix(m)[0]),
               .tolerance = 0,
               .reason = "powers of two and products with 0"};
});

// The columns are nearly in one plane: on which side the third one lies rounding decides, in them and not after them.
[[maybe_unused]] const bool y16 = addRow([] {
    Random random(16);
    double naive = 0, ours = 0;
    for (int i = 0; i < 1000; ++i) {
        const vec3 x = random.direction(), y = random.direction();
        const vec3 z = random.number(-1, 1) * x + random.number(-1, 1) * y;
        const mat4 m(vec4(x, 0), vec4(y, 0), vec4(z, 0), vec4(0, 0, 0, 1));
        const Wide determinant = dot(cross(wide(x), wide(y)), wide(z));
        if (determinant == 0) continue;
        const Wide3 truth = (determinant < 0 ? Wide(-1) : Wide(1)) * cross(wide(y), wide(z));
        const auto isWrong = [&](const vec3& normal) { return dot(truth, wide(normal)) > 0 ? 0 : 1; };
        naive += isWrong((glm::determinant(mat3(m)) < 0 ? -1.0 : 1.0) * glm::cross(y, z));
        ours += isWrong(normalMatrix(m)[0]);
    }
    return Row{.id = "Y16",
               .input = "1000 matrices whose columns are in a plane but for rounding",
               .measured = "normals that point to the wrong side",
               .naive = "cofactors with the sign of the determinant in double",
               .naiveError = naive,
               .ours = "normalMatrix: the sign of the exact determinant",
               .ourError = ours,
               .tolerance = 0,
               .reason = "a sign is right or wrong; 24 parts that do not overlap hold the determinant exactly"};
});

[[maybe_unused]] const bool y17 = addRow([] {
    const double tiny = 0x1p-1066;
    const vec4 plane(3 * tiny, 5 * tiny, 0, 2 * tiny), from(0, 10, 0, 1);
    const Wide truth = 2 / sqrt(Wide(34));  // the plane's distance
    const vec3 direction = glm::normalize(vec3(3, 5, 0));
    return Row{.id = "Y17",
               .input = "a plane whose normal is 1e-320 long",
               .measured = "relative error of its distance from the origin",
               .naive = "d/(n · direction), though that length has but a few digits",
               .naiveError = relative(plane.w / glm::dot(direction, vec3(plane)), truth),
               .ours = "shadowCasterBounds: the normal scaled first",
               .ourError = relative(shadowCasterBounds(from, plane)[0].w, truth),
               .tolerance = 1e-15,
               .reason = "a unit vector, its product with the normal and a quotient: 8e-16"};
});

[[maybe_unused]] const bool y18 = addRow([] {
    // The near plane's normal is what is left of 2e272 and its neighbour
    mat4 clipFromWorld = scale(1, 1, 0);
    clipFromWorld[2][2] = -2e272 * (1 - 1e-9);
    clipFromWorld[2][3] = 2e272;
    clipFromWorld[3][3] = 5e-46;
    const mat4 rows = glm::transpose(clipFromWorld);
    const vec4 scaled = rows[3] * 0x1p-905 + rows[2] * 0x1p-905;
    const Wide truth = Wide(5e-46) / (Wide(2e272) + Wide(clipFromWorld[2][2]));
    const auto steps = [&](double distance) {
        return static_cast<double>(abs(Wide(distance) - truth) / Wide(0x1p-1074));
    };
    return Row{.id = "Y18",
               .input = "a plane whose distance, 2.5e-309, is smaller than a double can hold with all digits",
               .measured = "how far the distance is off, in steps of the smallest double",
               .naive = "all of the row brought to a size of 1, then divided by the normal's length",
               .naiveError = steps(scaled.w / scaled.z),
               .ours = "planesFromClip: the normal and the distance scaled each for itself",
               .ourError = steps(planesFromClip(clipFromWorld)[nearPlane].w),
               .tolerance = 1,
               .reason = "two quotients rounded, of which the last keeps no more digits than there are"};
});

[[maybe_unused]] const bool y19 = addRow([] {
    const mat4 clipFromWorld(0.1, 0.2, 0.3, 0, 0.4, 0.5, 0.6, 0, 0.7, 0.8, 0.9, 0, 0, 0, 0, 1);
    const auto off = [&](const vec3& corner) {
        return static_cast<double>(length(firstThree(wide(clipFromWorld) * wide(vec4(corner, 1))) - wide(vec3(1))));
    };
    const vec4 plain = glm::inverse(clipFromWorld) * vec4(1);
    return Row{.id = "Y19",
               .input = "0.1 to 0.9 in a matrix, which is singular but for the rounding of its entries",
               .measured = "how far from (1, 1, 1) the corner comes to lie that goes there",
               .naive = "glm::inverse in double, divided by w",
               .naiveError = off(vec3(plain) / plain.w),
               .ours = "viewVolumeCorners: answers only what the matrix takes back to the cube's corner",
               .ourError = off(viewVolumeCorners(clipFromWorld)[7]),
               .tolerance = 3e-15,
               .reason = "four roundings of each row's terms, which are 1.5 to 2.1 together"};
});

}  // namespace
