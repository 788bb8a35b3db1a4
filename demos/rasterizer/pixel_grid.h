// A small picture with pixels large enough to count.
#pragma once
#include "mv/gl/drawing.h"
#include "mv/image/picture.h"

namespace mv {

// The place of a picture of columns x rows pixels in a pane: as large as whole pixels of the screen allow, at its upper
// left corner, with `margin` pixels round it. In the plot's values pixel (i, j) reaches from (i, j) to (i + 1, j + 1),
// y upwards.
Plot gridPlot(const Pane& pane, int columns, int rows, int margin = 8);

// Copies the small picture into that place of the sheet, which is as large as the whole picture; what lies beyond it is left
// out. `pane` as in gridPlot(); `scale`: pixels of the sheet for each of what these two count.
void magnify(const Picture& small, const Plot& plot, const Pane& pane, const vec2& scale, Picture& sheet);

// Draws the lines between the pixels where they are 6 screen pixels apart or more, and the frame.
void drawGrid(Drawing& drawing, const Plot& plot);

}  // namespace mv
