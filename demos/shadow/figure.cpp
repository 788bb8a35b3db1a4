// The figures over shadow: the light, and its rays through the square's corners.
#include "shadow.h"
#include "shared/light_rays.h"

namespace mv::shadow {

void tell(const CasterVerdict& verdict, const Frame& frame) {
    if (!verdict.sentence.empty()) frame.say(verdict.sentence);
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    if (!s.rays) return;
    gpu.drawing.begin(frame);
    drawLightRays(gpu.drawing, clipFromViewOf(frame) * viewFromWorld, lightOf(s, frame), cornersOf(worldFromModelOf(s)),
                  {&planeOfShadow, 1});
    gpu.drawing.draw(frame);
}

}  // namespace mv::shadow
