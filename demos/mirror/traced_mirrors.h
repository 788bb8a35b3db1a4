// mirror's reference: a ray for each pixel, which the mirrors turn round; nothing of the matrices that draw them.
#pragma once
#include <vector>

#include "mirror_room.h"
#include "mv/demo/demo.h"

namespace mv::mirror {

// All that the rays meet, and what the mirrors do to them.
struct TracedScene {
    Scene scene;
    MirrorRoom room;
    int bounces = 0;
    double reflectance = 1;
    bool operator==(const TracedScene&) const = default;
};
TracedScene tracedScene(const Demo& demo, const FrameInfo& frame);

// For each pixel, the number of the object that is seen, from 1, and 0.9 times its brightness; its region is a number
// for the object and the bounces together. -1 where there is nothing.
Reference traced(const TracedScene& scene, int width, int height);

// For each object's number, from 1: whether all of it is behind the first mirror.
std::vector<bool> behindFirst(const TracedScene& scene);

}  // namespace mv::mirror
