#include "lit_difference.h"

#include <cmath>

#include "mv/error.h"
#include "mv/gl/gl.h"
#include "mv/gl/program.h"
#include "mv/gl/state.h"
#include "mv/gl/text.h"
#include "shared/lit_reference.h"

namespace mv {

// Clears the target to -1, where nothing is compared, with all its buffers, has `draw` draw the quantity into it as for a study,
// and returns that, one float a pixel, the upper row first. `draw` finds the state as the caller has it; what it changes is
// undone, and the frame's picture is bound again.
static std::vector<float> drawMeasured(const Target& target, const Frame& frame, const std::function<void()>& draw) {
    std::vector<float> drawn;
    const bool before = setMeasuring(true);
    try {
        const StateScope scope;
        target.bind();
        glClearColor(-1, -1, -1, -1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        draw();
        drawn = target.readRed();
    } catch (...) {
        setMeasuring(before);
        throw;
    }
    setMeasuring(before);
    frame.bindTarget();
    return drawn;
}

LitDifference::Found LitDifference::show(const Scene& scene, const Frame& frame, const std::function<void()>& draw,
                                         const std::function<void()>& against) {
    const std::vector<float> here = drawn(frame, draw);
    const std::vector<float> there = against ? drawn(frame, against) : byRays(scene, frame);
    Picture picture(frame.width(), frame.height());
    double squares = 0;
    long compared = 0, beyond = 0;
    for (std::size_t i = 0; i < here.size(); ++i) {
        const bool counts = here[i] >= 0 && there[i] >= 0;
        const double difference = counts ? double(here[i]) - double(there[i]) : 0;
        compared += counts ? 1 : 0;
        beyond += std::abs(difference) > 0.5 ? 1 : 0;
        squares += difference * difference;
        const vec3 grey(counts ? 70 + 60 * double(there[i]) : 40);
        const vec3 far = difference < 0 ? vec3(255, 60, 30) : vec3(60, 170, 255);
        const vec3 color = grey + std::abs(difference) * (far - grey);
        for (int k = 0; k < 3; ++k) {
            picture.rgba[4 * i + static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(std::lround(color[k]));
        }
        picture.rgba[4 * i + 3] = 255;
    }
    showImage(frame, 0, 0, picture);
    if (compared == 0) return {};
    return {100.0 * double(beyond) / double(compared), std::sqrt(squares / double(compared))};
}

std::vector<float> LitDifference::drawn(const Frame& frame, const std::function<void()>& draw) {
    if (!floatTargets()) {
        throw Error("the difference", "needs targets of floats; this OpenGL ES lacks EXT_color_buffer_float");
    }
    target_.fit(frame.width(), frame.height(), {.depth = true, .stencil = true, .color = GL_R32F}, "lit fraction");
    return drawMeasured(target_, frame, draw);
}

std::vector<float> LitDifference::byRays(const Scene& scene, const FrameInfo& frame) {
    if (castFor_.changed(scene, frame.width(), frame.height())) rays_ = litReference(scene, frame, {}, {});
    std::vector<float> lit(rays_.values.begin(), rays_.values.end());
    for (std::size_t i = 0; i < lit.size(); ++i) {
        if (rays_.regions[i] < 0) lit[i] = -1;
    }
    return lit;
}

}  // namespace mv
