// GL_LINES that grow with the picture, as the lines of a figure do.
#pragma once
#include <algorithm>
#include <cmath>

#include "mv/demo/frame.h"
#include "mv/gl/functions.h"

namespace mv {

// How many pixels wide a line is that is so many wide in a picture of the size that the demo declares; no fewer.
inline int lineWidth(const FrameInfo& frame, int declared = 1) {
    return std::max(declared, static_cast<int>(std::lround(declared * frame.inUnits().sizeScale())));
}

// Draws lines as wide as a figure's unit: OpenGL's are one pixel wide, and glLineWidth() does not change that in every context.
// So they are drawn several times, each in a viewport a pixel aside, to both sides and up and down. `pane` is in pixels, and is
// the viewport before and after it; nothing else is set. A unit of one pixel is one draw.
template <class Draw>
void drawWide(const FrameInfo& frame, const Pane& pane, const Draw& draw) {
    const int width = lineWidth(frame), first = -(width - 1) / 2;
    for (int i = first; i < first + width; ++i) {
        if (i == 0) {
            draw();
            continue;
        }
        glViewport(pane.x + i, pane.y, pane.width, pane.height);
        draw();
        glViewport(pane.x, pane.y + i, pane.width, pane.height);
        draw();
        glViewport(pane.x, pane.y, pane.width, pane.height);
    }
}

template <class Draw>
void drawWide(const FrameInfo& frame, const Draw& draw) {
    const FrameInfo pixels = frame.inPixels();
    drawWide(frame, {0, 0, pixels.width(), pixels.height()}, draw);
}

}  // namespace mv
