// The other way, by triangles: it asks which pixels a triangle covers, not what a pixel's ray meets. And the scene for OpenGL.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "cast_meshes.h"
#include "depth_raster.h"
#include "mv/demo/made_for.h"
#include "mv/demo/seen.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "ray-cast.h"

namespace mv::ray_cast {

// The settings that make the picture. The chosen pixel and the threads do not change it.
Settings withoutPixel(Settings s) {
    s.threads = 1;
    s.pixelX = s.pixelY = 0;
    return s;
}

bool isThere(const Settings& s, CastKind kind) {
    if (s.objects == Objects::all) return kind < CastKind::teapot;
    return s.objects == only(kind);
}
std::vector<CastKind> kindsOf(const Settings& s) {
    std::vector<CastKind> kinds;
    for (std::size_t i = 0; i < castKindNames.size(); ++i) {
        if (isThere(s, static_cast<CastKind>(i))) kinds.push_back(static_cast<CastKind>(i));
    }
    return kinds;
}
vec3 normalOf(const SceneTriangle& triangle) { return glm::cross(triangle.b - triangle.a, triangle.c - triangle.a); }

// Keep the triangles, so that a measured time is that of finding them, without the preparation.
std::shared_ptr<const Triangles> trianglesOf(const Settings& s) {
    static MadeFor<Objects, int> keptFor;
    static std::shared_ptr<const Triangles> kept;
    if (!keptFor.changed(s.objects, s.triangles)) return kept;
    Triangles made{castTriangles(kindsOf(s), static_cast<int>(std::lround(std::sqrt(s.triangles / 64.0)))), nullptr};
    if (isThere(s, CastKind::teapot)) made.tree = findTriangles(RayStructure::tree, made.all);
    return kept = std::make_shared<const Triangles>(std::move(made));
}

Shown shownBy(const Settings& s) { return {kindsOf(s), isThere(s, CastKind::teapot) ? trianglesOf(s) : nullptr}; }

// The same eye, without objects.
static Scene viewOf(const Settings& s) {
    Scene scene;
    const CastEye from = eyeOf(s);
    scene.viewFromWorld = lookAt(from.at, from.at - from.w, vec3(0, 1, 0));
    scene.clipFromView =
        perspective(2 * degrees(std::atan(from.half)), 1, s.size * (s.distance - 7), s.size * (s.distance + 7));
    return scene;
}

// Fill the triangles one after the other, and take from each pixel's depth the t of its ray.
static Seen rasterize(const Settings& s) {
    const auto triangles = trianglesOf(s);
    const Scene view = viewOf(s);
    const DepthRaster filled =
        rasterized(triangles->all, view.clipFromWorld() * scale(s.size, s.size, s.size), s.rows, s.rows);
    const mat4& p = view.clipFromView;
    Seen seen(filled.depth.size());
    for (std::size_t pixel = 0; pixel < seen.size(); ++pixel) {
        if (filled.triangle[pixel] < 0) continue;
        const SceneTriangle& in = triangles->all[static_cast<std::size_t>(filled.triangle[pixel])];
        const int place = static_cast<int>(pixel);
        // Undo the division: first the distance along -w, then along the ray
        const double before = p[3][2] / (filled.depth[pixel] + p[2][2]);
        const double t = before / -glm::dot(rayOf(s, place % s.rows, place / s.rows).direction, eyeOf(s).w);
        seen[pixel] = CastCandidate{{t, normalOf(in)}, static_cast<CastKind>(in.object)};
    }
    return seen;
}

Seen seenBy(const Settings& s) { return s.by == Maker::raster ? rasterize(s) : castRays(s); }
const Seen& keptSeen(Gpu& gpu, const Settings& s) {
    return gpu.seen.of({withoutPixel(s)}, [&] { return seenBy(s); });
}

static SceneObject teapotMesh(const Settings& s) {
    MeshData mesh;
    for (const SceneTriangle& one : trianglesOf(s)->all) {
        for (const vec3& corner : {one.a, one.b, one.c}) {
            mesh.positions.emplace_back(corner);
            mesh.normals.emplace_back(normalOf(one));
        }
    }
    return {.name = "teapot",
            .mesh = std::move(mesh),
            .worldFromObject = scale(s.size, s.size, s.size),
            .color = castColors.at(static_cast<std::size_t>(CastKind::teapot))};
}
Scene sceneOf(const Settings& s, const FrameInfo&) {
    Scene scene = viewOf(s);
    for (const CastKind kind : kindsOf(s))
        scene.objects.push_back(kind == CastKind::teapot ? teapotMesh(s) : castMesh(kind, s.size));
    return scene;
}

// 1 for a plane, and so on; 0 is the sky.
static double numberOf(const std::string& name) {
    return double(std::ranges::find(castKindNames, name) - castKindNames.begin()) + 1;
}

static void drawInto(Gpu& gpu, const Settings& s, const Scene& scene, const mat4& clipFromWorld, const Pane& pane) {
    glViewport(pane.x, pane.y, pane.width, pane.height);
    gpu.program.set("clipFromScene",
                    clipFromWorld * scale(s.size, s.size, s.size));  // all objects are in world space already
    for (const auto& [object, mesh] : gpu.meshes.of(scene)) {
        gpu.program.set("color", object.color);
        gpu.program.set("id", numberOf(object.name));
        mesh.draw();
    }
}

// Begin to draw the scene's triangles by OpenGL.
void beginTriangles(Gpu& gpu, const Scene& scene) {
    gpu.meshes.follow(scene);
    glEnable(GL_DEPTH_TEST);
    gpu.program.use();
    gpu.program.set("toLight", glm::normalize(vec3(0.5, 0.8, 0.35)));
}
void drawFromSide(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame) {
    drawInto(gpu, s, scene, fromSide(s, frame).clipFromWorld(), sidePane(frame));
    glViewport(0, 0, frame.width(), frame.height());
}
void drawByGl(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame) {
    drawInto(gpu, s, scene, scene.clipFromWorld(), picturePane(frame));
    glViewport(0, 0, frame.width(), frame.height());
}

// Draw for the study the number of each object, as the eye sees it.
void drawNumbers(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Scene scene = seen(sceneOf(s, frame), frame);
    beginTriangles(gpu, scene);
    drawInto(gpu, s, scene, scene.clipFromWorld(), {0, 0, frame.width(), frame.height()});
}

}  // namespace mv::ray_cast
