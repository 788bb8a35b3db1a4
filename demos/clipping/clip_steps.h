// The steps of the methods for a segment, drawn and in words. Segment and window are `offset` farther from the origin than
// the figure's plane shows them.
#pragma once
#include <vector>

#include "clip_figure.h"

namespace mv {

// Cohen and Sutherland: the first `made` rounds, those to come in grey.
void showRounds(ClipFigure& figure, const std::vector<CodeRound>& rounds, int made, double offset);
// Liang and Barsky, Cyrus and Beck: the parameters t at which the segment's line crosses the lines of the four sides.
void showParameters(ClipFigure& figure, const Segment& whole, const Box& box, double offset, bool withDistances);
// The library's method: the side of the segment's line on which each corner lies.
void showCorners(ClipFigure& figure, const Segment& whole, const Box& box, double offset);

}  // namespace mv
