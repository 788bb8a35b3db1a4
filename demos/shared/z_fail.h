// Shadow volumes counted in the stencil buffer.
#pragma once
#include "mv/gl/gl.h"
#include "mv/gl/program.h"
#include "shared/caster_volumes.h"

namespace mv {

// Adds to the stencil buffer, in each pixel, the number of volumes round what is seen there: z-fail counts from the far
// end of the view towards it, in through a back face, out through a front face. Wants the scene's depths drawn, depth and
// stencil test on, colour and depth masked, culling off, and a projection without a far plane. `program` is in use, and
// draws `position` (a vec4) by clipFromObject. Leaves its stencil operations set. Source: as shadowVolume.
inline void countByZFail(const CasterVolumes& volumes, const Scene& scene, const Program& program) {
    glStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
    glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
    for (const CasterVolumes::Caster& caster : volumes.casters()) {
        program.set("clipFromObject", scene.clipFromWorld() * scene.objects[caster.object].worldFromObject);
        caster.mesh.draw();
    }
}

}  // namespace mv
