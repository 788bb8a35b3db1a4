#include "mirrors.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "mv/error.h"
#include "mv/math/clip.h"
#include "mv/math/require.h"
#include "mv/math/shadow.h"

namespace mv {
namespace {

// The edges of a polygon in clip space: the planes through the eye (x = y = w = 0) and its edges, towards its inside.
std::vector<vec4> edgesOf(const std::vector<vec4>& outline) {
    const auto flat = [](const vec4& p) { return vec3(p.x, p.y, p.w); };
    vec3 inside(0);
    for (const vec4& corner : outline) inside += flat(corner) / corner.w;
    std::vector<vec4> edges;
    edges.reserve(outline.size());
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const vec3 across = glm::cross(flat(outline[i]), flat(outline[(i + 1) % outline.size()]));
        const double side = glm::dot(across, inside);
        if (side != 0) edges.push_back((side > 0 ? 1.0 : -1.0) * vec4(across.x, across.y, 0, across.z));
    }
    return edges;
}

}  // namespace

vec4 Mirror::plane() const {
    const vec3 normal = glm::normalize(glm::cross(halfU, halfV));
    return {normal, -glm::dot(normal, middle)};
}

std::array<vec3, 4> Mirror::corners() const {
    return {middle - halfU - halfV, middle + halfU - halfV, middle + halfU + halfV, middle - halfU + halfV};
}

std::vector<vec4> edgesOfView() { return {clipVolume().begin(), clipVolume().end()}; }

std::vector<std::vector<SeenMirror>> mirrorChains(std::span<const Mirror> mirrors, const mat4& clipFromWorld,
                                                  int most) {
    if (mirrors.size() > 2)
        throw Error("mirrorChains", "must be given two mirrors at most", std::to_string(mirrors.size()));
    // The eye is the point whose x, y and w are 0.
    const vec4 clip = glm::inverse(clipFromWorld) * vec4(0, 0, 1, 0);
    requireFinite("mirrorChains", "the eye", clip);
    const vec3 eye = vec3(clip) / clip.w;

    std::vector<std::vector<SeenMirror>> chains;
    for (std::size_t first = 0; first < mirrors.size(); ++first) {
        std::vector<SeenMirror> chain;
        mat4 worldFromMirror(1);
        std::vector<vec4> edges = edgesOfView();
        for (std::size_t which = first; which < mirrors.size() && static_cast<int>(chain.size()) < most;) {
            const Mirror& mirror = mirrors[which];
            const vec3 imagedEye(glm::inverse(worldFromMirror) * vec4(eye, 1));
            if (lightSide(vec4(imagedEye, 1), mirror.plane()) <= 0) break;
            std::vector<vec4> outline;
            for (const vec3& corner : mirror.corners())
                outline.push_back(clipFromWorld * worldFromMirror * vec4(corner, 1));
            outline = clipPolygon(outline, edges);
            if (outline.size() < 3) break;
            edges = edgesOf(outline);
            if (edges.size() < 3) break;  // seen exactly from the side
            const mat4 worldFromShown = worldFromMirror * reflection(mirror.plane());
            chain.push_back({which, worldFromMirror, worldFromShown, outline, edges});
            worldFromMirror = worldFromShown;
            if (mirrors.size() == 1) break;
            which = 1 - which;
        }
        if (!chain.empty()) chains.push_back(std::move(chain));
    }
    return chains;
}

bool areBeyond(std::span<const vec4> points, std::span<const vec4> halfSpaces) {
    return std::any_of(halfSpaces.begin(), halfSpaces.end(), [&](const vec4& bound) {
        return std::all_of(points.begin(), points.end(), [&](const vec4& p) { return glm::dot(bound, p) < 0; });
    });
}

// Planes are rows, so the same matrix maps them the other way.
vec4 planeIn(const mat4& worldFromOther, const vec4& plane) { return plane * worldFromOther; }

mat4 withNearPlane(const mat4& clipFromView, const vec4& plane) {
    if (plane.w >= 0) throw Error("withNearPlane", "must be given a plane with the eye behind it", numberText(plane.w));
    const mat4 viewFromClip = glm::inverse(clipFromView);
    // Keep within the new far plane the corner of the old one that is farthest in front of the plane.
    const vec4 inClip = plane * viewFromClip;
    const vec4 corner = viewFromClip * vec4(inClip.x < 0 ? -1 : 1, inClip.y < 0 ? -1 : 1, 1, 1);
    const vec4 w(clipFromView[0].w, clipFromView[1].w, clipFromView[2].w, clipFromView[3].w);
    // z = -w on the plane, and z = w at that corner
    const vec4 z = 2 * glm::dot(w, corner) / glm::dot(plane, corner) * plane - w;
    mat4 result = clipFromView;
    for (int column = 0; column < 4; ++column) result[column].z = z[column];
    return result;
}

}  // namespace mv
