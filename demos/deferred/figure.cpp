// Beside the stored textures, what they are.
#include <array>

#include "deferred.h"
#include "mv/gl/text.h"

namespace mv::deferred {

void drawFigure(Gpu&, const Settings& s, const Frame& inPixels) {
    if (s.show != Show::targets || s.way == Way::forward) return;
    const Frame frame = inPixels.inUnits();
    const int right = frame.width() / 2 + 8, lower = frame.height() / 2 + 8;
    const std::array<TextLine, 4> names{
        {{8, 8, "colours"}, {right, 8, "normals"}, {8, lower, "depths"}, {right, lower, "the sum of light"}}};
    drawText(frame, names);
}

}  // namespace mv::deferred
