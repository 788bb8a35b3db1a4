// The figures over z-buffer: the order in which the bars are drawn, and the depth of each distance.
#include <algorithm>
#include <glm/common.hpp>
#include <string>

#include "mv/geometry/plot.h"
#include "z-buffer.h"

namespace mv::z_buffer {

// Number the bars in the order in which they are drawn, and say what decides.
static void drawOrder(Gpu& gpu, const Settings& s, const Frame& frame) {
    const int size = std::clamp(frame.height() / 32, 8, 22);
    const vec4 ink(0.1, 0.1, 0.1, 1), white(1, 1, 1, 0.85);
    const mat4 clip = clipFromView(s, frame.aspect());
    const std::array<Plate, 3> plates = platesOf(s);
    gpu.drawing.begin(frame);
    int number = 0;
    for (const Part& part : partsInOrder(s.order, plates, cutsOf(s))) {
        if (s.order == Order::sorted && s.pieces > 1) break;  // of pieces there are too many to number
        const Plate& plate = plates.at(part.plate);
        gpu.drawing.text(clip * plate.viewFromPlate, {0.5, 0, 0}, {-0.5 * size, 0.7 * size}, std::to_string(++number),
                         {size, ink, white});
    }
    gpu.drawing.text({8, frame.height() - 8.0}, "three bars, each over one and under another", {size, ink, vec4(0)});
    gpu.drawing.text({8, 3.2 * size}, "drawn in the order of the numbers", {size, ink, vec4(0)});
    gpu.drawing.text({8, 1.7 * size},
                     s.depthTest ? "with the depth test the nearer one is kept in each pixel"
                                 : "without the depth test the later one covers the earlier: wrong somewhere",
                     {size, ink, vec4(0)});
    gpu.drawing.draw(frame);
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    if (s.words && s.shown == Shown::colors && s.scene == Which::cycle) drawOrder(gpu, s, frame);
    if (s.shown != Shown::curve) return;
    const mat4 clip = clipFromView(s, frame.aspect());
    const auto kept = [&](double distance) { return keptDepth(s.format, depthOf(s, clip, float(distance))); };
    const vec2 size(frame.width(), frame.height());
    const Plot plot{{size * vec2(0.12, 0.14), size * 0.9}, {s.near, s.far, "distance", true}, {0, 1, "depth"}};

    // Draw the curve from near to far
    std::vector<vec2> curve;
    for (int i = 0; i <= 300; ++i) {
        const double distance = plot.value(glm::mix(plot.box.low, plot.box.high, i / 300.0)).x;
        curve.emplace_back(distance, kept(distance));
    }
    gpu.drawing.begin(frame);
    gpu.drawing.fill({vec2(0), size}, vec4(1, 1, 1, 0.85));
    gpu.drawing.axes(plot);
    gpu.drawing.curve(plot, curve, {.width = 2});

    // Mark the middles of the three plates
    for (const Plate& plate : platesOf(s)) {
        const double distance = -(plate.viewFromPlate * vec4(0.5, 0, 0, 1)).z;
        if (!(distance >= s.near && distance <= s.far)) continue;
        gpu.drawing.point(plot.pixel({distance, kept(distance)}), 9, vec4(plate.color, 1));
    }
    gpu.drawing.draw(frame);
}

void tell(const Settings& s, const Frame& frame) {
    if (!s.depthTest) frame.say("Without depth test nothing is written into the depth buffer, either.");
}

}  // namespace mv::z_buffer
