// shadow-volume: shadows counted in the stencil buffer, by the surface of the space that each solid keeps from the light.
#include "shadow-volume.h"

#include <algorithm>
#include <glm/matrix.hpp>

#include "mv/demo/seen.h"
#include "mv/math/transform.h"

namespace mv::shadow_volume {

// Seven bits count one group of casters after the other. The eighth notes that a count was not 0.
static constexpr GLuint wholeCount = 0xFF, inOneGroup = 0x7F, inSomeGroup = 0x80;

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Scene scene = seen(sceneOf(s, frame), frame);
    const vec4 light = scene.lights[0].position;
    gpu.meshes.follow(scene);
    followVolumes(gpu, s, scene);
    tell(gpu, s, scene, frame);

    // Draw the scene in full light, and fill the depth buffer
    glEnable(GL_DEPTH_TEST);
    gpu.program.use();
    gpu.program.set("light", light);
    drawObjects(gpu, scene, 1);

    // Count for each pixel the volumes round its surface. Colours and depths stay as they are
    const std::size_t casters = gpu.volumes.casters().size();
    glEnable(GL_STENCIL_TEST);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    GLuint inShadow = wholeCount;  // the bits of the stencil buffer that tell
    if (needsGroups(s, casters)) {
        countInGroups(gpu, s, scene);
        inShadow = inSomeGroup;
    } else {
        countVolumes(gpu, s, scene, 0, casters);
    }

    // Draw the scene again without the light, where the count is not 0
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glStencilFunc(GL_NOTEQUAL, 0, inShadow);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glDepthFunc(GL_EQUAL);
    gpu.program.use();
    drawObjects(gpu, scene, 0);
}

// Make each caster's volume anew where it or the light has moved. The geometry shader needs the casters alone.
void followVolumes(Gpu& gpu, const Settings& s, const Scene& scene) {
    if (isByShader(s)) return gpu.volumes.followCasters(scene);
    gpu.volumes.follow(scene, scene.lights[0].position, s.silhouette ? Extrude::silhouette : Extrude::everyTriangle);
}

// Count as many casters at a time as seven bits hold, and note after each group where the count is not 0.
void countInGroups(Gpu& gpu, const Settings& s, const Scene& scene) {
    const std::size_t casters = gpu.volumes.casters().size();
    for (std::size_t first = 0; first < casters; first += inOneGroup) {
        glStencilMask(inOneGroup);
        countVolumes(gpu, s, scene, first, std::min(first + inOneGroup, casters));
        glStencilMask(inSomeGroup);
        glStencilFunc(GL_NOTEQUAL, inSomeGroup, inOneGroup);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        drawEverywhere(gpu, vec4(0));
    }
}

// Count the volumes of the casters first .. last - 1 in the stencil buffer.
void countVolumes(Gpu& gpu, const Settings& s, const Scene& scene, std::size_t first, std::size_t last) {
    // Start a count from the eye with the volumes that contain the eye. Plain z-pass forgets them
    const int start = s.method == Method::zPassStarted ? volumesRoundEye(gpu, scene, first, last) & 0xFF : 0;
    if (start != 0 || first != 0) startCountAt(gpu, start);

    if (s.method == Method::zFail) {
        // Count the sides behind the surface: in through a back face, out through a front face
        glStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
        glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
    } else {
        // Count the sides before the surface: in through a front face, out through a back face
        glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
        glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
    }
    if (isByShader(s)) return drawSidesByShader(gpu, s, scene, first, last, vec4(0));
    gpu.volumeProgram.use();
    for (std::size_t i = first; i < last; ++i) {
        const Caster& caster = gpu.volumes.casters()[i];
        drawVolume(gpu, scene, caster, countedIndices(s, caster));
    }
}

// Write a number into the whole stencil buffer, within its mask.
void startCountAt(Gpu& gpu, int start) {
    glStencilFunc(GL_ALWAYS, start, ~0U);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    drawEverywhere(gpu, vec4(0));
    glStencilFunc(GL_ALWAYS, 0, ~0U);
}

void drawVolume(Gpu& gpu, const Scene& scene, const Caster& caster, std::size_t indices) {
    gpu.volumeProgram.set("clipFromObject", scene.clipFromWorld() * scene.objects[caster.object].worldFromObject);
    caster.mesh.draw(0, indices);
}

void drawObjects(Gpu& gpu, const Scene& scene, double lit) {
    gpu.program.set("lit", lit);
    for (const auto& [object, mesh] : gpu.meshes.of(scene)) {
        gpu.program.set("clipFromObject", scene.clipFromWorld() * object.worldFromObject);
        gpu.program.set("worldFromObject", object.worldFromObject);
        gpu.program.set("worldFromNormal", normalMatrix(object.worldFromObject));
        gpu.program.set("color", object.color);
        mesh.draw();
    }
}

// Draw over each pixel that passes the stencil test, whatever its depth.
void drawEverywhere(Gpu& gpu, const vec4& color) {
    glDisable(GL_DEPTH_TEST);
    gpu.volumeProgram.use();
    gpu.volumeProgram.set("clipFromObject", rotateX(90) * scale(2));
    gpu.volumeProgram.set("color", color);
    gpu.wholePicture->draw();
    glEnable(GL_DEPTH_TEST);
}

// A convex caster counts once at most, the pawn and the ring a few times. A picture of the count needs one count, not groups.
bool needsGroups(const Settings& s, std::size_t casters) {
    return casters > mostInOneCount && s.groups && s.show != Show::count;
}

// The caps of a volume never lie before the surface, so z-pass leaves them out.
std::size_t countedIndices(const Settings& s, const Caster& caster) {
    return s.method == Method::zFail ? caster.volume.indices.size() : caster.volume.sides;
}

// The number of volumes, of the casters first .. last - 1, that contain the eye.
int volumesRoundEye(const Gpu& gpu, const Scene& scene, std::size_t first, std::size_t last) {
    const vec3 eye(glm::inverse(scene.viewFromWorld)[3]);
    return gpu.volumes.around(scene, scene.lights[0].position, eye, first, last);
}

}  // namespace mv::shadow_volume
