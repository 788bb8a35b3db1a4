// How the methods for a segment come to their answer, drawn and in words. Segment and window are `offset` farther from the
// origin than the figure's plane shows them.
#pragma once
#include <vector>

#include "clip_figure.h"

namespace mv {

// Cohen and Sutherland: the first `made` rounds, those to come in grey.
void showRounds(ClipFigure& figure, const std::vector<CodeRound>& rounds, int made, double offset);
// Liang and Barsky, Cyrus and Beck: where the segment's line crosses those of the four sides, by t.
void showParameters(ClipFigure& figure, const Segment& whole, const Box& box, double offset, bool withDistances);
// The library's: on which side of the segment's line the corners lie.
void showCorners(ClipFigure& figure, const Segment& whole, const Box& box, double offset);

}  // namespace mv
