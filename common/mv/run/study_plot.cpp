// What a study looks like: its table, its plot and its page.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "mv/error.h"
#include "mv/gl/word_sheet.h"
#include "mv/run/gnuplot.h"
#include "mv/run/study.h"
#include "mv/run/study_chart.h"
#include "mv/run/words.h"

namespace mv {
namespace {

// ---- The SVG. A study may be anybody's file: its texts come into gnuplot's script by quotedForGnuplot() alone, and not
// into data, in which quotes cannot be quoted.

// Pixels of the SVG, which is as wide as a page shows it, so that no letter is smaller there than here.
constexpr int svgWidth = 900;
constexpr double plotLeft = 76, plotRight = 866, plotHeight = 340;
constexpr double titleSize = 15, textSize = 12, labelSize = 11;
constexpr double lineHeight = 17;
constexpr double markHalf = 4.5;

// DejaVu Sans is 1.164 of its size high, from its deepest letter to its highest.
double textWidth(const std::string& text, double size) { return widthOf(text, int(std::lround(1.164 * size))); }

// The words in lines that are no wider than that, broken at spaces.
std::vector<std::string> linesOf(const std::string& text, double width, double size) {
    std::vector<std::string> lines{""};
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (!lines.back().empty() && textWidth(longer, size) > width) {
            lines.push_back(word);
        } else {
            lines.back() = longer;
        }
    }
    return lines;
}

int gnuplotMark(Mark mark) {
    switch (mark) {
        case Mark::disc:
            return 7;
        case Mark::square:
            return 5;
        case Mark::triangle:
            return 9;
        case Mark::diamond:
            return 13;
        case Mark::wedge:
            return 11;
        case Mark::openSquare:
            return 4;
        case Mark::openTriangle:
            return 8;
        case Mark::openDiamond:
            return 12;
        case Mark::openWedge:
            return 10;
        case Mark::cross:
            return 2;
        case Mark::plus:
            return 1;
        case Mark::pentagon:
            return 15;
        case Mark::star:
            return 3;
    }
    return 7;
}

// For a line, and for a mark.
std::string strokeOf(const SeriesLook& look) {
    const char* const dashes[] = {"solid", "(9,5)", "(2,4)"};
    char color[16];
    std::snprintf(color, sizeof color, "'#%06X'", static_cast<unsigned>(look.on(blackInk)));
    return std::string("lw 1.8 dt ") + dashes[static_cast<std::size_t>(look.dash)] + " lc rgb " + color;
}
std::string pointOf(const SeriesLook& look) {
    char color[16];
    std::snprintf(color, sizeof color, "'#%06X'", static_cast<unsigned>(look.on(blackInk)));
    return "pt " + std::to_string(gnuplotMark(look.mark)) + " ps 0.9 lw 1.8 lc rgb " + color;
}
constexpr const char* ring = "pt 6 ps 1.9 lw 1.6 lc rgb 'black'";

// Collects the script. Positions are pixels of the whole SVG, y downwards.
class SvgScript {
  public:
    explicit SvgScript(double height) : height_(height) {}
    std::string at(double x, double y) const {
        return "screen " + formatted("%.6f", x / svgWidth) + ", screen " + formatted("%.6f", 1 - y / height_);
    }
    // Its middle is at that height.
    void write(const std::string& text, double x, double y, double size, const std::string& more = "left") {
        script_ += "set label " + quotedForGnuplot(text) + " at " + at(x, y) + " " + more + " front font '," +
                   formatted("%g", size) + "' noenhanced\n";
    }
    void line(double fromX, double fromY, double toX, double toY, const std::string& stroke) {
        script_ += "set arrow from " + at(fromX, fromY) + " to " + at(toX, toY) + " nohead front " + stroke + "\n";
    }
    void point(double x, double y, const std::string& mark) {
        script_ += "set label '' at " + at(x, y) + " front point " + mark + "\n";
    }
    void add(const std::string& text) { script_ += text; }
    const std::string& text() const { return script_; }
    double height() const { return height_; }

  private:
    double height_;
    std::string script_;
};

std::string tics(const char* axis, const std::vector<ChartTick>& ticks) {
    std::string list;
    for (const ChartTick& tick : ticks) {
        list += (list.empty() ? "" : ", ") + quotedForGnuplot(tick.label) + formatted(" %.9g", tick.value);
    }
    return std::string("set ") + axis + "tics (" + list + ")\n";
}

struct SceneSvg {
    std::string scene;
    ChartSpace space;
    Chart chart;
    double top = 0;                                // of all of it
    std::vector<std::vector<std::string>> legend;  // lines of each series
    std::vector<std::string> title, axis;          // lines above the plot and below it
    double bottom() const { return legendTop() + double(legendLines()) * lineHeight + 30; }
    double legendTop() const { return space.area.bottom + 32 + double(axis.size()) * lineHeight + 6; }
    std::size_t legendLines() const {
        std::size_t lines = 1;  // the ring's
        for (const auto& entry : legend) lines += entry.size();
        return lines;
    }
};

SceneSvg sceneSvg(const StudyRun& run, const std::string& scene, double top) {
    SceneSvg svg;
    svg.scene = scene;
    svg.top = top;
    svg.title = linesOf(run.demo + (scene.empty() ? "" : ": " + scene), plotRight - plotLeft, titleSize);
    svg.space.beside = svgWidth - plotRight;
    svg.space.line = labelSize + 3;
    svg.space.mark = markHalf;
    svg.space.width = [](const std::string& text) { return textWidth(text, labelSize); };
    const double above = top + 12 + double(svg.title.size()) * 20;
    svg.space.area = {plotLeft, above, plotRight, above + plotHeight};
    auto chart = layOutChart(run, scene, svg.space);
    if (!chart) throw Error("plot", "must have a row with an error and a time", scene);
    svg.chart = std::move(*chart);
    svg.axis = linesOf(errorName(run.axis) + ": " + run.quantity, plotRight - plotLeft, textSize);
    if (!svg.chart.alongLines.empty()) {
        for (std::string& line : linesOf(svg.chart.alongLines, plotRight - plotLeft, textSize)) {
            svg.axis.push_back(std::move(line));
        }
    }
    for (const ChartSeries& series : svg.chart.series) {
        svg.legend.push_back(linesOf(series.legend, plotRight - plotLeft - 44, textSize));
    }
    return svg;
}

void drawScene(SvgScript& script, const StudyRun& run, const SceneSvg& svg) {
    const Chart& chart = svg.chart;
    const ChartBox& area = svg.space.area;
    // What the whole area shows: the axis of errors goes on below its low end, where the errors of 0 stand.
    const double perPixel = std::log(chart.error.high / chart.error.low) / (chart.error.to - chart.error.from);
    const double leftEnd = chart.error.low * std::exp(perPixel * (area.left - chart.error.from));
    const auto errorAt = [&](double x) { return chart.error.low * std::exp(perPixel * (x - chart.error.from)); };
    const double screen = 1 / script.height();
    script.add("unset label\nunset arrow\nset lmargin at screen " + formatted("%.6f", area.left / svgWidth) +
               "\nset rmargin at screen " + formatted("%.6f", area.right / svgWidth) + "\nset tmargin at screen " +
               formatted("%.6f", 1 - area.top * screen) + "\nset bmargin at screen " +
               formatted("%.6f", 1 - area.bottom * screen) + "\n");
    script.add("set xrange [" + formatted("%.9g", leftEnd) + ":" + formatted("%.9g", chart.error.high) +
               "]\nset yrange [" + formatted("%.9g", chart.time.low) + ":" + formatted("%.9g", chart.time.high) +
               "]\n");
    script.add(tics("x", chart.errorTicks) + tics("y", chart.timeTicks));
    if (chart.zero) {
        script.add("set xtics add ('0' " + formatted("%.9g", errorAt(*chart.zero)) + ")\n");
        script.line(chart.error.from, area.top, chart.error.from, area.bottom, "dt (3,3) lw 1 lc rgb '#666666'");
    }
    for (std::size_t i = 0; i < svg.title.size(); ++i) {
        script.write(svg.title[i], plotLeft, svg.top + 12 + 20 * double(i), titleSize);
    }
    script.write(run.width > 0 ? "milliseconds a frame" : "milliseconds", 16, (area.top + area.bottom) / 2, textSize,
                 "center rotate by 90");
    for (std::size_t i = 0; i < svg.axis.size(); ++i) {
        script.write(svg.axis[i], (plotLeft + plotRight) / 2, area.bottom + 40 + lineHeight * double(i), textSize,
                     "center");
    }
    for (const ChartLabel& label : chart.labels) {
        script.write(label.text, label.box.left, (label.box.top + label.box.bottom) / 2, labelSize);
    }
    double y = svg.legendTop() + lineHeight;
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        script.line(plotLeft, y, plotLeft + 32, y, strokeOf(chart.series[i].look));
        script.point(plotLeft + 16, y, pointOf(chart.series[i].look));
        for (const std::string& line : svg.legend[i]) {
            script.write(line, plotLeft + 42, y, textSize);
            y += lineHeight;
        }
    }
    script.point(plotLeft + 16, y, ring);
    script.write("Pareto-best: " + bestText(run), plotLeft + 42, y, textSize);

    std::string data, plots;
    int index = 0;
    const auto addBlock = [&](const std::string& points, const std::string& style) {
        if (points.empty()) return;
        const std::string name = "$block" + std::to_string(index++);
        data += name + " << END\n" + points + "END\n";
        plots += (plots.empty() ? "plot " : ", \\\n  ") + name + " using 1:2 with " + style + " notitle";
    };
    const auto pointText = [&](double x, double timeY) {
        return formatted("%.9g ", errorAt(x)) + formatted("%.9g\n", chart.time.valueAt(timeY));
    };
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        std::string lines;
        for (const ChartLine& line : chart.lines) {
            if (line.series == i) lines += pointText(line.fromX, line.fromY) + pointText(line.toX, line.toY) + "\n";
        }
        addBlock(lines, "lines " + strokeOf(chart.series[i].look));
    }
    std::string best;
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        std::string points;
        for (const ChartPoint& point : chart.points) {
            if (point.series != i) continue;
            points += pointText(point.x, point.y);
            if (run.rows[point.row].best) best += pointText(point.x, point.y);
        }
        addBlock(points, "points " + pointOf(chart.series[i].look));
    }
    addBlock(best, std::string("points ") + ring);
    script.add(data + plots + "\n");
}

}  // namespace

std::vector<std::string> scenesOf(const StudyRun& run) {
    std::vector<std::string> scenes;
    for (const StudyRow& row : run.rows) {
        if (std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end()) scenes.push_back(row.scene);
    }
    return scenes;
}

std::vector<std::string> methodsOf(const StudyRun& run, const std::string& scene) {
    std::vector<std::string> methods;
    for (const StudyRow& row : run.rows) {
        if (row.scene != scene) continue;
        if (std::find(methods.begin(), methods.end(), row.method) == methods.end()) methods.push_back(row.method);
    }
    return methods;
}

std::string machineText(const StudyRun& run) {
    return run.renderer + ", " + run.processor + ", " + std::to_string(run.threads) +
           (run.threads == 1 ? " thread" : " threads");
}

std::string countsText(const StudyRow& row) {
    std::string text;
    for (const auto& [name, amount] : row.counts) {
        if (!text.empty()) text += ", ";
        text += std::string(name).append(" ").append(formatted("%.10g", amount));
    }
    return text;
}

std::string referenceText(const StudyRun& run) {
    std::string text = run.reference;
    for (const auto& [scene, error] : run.referenceErrors) {
        text += std::string("; ")
                    .append(scene.empty() ? "its" : scene + ": its")
                    .append(" own error ")
                    .append(errorText(error))
                    .append(" by doubling");
    }
    return text;
}

std::string studyTable(const StudyRun& run) {
    std::vector<std::vector<std::string>> rows{
        {"scene", "method", "p", "rms", "max", "wrong %", "away from edges %", "ms", "MAD", "best", "counts"}};
    std::string failures;
    for (const StudyRow& row : run.rows) {
        if (!row.ok()) {
            failures += "failed: " + row.scene + ", " + row.method + " " + row.parameter + ": " + row.status + "\n";
            rows.push_back({row.scene, row.method, row.parameter, "-", "-", "-", "-", "-", "-", "", "failed"});
            continue;
        }
        rows.push_back({row.scene, row.method, row.parameter, errorText(row.all.rms), errorText(row.all.max),
                        errorText(100 * row.all.fraction), errorText(100 * row.awayFromEdges.fraction),
                        row.rounds ? formatted("%.3g", row.msMedian) : "-",
                        row.rounds ? formatted("%.2g", row.msMad) : "-", row.best ? "*" : "", countsText(row)});
    }
    std::string text = run.demo + ": " + run.quantity + "\nreference: " + referenceText(run) +
                       "\nmachine: " + machineText(run) + "\n\n" + aligned(rows, 3) + failures + "\n";
    for (const std::string& scene : scenesOf(run)) {
        for (const std::string& method : methodsOf(run, scene)) {
            const auto error = errorSlope(run, scene, method), time = timeSlope(run, scene, method);
            if (!error && !time) continue;
            text.append("slope ").append(scene.empty() ? "" : scene + ", ").append(method).append(":");
            if (error) text += formatted(" error ~ p^%.2f", *error);
            if (time) text += formatted(" time ~ p^%.2f", *time);
            text += "\n";
        }
    }
    return text;
}

std::string studySvg(const StudyRun& run) {
    std::vector<SceneSvg> scenes;
    double bottom = 4;
    for (const std::string& scene : scenesOf(run)) {
        scenes.push_back(sceneSvg(run, scene, bottom));
        bottom = scenes.back().bottom();
    }
    std::vector<std::string> foot = linesOf("Reference: " + referenceText(run), svgWidth - 20, labelSize);
    for (std::string& line : linesOf("Measured on: " + machineText(run), svgWidth - 20, labelSize)) {
        foot.push_back(std::move(line));
    }
    SvgScript script(bottom + double(foot.size()) * lineHeight + 8);
    script.add("set terminal svg size " + std::to_string(svgWidth) + "," + formatted("%.0f", script.height()) +
               " dynamic font 'DejaVu Sans," + formatted("%g", textSize) +
               "' background rgb 'white'\nset encoding utf8\nset logscale xy\nset grid lc rgb '#dddddd'\nunset key\n" +
               "set border lw 1\nset xtics scale 0.6\nset ytics scale 0.6\nset origin 0,0\nset size 1,1\n" +
               "set multiplot\n");
    for (const SceneSvg& scene : scenes) drawScene(script, run, scene);
    // Words alone: a plot without axes, of nothing
    script.add("unset label\nunset arrow\nunset border\nunset tics\nunset grid\n");
    for (std::size_t i = 0; i < foot.size(); ++i) {
        script.write(foot[i], 10, bottom + lineHeight * (double(i) + 0.5), labelSize);
    }
    return drawnByGnuplot(script.text() + "plot 1/0 notitle\nunset multiplot\nset output\n");
}

}  // namespace mv
