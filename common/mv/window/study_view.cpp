#include "mv/window/study_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "mv/run/study.h"
#include "mv/run/words.h"

namespace mv {
namespace {

// Told apart by their shapes too, for eyes that do not tell the colours apart.
constexpr std::array<ImU32, 8> colors{IM_COL32(105, 170, 245, 255), IM_COL32(255, 165, 75, 255),
                                      IM_COL32(120, 210, 120, 255), IM_COL32(245, 120, 120, 255),
                                      IM_COL32(190, 155, 245, 255), IM_COL32(240, 225, 100, 255),
                                      IM_COL32(100, 215, 215, 255), IM_COL32(245, 155, 205, 255)};

void drawMarker(ImDrawList& list, ImVec2 at, std::size_t method, float size) {
    const ImU32 color = colors[method % colors.size()];
    switch (method % 4) {
        case 0:
            return list.AddCircleFilled(at, size, color);
        case 1:
            return list.AddRectFilled({at.x - size, at.y - size}, {at.x + size, at.y + size}, color);
        case 2:
            return list.AddNgonFilled(at, size * 1.4F, color, 4);
        default:
            return list.AddTriangleFilled({at.x, at.y - size * 1.3F}, {at.x + size * 1.2F, at.y + size},
                                          {at.x - size * 1.2F, at.y + size}, color);
    }
}

// ---- A logarithmic axis

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

struct Axis {
    double low, high;  // values
    float from, to;    // positions on the screen
    float at(double value) const {
        return from + (to - from) * static_cast<float>(std::log(value / low) / std::log(high / low));
    }
};

struct Tick {
    double value;
    bool decade;
};

std::vector<Tick> ticks(const Axis& axis) {
    std::vector<Tick> all;
    const int last = static_cast<int>(std::floor(std::log10(axis.high * 1.001)));
    for (int power = static_cast<int>(std::floor(std::log10(axis.low))); power <= last; ++power) {
        for (const double step : {1.0, 2.0, 5.0}) {
            const double value = step * std::pow(10, power);
            if (value >= axis.low * 0.999 && value <= axis.high * 1.001) all.push_back({value, step == 1});
        }
    }
    return all;
}

std::string superscript(int number) {
    static constexpr std::array<const char*, 10> digits{"\u2070", "\u00B9", "\u00B2", "\u00B3", "\u2074",
                                                        "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    std::string text = number < 0 ? "\u207B" : "";
    for (const char c : std::to_string(std::abs(number))) text += digits[static_cast<std::size_t>(c - '0')];
    return text;
}

// Plain numbers, or powers of ten for all of an axis where some would be long.
std::string tickText(const Axis& axis, const Tick& tick) {
    if (axis.low > 0.9e-4 && axis.high < 1.1e5) return formatted("%g", tick.value);
    const int power = static_cast<int>(std::lround(std::log10(decadeOf(tick.value * 1.001))));
    const double factor = tick.value / std::pow(10, power);
    return (tick.decade ? "" : formatted("%.0f\u00B7", factor)) + "10" + superscript(power);
}

// ---- The plot's frame

constexpr float plotHeight = 230, zeroWidth = 26;  // pixels at ordinary density

struct Plot {
    ImVec2 low, high;  // of the area with the points
    Axis x, y;
    float zeroX = 0;  // where the rows without any error stand
    bool anyZero = false;

    ImVec2 at(double error, double time) const { return {error > 0 ? x.at(error) : zeroX, y.at(time)}; }
};

bool plotted(const StudyRow& row, const std::string& scene) {
    return row.scene == scene && row.ok() && row.rounds > 0 && row.msMedian > 0;
}

// Nothing where no row has a time.
std::optional<Plot> layOut(const StudyRun& run, const std::string& scene, ImVec2 corner, float width, float scale) {
    double nearest = 0, farthest = 0, fastest = 0, slowest = 0;
    Plot plot{};
    for (const StudyRow& row : run.rows) {
        if (!plotted(row, scene)) continue;
        fastest = fastest == 0 ? row.msMedian : std::min(fastest, row.msMedian);
        slowest = std::max(slowest, row.msMedian);
        const double error = run.shownError(row);
        plot.anyZero |= error == 0;
        if (error <= 0) continue;
        nearest = nearest == 0 ? error : std::min(nearest, error);
        farthest = std::max(farthest, error);
    }
    if (fastest == 0) return {};
    if (nearest == 0) nearest = farthest = 1;
    const float line = ImGui::GetTextLineHeight();
    plot.y = {niceBelow(fastest / 1.2), niceAbove(slowest * 1.2), 0, 0};
    float labels = 0;
    for (const Tick& tick : ticks(plot.y)) {
        labels = std::max(labels, ImGui::CalcTextSize(tickText(plot.y, tick).c_str()).x);
    }
    plot.low = {corner.x + labels + 6 * scale, corner.y + 1.6F * line};
    plot.high = {corner.x + width, plot.low.y + plotHeight * scale};
    plot.y.from = plot.high.y;
    plot.y.to = plot.low.y;
    plot.zeroX = plot.low.x + zeroWidth * scale / 2;
    plot.x = {niceBelow(nearest / 1.2), niceAbove(farthest * 1.2), plot.low.x + (plot.anyZero ? zeroWidth * scale : 0),
              plot.high.x};
    return plot;
}

// The labels of an axis, the powers of ten first, the others where there is room beside them and what is `taken`.
template <class Place>
void label(ImDrawList& list, const Axis& axis, bool across, const Place& place,
           std::vector<std::pair<float, float>> taken = {}) {
    for (const bool decades : {true, false}) {
        for (const Tick& tick : ticks(axis)) {
            if (tick.decade != decades) continue;
            const std::string text = tickText(axis, tick);
            const ImVec2 size = ImGui::CalcTextSize(text.c_str()), at = place(axis.at(tick.value), size);
            const float from = across ? at.x - 4 : at.y, to = across ? at.x + size.x + 4 : at.y + size.y;
            if (std::any_of(taken.begin(), taken.end(), [&](auto& t) { return from < t.second && t.first < to; })) {
                continue;
            }
            taken.emplace_back(from, to);
            list.AddText(at, ImGui::GetColorU32(color::dim), text.c_str());
        }
    }
}

void drawFrame(ImDrawList& list, const StudyRun& run, const Plot& plot, ImVec2 corner, float scale) {
    const ImU32 ink = ImGui::GetColorU32(color::dim), grid = ImGui::GetColorU32(ImGuiCol_Separator);
    const ImVec4 faint = ImGui::GetStyleColorVec4(ImGuiCol_Separator);
    const ImU32 faintGrid = ImGui::GetColorU32({faint.x, faint.y, faint.z, 0.45F});
    const float line = ImGui::GetTextLineHeight();
    list.AddRectFilled(plot.low, plot.high, ImGui::GetColorU32({0, 0, 0, 0.25F}));
    for (const Tick& tick : ticks(plot.x)) {
        list.AddLine({plot.x.at(tick.value), plot.low.y}, {plot.x.at(tick.value), plot.high.y},
                     tick.decade ? grid : faintGrid);
    }
    for (const Tick& tick : ticks(plot.y)) {
        list.AddLine({plot.low.x, plot.y.at(tick.value)}, {plot.high.x, plot.y.at(tick.value)},
                     tick.decade ? grid : faintGrid);
    }
    list.AddLine({plot.low.x, plot.low.y}, {plot.low.x, plot.high.y}, ink);
    list.AddLine({plot.low.x, plot.high.y}, plot.high, ink);
    const float below = plot.high.y + 3 * scale;
    std::vector<std::pair<float, float>> taken;
    if (plot.anyZero) {
        const int dashes = static_cast<int>((plot.high.y - plot.low.y) / (6 * scale));
        for (int i = 0; i < dashes; ++i) {
            const float y = plot.low.y + 6 * scale * float(i);
            list.AddLine({plot.x.from, y}, {plot.x.from, y + 3 * scale}, ink);
        }
        const float half = ImGui::CalcTextSize("0").x / 2;
        list.AddText({plot.zeroX - half, below}, ink, "0");
        taken.emplace_back(plot.zeroX - half - 4, plot.zeroX + half + 4);
    }
    const auto belowTick = [&](float x, ImVec2 size) {  // and within the panel, also that of a tick at its edge
        return ImVec2{std::min(x - size.x / 2, plot.high.x - size.x), below};
    };
    const auto besideTick = [&](float y, ImVec2 size) {
        return ImVec2{plot.low.x - size.x - 4 * scale, y - size.y / 2};
    };
    label(list, plot.x, true, belowTick, taken);
    label(list, plot.y, false, besideTick);
    list.AddText(corner, ink, "milliseconds");
    const char* error = run.axis == ErrorAxis::rms ? "root mean square error" : "part that is wrong";
    list.AddText({plot.high.x - ImGui::CalcTextSize(error).x, below + line}, ink, error);
}

// ---- Words

void rowTip(const StudyRow& row) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 20);
    ImGui::TextColored(color::heading, "%s", rowName(row).c_str());
    ImGui::TextUnformatted(("error: rms " + errorText(row.all.rms) + ", largest " + errorText(row.all.max) +
                            ", wrong " + errorText(100 * row.all.fraction) + " %")
                               .c_str());
    if (row.awayFromEdges.n != row.all.n) {
        ImGui::TextUnformatted(("away from edges: rms " + errorText(row.awayFromEdges.rms) + ", wrong " +
                                errorText(100 * row.awayFromEdges.fraction) + " %")
                                   .c_str());
    }
    ImGui::TextUnformatted((formatted("%.3g ms, median of ", row.msMedian) + std::to_string(row.rounds) + " (MAD " +
                            formatted("%.2g)", row.msMad))
                               .c_str());
    if (!row.counts.empty()) ImGui::TextUnformatted(countsText(row).c_str());
    std::string settings;
    for (const KnobSetting& setting : row.settings) {
        settings += (settings.empty() ? "--" : " --") + setting.name + " " + setting.text;
    }
    ImGui::PushStyleColor(ImGuiCol_Text, color::dim);
    if (row.best) ImGui::TextUnformatted("Pareto-best: no other is both nearer and faster.");
    if (!settings.empty()) ImGui::TextUnformatted(("Click to set " + settings).c_str());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void showLegend(const StudyRun& run, const std::string& scene, float scale) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line = ImGui::GetTextLineHeight(), indent = 26 * scale;
    const auto entry = [&](const std::string& text, const auto& sign) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        sign(ImVec2{at.x + indent / 2 - 4 * scale, at.y + line / 2});
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
        wrapped(text);
    };
    const std::vector<std::string> methods = methodsOf(run, scene);
    for (std::size_t i = 0; i < methods.size(); ++i) {
        std::string text = methods[i];
        if (const auto slope = errorSlope(run, scene, methods[i])) text += formatted(" (error ~ p^%.2f)", *slope);
        entry(text, [&](ImVec2 at) {
            list.AddLine({at.x - 9 * scale, at.y}, {at.x + 9 * scale, at.y}, colors[i % colors.size()], 1.5F * scale);
            drawMarker(list, at, i, 4 * scale);
        });
    }
    entry("Pareto-best: no other is both nearer and faster",
          [&](ImVec2 at) { list.AddCircle(at, 7 * scale, ImGui::GetColorU32(ImGuiCol_Text), 0, 1.5F * scale); });
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

}  // namespace

std::string rowName(const StudyRow& row) {
    return row.parameter.empty() ? row.method : row.method + " " + row.parameter;
}

std::optional<std::size_t> showStudyPlot(const StudyRun& run, const std::string& scene, std::optional<std::size_t> here,
                                         float scale) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const std::optional<Plot> plot = layOut(run, scene, corner, width, scale);
    if (!plot) {
        wrapped(color::error, "No setting of this scene could be measured.");
        return {};
    }
    const float line = ImGui::GetTextLineHeight();
    const bool clicked = ImGui::InvisibleButton("plot", {width, plot->high.y - corner.y + 2 * line + 6 * scale});
    const bool over = ImGui::IsItemHovered();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    drawFrame(list, run, *plot, corner, scale);

    // The lines first, so that no point hides under one. A row without any error is on no line: it is infinitely far.
    const std::vector<std::string> methods = methodsOf(run, scene);
    std::vector<const StudyRow*> last(methods.size(), nullptr);
    const auto methodOf = [&](const StudyRow& row) {
        return static_cast<std::size_t>(std::find(methods.begin(), methods.end(), row.method) - methods.begin());
    };
    const auto placeOf = [&](const StudyRow& row) { return plot->at(run.shownError(row), row.msMedian); };
    for (const StudyRow& row : run.rows) {
        if (!plotted(row, scene)) continue;
        const std::size_t method = methodOf(row);
        if (last[method] && run.shownError(row) > 0) {
            list.AddLine(placeOf(*last[method]), placeOf(row), colors[method % colors.size()], 1.5F * scale);
        }
        last[method] = run.shownError(row) > 0 ? &row : nullptr;
    }
    if (here && plotted(run.rows[*here], scene)) drawHere(list, *plot, placeOf(run.rows[*here]), scale);

    std::optional<std::size_t> nearest;
    float reach = 10 * scale;
    const ImVec2 mouse = ImGui::GetMousePos();
    for (std::size_t i = 0; i < run.rows.size(); ++i) {
        const StudyRow& row = run.rows[i];
        if (!plotted(row, scene)) continue;
        const ImVec2 at = placeOf(row);
        drawMarker(list, at, methodOf(row), 4 * scale);
        if (row.best) list.AddCircle(at, 7 * scale, ImGui::GetColorU32(ImGuiCol_Text), 0, 1.5F * scale);
        notePlace("point " + rowName(row), {at.x - 4, at.y - 4, at.x + 4, at.y + 4});
        const float away = std::hypot(mouse.x - at.x, mouse.y - at.y);
        if (!over || away > reach) continue;
        reach = away;
        nearest = i;
    }
    if (nearest) {
        list.AddCircle(placeOf(run.rows[*nearest]), 9 * scale, ImGui::GetColorU32(color::heading), 0, 2 * scale);
        rowTip(run.rows[*nearest]);
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    }
    showLegend(run, scene, scale);
    return clicked ? nearest : std::nullopt;
}

}  // namespace mv
