// deferred: many lamps, asked by each fragment, by each pixel that is seen, or by the pixels in reach; and their sum, beyond 1.
#include "deferred.h"

#include <array>
#include <glm/matrix.hpp>
#include <utility>

#include "mv/demo/seen.h"
#include "mv/gl/gl.h"
#include "mv/math/transform.h"

namespace mv::deferred {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    // Sum up the light in a target of its own
    constexpr std::array ways{forward, deferred, lampByLamp};
    ways.at(static_cast<std::size_t>(s.way))(gpu, s, frame);

    // Make a picture of the sum
    frame.bindTarget();
    glViewport(0, 0, frame.width(), frame.height());
    showSum(gpu, s, frame);
}

static const Program& use(Gpu& gpu, const char* vertex, const char* fragment) {
    const Program& program = gpu.programs.of({vertex, fragment});
    program.use();
    return program;
}

static void setLamps(const Program& program, const Settings& s, const Lamps& lamps) {
    program.set("place", lamps.place);
    program.set("power", lamps.power);
    program.set("count", lamps.count);
    program.set("reach", s.reach);
    program.set("ambient", ambient);
}

// The target that light is summed up in. Its alpha is 0 where nothing is seen.
static void beginSum(Gpu& gpu, const Settings& s, const Frame& frame, bool hasDepth) {
    const GLenum format = s.sum == Sum::halfFloat ? GL_RGBA16F : GL_RGBA8;
    gpu.sum.begin(frame.width(), frame.height(), {format}, hasDepth, "sum of light");
    glClearColor(0, 0, 0, 0);
    glClear(hasDepth ? GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT);
}

static void drawWorld(Gpu& gpu, const Settings& s, const Program& program, const Frame& frame) {
    program.set("clipFromWorld", seen(cameraOf(s, frame), frame).clipFromWorld());
    glEnable(GL_DEPTH_TEST);
    gpu.world->draw();
    glDisable(GL_DEPTH_TEST);
}

// Forward: draw the world once. Each fragment asks each lamp, also where a later one will hide it.
void forward(Gpu& gpu, const Settings& s, const Frame& frame) {
    beginSum(gpu, s, frame, true);
    const Program& program = use(gpu, "surface.vert", "forward.frag");
    setLamps(program, s, reaching(s, cameraOf(s, frame)));
    drawWorld(gpu, s, program, frame);
}

// Deferred: first store what is seen, then let each pixel ask each lamp once.
void deferred(Gpu& gpu, const Settings& s, const Frame& frame) {
    storeSurfaces(gpu, s, frame);
    beginSum(gpu, s, frame, false);
    askLamps(gpu, s, frame, reaching(s, cameraOf(s, frame)));
}

// Draw the world into several textures at once: its colours, its normals, its depths.
void storeSurfaces(Gpu& gpu, const Settings& s, const Frame& frame) {
    const GLenum ofNormals = s.normalBits == 8 ? GL_RGBA8 : GL_RGB10_A2;
    gpu.surfaces.begin(frame.width(), frame.height(), {GL_RGBA8, ofNormals}, true, "surfaces");
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    drawWorld(gpu, s, use(gpu, "surface.vert", "surface.frag"), frame);
}

// Give a program the stored textures.
static void readSurfaces(const Gpu& gpu, const Program& program) {
    gpu.surfaces.bindColor(0, 0);
    gpu.surfaces.bindColor(1, 1);
    gpu.surfaces.bindDepth(2);
    program.set("colors", 0);
    program.set("normals", 1);
    program.set("depths", 2);
}

void askLamps(Gpu& gpu, const Settings& s, const Frame& frame, const Lamps& lamps) {
    const Program& program = use(gpu, "pixels.vert", "pixels.frag");
    readSurfaces(gpu, program);
    program.set("worldFromClip", glm::inverse(seen(cameraOf(s, frame), frame).clipFromWorld()));
    setLamps(program, s, lamps);
    gpu.wholePicture->draw();
}

// Lamp by lamp: draw a ball about each lamp, as large as its reach. Only the pixels that the ball covers ask, and blending adds up.
void lampByLamp(Gpu& gpu, const Settings& s, const Frame& frame) {
    storeSurfaces(gpu, s, frame);
    beginSum(gpu, s, frame, false);
    Lamps lamps = reaching(s, cameraOf(s, frame));
    const auto count = static_cast<std::size_t>(std::exchange(lamps.count, 0));
    askLamps(gpu, s, frame, lamps);  // none of them: the light that is everywhere

    // Draw the balls' far sides: one for each pixel, also where the eye is in a ball
    const Program& program = use(gpu, "lamp.vert", "lamp.frag");
    readSurfaces(gpu, program);
    const mat4 clipFromWorld = seen(cameraOf(s, frame), frame).clipFromWorld();
    program.set("worldFromClip", glm::inverse(clipFromWorld));
    program.set("reach", s.reach);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    for (std::size_t i = 0; i < count; ++i) {
        // The mesh's faces lie up to a twentieth within the ball that it stands for
        program.set("clipFromBall", clipFromWorld * translate(lamps.place[i]) * scale(1.1 * s.reach));
        program.set("place", lamps.place[i]);
        program.set("power", lamps.power[i]);
        gpu.ball->draw();
    }
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
}

// Press the sum, which has no upper end, into a picture, which ends at 1; or show the stored textures beside it.
void showSum(Gpu& gpu, const Settings& s, const Frame& frame) {
    const bool asTargets = s.show == Show::targets && s.way != Way::forward && !frame.measuring();
    const Program& program = use(gpu, "pixels.vert", asTargets ? "targets.frag" : "tone.frag");
    if (asTargets)
        readSurfaces(gpu, program);
    else
        program.set("reinhard", s.tone == Tone::reinhard);
    gpu.sum.bindColor(0, 3);
    program.set("sums", 3);
    program.set("background", background);
    gpu.wholePicture->draw();
}

}  // namespace mv::deferred
