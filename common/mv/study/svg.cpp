// A study's plot as SVG, from the layout that the window draws, too (chart.h). A study may be anybody's file: each of its texts
// comes into the SVG by escaped() alone.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "mv/error.h"
#include "mv/gl/word_sheet.h"
#include "mv/paper/tables.h"
#include "mv/study/chart.h"
#include "mv/study/study.h"

namespace mv {
namespace {

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

// As XML's text, in which no mark is taken for one; a control character, which XML does not have, is a space.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&') {
            result += "&amp;";
        } else if (c == '<') {
            result += "&lt;";
        } else if (c == '>') {
            result += "&gt;";
        } else if (c == '"') {
            result += "&quot;";
        } else {
            result += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
        }
    }
    return result;
}

// The whole of it, collected. Positions are pixels, y downwards.
class Svg {
  public:
    // An element, with attributes in turns of name and value.
    Svg& add(const std::string& element) {
        text_ += element + "\n";
        return *this;
    }
    // Its middle is at that height: a third of its size is above the line that letters stand on.
    void write(const std::string& text, double x, double y, double size, const std::string& more = "") {
        add("<text" + at("x", x) + at("y", y + 0.35 * size) + " font-size=\"" + formatted("%g", size) + "\"" + more +
            ">" + escaped(text) + "</text>");
    }
    void line(double fromX, double fromY, double toX, double toY, const std::string& stroke) {
        add("<line" + at("x1", fromX) + at("y1", fromY) + at("x2", toX) + at("y2", toY) + stroke + "/>");
    }
    void ring(double x, double y) {
        add("<circle" + at("cx", x) + at("cy", y) + at("r", 1.9 * markHalf) +
            " fill=\"none\" stroke=\"#000000\" stroke-width=\"1.6\"/>");
    }
    void mark(double x, double y, const SeriesLook& look) {
        const MarkShape shape = shapeOf(look.mark);
        const std::string color = colorOf(look);
        if (shape.paths.empty()) {
            add("<circle" + at("cx", x) + at("cy", y) + at("r", markHalf) + " fill=\"" + color + "\"/>");
            return;
        }
        std::string path;
        for (const auto& places : shape.paths) {
            for (const MarkShape::Place& place : places) {
                path += (&place == places.data() ? "M" : "L") + formatted("%.1f ", x + markHalf * place.x) +
                        formatted("%.1f", y + markHalf * place.y);
            }
            if (places.size() > 2) path += "Z";
        }
        add("<path d=\"" + path + "\" " +
            (shape.filled ? "fill=\"" + color + "\"/>"
                          : "fill=\"#ffffff\" stroke=\"" + color + "\" stroke-width=\"1.6\"/>"));
    }
    static std::string strokeOf(const SeriesLook& look) {
        const DashLengths dash = lengthsOf(look.dash);
        std::string stroke = " stroke=\"" + colorOf(look) + "\" stroke-width=\"1.8\"";
        if (dash.on > 0) stroke += " stroke-dasharray=\"" + formatted("%g ", dash.on) + formatted("%g\"", dash.off);
        return stroke;
    }
    const std::string& text() const { return text_; }

  private:
    static std::string at(const char* name, double value) {
        return std::string(" ") + name + formatted("=\"%.1f\"", value);
    }
    static std::string colorOf(const SeriesLook& look) {
        char color[16];
        std::snprintf(color, sizeof color, "#%06X", static_cast<unsigned>(look.on(blackInk)));
        return color;
    }
    std::string text_;
};

constexpr const char* inTheMiddle = " text-anchor=\"middle\"";
constexpr const char* gridStroke = " stroke=\"#dddddd\"";
constexpr const char* frameStroke = " stroke=\"#000000\"";

struct SceneSvg {
    ChartSpace space;
    Chart chart;
    double top = 0;                                // of all of it
    std::vector<std::vector<std::string>> legend;  // lines of each series
    std::vector<std::string> title, axis;          // lines above the plot and below it
    std::string time;                              // beside it
    double bottom() const { return legendTop() + double(legendLines()) * lineHeight + 30; }
    double legendTop() const { return space.area.bottom + 32 + double(axis.size()) * lineHeight + 6; }
    std::size_t legendLines() const {
        std::size_t lines = space.joined ? 1 : 0;  // the ring's
        for (const auto& entry : legend) lines += entry.size();
        return lines;
    }
};

SceneSvg sceneSvg(const StudyRun& run, const std::string& scene, double top, const PlotWords& words) {
    SceneSvg svg;
    svg.top = top;
    const std::string title = run.demo + (scene.empty() ? "" : ": " + scene) + ", on " + machineName(run);
    svg.title = linesOf(words.title.empty() ? title : words.title, plotRight - plotLeft, titleSize);
    svg.time = !words.time.empty() ? words.time : run.width > 0 ? "milliseconds a frame" : "milliseconds";
    svg.space.beside = svgWidth - plotRight;
    svg.space.line = labelSize + 3;
    svg.space.mark = markHalf;
    svg.space.width = [](const std::string& text) { return textWidth(text, labelSize); };
    svg.space.joined = words.joined;
    const double above = top + 12 + double(svg.title.size()) * 20;
    svg.space.area = {plotLeft, above, plotRight, above + plotHeight};
    auto chart = layOutChart(run, scene, svg.space);
    if (!chart) throw Error("plot", "must have a row with an error and a time", scene);
    svg.chart = std::move(*chart);
    const std::string error = errorName(run.axis) + ": " + run.quantity;
    svg.axis = linesOf(words.error.empty() ? error : words.error, plotRight - plotLeft, textSize);
    if (!svg.chart.alongLines.empty() && words.joined) {
        for (std::string& line : linesOf(svg.chart.alongLines, plotRight - plotLeft, textSize)) {
            svg.axis.push_back(std::move(line));
        }
    }
    for (const ChartSeries& series : svg.chart.series) {
        const std::string& legend = words.joined ? series.legend : series.method;
        svg.legend.push_back(linesOf(legend, plotRight - plotLeft - 44, textSize));
    }
    return svg;
}

void drawAxes(Svg& out, const SceneSvg& svg) {
    const Chart& chart = svg.chart;
    const ChartBox& area = svg.space.area;
    for (const ChartTick& tick : chart.errorTicks) {
        const double x = chart.error.at(tick.value);
        out.line(x, area.top, x, area.bottom, gridStroke);
        if (!tick.label.empty()) out.write(tick.label, tick.labelFrom, area.bottom + 14, labelSize);
    }
    for (const ChartTick& tick : chart.timeTicks) {
        const double y = chart.time.at(tick.value);
        out.line(area.left, y, area.right, y, gridStroke);
        if (!tick.label.empty()) out.write(tick.label, area.left - 6, y, labelSize, " text-anchor=\"end\"");
    }
    if (chart.zero) {
        out.write("0", *chart.zero, area.bottom + 14, labelSize, inTheMiddle);
        out.line(chart.error.from, area.top, chart.error.from, area.bottom,
                 " stroke=\"#666666\" stroke-dasharray=\"3 3\"");
    }
    out.line(area.left, area.top, area.left, area.bottom, frameStroke);
    out.line(area.left, area.bottom, area.right, area.bottom, frameStroke);
    for (std::size_t i = 0; i < svg.title.size(); ++i) {
        out.write(svg.title[i], plotLeft, svg.top + 12 + 20 * double(i), titleSize);
    }
    const double middle = (area.top + area.bottom) / 2;
    out.write(svg.time, 16, middle, textSize, inTheMiddle + formatted(" transform=\"rotate(-90 16 %.1f)\"", middle));
    for (std::size_t i = 0; i < svg.axis.size(); ++i) {
        out.write(svg.axis[i], (plotLeft + plotRight) / 2, area.bottom + 36 + lineHeight * double(i), textSize,
                  inTheMiddle);
    }
}

void drawScene(Svg& out, const StudyRun& run, const SceneSvg& svg) {
    const Chart& chart = svg.chart;
    drawAxes(out, svg);
    // The lines first, so that no point hides under one.
    for (const ChartLine& line : chart.lines) {
        out.line(line.fromX, line.fromY, line.toX, line.toY, Svg::strokeOf(chart.series[line.series].look));
    }
    for (const ChartLabel& label : chart.labels) {
        out.write(label.text, label.box.left, (label.box.top + label.box.bottom) / 2, labelSize, " fill=\"#444444\"");
    }
    for (const ChartPoint& point : chart.points) {
        const StudyRow& row = run.rows[point.row];
        out.add("<g data-row=\"" + std::to_string(point.row) + "\"><title>" + escaped(rowSentence(run, row)) +
                "</title>");
        out.mark(point.x, point.y, chart.series[point.series].look);
        if (row.best && svg.space.joined) out.ring(point.x, point.y);
        out.add("</g>");
    }
    double y = svg.legendTop() + lineHeight;
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        if (svg.space.joined) out.line(plotLeft, y, plotLeft + 32, y, Svg::strokeOf(chart.series[i].look));
        out.mark(plotLeft + 16, y, chart.series[i].look);
        for (const std::string& line : svg.legend[i]) {
            out.write(line, plotLeft + 42, y, textSize);
            y += lineHeight;
        }
    }
    if (!svg.space.joined) return;
    out.ring(plotLeft + 16, y);
    out.write("Pareto-best: " + bestText(run), plotLeft + 42, y, textSize);
}

}  // namespace

std::string studySvg(const StudyRun& run, const PlotWords& words) {
    Svg out;
    double bottom = 4;
    for (const std::string& scene : scenesOf(run)) {
        const SceneSvg svg = sceneSvg(run, scene, bottom, words);
        drawScene(out, run, svg);
        bottom = svg.bottom();
    }
    std::vector<std::string> foot = linesOf("Reference: " + referenceText(run), svgWidth - 20, labelSize);
    for (std::string& line : linesOf("Measured on: " + machineText(run), svgWidth - 20, labelSize)) {
        foot.push_back(std::move(line));
    }
    for (std::size_t i = 0; i < foot.size(); ++i) {
        out.write(foot[i], 10, bottom + lineHeight * (double(i) + 0.5), labelSize);
    }
    const std::string width = std::to_string(svgWidth),
                      height = formatted("%.0f", bottom + double(foot.size()) * lineHeight + 8);
    // Verdana has the widths of DejaVu Sans, by which the labels were placed.
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + width + " " + height + "\" width=\"" + width +
           "\" height=\"" + height +
           "\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n"
           "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" +
           out.text() + "</svg>\n";
}

}  // namespace mv
