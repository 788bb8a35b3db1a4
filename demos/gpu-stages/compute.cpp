// Rings by a fragment shader, on the left, and by a compute shader; or the light that falls through such water.
#include "gpu-stages.h"
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

// Count where the rays of light land, 16 for each pixel. The counts are kept while the size is the same.
static void countRays(Gpu& gpu, const Pane& right) {
    if (!gpu.countsFor.changed(right.width, right.height)) return;
    gpu.counts = makeTexture();
    glBindTexture(GL_TEXTURE_2D, gpu.counts.id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    const std::vector<GLuint> zeros(static_cast<std::size_t>(right.width) * static_cast<std::size_t>(right.height));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32UI, right.width, right.height, 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                 zeros.data());
    programOf(gpu, {"caustics.comp"}).use();
    glBindImageTexture(0, gpu.counts.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
    glDispatchCompute(GLuint(4 * right.width + 7) / 8, GLuint(4 * right.height + 7) / 8, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
}

// Draw what the compute shader stored: colours, or counts.
static void drawStored(Gpu& gpu, Kernel kernel, const Pane& right) {
    const Program& program = programOf(gpu, {"ripples.vert", kernel == Kernel::rings ? "texels.frag" : "light.frag"});
    program.use();
    program.set("image", 0);
    if (kernel == Kernel::rings) {
        gpu.image.bindColor(0);
    } else {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, gpu.counts.id());
    }
    fill(gpu, right, program);
}

void drawCompute(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Pane left = belowHeading(frame, 0), right = belowHeading(frame, 1);
    if (s.computes && s.kernel == Kernel::rings) computePicture(gpu, right, frame);
    if (s.computes && s.kernel == Kernel::caustics) countRays(gpu, right);

    // Draw the left picture by a fragment shader
    const Program& byFragment = programOf(gpu, {"ripples.vert", "ripples.frag"});
    byFragment.use();
    byFragment.set("size", vec2(left.width, left.height));
    fill(gpu, left, byFragment);
    if (s.computes) drawStored(gpu, s.kernel, right);
    glViewport(0, 0, frame.width(), frame.height());
}

}  // namespace mv::gpu_stages
