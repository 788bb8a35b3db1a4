// The same rings by a fragment shader, on the left, and by a compute shader.
#include "gpu-stages.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/gl.h"

namespace mv::gpu_stages {

static void fill(Gpu& gpu, const Pane& pane, const Program& program) {
    program.set("corner", vec2(pane.x, pane.y));
    glViewport(pane.x, pane.y, pane.width, pane.height);
    gpu.square->draw();
}

// Compute the right picture, in groups of 8 x 8 pixels. No triangle and no rasterizer takes part. The picture is kept while its
// size is the same.
static void computePicture(Gpu& gpu, const Pane& right, const Frame& frame) {
    if (!gpu.image.fit(right.width, right.height, {.texture = true}, "image")) return;
    programOf(gpu, {"compute.comp"}).use();
    gpu.image.bindImage(0);
    glDispatchCompute(GLuint(right.width + 7) / 8, GLuint(right.height + 7) / 8, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
    frame.bindTarget();
}

void drawCompute(Gpu& gpu, const Frame& frame) {
    const std::vector<Pane> panes = frame.panes(2);
    const Pane left = belowHeading(panes[0]), right = belowHeading(panes[1]);
    const bool computes = has(beyond_es::computeShaders);
    if (computes) computePicture(gpu, right, frame);

    // Draw the left picture by a fragment shader
    const Program& byFragment = programOf(gpu, {"ripples.vert", "ripples.frag"});
    byFragment.use();
    byFragment.set("size", vec2(left.width, left.height));
    fill(gpu, left, byFragment);

    // Draw the texels that the compute shader wrote
    if (computes) {
        const Program& texels = programOf(gpu, {"ripples.vert", "texels.frag"});
        texels.use();
        texels.set("image", 0);
        gpu.image.bindColor(0);
        fill(gpu, right, texels);
    }
    glViewport(0, 0, frame.width(), frame.height());
}

}  // namespace mv::gpu_stages
