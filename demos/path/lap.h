// A lap round a closed path whose frames are known at samples.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "mv/gl/drawing.h"
#include "mv/motion/path_frame.h"

namespace mv {

struct Lap {
    std::vector<PathSample> samples;
    std::vector<PathFrame> frames;
    std::vector<double> ways;        // metres from the first sample, by chords
    std::vector<double> turns;       // turn of up about the path before each sample, deg/m; 0 for the first
    std::vector<std::size_t> flips;  // samples
};

// Turns are told against the least turn from each sample to the next. A flip is where up turns by more than 90 degrees
// within `window` metres, at once or in a whirl, and is named by its fastest sample: so their number does not depend on how
// near the samples are, as long as there are some in a window. Refused: other numbers of frames than of samples, fewer than
// two, two samples at one place, and what turnedTo refuses.
Lap lapOf(std::vector<PathSample> samples, std::vector<PathFrame> frames, double window);

// The frame at a part 0..1 of the lap, all samples being equally far apart in it, where the velocity is this. Between two
// samples it turns about the path evenly; by more than 90 degrees it turns at the next sample, at once.
PathFrame frameAt(const Lap& lap, double part, const vec3& velocity);

// Right red, up green, forward blue: colours of axes x, y and z, where a thing looks along -z. The red is orange and the green bluish,
// for eyes that have no cones of long or of middle waves.
inline const vec4 rightColor(0.80, 0.30, 0, 1), upColor(0, 0.52, 0.40, 1), forwardColor(0.10, 0.30, 0.85, 1);
// A frame at a place, `size` long, hidden by what is before it.
void drawFrame(Drawing& drawing, const mat4& clipFromWorld, const vec3& at, const PathFrame& frame, double size,
               double width);
// A small frame every five metres, and a red dot at each flip.
void drawLap(Drawing& drawing, const mat4& clipFromWorld, const Lap& lap);

}  // namespace mv
