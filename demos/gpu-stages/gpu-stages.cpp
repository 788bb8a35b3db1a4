// gpu-stages: one patch through all stages of the pipeline, each on or off, with what goes into it and what comes out.
#include "gpu-stages.h"

#include <array>

#include "mv/gl/gl.h"
#include "mv/math/transform.h"

namespace mv::gpu_stages {

// Each thing that is shown is a part of the lesson, in a file of its own: stages.cpp, primitives.cpp, meshes.cpp, compute.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    constexpr std::array ofShow{drawStages, drawPrimitives, drawMeshes, drawCompute};
    glEnable(GL_DEPTH_TEST);
    ofShow.at(static_cast<std::size_t>(s.show))(gpu, s, frame);
}

mat4 turnOf(const Settings& s) { return rotateX(s.spinX) * rotateY(s.spinY); }

}  // namespace mv::gpu_stages
