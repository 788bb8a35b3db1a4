// A picture of panes beside each other above a strip of graphs, with words in colours.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "mv/demo/frame.h"
#include "mv/geometry/plot.h"
#include "mv/gl/drawing.h"

namespace mv {

// The pane from one part of the width to another, above the strip, which is three tenths of the height.
Pane paneAboveStrip(const FrameInfo& frame, double from, double to);
// The box of a graph in the strip, from one part of the width to another, with room for its numbers and its title.
Box graphInStrip(const FrameInfo& frame, double from, double to);

// The first of 1, 2, 5, 10, 20, 50 ... (and parts) that is no less: the end of an axis that has a tick there. Refused: what is not
// above 0.
double roundAbove(double value);

// Words that stand one after the other, each in its colour.
using ColoredWords = std::vector<std::pair<std::string, vec4>>;
// On the line numbered `line`, from 0, below the upper edge of the pane, or from -1 above its lower edge. Their size is the
// picture's, or less, down to 6 px, where they would not fit into the pane; words that do not fit then are left out.
void drawWords(Drawing& drawing, const FrameInfo& frame, const Pane& pane, int line, const ColoredWords& words);
// The plot's axes, and its title above it, no wider than the plot by the same rule. The whole picture must be the drawing's pane.
void drawAxes(Drawing& drawing, const FrameInfo& frame, const Plot& plot, const ColoredWords& title);

}  // namespace mv
