#include "shared/measured.h"

#include "mv/gl/gl.h"
#include "mv/gl/program.h"
#include "mv/gl/state.h"

namespace mv {

std::vector<float> drawMeasured(const Target& target, const Frame& frame, const std::function<void()>& draw) {
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

}  // namespace mv
