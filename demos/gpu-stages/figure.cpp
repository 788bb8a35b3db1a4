// The eye of gpu-stages, its counted draws, and all beside the patch: the table of the stages, the control points.
#include "exact_patch.h"
#include "gpu-stages.h"
#include "mv/demo/seen.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/wide_lines.h"

namespace mv::gpu_stages {

// The eye, for the left of the picture. The table is beside it.
Scene sceneOf(const Settings& s, const FrameInfo& frame) {
    Scene scene;
    // The patch stands on the left or, in an upright picture, above; the table is on the right or below
    const bool isNarrow = narrowTable(frame);
    const double part = isNarrow ? 0.32 : 0.47, middle = isNarrow ? -0.69 : -0.55;
    scene.clipFromView = frame.isUpright()
                             ? translate(0, 0.5, 0) * scale(1, 0.5, 1) * perspective(35, 2 * frame.aspect(), 1, 20)
                             : translate(middle, 0, 0) * scale(part, 1, 1) *
                                   perspective(isNarrow ? 50 : 35, part * frame.aspect(), 1, 20);
    scene.viewFromWorld = lookAt(vec3(0, 0, 10.5), vec3(0), vec3(0, 1, 0)) * turnOf(s) * translate(0, -0.4, 0);
    return scene;
}

void submit(Gpu& gpu, const Stages& s) {
    const GLenum primitives = mode(s);
    Mesh& mesh = *(primitives == GL_PATCHES ? gpu.patch : primitives == GL_POINTS ? gpu.points : gpu.net);
    mesh.drawAs(primitives);
}

// Draw the patch, its lines as wide as a figure's, or send it up to the rasterizer only. Count the fragments where somebody reads their number.
void drawCounted(Gpu& gpu, const Settings& s, Geometry stage, const Frame& frame) {
    const bool ofLines = stage == Geometry::normals || domainOf(s.stages) == Domain::isolines;
    const auto drawn = [&] {
        if (ofLines)
            drawWide(frame, [&] { submit(gpu, s.stages); });
        else
            submit(gpu, s.stages);
    };
    if (!s.stages.fragments) glEnable(GL_RASTERIZER_DISCARD);
    if (s.counts && frame.readouts())
        gpu.passed += countedBy(GL_SAMPLES_PASSED, drawn);
    else
        drawn();
    if (!s.stages.fragments) glDisable(GL_RASTERIZER_DISCARD);
}

// Count the primitives that this program sends on, and those that it would without its geometry shader. Count again when
// another number is to be expected.
void countPrimitives(Gpu& gpu, const Settings& s, const Frame& frame) {
    if (!s.counts) return;
    const Geometry stage = geometryStage(s.stages);
    if (gpu.countedFor.changed(s.stages.tessellation, s.stages.inner, outerLevel(s.stages), stage,
                               domainOf(s.stages))) {
        const auto countedBy = [&](const Program& program) {
            return counted(program, mode(s.stages), [&] { submit(gpu, s.stages); });
        };
        gpu.sent = countedBy(gpu.programs.of(filesOf(s.stages, stage)));
        gpu.toGeometry = stage == Geometry::off ? gpu.sent : countedBy(prepare(gpu, s, Geometry::off, frame));
    }
    frame.count("primitives for the rasterizer", double(gpu.sent.number.generated));
}

static void drawStagesFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Stages& stages = s.stages;
    if (stages.fragments) {
        const mat4 clipFromWorld = seen(sceneOf(s, frame), frame).clipFromWorld();
        const ExactPatch exact(stages.bend);
        for (const vec3& point : exact.patch().points)
            gpu.drawing.point(clipFromWorld, point, frame.height() / 90.0, vec4(0.45, 0.45, 0.5, 1));
    }
    drawStageTable(gpu.drawing, frame, stages.direct3d,
                   {.mode = mode(stages),
                    .inner = stages.inner,
                    .outer = outerLevel(stages),
                    .isBent = stages.bend != 0.0,
                    .hasGeometry = geometryStage(stages) != Geometry::off,
                    .hasFragments = stages.fragments,
                    .toGeometry = gpu.toGeometry,
                    .sent = gpu.sent});
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    gpu.drawing.begin(frame);
    if (s.show == Show::stages) drawStagesFigure(gpu, s, frame);
    if (s.show == Show::primitives) gpu.types.label(frame, gpu.drawing);
    if (s.show == Show::meshes) gpu.bodies.label(frame, turnOf(s), gpu.drawing);
    if (s.show == Show::compute) drawHeadings(gpu.drawing, frame, s.kernel == Kernel::caustics, s.computes);
    gpu.drawing.draw(frame);
}

}  // namespace mv::gpu_stages
