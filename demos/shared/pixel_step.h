// A pixel that a rasterizer sets. Pixels are numbered from the lower left one, (0, 0).
#pragma once

namespace mv {

struct PixelStep {
    int x, y;
    double error = 0;     // the error term when the pixel was set, in the method's own unit
    double coverage = 1;  // how much of the colour it gets
};

}  // namespace mv
