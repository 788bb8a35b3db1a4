// cube-shadows: shadows of what stands before a floor and a wall, by one matrix for any plane and any light.
#include "cube-shadows.h"

#include <array>

#include "mv/demo/seen.h"
#include "mv/gl/state.h"
#include "mv/math/shadow.h"
#include "mv/math/shadow_textbook.h"
#include "mv/math/transform.h"

namespace mv::cube_shadows {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Scene scene = seen(sceneOf(s, frame), frame);
    gpu.meshes.follow(scene);
    tell(s, scene, frame);

    // Draw the scene without shadows. The stencil buffer stores for each pixel the tag of the plane seen there, or 0
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    drawSurfaces(gpu, s, scene);
    drawEdgesAndLamp(gpu, s, scene, frame);

    // Draw the casters again, flattened onto each plane, where the tag shows that this plane is seen. The tag replaces
    // the depth test, so shadow and plane do not z-fight
    glDisable(GL_DEPTH_TEST);
    drawShadows(gpu, s, scene);
}

static void setSeen(bool isSeen) {
    const GLboolean seen = isSeen;
    glColorMask(seen, seen, seen, seen);
    glDepthMask(seen);
}

void drawSurfaces(Gpu& gpu, const Settings& s, const Scene& scene) {
    const auto objects = gpu.meshes.of(scene);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    gpu.surfaces.use();
    gpu.surfaces.set("clipFromView", scene.clipFromView);
    gpu.surfaces.set("viewLight", scene.viewFromWorld * lightOf(s));
    for (const auto& [object, mesh] : objects) {
        if (object.casts) drawSurface(gpu, scene, mesh, object.worldFromObject);
    }

    // Tag the plane of the scene `plane` without drawing it: the course's program has no visible plane
    setSeen(s.scene != Which::plane);
    for (const Ground& ground : groundsOf(s)) {
        const auto& [object, mesh] = objects[ground.object.index];
        glStencilFunc(GL_ALWAYS, showsFront(s, ground.plane) ? ground.tag : 0, 0xFF);
        drawSurface(gpu, scene, mesh, object.worldFromObject);
    }
    setSeen(true);
    glStencilFunc(GL_ALWAYS, 0, 0xFF);
}

void drawSurface(Gpu& gpu, const Scene& scene, const Mesh& mesh, const mat4& worldFromModel) {
    gpu.surfaces.set("viewFromModel", scene.viewFromWorld * worldFromModel);
    mesh.draw();
}

void drawShadows(Gpu& gpu, const Settings& s, const Scene& scene) {
    // Multiply the colour of the plane. With `once`, the first shadow sets the tag to 0, so that no second one follows
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    glStencilOp(GL_KEEP, GL_KEEP, s.once ? GL_ZERO : GL_KEEP);

    setEnabled(GL_CLIP_DISTANCE0, s.cut == Cut::clip);
    setEnabled(GL_CLIP_DISTANCE1, s.cut == Cut::clip);
    gpu.shadows.use();
    gpu.shadows.set("clipFromView", scene.clipFromView);
    gpu.shadows.set("darkness", s.darkness);
    gpu.shadows.set("cut", static_cast<int>(s.cut));

    for (const Ground& ground : groundsOf(s)) {
        const bool isUncut = s.cut == Cut::none && isLit(s, ground.plane);
        glStencilFunc(GL_EQUAL, ground.tag, 0xFF);
        for (const auto& [object, mesh] : gpu.meshes.castersOf(scene)) {
            if (isUncut || judged(s, object, ground).casts) drawShadow(gpu, s, scene, ground.plane, object, mesh);
        }
    }
}

// Cut off the parts of a caster that are not between plane and light: they cast no true shadow.
void drawShadow(Gpu& gpu, const Settings& s, const Scene& scene, const Plane& plane, const SceneObject& caster,
                const Mesh& mesh) {
    const auto [beforePlane, beforeLight] = shadowCasterBounds(plane.localOf(lightOf(s)), plane.local());
    const mat4 localFromModel = translate(-plane.origin) * caster.worldFromObject;
    gpu.shadows.set("beforePlane", beforePlane * localFromModel);  // the transpose of the matrix moves a half space
    gpu.shadows.set("beforeLight", beforeLight * localFromModel);
    gpu.shadows.set("viewFromModel", flattened(s, scene.viewFromWorld, plane, caster.worldFromObject));
    mesh.draw();
}

bool isLit(const Settings& s, const Plane& plane) { return lightSide(plane.localOf(lightOf(s)), plane.local()) > 0; }

// Judge whether some part of a caster is between plane and light, and if not, why.
CasterVerdict judged(const Settings& s, const SceneObject& caster, const Ground& ground) {
    const mat4 localFromModel = translate(-ground.plane.origin) * caster.worldFromObject;
    std::vector<vec3> corners;
    corners.reserve(caster.mesh.positions.size());
    for (const fvec3& corner : caster.mesh.positions) corners.emplace_back(localFromModel * vec4(corner, 1));
    return judgeCaster(caster.name, corners, ground.plane.localOf(lightOf(s)), ground.plane.local(), ground.kind);
}

template <class T>
static glm::mat<4, 4, T> textbook(Formula formula, const glm::vec<4, T>& light, const glm::vec<4, T>& plane) {
    if (formula == Formula::axisAligned) return textbookShadowAcrossAxis(light, plane);
    return textbookShadow(light, plane, formula == Formula::transposed);
}

// The one matrix that takes a point of the model, flattens it onto the plane, and goes on to the space `target`. The product is
// formed before the upload. Keep large coordinates away from the shadow's matrix: both of its sides are relative to the plane's point.
static mat4 flattenedLocally(const Settings& s, const mat4& targetFromWorld, const Plane& plane,
                             const mat4& worldFromModel) {
    const mat4 flat = s.formula == Formula::general ? shadowProjection(lightOf(s), plane.inWorld(), plane.origin)
                                                    : textbook(s.formula, plane.localOf(lightOf(s)), plane.local());
    return (targetFromWorld * translate(plane.origin)) * flat * (translate(-plane.origin) * worldFromModel);
}

// The same in world coordinates, in double or in float.
static mat4 flattenedInWorld(const Settings& s, const mat4& targetFromWorld, const Plane& plane,
                             const mat4& worldFromModel) {
    const mat4 flat = s.formula == Formula::general ? shadowProjection(lightOf(s), plane.inWorld())
                                                    : textbook(s.formula, lightOf(s), plane.inWorld());
    return targetFromWorld * flat * worldFromModel;
}
static mat4 flattenedInFloat(const Settings& s, const mat4& targetFromWorld, const Plane& plane,
                             const mat4& worldFromModel) {
    const fmat4 flat = textbook(s.formula, fvec4(lightOf(s)), fvec4(plane.inWorld()));
    return mat4(fmat4(targetFromWorld) * flat * fmat4(worldFromModel));
}

mat4 flattened(const Settings& s, const mat4& targetFromWorld, const Plane& plane, const mat4& worldFromModel) {
    constexpr std::array ofSpace{flattenedLocally, flattenedInWorld, flattenedInFloat};  // in the order of Space
    return ofSpace.at(std::size_t(s.space))(s, targetFromWorld, plane, worldFromModel);
}

}  // namespace mv::cube_shadows
