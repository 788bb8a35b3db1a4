// soft-shadows: the shadow of a lamp that has a size: by many points, by a blur, and by a blur that asks how wide.
#include "soft-shadows.h"

#include "mv/demo/seen.h"
#include "mv/gl/gl.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"

namespace mv::soft_shadows {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Scene scene = seen(sceneOf(s, frame), frame);
    const std::vector<vec3> points = pointsOf(s, scene.lights[0]);
    frame.show("clipFromWorld", scene.clipFromWorld());
    frame.count("points", double(points.size()));
    gpu.meshes.follow(scene);

    // Add up the darkness of each pixel
    glEnable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glBlendFunc(GL_ONE, GL_ONE);
    if (!isByPoints(s)) keepMap(gpu, s, scene);
    clearDarkness(gpu, s, scene, frame);
    const bool blursPicture = s.method == Method::blur;
    if (s.method == Method::matrix)
        addByMatrix(gpu, scene, points);
    else if (s.method == Method::maps)
        addByMaps(gpu, s, scene, points);
    else if (s.method == Method::pcss)
        addByPcss(gpu, s, scene);
    else
        addByMap(gpu, scene, points.front(), 1, blursPicture ? 1 : s.taps);

    // Shade the scene by the part of the lamp that reaches each pixel. Only a blur in the picture reads neighbouring pixels
    frame.bindTarget();
    gpu.darkness.bindColor(0);
    shade(gpu, scene, blursPicture ? s.taps : 1);
}

static void drawPlain(Gpu& gpu, const mat4& clipFromWorld, const SceneObject& object, const Mesh& mesh) {
    gpu.plain.set("clipFromObject", clipFromWorld * object.worldFromObject);
    mesh.draw();
}

// Clear the darkness, and draw the depths of the visible surfaces, so that only these are darkened.
void clearDarkness(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame) {
    gpu.darkness.begin(frame.width(), frame.height(),
                       {.depth = true,
                        .stencil = s.method == Method::matrix,
                        .color = s.accumulate == Sum::floats ? GLenum(GL_R32F) : GLenum(GL_R8),
                        .texture = true},
                       "darkness");
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gpu.plain.use();
    for (const auto& [object, mesh] : gpu.meshes.of(scene)) drawPlain(gpu, scene.clipFromWorld(), object, mesh);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

// Flatten the casters onto the floor, once for each point. Where shadows of one point overlap, only the first darkens: each
// point has a number, from 254 down, darkens only pixels whose stencil value is above its number, and writes it there.
void addByMatrix(Gpu& gpu, const Scene& scene, const std::vector<vec3>& points) {
    constexpr vec4 floor(0, 1, 0, 0);
    glEnable(GL_BLEND);
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glDepthMask(GL_FALSE);
    const auto objects = gpu.meshes.of(scene), casters = gpu.meshes.castersOf(scene);
    const auto& [ground, groundMesh] = objects.front();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto turn = static_cast<GLint>(i % 254);
        if (turn == 0) {
            // Begin at 255 again, where the floor is seen
            glDepthFunc(GL_EQUAL);
            glStencilFunc(GL_ALWAYS, 255, 255);
            gpu.plain.set("color", vec4(0));
            drawPlain(gpu, scene.clipFromWorld(), ground, groundMesh);
            glDepthFunc(GL_ALWAYS);
            gpu.plain.set("color", vec4(1.0 / double(points.size())));
        }
        glStencilFunc(GL_LESS, 254 - turn, 255);
        const mat4 clipFromShadow = scene.clipFromWorld() * shadowProjection(vec4(points[i], 1), floor);
        for (const auto& [caster, mesh] : casters) drawPlain(gpu, clipFromShadow, caster, mesh);
    }
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_BLEND);
}

// Draw a map from each point, one after the other, into the same texture.
void addByMaps(Gpu& gpu, const Settings& s, const Scene& scene, const std::vector<vec3>& points) {
    for (const vec3& point : points) {
        gpu.lightOfMap = viewFrom(scene, point);
        drawMap(gpu, s, scene);
        gpu.darkness.bind();
        addByMap(gpu, scene, point, 1.0 / double(points.size()), 1);
    }
    gpu.mapFor.forget();
}

// Draw an object into the picture, with the place on the map of each of its points.
static void drawLookedUp(const Gpu& gpu, const Program& program, const Scene& scene, const SceneObject& object,
                         const Mesh& mesh) {
    program.set("clipFromObject", scene.clipFromWorld() * object.worldFromObject);
    program.set("mapFromObject", gpu.lightOfMap.mapFromWorld() * object.worldFromObject);
    mesh.draw();
}

// Add the darkness by the map drawn from `point`, times this share of the lamp, averaged over side x side texels.
void addByMap(Gpu& gpu, const Scene& scene, const vec3& point, double share, int side) {
    const Program& program = *gpu.byMap;
    glEnable(GL_BLEND);
    glDepthFunc(GL_EQUAL);
    gpu.map.bind(0, DepthLookup::compareNearest);
    program.use();
    program.set("map", 0);
    program.set("share", share);
    program.set("side", side);
    program.set("light", point);
    for (const auto& [object, mesh] : gpu.meshes.of(scene)) {
        program.set("worldFromObject", object.worldFromObject);
        drawLookedUp(gpu, program, scene, object, mesh);
    }
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
}

// Search, in the shader, the pyramid from each pixel to the lamp for casters, and average over a square sized by their distance.
void addByPcss(Gpu& gpu, const Settings& s, const Scene& scene) {
    const SceneLight& lamp = scene.lights[0];
    const mat4 mapFromWorld = gpu.lightOfMap.mapFromWorld();
    const Program& program = *gpu.byPcss;
    glDepthFunc(GL_EQUAL);
    gpu.map.bind(0, DepthLookup::depth);
    program.use();
    program.set("map", 0);
    program.set("mapLamp", mapFromWorld * lamp.position);
    program.set("mapHalfU", mapFromWorld * vec4(lamp.halfU, 0));
    program.set("mapHalfV", mapFromWorld * vec4(lamp.halfV, 0));
    program.set("near", gpu.lightOfMap.bounds.near);
    program.set("far", gpu.lightOfMap.bounds.far);
    program.set("side", s.taps);
    program.set("isDisc", s.lampShape == Shape::disc);
    for (const auto& [object, mesh] : gpu.meshes.of(scene)) drawLookedUp(gpu, program, scene, object, mesh);
    glDepthFunc(GL_LESS);
}

void shade(Gpu& gpu, const Scene& scene, int side) {
    const Program& program = gpu.shading;
    program.use();
    program.set("darkness", 0);
    program.set("side", side);
    program.set("lamp", vec3(scene.lights[0].position));
    for (const auto& [object, mesh] : gpu.meshes.of(scene)) {
        program.set("clipFromObject", scene.clipFromWorld() * object.worldFromObject);
        program.set("worldFromObject", object.worldFromObject);
        program.set("worldFromNormal", normalMatrix(object.worldFromObject));
        program.set("color", object.color);
        mesh.draw();
    }
}

// Draw the map from the lamp's middle, unless the one of the last frame still holds.
void keepMap(Gpu& gpu, const Settings& s, const Scene& scene) {
    gpu.lightOfMap = viewFrom(scene, vec3(scene.lights[0].position));
    if (gpu.mapFor.changed(s.scene, s.resolution, gpu.lightOfMap.clipFromWorld(), casterPlaces(scene)))
        drawMap(gpu, s, scene);
}

void drawMap(Gpu& gpu, const Settings& s, const Scene& scene) {
    gpu.map.begin(s.resolution, "map");
    glClear(GL_DEPTH_BUFFER_BIT);
    // Push what casts back by two texels of its slope, so that no surface shades itself
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2, 4);
    gpu.plain.use();
    for (const auto& [caster, mesh] : gpu.meshes.castersOf(scene))
        drawPlain(gpu, gpu.lightOfMap.clipFromWorld(), caster, mesh);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

// The lamp looks straight down, and the map holds all casters.
LightView viewFrom(const Scene& scene, const vec3& point) {
    return fitLightView(point, vec3(0, -1, 0), scene.lights[0].halfV, casterPoints(scene), 0.1);
}

bool isByPoints(const Settings& s) { return s.method == Method::matrix || s.method == Method::maps; }

}  // namespace mv::soft_shadows
