// Bodies that can be cut regularly, and one that cannot.
#include <array>

#include "gpu-stages.h"

namespace mv::gpu_stages {

// Send the bodies through the wireframe's geometry shader. Without such shaders their faces are drawn, lit.
void drawMeshes(Gpu& gpu, const Settings& s, const Frame& frame) {
    constexpr std::array stages{Geometry::off, Geometry::wireframe};
    const Geometry stage = stages.at(s.hasWires);
    const Stages untouched{.tessellation = false};
    const Program& program = gpu.programs.of(filesOf(untouched, stage));
    program.use();
    program.set("bend", 0.0);
    program.set("color", colorOf(untouched, stage));
    if (s.hasWires) setWireframe(program, frame);
    gpu.bodies.draw(frame, turnOf(s), program, s.cells);
}

}  // namespace mv::gpu_stages
