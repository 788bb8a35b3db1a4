#include "mv/window/study_view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "mv/paper/tables.h"
#include "mv/study/chart.h"
#include "mv/study/study.h"

namespace mv {
namespace {

// ---- The looks of the lines, as mv/study/look.h has them

ImU32 colorOf(const SeriesLook& look) {
    const Rgb rgb = look.on(ImGui::GetStyleColorVec4(ImGuiCol_Text).x > 0.5F ? whiteInk : blackInk);
    return IM_COL32(rgb >> 16U & 0xFFU, rgb >> 8U & 0xFFU, rgb & 0xFFU, 255);
}

void drawMarker(ImDrawList& list, ImVec2 at, const SeriesLook& look, float size, float scale) {
    const ImU32 color = colorOf(look);
    const MarkShape shape = shapeOf(look.mark);
    if (shape.paths.empty()) return list.AddCircleFilled(at, size, color);
    for (const auto& places : shape.paths) {
        std::vector<ImVec2> corners;
        for (const MarkShape::Place& place : places) {
            corners.emplace_back(at.x + size * static_cast<float>(place.x), at.y + size * static_cast<float>(place.y));
        }
        const int count = static_cast<int>(corners.size());
        if (shape.filled) {
            list.AddConvexPolyFilled(corners.data(), count, color);
        } else {
            const ImDrawFlags closed = count > 2 ? ImDrawFlags_Closed : ImDrawFlags_None;
            list.AddPolyline(corners.data(), count, color, closed, 1.6F * scale);
        }
    }
}

// In pieces of `on` pixels, `off` apart.
void drawDashes(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 color, float thickness, float on, float off) {
    const float length = std::hypot(to.x - from.x, to.y - from.y);
    const int pieces = static_cast<int>(std::ceil(length / (on + off)));
    for (int i = 0; i < pieces; ++i) {
        const float start = static_cast<float>(i) * (on + off) / length;
        const float end = std::min(1.0F, start + on / length);
        list.AddLine({from.x + (to.x - from.x) * start, from.y + (to.y - from.y) * start},
                     {from.x + (to.x - from.x) * end, from.y + (to.y - from.y) * end}, color, thickness);
    }
}

void drawStroke(ImDrawList& list, ImVec2 from, ImVec2 to, const SeriesLook& look, float scale) {
    const float thickness = 1.5F * scale;
    const DashLengths dash = lengthsOf(look.dash);
    if (dash.on == 0) return list.AddLine(from, to, colorOf(look), thickness);
    drawDashes(list, from, to, colorOf(look), thickness, static_cast<float>(dash.on) * scale,
               static_cast<float>(dash.off) * scale);
}

ImVec2 onScreen(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

// ---- The plot's frame

constexpr float plotHeight = 230;      // pixels at ordinary density, at least
constexpr float plotPartHigh = 0.65F;  // of its width, in a wide panel

double widthOf(const std::string& text) { return double(ImGui::CalcTextSize(text.c_str()).x); }

struct Plot {
    ChartSpace space;
    Chart chart;
    ImVec2 low, high;  // of the area with the points
    float line = 0;    // height of one of text
};

// Nothing where no row has a time.
std::optional<Plot> layOut(const StudyRun& run, const std::string& scene, ImVec2 corner, float width, float scale) {
    Plot plot;
    plot.line = ImGui::GetTextLineHeight();
    plot.space.line = double(plot.line);
    plot.space.mark = 4 * double(scale);
    plot.space.width = widthOf;
    plot.low = {corner.x, corner.y + 1.6F * plot.line};
    plot.high = {corner.x + width, plot.low.y + std::max(plotHeight * scale, plotPartHigh * width)};
    const auto setArea = [&] {
        plot.space.area = {double(plot.low.x), double(plot.low.y), double(plot.high.x), double(plot.high.y)};
    };
    setArea();
    plot.low.x += static_cast<float>(timeLabelWidth(run, scene, plot.space)) + 6 * scale;
    setArea();
    auto chart = layOutChart(run, scene, plot.space);
    if (!chart) return {};
    plot.chart = std::move(*chart);
    return plot;
}

void drawFrame(ImDrawList& list, const StudyRun& run, const Plot& plot, ImVec2 corner, float scale) {
    const ImU32 ink = ImGui::GetColorU32(color::dim), grid = ImGui::GetColorU32(ImGuiCol_Separator);
    const ImVec4 faint = ImGui::GetStyleColorVec4(ImGuiCol_Separator);
    const ImU32 faintGrid = ImGui::GetColorU32({faint.x, faint.y, faint.z, 0.45F});
    const Chart& chart = plot.chart;
    list.AddRectFilled(plot.low, plot.high, ImGui::GetColorU32({0, 0, 0, 0.25F}));
    const float below = plot.high.y + 3 * scale;
    for (const ChartTick& tick : chart.errorTicks) {
        const float x = static_cast<float>(chart.error.at(tick.value));
        list.AddLine({x, plot.low.y}, {x, plot.high.y}, tick.power ? grid : faintGrid);
        list.AddText({static_cast<float>(tick.labelFrom), below}, ink, tick.label.c_str());
    }
    for (const ChartTick& tick : chart.timeTicks) {
        const float y = static_cast<float>(chart.time.at(tick.value));
        list.AddLine({plot.low.x, y}, {plot.high.x, y}, tick.power ? grid : faintGrid);
        const ImVec2 size = ImGui::CalcTextSize(tick.label.c_str());
        list.AddText({plot.low.x - size.x - 4 * scale, y - size.y / 2}, ink, tick.label.c_str());
    }
    list.AddLine({plot.low.x, plot.low.y}, {plot.low.x, plot.high.y}, ink);
    list.AddLine({plot.low.x, plot.high.y}, plot.high, ink);
    if (chart.zero) {
        drawDashes(list, onScreen(chart.error.from, double(plot.low.y)),
                   onScreen(chart.error.from, double(plot.high.y)), ink, 1, 3 * scale, 3 * scale);
        list.AddText({static_cast<float>(*chart.zero - widthOf("0") / 2), below}, ink, "0");
    }
    list.AddText(corner, ink, run.width > 0 ? "milliseconds a frame" : "milliseconds");
    const std::string error = errorName(run.axis);
    list.AddText({plot.high.x - ImGui::CalcTextSize(error.c_str()).x, below + plot.line}, ink, error.c_str());
}

// ---- Words

// Beside the plot, so that it covers none of its points: left of the panel, over the picture; where that is too narrow,
// above the plot or below it.
void besidePlot(const Plot& plot, ImVec2 corner, const std::function<void(float width)>& show) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float panel = ImGui::GetWindowPos().x - ImGui::GetStyle().WindowPadding.x;
    const float em = ImGui::GetFontSize(), gap = em / 2, padding = 2 * ImGui::GetStyle().WindowPadding.x;
    const float below = plot.high.y + 2 * plot.line + gap;
    float width = std::min(22 * em, panel - 2 * gap - padding);
    if (width >= 14 * em) {
        const float y = std::clamp(plot.low.y, 0.0F, screen.y);
        ImGui::SetNextWindowPos({panel - gap, y}, ImGuiCond_Always, {1, y / screen.y});
    } else {
        width = std::min(22 * em, plot.high.x - corner.x);
        const bool under = screen.y - below > corner.y;
        ImGui::SetNextWindowPos({corner.x, under ? below : corner.y - gap}, ImGuiCond_Always, {0, under ? 0.0F : 1.0F});
    }
    ImGui::BeginTooltip();
    show(width);
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    notePlace("study tip", {at.x, at.y, at.x + size.x, at.y + size.y});
    ImGui::EndTooltip();
}

void showLines(const std::string& text, float width) { ImGui::TextUnformatted(brokenAtSpaces(text, width).c_str()); }

void rowTip(const StudyRun& run, const StudyRow& row, float width) {
    ImGui::PushStyleColor(ImGuiCol_Text, color::heading);
    showLines(row.parameter.empty() ? row.method
                                    : row.method + ", " + knobOf(run, row.scene, row.method) + "\u00A0" + row.parameter,
              width);
    ImGui::PopStyleColor();
    showLines("error: rms\u00A0" + errorText(row.all.rms) + ", largest\u00A0" + errorText(row.all.max) +
                  ", wrong\u00A0" + errorText(100 * row.all.fraction) + "\u00A0%",
              width);
    if (row.awayFromEdges.n != row.all.n) {
        showLines("away from edges: rms\u00A0" + errorText(row.awayFromEdges.rms) + ", wrong\u00A0" +
                      errorText(100 * row.awayFromEdges.fraction) + "\u00A0%",
                  width);
    }
    showLines(formatted("%.3g\u00A0ms, median of\u00A0", row.msMedian) + std::to_string(row.rounds) +
                  formatted(" (MAD\u00A0%.2g)", row.msMad),
              width);
    std::string counts, settings;
    for (const auto& [name, amount] : row.counts) {
        counts += (counts.empty() ? "" : ", ") + name + formatted("\u00A0%.10g", amount);
    }
    if (!counts.empty()) showLines(counts, width);
    for (const KnobSetting& setting : row.settings) {
        settings += (settings.empty() ? "--" : " --") + setting.name + "\u00A0" + setting.text;
    }
    ImGui::PushStyleColor(ImGuiCol_Text, color::dim);
    if (row.best) showLines("Pareto-best: " + bestText(run) + ".", width);
    if (!settings.empty()) showLines("Click to set " + settings, width);
    ImGui::PopStyleColor();
}

std::string askedText(const StudyRun& run, const StudyBound& bound) {
    return (bound.of == StudyBound::Of::time ? "time" : errorName(run.axis)) + " at most\u00A0" + boundText(bound);
}

void boundTip(const StudyRun& run, const StudyPlotMarks& marks, const StudyBound& bound, float width) {
    const auto chosen = rowWithin(run, marks.rows, bound);
    ImGui::PushStyleColor(ImGuiCol_Text, color::heading);
    showLines(askedText(run, bound), width);
    ImGui::PopStyleColor();
    if (!chosen) return showLines("No setting of this problem keeps it.", width);
    const bool ofTime = bound.of == StudyBound::Of::time;
    showLines("Click to set the " + std::string(ofTime ? "most exact" : "cheapest") +
                  " that keeps it: " + rowSentence(run, run.rows[*chosen]),
              width);
}

void showLegend(const StudyRun& run, const Plot& plot, const StudyPlotMarks& marks, float scale) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line = ImGui::GetTextLineHeight(), indent = 34 * scale;
    const auto entry = [&](const std::string& text, const auto& sign) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        sign(ImVec2{at.x + indent / 2 - 4 * scale, at.y + line / 2});
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
        wrapped(text);
    };
    for (const ChartSeries& series : plot.chart.series) {
        entry(series.legend, [&](ImVec2 at) {
            drawStroke(list, {at.x - 13 * scale, at.y}, {at.x + 13 * scale, at.y}, series.look, scale);
            drawMarker(list, at, series.look, 4 * scale, scale);
        });
    }
    entry("Pareto-best: " + bestText(run),
          [&](ImVec2 at) { list.AddCircle(at, 7 * scale, ImGui::GetColorU32(ImGuiCol_Text), 0, 1.5F * scale); });
    if (!marks.bound) return;
    entry("chosen: " + askedText(run, *marks.bound), [&](ImVec2 at) {
        list.AddRect({at.x - 8 * scale, at.y - 8 * scale}, {at.x + 8 * scale, at.y + 8 * scale},
                     ImGui::GetColorU32(color::heading), 0, 0, 2 * scale);
    });
}

// The present settings: a cross through the whole plot, and the word.
void drawHere(ImDrawList& list, const Plot& plot, ImVec2 at, float scale) {
    const ImU32 ink = ImGui::GetColorU32(color::note);
    list.AddLine({plot.low.x, at.y}, {plot.high.x, at.y}, ink);
    list.AddLine({at.x, plot.low.y}, {at.x, plot.high.y}, ink);
    const ImVec2 size = ImGui::CalcTextSize("here");
    const float gap = 9 * scale;
    const ImVec2 word{at.x + gap + size.x < plot.high.x ? at.x + gap : at.x - gap - size.x,
                      at.y - gap - size.y > plot.low.y ? at.y - gap - size.y : at.y + gap};
    list.AddRectFilled({word.x - 3 * scale, word.y}, {word.x + size.x + 3 * scale, word.y + size.y},
                       ImGui::GetColorU32(color::noteBack), 3 * scale);
    list.AddText(word, ink, "here");
}

// ---- Bounds, by a click on an axis

// The value as it is said: two digits are what a pixel tells.
StudyBound boundAt(StudyBound::Of of, double value) {
    return {of, std::strtod(formatted("%.2g", value).c_str(), nullptr)};
}

std::optional<StudyBound> boundUnder(const Plot& plot, ImVec2 mouse, ImVec2 corner) {
    const Chart& chart = plot.chart;
    const float foot = plot.high.y + plot.line + 4;
    if (mouse.x >= plot.low.x && mouse.y > plot.high.y && mouse.y <= foot) {
        if (chart.zero && double(mouse.x) < chart.error.from) return StudyBound{StudyBound::Of::error, 0};
        return boundAt(StudyBound::Of::error, chart.error.valueAt(double(mouse.x)));
    }
    if (mouse.x >= corner.x && mouse.x < plot.low.x && mouse.y >= plot.low.y && mouse.y <= plot.high.y) {
        return boundAt(StudyBound::Of::time, chart.time.valueAt(double(mouse.y)));
    }
    return {};
}

void noteAxes(const Plot& plot, ImVec2 corner) {
    const float from = static_cast<float>(plot.chart.error.from);
    notePlace("error axis", {from, plot.high.y + 2, plot.high.x, plot.high.y + plot.line});
    notePlace("time axis", {corner.x, plot.low.y, plot.low.x - 2, plot.high.y});
    if (plot.chart.zero) notePlace("error axis 0", {plot.low.x, plot.high.y + 2, from, plot.high.y + plot.line});
}

// A line at the bound through the plot.
void drawBound(ImDrawList& list, const Plot& plot, const StudyBound& bound, ImU32 ink, float scale) {
    const Chart& chart = plot.chart;
    if (bound.of == StudyBound::Of::time) {
        const float y = static_cast<float>(chart.time.at(std::clamp(bound.value, chart.time.low, chart.time.high)));
        return drawDashes(list, {plot.low.x, y}, {plot.high.x, y}, ink, 1.5F * scale, 5 * scale, 3 * scale);
    }
    const double error = std::clamp(bound.value, chart.error.low, chart.error.high);
    const float x = static_cast<float>(bound.value == 0 && chart.zero ? *chart.zero : chart.error.at(error));
    drawDashes(list, {x, plot.low.y}, {x, plot.high.y}, ink, 1.5F * scale, 5 * scale, 3 * scale);
}

}  // namespace

std::string rowName(const StudyRow& row) {
    return row.parameter.empty() ? row.method : row.method + " " + row.parameter;
}

StudyPlotClick showStudyPlot(const StudyRun& run, const std::string& scene, const StudyPlotMarks& marks, float scale) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const std::optional<Plot> plot = layOut(run, scene, corner, width, scale);
    if (!plot) {
        wrapped(color::error, "No setting of this scene could be measured.");
        return {};
    }
    const bool clicked = ImGui::InvisibleButton("plot", {width, plot->high.y - corner.y + 2 * plot->line + 6 * scale});
    notePlace("plot");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // The keys are at it, or have pressed it; to Dear ImGui it is hovered then, too
    const bool byKeys = clicked && !ImGui::IsMouseReleased(ImGuiMouseButton_Left);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const bool over = !byKeys && ImGui::IsItemHovered() && ImGui::IsMouseHoveringRect(low, high);
    if (ImGui::IsItemFocused() && (ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0)
        list.AddRect({low.x - 2, low.y - 2}, {high.x + 2, high.y + 2}, ImGui::GetColorU32(ImGuiCol_NavHighlight), 0, 0,
                     2 * scale);
    drawFrame(list, run, *plot, corner, scale);
    noteAxes(*plot, corner);
    const Chart& chart = plot->chart;

    // The lines first, so that no point hides under one.
    for (const ChartLine& line : chart.lines) {
        drawStroke(list, onScreen(line.fromX, line.fromY), onScreen(line.toX, line.toY), chart.series[line.series].look,
                   scale);
    }
    const ImU32 chosenInk = ImGui::GetColorU32(color::heading);
    if (marks.bound) drawBound(list, *plot, *marks.bound, chosenInk, scale);
    for (const ChartPoint& point : chart.points) {
        if (marks.here == point.row) drawHere(list, *plot, onScreen(point.x, point.y), scale);
    }
    for (const ChartLabel& label : chart.labels) {
        list.AddText(onScreen(label.box.left, label.box.top), ImGui::GetColorU32(color::dim), label.text.c_str());
    }

    const ChartPoint* nearest = nullptr;
    float reach = 10 * scale;
    const ImVec2 mouse = ImGui::GetMousePos();
    for (const ChartPoint& point : chart.points) {
        const StudyRow& row = run.rows[point.row];
        const ImVec2 at = onScreen(point.x, point.y);
        drawMarker(list, at, chart.series[point.series].look, 4 * scale, scale);
        if (row.best) list.AddCircle(at, 7 * scale, ImGui::GetColorU32(ImGuiCol_Text), 0, 1.5F * scale);
        if (marks.chosen == point.row) {
            const float half = 9 * scale;
            list.AddRect({at.x - half, at.y - half}, {at.x + half, at.y + half}, chosenInk, 0, 0, 2 * scale);
        }
        notePlace("point " + rowName(row), {at.x - 4, at.y - 4, at.x + 4, at.y + 4});
        const float away = std::hypot(mouse.x - at.x, mouse.y - at.y);
        if (!over || away > reach) continue;
        reach = away;
        nearest = &point;
    }
    StudyPlotClick click;
    if (const auto bound = nearest || !over ? std::nullopt : boundUnder(*plot, mouse, corner)) {
        drawBound(list, *plot, *bound, ImGui::GetColorU32(color::dim), scale);
        besidePlot(*plot, corner, [&](float tipWidth) { boundTip(run, marks, *bound, tipWidth); });
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        if (clicked) click.bound = bound;
    }
    if (nearest) {
        list.AddCircle(onScreen(nearest->x, nearest->y), 9 * scale, chosenInk, 0, 2 * scale);
        besidePlot(*plot, corner, [&](float tipWidth) { rowTip(run, run.rows[nearest->row], tipWidth); });
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        if (clicked) click.row = nearest->row;
    }
    if (byKeys && !chart.points.empty()) {  // one point after the other
        const auto at =
            std::ranges::find_if(chart.points, [&](const ChartPoint& point) { return marks.here == point.row; });
        click.row = (at == chart.points.end() || at + 1 == chart.points.end() ? chart.points.front() : *(at + 1)).row;
    }
    showLegend(run, *plot, marks, scale);
    return click;
}

}  // namespace mv
