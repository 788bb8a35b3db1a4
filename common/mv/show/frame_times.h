// How long a frame takes.
#pragma once

namespace mv {

class Stage;

struct FrameTimes {
    double firstMs = 0;   // the first draw, with what it compiles and uploads
    double medianMs = 0;  // of the later ones, each finished with glFinish
    double madMs = 0;     // median absolute deviation from that median
    int runs = 0;
};

// Draws frame `index` `runs` times more and times each. The picture stays the same.
FrameTimes timeFrames(Stage& stage, int index, int runs, double firstMs);

}  // namespace mv
