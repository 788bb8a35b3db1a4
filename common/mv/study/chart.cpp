#include "mv/study/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mv/paper/tables.h"
#include "mv/study/study.h"

namespace mv {

// ---- Marks and dashes

MarkShape shapeOf(Mark mark) {
    // Places round the middle, from the top on; the first is `turn` of a whole turn further.
    const auto round = [](int count, double radius, double turn) {
        std::vector<MarkShape::Place> places;
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * (double(i) / count + turn);
            places.push_back({radius * std::sin(angle), -radius * std::cos(angle)});
        }
        return places;
    };
    const auto strokes = [&](int count, double turn) {
        MarkShape shape{{}, false};
        for (int i = 0; i < count; ++i) shape.paths.push_back(round(2, 1.25, double(i) / (2 * count) + turn));
        return shape;
    };
    switch (mark) {
        case Mark::disc:
            break;
        case Mark::square:
            return {{round(4, 1.3, 0.125)}, true};
        case Mark::triangle:
            return {{round(3, 1.4, 0)}, true};
        case Mark::diamond:
            return {{round(4, 1.4, 0)}, true};
        case Mark::wedge:
            return {{round(3, 1.4, 0.5)}, true};
        case Mark::openSquare:
            return {{round(4, 1.3, 0.125)}, false};
        case Mark::openTriangle:
            return {{round(3, 1.4, 0)}, false};
        case Mark::openDiamond:
            return {{round(4, 1.4, 0)}, false};
        case Mark::openWedge:
            return {{round(3, 1.4, 0.5)}, false};
        case Mark::cross:
            return strokes(2, 0.125);
        case Mark::plus:
            return strokes(2, 0);
        case Mark::pentagon:
            return {{round(5, 1.3, 0)}, true};
        case Mark::star:
            return strokes(3, 0);
    }
    return {{}, true};
}

DashLengths lengthsOf(Dash dash) {
    if (dash == Dash::solid) return {0, 0};
    return dash == Dash::dashed ? DashLengths{7, 4} : DashLengths{2, 3};
}

namespace {

// ---- Axes

double decadeOf(double value) { return std::pow(10, std::floor(std::log10(value))); }

// 1, 2 or 5 times a power of ten: the next one down or up.
double niceBelow(double value) {
    const double decade = decadeOf(value);
    for (const double step : {5.0, 2.0}) {
        if (step * decade <= value) return step * decade;
    }
    return decade;
}
double niceAbove(double value) {
    const double decade = decadeOf(value);
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * decade >= value) return step * decade;
    }
    return 10 * decade;
}

struct Range {
    double low = 0, high = 0;  // of the positive values; 0 where there are none
    void add(double value) {
        if (value <= 0) return;
        low = low == 0 ? value : std::min(low, value);
        high = std::max(high, value);
    }
};

struct Ranges {
    Range error, time;
    bool anyZero = false;
};

// Nothing where no row is plotted.
std::optional<Ranges> rangesOf(const StudyRun& run, const std::string& scene) {
    Ranges ranges;
    long most = 0;  // values compared
    for (const StudyRow& row : run.rows) {
        if (row.scene != scene || !isPlotted(row)) continue;
        ranges.time.add(row.msMedian);
        ranges.error.add(run.shownError(row));
        ranges.anyZero |= run.shownError(row) == 0;
        most = std::max(most, row.all.n);
    }
    if (ranges.time.low == 0) return {};
    // An axis on which every error is 0 shows what it could have been: from one wrong value of all to all of them.
    if (ranges.error.low == 0) {
        ranges.error.add(1);
        if (run.axis == ErrorAxis::fraction && most > 0) ranges.error.add(1.0 / double(most));
    }
    return ranges;
}

// With room round its values, so that no mark is cut off.
ChartAxis axisOf(const Range& range, double from, double to) {
    return {niceBelow(range.low / 1.2), niceAbove(range.high * 1.2), from, to};
}

std::string superscript(int number) {
    static constexpr std::array<const char*, 10> digits{"\u2070", "\u00B9", "\u00B2", "\u00B3", "\u2074",
                                                        "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    std::string text = number < 0 ? "\u207B" : "";
    for (const char c : std::to_string(std::abs(number))) text += digits[static_cast<std::size_t>(c - '0')];
    return text;
}

// Plain numbers, or powers of ten for all of an axis where some would be long.
std::string tickText(const ChartAxis& axis, const ChartTick& tick) {
    if (axis.low > 0.9e-4 && axis.high < 1.1e5) return formatted("%g", tick.value);
    const int power = static_cast<int>(std::lround(std::log10(decadeOf(tick.value * 1.001))));
    const double factor = tick.value / std::pow(10, power);
    return (tick.power ? "" : formatted("%.0f\u00B7", factor)) + "10" + superscript(power);
}

// `largest`: what lies beyond is room for marks, and no value.
std::vector<ChartTick> ticksOf(const ChartAxis& axis, double largest) {
    std::vector<ChartTick> ticks;
    const int last = static_cast<int>(std::floor(std::log10(axis.high * 1.001)));
    const int first = static_cast<int>(std::floor(std::log10(axis.low * 1.001)));
    for (int power = first; power <= last; ++power) {
        for (const double step : {1.0, 2.0, 5.0}) {
            const double value = step * std::pow(10, power);
            if (value < axis.low * 0.999 || value > std::min(axis.high, largest) * 1.001) continue;
            if (step == 1 || last - first < 8) ticks.push_back({value, step == 1, ""});
        }
    }
    return ticks;
}

// How much of the axis a label takes.
using Extent = std::function<std::pair<double, double>(double place, const std::string& text)>;

// Gives each tick its label where there is room: the powers of ten first, then the others. The ends come before them
// where that leaves one label. Between two stays a gap. Returns how many have one.
long labelTicks(std::vector<ChartTick>& ticks, const ChartAxis& axis, const Extent& extent, double gap,
                const std::vector<std::pair<double, double>>& taken) {
    long labelled = 0;
    for (const bool endsFirst : {false, true}) {
        std::vector<ChartTick*> order;
        if (endsFirst && !ticks.empty()) order = {&ticks.front(), &ticks.back()};
        for (const bool power : {true, false}) {
            for (ChartTick& tick : ticks) {
                if (tick.power == power) order.push_back(&tick);
            }
        }
        auto used = taken;
        for (ChartTick& tick : ticks) tick.label.clear();
        for (ChartTick* tick : order) {
            const std::string text = tickText(axis, *tick);
            const auto [from, to] = extent(axis.at(tick->value), text);
            const bool free = std::none_of(used.begin(), used.end(), [&, from = from, to = to](const auto& other) {
                return from < other.second + gap && other.first < to + gap;
            });
            if (!free || !tick->label.empty()) continue;
            tick->label = text;
            tick->labelFrom = from;
            used.emplace_back(from, to);
        }
        labelled = std::count_if(ticks.begin(), ticks.end(), [](const ChartTick& tick) { return !tick.label.empty(); });
        if (labelled >= 2) break;
    }
    return labelled;
}

// ---- Words

// The first and the last value that the knob has in these rows: "256 … 4096", or the only one.
std::string spanOf(const std::vector<const StudyRow*>& rows) {
    if (rows.empty()) return "";
    const std::string &first = rows.front()->parameter, &last = rows.back()->parameter;
    return first == last ? first : first + " \u2026 " + last;
}

std::string legendOf(const StudyRun& run, const std::string& scene, const std::string& method) {
    std::vector<const StudyRow*> plotted, onLine;
    for (const StudyRow& row : run.rows) {
        if (row.scene != scene || row.method != method) continue;
        if (isPlotted(row)) plotted.push_back(&row);
        if (isOnLine(run, row)) onLine.push_back(&row);
    }
    const std::string knob = knobOf(run, scene, method);
    if (knob.empty() || plotted.empty()) return method;
    std::string text = method + ": " + knob + " " + spanOf(plotted);
    const auto ofError = errorSlope(run, scene, method), drawn = drawnSlope(run, scene, method);
    if (ofError) text += ", error ~ " + knob + formatted("^%.2f", *ofError);
    if (drawn) text += ", time ~ error" + formatted("^%.2f", *drawn);
    if (!ofError && !drawn) return text;
    // A slope of the logarithms knows no 0, neither of the error nor of the knob.
    std::vector<const StudyRow*> counted;
    for (const StudyRow* row : onLine) {
        if (row->parameter != "0") counted.push_back(row);
    }
    if (ofError && counted.size() < plotted.size()) text += " over " + spanOf(counted);
    return text;
}

// "resolution 256 … 4096; taps 1 … 31"
std::string knobsAlongLines(const StudyRun& run, const std::string& scene) {
    struct Knob {
        std::string name;
        std::vector<const StudyRow*> widest;
    };
    std::vector<Knob> knobs;
    for (const std::string& method : methodsOf(run, scene)) {
        const std::string name = knobOf(run, scene, method);
        if (name.empty()) continue;
        std::vector<const StudyRow*> rows;
        for (const StudyRow& row : run.rows) {
            if (row.scene == scene && row.method == method && isPlotted(row)) rows.push_back(&row);
        }
        const auto known =
            std::find_if(knobs.begin(), knobs.end(), [&](const Knob& knob) { return knob.name == name; });
        if (known == knobs.end()) {
            knobs.push_back({name, rows});
        } else if (rows.size() > known->widest.size()) {
            known->widest = rows;
        }
    }
    std::string text;
    for (const Knob& knob : knobs) {
        if (!knob.widest.empty()) text += (text.empty() ? "" : "; ") + knob.name + " " + spanOf(knob.widest);
    }
    return text.empty() ? "" : "along a line: " + text;
}

// ---- Labels beside points

bool crosses(const ChartLine& line, const ChartBox& box) {
    // The part of the line inside the four sides
    double enter = 0, leave = 1;
    const double dx = line.toX - line.fromX, dy = line.toY - line.fromY;
    const auto cut = [&](double from, double d, double low, double high) {
        if (d == 0) return from > low && from < high;
        const double a = (low - from) / d, b = (high - from) / d;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
        return enter < leave;
    };
    return cut(line.fromX, dx, box.left, box.right) && cut(line.fromY, dy, box.top, box.bottom);
}

class Labeller {
  public:
    Labeller(Chart& chart, const StudyRun& run, const ChartSpace& space) : chart_(chart), run_(run), space_(space) {
        for (const ChartPoint& point : chart.points) marks_.push_back(markOf(point));
    }

    // The ends of each line with the knob's name, else with the value alone; then what is between where it fits.
    void label(const std::string& scene) {
        std::vector<std::vector<const ChartPoint*>> lines(chart_.series.size());
        for (const ChartPoint& point : chart_.points) {
            if (!run_.rows[point.row].parameter.empty()) lines[point.series].push_back(&point);
        }
        for (const bool ends : {true, false}) {
            for (std::size_t i = 0; i < lines.size(); ++i) {
                const std::string knob = knobOf(run_, scene, chart_.series[i].method);
                const std::string prefix = knob.empty() ? "" : knob + " ";
                for (const ChartPoint* point : lines[i]) {
                    const bool isEnd = point == lines[i].front() || point == lines[i].back();
                    if (isEnd != ends) continue;
                    const std::string& value = run_.rows[point->row].parameter;
                    if (!place(*point, prefix + value)) place(*point, value);
                }
            }
        }
    }

  private:
    // With the ring of a best one.
    ChartBox markOf(const ChartPoint& point) const {
        const double half = space_.mark * (run_.rows[point.row].best ? 1.9 : 1.2);
        return {point.x - half, point.y - half, point.x + half, point.y + half};
    }

    bool place(const ChartPoint& point, const std::string& text) {
        const double width = space_.width(text), height = space_.line;
        const ChartBox mark = markOf(point);
        const double gap = 2, right = mark.right + gap, left = mark.left - gap - width;
        const double above = mark.top - height, below = mark.bottom, middle = point.y - height / 2;
        const double across = point.x - width / 2;
        for (const auto& [x, y] : {std::pair{right, middle},
                                   {right, above + height / 2},
                                   {right, below - height / 2},
                                   {left, middle},
                                   {left, above + height / 2},
                                   {left, below - height / 2},
                                   {across, above},
                                   {across, below}}) {
            const ChartBox box{x, y, x + width, y + height};
            if (!isFree(box)) continue;
            chart_.labels.push_back({point.row, point.series, text, box});
            return true;
        }
        return false;
    }

    bool isFree(const ChartBox& box) const {
        const ChartBox& area = space_.area;
        if (box.left < area.left || box.right > area.right || box.top < area.top || box.bottom > area.bottom) {
            return false;
        }
        // Between the errors of 0 and the axis stands a line
        if (chart_.zero && box.left < chart_.error.from && box.right > chart_.error.from) return false;
        return std::none_of(marks_.begin(), marks_.end(), [&](const ChartBox& mark) { return mark.meets(box); }) &&
               std::none_of(chart_.labels.begin(), chart_.labels.end(),
                            [&](const ChartLabel& label) { return label.box.meets(box); }) &&
               std::none_of(chart_.lines.begin(), chart_.lines.end(),
                            [&](const ChartLine& line) { return crosses(line, box); });
    }

    Chart& chart_;
    const StudyRun& run_;
    const ChartSpace& space_;
    std::vector<ChartBox> marks_;
};

}  // namespace

double ChartAxis::at(double value) const { return from + (to - from) * std::log(value / low) / std::log(high / low); }

double ChartAxis::valueAt(double place) const {
    const double part = std::clamp((place - from) / (to - from), 0.0, 1.0);
    return low * std::pow(high / low, part);
}

double timeLabelWidth(const StudyRun& run, const std::string& scene, const ChartSpace& space) {
    const std::optional<Ranges> ranges = rangesOf(run, scene);
    if (!ranges) return 0;
    const ChartAxis axis = axisOf(ranges->time, space.area.bottom, space.area.top);
    double width = 0;
    for (const ChartTick& tick : ticksOf(axis, axis.high)) width = std::max(width, space.width(tickText(axis, tick)));
    return width;
}

std::optional<Chart> layOutChart(const StudyRun& run, const std::string& scene, const ChartSpace& space) {
    const std::optional<Ranges> ranges = rangesOf(run, scene);
    if (!ranges) return {};
    Chart chart;
    const ChartBox& area = space.area;
    const double zeroWidth = 6 * space.mark;
    if (ranges->anyZero) chart.zero = area.left + zeroWidth / 2;
    chart.time = axisOf(ranges->time, area.bottom, area.top);
    chart.error = axisOf(ranges->error, area.left + (ranges->anyZero ? zeroWidth : 0), area.right);
    double largest = chart.error.high;
    if (run.axis == ErrorAxis::fraction && chart.error.high > 1) {  // more than all cannot be wrong
        largest = 1;
        chart.error.high = 1.3;
    }

    chart.timeTicks = ticksOf(chart.time, chart.time.high);
    const auto besideAxis = [&](double place, const std::string&) {
        return std::pair{place - space.line / 2, place + space.line / 2};
    };
    labelTicks(chart.timeTicks, chart.time, besideAxis, 0, {});
    std::vector<std::pair<double, double>> taken;
    if (chart.zero) taken.emplace_back(*chart.zero - space.width("0") / 2, *chart.zero + space.width("0") / 2);
    const auto belowAxis = [&](double place, const std::string& text) {
        const double width = space.width(text), left = std::min(place - width / 2, area.right + space.beside - width);
        return std::pair{left, left + width};
    };
    for (int tries = 0; tries < 9; ++tries) {
        chart.errorTicks = ticksOf(chart.error, largest);
        if (labelTicks(chart.errorTicks, chart.error, belowAxis, space.width("0"), taken) >= 2) break;
        chart.error.low = niceBelow(0.99 * chart.error.low);  // the label at the low end had no room beside that of 0
    }

    const std::vector<std::string> methods = methodsOf(run, scene);
    for (std::size_t i = 0; i < methods.size(); ++i) {
        chart.series.push_back({methods[i], seriesLook(i), legendOf(run, scene, methods[i])});
        const ChartPoint* last = nullptr;
        std::vector<ChartPoint> points;
        points.reserve(run.rows.size());  // so that `last` stays
        for (std::size_t row = 0; row < run.rows.size(); ++row) {
            const StudyRow& each = run.rows[row];
            if (each.scene != scene || each.method != methods[i] || !isPlotted(each)) continue;
            const double error = run.shownError(each);
            points.push_back({row, i, error > 0 ? chart.error.at(error) : *chart.zero, chart.time.at(each.msMedian)});
            const ChartPoint& here = points.back();
            // A row without any error is on no line: it is infinitely far.
            if (space.joined && last && error > 0) chart.lines.push_back({i, last->x, last->y, here.x, here.y});
            last = error > 0 ? &here : nullptr;
        }
        chart.points.insert(chart.points.end(), points.begin(), points.end());
    }
    chart.alongLines = knobsAlongLines(run, scene);
    Labeller(chart, run, space).label(scene);
    return chart;
}

}  // namespace mv
