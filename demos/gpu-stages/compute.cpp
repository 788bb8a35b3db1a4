// Rings on water: by a fragment shader, on the left, and by a compute shader; or the light that falls through that water.
#include <array>

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
    gpu.programs.of({"compute.comp"}).use();
    gpu.image.bindImage(0);
    glDispatchCompute(GLuint(right.width + 7) / 8, GLuint(right.height + 7) / 8, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
    frame.bindTarget();
}

// Count where the rays of light land, 16 for each pixel. The counts are kept while the size is the same.
static void countRays(Gpu& gpu, const Pane& right, const Frame&) {
    if (!gpu.countsFor.changed(right.width, right.height)) return;
    gpu.counts = makeTexture();
    glBindTexture(GL_TEXTURE_2D, gpu.counts.id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    const std::vector<GLuint> zeros(static_cast<std::size_t>(right.width) * static_cast<std::size_t>(right.height));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32UI, right.width, right.height, 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                 zeros.data());
    gpu.programs.of({"caustics.comp"}).use();
    glBindImageTexture(0, gpu.counts.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
    glDispatchCompute(GLuint(4 * right.width + 7) / 8, GLuint(4 * right.height + 7) / 8, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
}

static void bindPicture(const Gpu& gpu) { gpu.image.bindColor(0); }
static void bindCounts(const Gpu& gpu) {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, gpu.counts.id());
}

// What a kernel stores, and how that is drawn.
struct Stored {
    void (*compute)(Gpu&, const Pane&, const Frame&);
    void (*bind)(const Gpu&);
    const char* fragment;
};
static constexpr std::array<Stored, 2> ofKernel{{{computePicture, bindPicture, "texels.frag"},  //
                                                 {countRays, bindCounts, "light.frag"}}};

// Compute the right picture unless it is there already, and draw what the compute shader stored: colours, or counts.
static void drawStored(Gpu& gpu, const Stored& stored, const Pane& right, const Frame& frame) {
    stored.compute(gpu, right, frame);
    const Program& program = gpu.programs.of({"ripples.vert", stored.fragment});
    program.use();
    program.set("image", 0);
    stored.bind(gpu);
    fill(gpu, right, program);
}

void drawCompute(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Pane left = belowHeading(frame, 0), right = belowHeading(frame, 1);
    if (s.computes) drawStored(gpu, ofKernel.at(static_cast<std::size_t>(s.kernel)), right, frame);

    // Draw the left picture by a fragment shader
    const Program& byFragment = gpu.programs.of({"ripples.vert", "ripples.frag"});
    byFragment.use();
    byFragment.set("size", vec2(left.width, left.height));
    fill(gpu, left, byFragment);
    glViewport(0, 0, frame.width(), frame.height());
}

}  // namespace mv::gpu_stages
