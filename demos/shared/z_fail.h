// Shadow volumes counted in the stencil buffer.
#pragma once
#include "mv/gl/gl.h"
#include "mv/gl/program.h"
#include "shared/caster_volumes.h"

namespace mv {

// Adds to the stencil buffer, in each pixel, the number of volumes round what is seen there: z-fail counts from the far
// end of the view towards it, in through a back face, out through a front face. Wants the scene's depths drawn, the depth
// test on and a projection without a far plane. `program` is in use, and draws `position` (a vec4) by clipFromObject.
// Leaves the stencil test on, culling off, and colour and depth masked. Source: as shadowVolume.
inline void countByZFail(const CasterVolumes& volumes, const Scene& scene, const Program& program) {
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 0, ~0U);
    glStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
    glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_FALSE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    for (const CasterVolumes::Caster& caster : volumes.casters()) {
        program.set("clipFromObject", scene.clipFromWorld() * scene.objects[caster.object].worldFromObject);
        caster.mesh.draw();
    }
}

}  // namespace mv
