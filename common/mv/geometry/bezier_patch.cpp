#include "mv/geometry/bezier_patch.h"

#include <glm/geometric.hpp>
#include <string>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"

namespace mv {
namespace {

constexpr double largestPatch = 1e38;  // room below the largest float
constexpr int mostPatchDivisions = 256;

// Exact at both ends: at 0 it is a, at 1 it is b.
vec3 between(const vec3& a, const vec3& b, double t) { return (1 - t) * a + t * b; }

// A Bezier curve of N points.
template <std::size_t N>
vec3 curve(std::array<vec3, N> p, double t) {
    for (std::size_t left = N - 1; left > 0; --left) {
        for (std::size_t i = 0; i < left; ++i) p[i] = between(p[i], p[i + 1], t);
    }
    return p[0];
}
// Its derivative, which has one point less. A derivative between coinciding points of the net is exactly 0 here.
template <std::size_t N>
std::array<vec3, N - 1> derivative(const std::array<vec3, N>& p) {
    std::array<vec3, N - 1> d;
    for (std::size_t i = 0; i + 1 < N; ++i) d[i] = double(N - 1) * (p[i + 1] - p[i]);
    return d;
}

std::array<vec3, 4> rowOf(const BezierPatch& patch, std::size_t j) {
    return {patch.points[4 * j], patch.points[4 * j + 1], patch.points[4 * j + 2], patch.points[4 * j + 3]};
}

// The direction of alongU x alongV; of its derivative where it is 0 because one of them is.
vec3 normalAt(const vec3& alongU, const vec3& alongV, const vec3& mixed, double u, double v) {
    const vec3 zero(0);
    vec3 across = accurateCross(alongU, alongV);
    if (alongU == zero) across = (v == 1 ? -1.0 : 1.0) * accurateCross(mixed, alongV);
    if (alongV == zero) across = (u == 1 ? -1.0 : 1.0) * accurateCross(alongU, mixed);
    if (across == zero || !isFinite(across)) {
        throw Error("patch", "must have a normal: more than one edge of it has collapsed at this place",
                    vectorText(vec2(u, v)));
    }
    return unit(across);
}

void requirePart(std::string_view name, double part) {
    if (part >= 0 && part <= 1) return;  // false for NaN
    throw Error("patch", std::string(name) + " must be 0 to 1", numberText(part));
}

}  // namespace

SurfacePoint pointOf(const BezierPatch& patch, double u, double v) {
    requirePart("u", u);
    requirePart("v", v);
    std::array<vec3, 4> points, slopes;  // of each row at u
    for (std::size_t j = 0; j < 4; ++j) {
        points[j] = curve(rowOf(patch, j), u);
        slopes[j] = curve(derivative(rowOf(patch, j)), u);
    }
    SurfacePoint at{curve(points, v), curve(slopes, v), curve(derivative(points), v), vec3(0)};
    requireFinite("patch", "its points and derivatives", at.position + at.alongU + at.alongV);
    at.normal = normalAt(at.alongU, at.alongV, curve(derivative(slopes), v), u, v);
    return at;
}

MeshData tessellated(std::span<const BezierPatch> patches, int divisions) {
    requireRange("tessellated", "divisions", divisions, 1, mostPatchDivisions);
    MeshData mesh;
    const auto n = static_cast<std::uint32_t>(divisions);
    for (const BezierPatch& patch : patches) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (std::uint32_t j = 0; j <= n; ++j) {
            for (std::uint32_t i = 0; i <= n; ++i) {
                const double u = double(i) / n, v = double(j) / n;
                const SurfacePoint at = pointOf(patch, u, v);
                if (largestComponent(at.position) > largestPatch) {
                    throw Error("tessellated", "coordinates must be within 1e38", vectorText(at.position));
                }
                mesh.positions.emplace_back(at.position);
                mesh.normals.emplace_back(at.normal);
                mesh.texCoords.emplace_back(u, v);
            }
        }
        const auto addTriangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            const fvec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
            if (p != q && q != r && r != p) mesh.indices.insert(mesh.indices.end(), {a, b, c});
        };
        for (std::uint32_t j = 0; j < n; ++j) {
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint32_t corner = first + j * (n + 1) + i, above = corner + n + 1;
                addTriangle(corner, corner + 1, above + 1);
                addTriangle(corner, above + 1, above);
            }
        }
    }
    return mesh;
}

}  // namespace mv
