#include "mv/study/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "mv/demo/demo.h"
#include "mv/study/study.h"

using namespace mv;

namespace {

// Letters of 7 pixels: about those of the window.
ChartSpace spaceOf(double width, double height) {
    ChartSpace space;
    space.area = {50, 20, 50 + width, 20 + height};
    space.line = 15;
    space.width = [](const std::string& text) { return 7.0 * double(text.size()); };
    return space;
}

struct Case {
    std::string name;
    StudyRun run;
    std::string scene;
};

// Every scene of every committed study, and what no study has: one point, no error at all, one error, one time.
std::vector<Case> cases() {
    std::vector<Case> all;
    for (const DemoInfo& info : catalogue()) {
        const auto run = committedStudy(info.name);
        if (!run) continue;
        for (const std::string& scene : scenesOf(*run)) all.push_back({info.name + ", " + scene, *run, scene});
    }
    const auto made = [&](const std::string& name, const std::vector<std::pair<double, double>>& rows, ErrorAxis axis) {
        Case each{name, {}, "scene"};
        each.run.axis = axis;
        int parameter = 1;
        for (const auto& [error, time] : rows) {
            StudyRow row;
            row.scene = "scene";
            row.method = "method";
            row.parameter = std::to_string(parameter++);
            row.knob = "taps";
            row.all.rms = row.all.fraction = row.all.max = error;
            row.all.n = 1000;
            row.msMedian = time;
            row.rounds = 7;
            each.run.rows.push_back(row);
        }
        all.push_back(each);
    };
    for (const ErrorAxis axis : {ErrorAxis::rms, ErrorAxis::fraction, ErrorAxis::max}) {
        made("one point", {{0.3, 2}}, axis);
        made("all is wrong", {{1, 2}}, axis);
        made("no error", {{0, 2}, {0, 3}}, axis);
        made("one error", {{0.1, 1}, {0.1, 7}}, axis);
        made("one time", {{0.1, 1}, {0.01, 1}}, axis);
        made("17 decades", {{1e-17, 1}, {1e-9, 20}, {0.5, 300}}, axis);
        made("huge and tiny times", {{0.1, 1e-7}, {0.2, 1e9}}, axis);
        made("a point between two ticks", {{0.3, 3.1}, {0.31, 3.2}}, axis);
    }
    return all;
}

// The two sizes that there are: the window's at its smallest, and the SVG's.
const std::array<std::pair<double, double>, 2> sizes{{{270, 230}, {808, 340}}};

bool inside(const ChartBox& box, const ChartBox& area) {
    return box.left >= area.left && box.right <= area.right && box.top >= area.top && box.bottom <= area.bottom;
}

}  // namespace

TEST(StudyChart, each_axis_has_two_labelled_ticks) {
    for (const Case& each : cases()) {
        for (const auto& [width, height] : sizes) {
            SCOPED_TRACE(each.name + " in " + std::to_string(int(width)));
            const auto space = spaceOf(width, height);
            const auto chart = layOutChart(each.run, each.scene, space);
            ASSERT_TRUE(chart);
            for (const auto* ticks : {&chart->errorTicks, &chart->timeTicks}) {
                std::set<std::string> labels;
                for (const ChartTick& tick : *ticks) {
                    if (!tick.label.empty()) labels.insert(tick.label);
                }
                EXPECT_GE(labels.size(), 2U) << (ticks == &chart->timeTicks ? "times" : "errors");
            }
            // No two of the labels below the axis are within a letter of each other, and none leaves the chart.
            double last = -1000;
            for (const ChartTick& tick : chart->errorTicks) {
                if (tick.label.empty()) continue;
                EXPECT_GE(tick.labelFrom, last + 7) << tick.label;
                last = tick.labelFrom + space.width(tick.label);
                EXPECT_LE(last, space.area.right + space.beside) << tick.label;
            }
        }
    }
}

// A reader finds at a tick the value that a point there has.
TEST(StudyChart, points_stand_where_their_numbers_are) {
    for (const Case& each : cases()) {
        SCOPED_TRACE(each.name);
        const auto space = spaceOf(270, 230);
        const auto chart = layOutChart(each.run, each.scene, space);
        ASSERT_TRUE(chart);
        const auto plotted = std::count_if(each.run.rows.begin(), each.run.rows.end(), [&](const StudyRow& row) {
            return row.scene == each.scene && isPlotted(row);
        });
        EXPECT_EQ(chart->points.size(), static_cast<std::size_t>(plotted));
        for (const ChartPoint& point : chart->points) {
            const StudyRow& row = each.run.rows[point.row];
            const double error = each.run.shownError(row);
            // Two logarithms and an exponential, each to a part in 1e15, of ranges up to 40
            EXPECT_NEAR(chart->time.valueAt(point.y) / row.msMedian, 1, 1e-12);
            if (error > 0) {
                EXPECT_NEAR(chart->error.valueAt(point.x) / error, 1, 1e-12);
            } else {
                EXPECT_LT(point.x, chart->error.from) << "0 stands beside the axis";
                EXPECT_EQ(point.x, chart->zero.value());
            }
            EXPECT_TRUE(inside({point.x, point.y, point.x, point.y}, space.area));
        }
        for (const ChartLine& line : chart->lines) {
            EXPECT_GE(std::min(line.fromX, line.toX), chart->error.from) << "no line leads to an error of 0";
        }
    }
}

TEST(StudyChart, no_label_covers_anything) {
    int full = 0, bare = 0;
    for (const Case& each : cases()) {
        for (const auto& [width, height] : sizes) {
            SCOPED_TRACE(each.name + " in " + std::to_string(int(width)));
            const auto space = spaceOf(width, height);
            const auto chart = layOutChart(each.run, each.scene, space);
            ASSERT_TRUE(chart);
            for (const ChartLabel& label : chart->labels) {
                EXPECT_TRUE(inside(label.box, space.area)) << label.text;
                EXPECT_NEAR(label.box.right - label.box.left, space.width(label.text), 1e-9);
                for (const ChartLabel& other : chart->labels) {
                    EXPECT_TRUE(&other == &label || !other.box.meets(label.box)) << label.text << " " << other.text;
                }
                for (const ChartPoint& point : chart->points) {
                    const ChartBox mark{point.x - space.mark, point.y - space.mark, point.x + space.mark,
                                        point.y + space.mark};
                    EXPECT_FALSE(mark.meets(label.box)) << label.text;
                }
                for (const ChartLine& line : chart->lines) {  // by a way of its own: a thousand places along it
                    const auto [left, right] = std::minmax(line.fromX, line.toX);
                    const auto [top, bottom] = std::minmax(line.fromY, line.toY);
                    if (!ChartBox{left, top, right, bottom}.meets(label.box)) continue;
                    for (int i = 0; i <= 1000; ++i) {
                        const double part = i / 1000.0, x = line.fromX + part * (line.toX - line.fromX),
                                     y = line.fromY + part * (line.toY - line.fromY);
                        ASSERT_FALSE(x > label.box.left && x < label.box.right && y > label.box.top &&
                                     y < label.box.bottom)
                            << label.text;
                    }
                }
                const StudyRow& row = each.run.rows[label.row];
                const std::string knob = knobOf(each.run, each.scene, row.method);
                const bool isFull = label.text == knob + " " + row.parameter;
                EXPECT_TRUE(isFull || label.text == row.parameter) << label.text;
                (isFull ? full : bare)++;
            }
            // Whether or not a label has room, the axis and the legend name the knob.
            for (const ChartSeries& series : chart->series) {
                const std::string knob = knobOf(each.run, each.scene, series.method);
                const bool isDrawn = std::ranges::any_of(each.run.rows, [&](const StudyRow& row) {
                    return row.scene == each.scene && row.method == series.method && isPlotted(row);
                });
                if (knob.empty() || !isDrawn)
                    continue;  // a method of which no row could be measured has its name alone
                EXPECT_NE(knob, "p") << series.method;
                EXPECT_NE(series.legend.find(": " + knob + " "), std::string::npos) << series.legend;
                EXPECT_NE(chart->alongLines.find(knob + " "), std::string::npos) << chart->alongLines;
            }
        }
    }
    EXPECT_GT(full, bare) << "where there is room the knob is named";
}

// The slope that is printed is that of the line on the screen, found here from its pixels.
TEST(StudyChart, the_slope_printed_is_the_slope_drawn) {
    int printed = 0;
    for (const Case& each : cases()) {
        SCOPED_TRACE(each.name);
        const auto chart = layOutChart(each.run, each.scene, spaceOf(808, 340));
        ASSERT_TRUE(chart);
        const double perDecadeX =
            (chart->error.to - chart->error.from) / std::log10(chart->error.high / chart->error.low);
        const double perDecadeY = (chart->time.to - chart->time.from) / std::log10(chart->time.high / chart->time.low);
        for (std::size_t i = 0; i < chart->series.size(); ++i) {
            std::vector<std::pair<double, double>> points;
            for (const ChartPoint& point : chart->points) {
                if (point.series == i && point.x >= chart->error.from) {
                    points.emplace_back(point.x / perDecadeX, point.y / perDecadeY);
                }
            }
            const std::string& legend = chart->series[i].legend;
            const auto at = legend.find("time ~ error^");
            if (at == std::string::npos) continue;
            ++printed;
            double x = 0, y = 0, xx = 0, xy = 0;
            for (const auto& [px, py] : points) {
                x += px / double(points.size());
                y += py / double(points.size());
            }
            for (const auto& [px, py] : points) {
                xx += (px - x) * (px - x);
                xy += (px - x) * (py - y);
            }
            EXPECT_GE(points.size(), 3U);
            EXPECT_NEAR(std::stod(legend.substr(at + 13)), xy / xx, 0.00501) << legend << ": it has two decimals";
        }
    }
    EXPECT_GT(printed, 20);
}

TEST(StudyChart, a_slope_says_over_which_points_it_is) {
    StudyRun run;
    const auto add = [&](const std::string& parameter, double error) {
        StudyRow row;
        row.method = "rule";
        row.parameter = parameter;
        row.knob = "n";
        row.all.rms = error;
        row.msMedian = 1 + std::stod(parameter);
        row.rounds = 7;
        run.rows.push_back(row);
    };
    for (const char* n : {"4", "16", "64"}) add(n, 1 / std::stod(n));
    const auto legend = [&] { return layOutChart(run, "", spaceOf(300, 200)).value().series[0].legend; };
    EXPECT_TRUE(legend().starts_with("rule: n 4 \u2026 64, error ~ n^-1.00, time ~ error^-"))
        << "of two knobs the line's is the last";
    EXPECT_EQ(legend().find("over"), std::string::npos) << legend();
    add("256", 0);
    EXPECT_NE(legend().find("n 4 \u2026 256"), std::string::npos) << legend();
    EXPECT_TRUE(legend().ends_with(" over 4 \u2026 64")) << legend() << ": 0 has no logarithm";
}

// ---- Looks

TEST(StudyLook, no_two_series_look_alike) {
    // More than any study has: z-buffer's 13 are the most.
    for (std::size_t i = 0; i < 21; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const SeriesLook a = seriesLook(i), b = seriesLook(j);
            const bool sameColor = a.ink == b.ink && a.color == b.color;
            EXPECT_FALSE(sameColor && a.dash == b.dash) << i << " " << j;
            EXPECT_FALSE(sameColor && a.mark == b.mark) << i << " " << j;
            EXPECT_TRUE(a.mark != b.mark || i - j >= markCount) << i << " " << j;
        }
    }
    for (const DemoInfo& info : catalogue()) {
        const auto run = committedStudy(info.name);
        if (!run) continue;
        for (const std::string& scene : scenesOf(*run))
            EXPECT_LE(methodsOf(*run, scene).size(), markCount) << info.name;
    }
}

namespace {

using Triple = std::array<double, 3>;

double linear(unsigned channel) {
    const double value = channel / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}
Triple linearOf(Rgb rgb) { return {linear(rgb >> 16U & 0xFFU), linear(rgb >> 8U & 0xFFU), linear(rgb & 0xFFU)}; }

Triple times(const std::array<Triple, 3>& matrix, const Triple& v) {
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) result[i] += matrix[i][k] * v[k];
        result[i] = std::clamp(result[i], 0.0, 1.0);
    }
    return result;
}

// CIE L*a*b* of linear sRGB, for D65.
Triple labOf(const Triple& rgb) {
    const Triple xyz{(0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2]) / 0.9505,
                     0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2],
                     (0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2]) / 1.089};
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    return {116 * f(xyz[1]) - 16, 500 * (f(xyz[0]) - f(xyz[1])), 200 * (f(xyz[1]) - f(xyz[2]))};
}

}  // namespace

// As eyes see them that lack one kind of cone: Machado, Oliveira and Fernandes 2009, at full severity, in linear sRGB.
TEST(StudyLook, colors_are_told_apart_by_colour_blind_eyes) {
    const std::array<std::array<Triple, 3>, 4> eyes{
        {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
         {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
         {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
         {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}}};
    std::vector<Rgb> all(seriesColors.begin(), seriesColors.end());
    for (const Rgb ink : {blackInk, whiteInk}) {
        all.push_back(ink);
        for (const auto& eye : eyes) {
            for (std::size_t i = 0; i < all.size(); ++i) {
                for (std::size_t j = 0; j < i; ++j) {
                    const Triple a = labOf(times(eye, linearOf(all[i]))), b = labOf(times(eye, linearOf(all[j])));
                    // 2.3 is just noticed between large patches side by side; four times that for lines apart.
                    EXPECT_GT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 4 * 2.3)
                        << i << " " << j << " of eyes " << &eye - eyes.data();
                }
            }
        }
        all.pop_back();
    }
}

TEST(StudyPlot, has_the_looks_and_names_of_the_chart) {
    const auto run = committedStudy("z-buffer").value();
    const std::string svg = studySvg(run);
    for (const Rgb rgb : seriesColors) {
        char text[32];
        std::snprintf(text, sizeof text, "stroke=\"#%06X\"", static_cast<unsigned>(rgb));
        EXPECT_NE(svg.find(text), std::string::npos) << text;
    }
    EXPECT_NE(svg.find("stroke-dasharray"), std::string::npos) << "the thirteen are more than the colours";
    for (const char* word : {"far 1e6", "along a line: far 100", "no other best row of the same far", ">0<"}) {
        EXPECT_NE(svg.find(word), std::string::npos) << word;
    }
    // No letter is smaller than 11 pixels where a page shows it 900 wide, which it is.
    EXPECT_NE(svg.find("width=\"900\""), std::string::npos);
    for (auto at = svg.find("font-size=\""); at != std::string::npos; at = svg.find("font-size=\"", at + 1)) {
        EXPECT_GE(std::stod(svg.substr(at + 11)), 11);
    }
}
