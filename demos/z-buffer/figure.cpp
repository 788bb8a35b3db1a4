// The figures over z-buffer: the depth of each distance.
#include <glm/common.hpp>

#include "mv/geometry/plot.h"
#include "z-buffer.h"

namespace mv::z_buffer {

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
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
