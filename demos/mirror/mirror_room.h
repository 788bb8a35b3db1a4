// A room for mirrors: one mirror, or two that face each other, things before them and a column behind the first one.
#pragma once
#include <vector>

#include "mirrors.h"
#include "mv/geometry/plot.h"
#include "mv/geometry/scene.h"
#include "mv/gl/drawing.h"

namespace mv {

struct MirrorRoom {
    double turn = 0;  // of the first mirror about its upright axis, degrees
    bool hasSecond = false;
    vec3 eye{0, 1.7, 2.9}, ball{0, 0.35, 0};  // the eye looks at the first mirror's middle
    bool operator==(const MirrorRoom&) const = default;
    std::vector<Mirror> mirrors() const;
    // Objects: floor, frame, ball, cube, cone, column and, with a second mirror, its frame. A frame is right behind its
    // mirror. Composed for a plan in the right part of the picture. Refused: an eye above or below that middle.
    Scene scene(double aspect) const;
    // The place among the objects of a mirror's own frame.
    static ObjectId frameOf(std::size_t mirror) { return {mirror == 0 ? std::size_t(1) : std::size_t(6)}; }
    static vec3 lookedAt() { return {0, 1.2, -2}; }
    static constexpr double ballRadius = 0.35;
    static constexpr double tile = 2;  // the floor's tiles are so large, and have a corner in the origin
};

// The place of the plan, seen from above: x to the right, and the far end above.
Plot planOfRoom(const FrameInfo& frame);
// Draws all that stands there, the images of the ball in the mirrors, and the way of the light from the ball by the first mirror to the
// eye, where there is one. Into the drawing, which has begun.
void drawPlan(Drawing& drawing, const FrameInfo& frame, const MirrorRoom& room, const Scene& scene,
              const std::vector<std::vector<SeenMirror>>& chains);

}  // namespace mv
