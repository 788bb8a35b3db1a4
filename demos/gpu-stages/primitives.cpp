// The ten primitive types, a pane each.
#include "gpu-stages.h"
#include "mv/gl/gl.h"

namespace mv::gpu_stages {

void drawPrimitives(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Program& flat = gpu.programs.of({"flat.vert", "flat.frag"});
    flat.use();
    glEnable(GL_PROGRAM_POINT_SIZE);
    gpu.types.draw(frame, flat, s.vertices, s.counts);
}

}  // namespace mv::gpu_stages
