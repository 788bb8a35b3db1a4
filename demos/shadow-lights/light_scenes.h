// Scenes under several lights that move, for shadows of each. As in shared/scenes.h: metres, y up, a floor at y = 0.
#pragma once
#include <vector>

#include "mv/geometry/scene.h"

namespace mv {

// Two reading lamps, which look at a ball that rolls to and fro, under a third light, which rests. As they are after
// `index` frames. Lights: the resting one, then one for each lamp, with its aim. Objects: floor; foot, lower arm, upper arm
// and shade of each lamp; ball.
Scene lampsAndBall(double aspect, int index);

// The still life under lights of all hues at these places. The colours of two or more add up to white.
Scene lightsOverStillLife(double aspect, const std::vector<vec3>& places);

// The same with `count` lights on a circle over it, which turns by a degree a frame.
Scene circleOfLights(double aspect, int index, int count);

}  // namespace mv
