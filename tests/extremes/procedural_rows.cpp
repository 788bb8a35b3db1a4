// X52: patterns far from the origin.
#include <algorithm>
#include <cmath>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "shared/procedural.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int width = 160, height = 120;

// A wall with the pattern, 2^24 from the origin, as the demo draws it: the largest error of a pixel.
double off(const std::string& pattern, Pattern which, const std::string& origin) {
    DemoRun run("procedural", width, height);
    run.set("view", "wall").set("pattern", pattern).set("distance", 16'777'216).set("origin", origin);
    (void)run.picture();
    const auto shown = stage().measure(1);
    const PatternPlace place{which, 5, 0, patternCentre(16'777'216)};
    double worst = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            // In the middle of its pixels; bricks are not asked beside an edge.
            const vec3 offset((2 * (x + 0.5) / width - 1) * 1.5 * width / height, (1 - 2 * (y + 0.5) / height) * 1.5,
                              0);
            const double truth = patternAt(place, offset);
            const auto same = [&](double dx, double dy) { return patternAt(place, offset + vec3(dx, dy, 0)) == truth; };
            if (which == Pattern::brick &&
                !(same(1e-4, 1e-4) && same(-1e-4, 1e-4) && same(1e-4, -1e-4) && same(-1e-4, -1e-4)))
                continue;
            worst = worse(worst, std::abs(truth - double(shown[pixelIndex(x, y, width)])));
        }
    }
    return worst;
}

Row row(const std::string& pattern, Pattern which) {
    return {.id = "X52 " + pattern,
            .input = pattern + " on a wall 2^24 from the origin, 160x120 pixels",
            .measured = "largest error of a pixel's number, 0..1",
            .naive = "the point in floats",
            .naiveError = off(pattern, which, "far"),
            .ours = "cells and places in them, of the middle in double; offsets in floats",
            .ourError = off(pattern, which, "near"),
            .tolerance = 1e-5,
            .reason = "floats' 6e-8 of a place in a cell, times slopes of noise and of what it bends"};
}

[[maybe_unused]] const bool x52noise = addRow([] { return row("noise", Pattern::noise); });
[[maybe_unused]] const bool x52brick = addRow([] { return row("brick", Pattern::brick); });
[[maybe_unused]] const bool x52wood = addRow([] { return row("wood", Pattern::wood); });

}  // namespace
