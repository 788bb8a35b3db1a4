// What is drawn over shadow-floor: the light's rays through the square's corners.
#include "shadow-floor.h"
#include "shared/light_rays.h"

namespace mv::shadow_floor {

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    if (!s.rays) return;
    gpu.drawing.begin(frame);
    drawLightRays(gpu.drawing, clipFromViewOf(frame) * viewFromWorldOf(s), vec4(lightOf(s, frame), 1), corners,
                  {&planeOfShadow, 1});
    gpu.drawing.draw(frame);
}

}  // namespace mv::shadow_floor
