// Over the picture of environment: the line between cube and rays. Beside it: how much is reflected, and the cube cut open.
#include <algorithm>
#include <string>

#include "environment.h"
#include "mv/gl/gl.h"
#include "mv/gl/word_size.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "reflectance_plot.h"

namespace mv::environment {
namespace {

const vec4 ink(0.1, 0.1, 0.1, 1);

void drawCross(Gpu& gpu, const Frame& frame, int x, int words) {
    const double width = frame.width() - x, height = frame.height();
    const double side = std::min((width - 28) / 4, 0.40 * height / 3);
    const Pane cross{x + int(0.5 * (width - 4 * side)), int(0.03 * height), int(4 * side), int(3 * side)};
    const auto [left, low, across, up] = frame.pixels(cross);
    glViewport(left, low, across, up);
    glDisable(GL_DEPTH_TEST);
    gpu.crossProgram->use();
    gpu.pane->draw();
    gpu.drawing.textAround({x + 0.5 * (width + 4 * side) - 0.9 * side, 0.03 * height + 2.5 * side}, "the cube",
                           {words, ink, vec4(0)});
}

void drawBeside(Gpu& gpu, const Settings& s, const Frame& frame, int x, int words) {
    const double width = frame.width() - x, height = frame.height();
    drawReflectance(gpu.drawing, {{x + 52, (looksUp(s) ? 0.58 : 0.12) * height}, {x + width - 14, 0.93 * height}},
                    coatingOf(s));
    gpu.drawing.textAround({x + 0.55 * width, 0.965 * height},
                           nameOf(s.material) + std::string(s.material == Material::mirror ? "" : "; thin: Schlick"),
                           {words, ink, vec4(0)});
    if (looksUp(s)) drawCross(gpu, frame, x, words);
}

}  // namespace

// The camera. In its place stands the body in the middle, and what is around it.
Scene sceneOf(const Settings& s, const FrameInfo& frame) {
    Scene scene;
    scene.viewFromWorld = seenFrom(s.orbit, lookAt(vec3(0, 0.9, 5.4), vec3(0), vec3(0, 1, 0)));
    scene.clipFromView = perspective(34, viewPane(frame).aspect(), 0.3, 450);  // the largest room is within
    return scene;
}

Pane viewPane(const FrameInfo& frame) {
    const FrameInfo units = frame.inUnits();
    const bool hasRoom = units.width() >= 700 && units.height() >= 350;
    return {0, 0, hasRoom ? frame.width() * 5 / 8 : frame.width(), frame.height()};
}
// A quantity is measured all over.
Pane paneOf(const Frame& frame) {
    return frame.measuring() ? Pane{0, 0, frame.width(), frame.height()} : viewPane(frame);
}

void tell(const Settings& s, const Frame& frame) {
    if (!s.seamless && isEs()) frame.say("OpenGL ES always filters across the edges of a cube.");
    if (!s.model.isSet()) return;
    const std::size_t leftOut = s.model.content()->leftOut;
    if (leftOut > 0) frame.say("Points and lines of the model are left out: " + std::to_string(leftOut) + ".");
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Pane left = viewPane(frame);
    if (inRoom(s)) glDisable(GL_CULL_FACE);
    Drawing& drawing = gpu.drawing;
    drawing.begin(frame);
    const int words = std::clamp(frame.height() / 38, leastWords, 16);
    if (splits(s) && left.height >= 100 && left.width >= 200) {
        drawing.line({0.5 * left.width, 0}, {0.5 * left.width, left.height}, {{1, 1, 1, 0.8}, 1.5});
        drawing.text({8, left.height - 8}, std::string(looksUp(s) ? "cube map, " : "") + nameOf(s.lookup),
                     {.height = words});
        drawing.text({0.5 * left.width + 8, left.height - 8}, "rays", {.height = words});
    }
    if (left.width < frame.width()) {
        drawBeside(gpu, s, frame, left.width, words);
        const FrameInfo inPixels = frame.inPixels();
        glViewport(0, 0, inPixels.width(), inPixels.height());
    }
    drawing.draw(frame);
}

}  // namespace mv::environment
