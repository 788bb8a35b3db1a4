// The figures over shadow-floor: the light's rays through the square's corners.
#include "mv/math/shadow.h"
#include "shadow-floor.h"
#include "shared/light_rays.h"

namespace mv::shadow_floor {

void tell(const Settings& s, const vec3& light, const CasterVerdict& verdict, const Frame& frame) {
    if (!verdict.sentence.empty()) frame.say(verdict.sentence);
    if (verdict.casts && s.crop && areaOnFloor(shadowProjection(vec4(light, 1), planeOfShadow)) == 0)
        frame.say("The shadow falls beside the floor: with crop off it is seen there.");
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    if (!s.rays) return;
    gpu.drawing.begin(frame);
    drawLightRays(gpu.drawing, clipFromViewOf(frame) * viewFromWorldOf(s), vec4(lightOf(s, frame), 1), corners,
                  {&planeOfShadow, 1});
    gpu.drawing.draw(frame);
}

}  // namespace mv::shadow_floor
