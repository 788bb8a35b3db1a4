// Beside the picture of cube-ortho: its box of view from outside, and the cube that the matrix makes of it.
#include "cube-ortho.h"

namespace mv::cube_ortho {

ViewFigure figureOf(const Settings& s) {
    return {viewFromModel(s), clipFromView(s), nearDistance(s), farDistance(s), false};
}

Pane paneOf(const Settings& s, const FrameInfo& frame) {
    return s.volume ? picturePane(frame) : Pane{0, 0, frame.width(), frame.height()};
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    tellStretch(clipFromView(s), frame);
    if (s.volume) drawViewFigure(gpu.drawing, gpu.program, gpu.cube, figureOf(s), frame);
}

}  // namespace mv::cube_ortho
