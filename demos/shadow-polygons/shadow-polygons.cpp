// shadow-polygons: the shadows of polygons on polygons, computed as polygons; a sphere round the light tells which pairs to try.
#include "shadow-polygons.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "mv/demo/seen.h"
#include "mv/gl/gl.h"

namespace mv::shadow_polygons {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    follow(gpu, s);
    const Pane pane = drawnPane(s, frame);
    const Scene scene = seen(sceneOf(s, {frame.index(), pane.width, pane.height}), frame);
    frame.show("clipFromWorld", scene.clipFromWorld());
    frame.count("projections", double(gpu.shadows.pairs.kept.size()));

    // Draw the polygons as if nothing stood between them and the light, and store in the stencil buffer which one is seen
    glViewport(pane.x, pane.y, pane.width, pane.height);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    gpu.program.use();
    gpu.program.set("clipFromWorld", scene.clipFromWorld());
    gpu.program.set("light", vec4(s.light, 1));
    gpu.program.set("lit", 1.0);
    drawParts(gpu.whole, GL_ALWAYS);

    // Draw the dark parts of each where it is seen. No depth tells them apart from what they lie on
    glDisable(GL_DEPTH_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gpu.program.set("lit", 0.0);
    drawParts(gpu.dark, GL_EQUAL);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
    glViewport(0, 0, frame.width(), frame.height());
}

// Draw what belongs to each polygon where the stencil buffer passes its number, which is its place, from 1.
void drawParts(const Parts& parts, GLenum passes) {
    for (const Part& part : parts.list) {
        glStencilFunc(passes, int(part.polygon) + 1, ~0U);
        parts.mesh.draw(part.first, part.count);
    }
}

// Find the shadows, unless light and polygons are those of the frame before: no shadow depends on the eye.
void follow(Gpu& gpu, const Settings& s) {
    if (!gpu.madeFor.changed(s.scene, s.method, s.polygons, s.size, s.light)) return;
    gpu.polygons = polygonsOf(s);
    gpu.caps.clear();
    for (const FlatPolygon& polygon : gpu.polygons) gpu.caps.push_back(capOf(polygon, s.light));
    gpu.shadows = shadowsOf(s.method, gpu.polygons, s.light);
    gpu.whole = partsOf(gpu.polygons, s.light);
    gpu.dark = partsOf(gpu.shadows.dark, gpu.polygons);
}

using Polygons = std::vector<FlatPolygon>;

// Choose the pairs of casters and receivers to try: none, all, or those that overlap on the sphere round the light.
static Pairs withoutPairs(const Polygons&, const vec3&) { return {}; }
static Pairs everyPair(const Polygons& polygons, const vec3&) { return allPairs(polygons.size()); }
static Pairs pairsBySphere(const Polygons& polygons, const vec3& light) {
    std::vector<Cap> caps;
    for (const FlatPolygon& polygon : polygons) caps.push_back(capOf(polygon, light));
    return pairsOnSphere(caps);
}

// Project each caster of a pair onto its receiver.
Shadows shadowsOf(Method method, const Polygons& polygons, const vec3& light) {
    constexpr std::array ofMethod{withoutPairs, everyPair, pairsBySphere};  // in the order of Method
    Shadows shadows{.pairs = ofMethod.at(std::size_t(method))(polygons, light), .dark = {}};
    std::vector<std::optional<Receiver>> receivers;
    for (const FlatPolygon& polygon : polygons) receivers.push_back(receiverOf(polygon, light));
    for (const CasterOn& pair : shadows.pairs.kept) {
        if (!receivers[pair.receiver]) continue;
        std::vector<vec3> corners = shadowOn(*receivers[pair.receiver], polygons[pair.caster]);
        if (!corners.empty()) shadows.dark.push_back({pair, std::move(corners)});
    }
    return shadows;
}

static void addFan(MeshData& mesh, const std::vector<vec3>& corners, const vec3& normal, const vec3& color) {
    for (std::size_t i = 2; i < corners.size(); ++i) {
        for (const std::size_t k : {std::size_t(0), i - 1, i}) {
            mesh.positions.emplace_back(corners[k]);
            mesh.normals.emplace_back(normal);
            mesh.colors.emplace_back(vec4(color, 1));
        }
    }
}

static vec3 normalOf(const std::vector<vec3>& corners) {
    return glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
}

// Add a polygon as triangles with its front towards the light.
void addPolygon(MeshData& mesh, const FlatPolygon& polygon, const vec3& light) {
    std::vector<vec3> corners = polygon.corners;
    if (glm::dot(normalOf(corners), light - corners[0]) < 0) std::reverse(corners.begin(), corners.end());
    addFan(mesh, corners, normalOf(corners), polygon.color);
}

Parts partsOf(const std::vector<FlatPolygon>& polygons, const vec3& light) {
    Parts parts;
    MeshData mesh;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const std::size_t first = mesh.positions.size();
        addPolygon(mesh, polygons[i], light);
        parts.list.push_back({i, first, mesh.positions.size() - first});
    }
    parts.mesh = Mesh(mesh, "polygons");
    return parts;
}

// The dark parts of one receiver follow each other, and are one part to draw.
Parts partsOf(const std::vector<Shadow>& dark, const std::vector<FlatPolygon>& polygons) {
    Parts parts;
    MeshData mesh;
    for (const Shadow& shadow : dark) {
        const std::size_t receiver = shadow.of.receiver, first = mesh.positions.size();
        if (parts.list.empty() || parts.list.back().polygon != receiver) parts.list.push_back({receiver, first, 0});
        addFan(mesh, shadow.corners, vec3(0, 1, 0), polygons[receiver].color);  // without light no normal counts
        parts.list.back().count += mesh.positions.size() - first;
    }
    if (!dark.empty()) parts.mesh = Mesh(mesh, "dark parts");
    return parts;
}

}  // namespace mv::shadow_polygons
