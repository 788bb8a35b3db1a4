// Beside the picture of cube-persp: its pyramid of view from outside, and the cube that the matrix makes of it.
#include "cube-persp.h"

namespace mv::cube_persp {

ViewFigure figureOf(const Settings& s) { return {viewFromModel(s), clipFromView(s), s.near, s.far, true}; }

Pane paneOf(const Settings& s, const FrameInfo& frame) {
    return s.volume ? picturePane(frame) : Pane{0, 0, frame.width(), frame.height()};
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    tellStretch(clipFromView(s), frame);
    if (s.volume) drawViewFigure(gpu.drawing, gpu.program, gpu.cube, figureOf(s), frame);
}

}  // namespace mv::cube_persp
