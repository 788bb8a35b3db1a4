// A scene of a study as a chart: what stands where, for whatever draws it, the SVG or the window. Error to the right, time
// upwards, both logarithmic.
#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mv/study/data.h"
#include "mv/study/look.h"

namespace mv {

// A mark of half size 1 round 0, y downwards: lines through these places. A disc has none.
struct MarkShape {
    struct Place {
        double x, y;
    };
    std::vector<std::vector<Place>> paths;
    bool filled;  // else strokes, closed where a path has more than two places
};
MarkShape shapeOf(Mark mark);

// Pixels of a dash and of the gap after it, at ordinary density; 0 for a solid line.
struct DashLengths {
    double on, off;
};
DashLengths lengthsOf(Dash dash);

// Positions are pixels, y downwards.
struct ChartBox {
    double left = 0, top = 0, right = 0, bottom = 0;
    bool meets(const ChartBox& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

// The frame that a chart is laid out for.
struct ChartSpace {
    ChartBox area;                                    // with the points
    double beside = 0;                                // room right of it, for a label of the axis
    double line = 12;                                 // height of a line of text
    double mark = 4;                                  // half the size of a point's mark
    std::function<double(const std::string&)> width;  // of a text
    bool joined = true;                               // a method's points, by its line
};

// A logarithmic axis. Its ends are 1, 2 or 5 times a power of ten, so that a single value has an axis, too.
struct ChartAxis {
    double low = 1, high = 10;  // values
    double from = 0, to = 1;    // where these are
    double at(double value) const;
    // The value at a place; at the nearer end beyond the axis.
    double valueAt(double place) const;
};

struct ChartTick {
    double value = 1;
    bool power = false;    // of ten
    std::string label;     // "" where there is no room beside the others
    double labelFrom = 0;  // its left, below the axis of errors; its top, beside that of times
};

struct ChartPoint {
    std::size_t row, series;  // into StudyRun::rows, Chart::series
    double x, y;
};

struct ChartLine {
    std::size_t series;
    double fromX, fromY, toX, toY;
};

// A text beside a point.
struct ChartLabel {
    std::size_t row, series;
    std::string text;
    ChartBox box;
};

struct ChartSeries {
    std::string method;
    SeriesLook look;
    std::string legend;  // the method, the knob that moves along the line, and the slopes
};

struct Chart {
    ChartAxis error, time;
    std::optional<double> zero;  // where errors of 0 stand: they have no place on a logarithmic axis
    std::vector<ChartTick> errorTicks, timeTicks;
    std::vector<ChartSeries> series;
    std::vector<ChartPoint> points;
    std::vector<ChartLine> lines;
    std::vector<ChartLabel> labels;  // none meets another, a point's mark or a line
    std::string alongLines;          // which knobs move along the lines, for the error's axis; "" for none
};

// Two labelled ticks at least stand on each axis that is longer than two labels. Nothing where no row of the scene has an
// error and a time.
std::optional<Chart> layOutChart(const StudyRun& run, const std::string& scene, const ChartSpace& space);

// How wide the labels of the time's axis may be, which stand left of the area; the area's own left side does not matter.
double timeLabelWidth(const StudyRun& run, const std::string& scene, const ChartSpace& space);

}  // namespace mv
