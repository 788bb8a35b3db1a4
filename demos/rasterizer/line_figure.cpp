// The figure of a line's step: the pixel that was set last, and the error that decides where the next one goes.
#include <algorithm>
#include <cmath>

#include "mv/formatted.h"
#include "sheet.h"

namespace mv::rasterizer {

// Frame the pixel that was set last, and show the error that decides where the next one goes: as a bar to the right where it is 0 or
// more, which is up, and else to the left.
void showDecision(Gpu& gpu, const Line& line, const std::vector<PixelStep>& pixels, const Grid& grid,
                  const Frame& frame) {
    const std::size_t made = grid.made(pixels.size());
    const bool hasError = line.method != LineMethod::naive && line.method != LineMethod::smooth;
    if (made == 0 || made >= pixels.size() || !hasError) return;
    const PixelStep &last = pixels[made - 1], &next = pixels[made];
    framePixel(gpu, last.x, last.y, red, grid, frame);

    // Compare the error after the slope was added, and before a step up took something away
    const auto [from, to] = line.ends;
    const double run = std::abs(grid.whole(to.x) - grid.whole(from.x)),
                 rise = std::abs(grid.whole(to.y) - grid.whole(from.y)), wide = std::max(run, rise),
                 high = std::min(run, rise);
    const double added = line.method == LineMethod::scaled    ? high
                         : line.method <= LineMethod::shifted ? high / wide
                                                              : 2 * high;
    const double limit = line.method == LineMethod::error ? 0.5 : 0, sum = last.error + added;
    const bool isUp = run >= rise ? next.y != last.y : next.x != last.x;
    showBar(gpu, (sum - limit) / (2 * added), grid, frame,
            "e = " + formatted("%.3g", last.error) + " + " + formatted("%.3g", added) + " = " + formatted("%.3g", sum) +
                (isUp ? ", not below " : ", below ") + formatted("%.3g", limit) +
                (isUp ? ": the next pixel is one higher" : ": the next pixel is in the same row"));
}

}  // namespace mv::rasterizer
