// What a study looks like: its table, its plot and its page.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mv/error.h"
#include "mv/run/gnuplot.h"
#include "mv/run/study.h"
#include "mv/run/words.h"

namespace mv {
namespace {

// ---- gnuplot. A study may be anybody's file: its texts come into the script by quotedForGnuplot() alone, and not into data,
// in which quotes cannot be quoted.

std::string legend(const StudyRun& run, const std::string& scene, const std::string& method) {
    std::string text = method;
    if (const auto slope = errorSlope(run, scene, method)) text += formatted(" (slope %.2f)", *slope);
    return text;
}

// Of the errors that are not 0, and where 0 is drawn; of the times.
struct PlotRange {
    double low, high, zero;
    double fastest, slowest;
};

PlotRange plotRange(const StudyRun& run, const std::string& scene) {
    double low = 0, high = 0, fastest = 0, slowest = 0;
    for (const StudyRow& row : run.rows) {
        if (row.scene != scene || !row.ok() || row.rounds == 0) continue;
        fastest = fastest == 0 ? row.msMedian : std::min(fastest, row.msMedian);
        slowest = std::max(slowest, row.msMedian);
        const double error = run.shownError(row);
        if (error <= 0) continue;
        low = low == 0 ? error : std::min(low, error);
        high = std::max(high, error);
    }
    if (low == 0) low = high = 1;
    if (fastest == 0) fastest = slowest = 1;
    const double decade = std::pow(10, std::floor(std::log10(low)));
    return {decade, 2 * high, decade / 6, fastest / 1.5, slowest * 1.5};
}

// 1, 2 and 5 of every decade: a range of times may lie between two powers of ten.
std::string timeTics(const PlotRange& range) {
    std::string tics;
    const int first = int(std::floor(std::log10(range.fastest))), last = int(std::floor(std::log10(range.slowest)));
    for (int power = first; power <= last; ++power) {
        for (const double step : {1.0, 2.0, 5.0}) {
            const std::string text = formatted("%g", step * std::pow(10, power));
            tics.append(tics.empty() ? "'" : ", '").append(text).append("' ").append(text);
        }
    }
    return "set ytics (" + tics + ")\n";
}

// One scene's plot. Zero has no place on a logarithmic axis; it gets a column of its own at the left.
std::string plotScript(const StudyRun& run, const std::string& scene) {
    const PlotRange range = plotRange(run, scene);
    const auto shownX = [&](const StudyRow& row) {
        const double error = run.shownError(row);
        return error > 0 ? error : range.zero;
    };
    const auto isShown = [&](const StudyRow& row) { return row.scene == scene && row.ok() && row.rounds > 0; };
    std::string data, plots, labels;
    int index = 0;
    const auto addBlock = [&](const std::string& style, const std::string& title, const auto& wanted) {
        std::string points;
        for (const StudyRow& row : run.rows) {
            if (!isShown(row) || !wanted(row)) continue;
            points += formatted("%.9g ", shownX(row)) + formatted("%.9g\n", row.msMedian);
        }
        if (points.empty()) return;
        const std::string name = "$block" + std::to_string(index++);
        data += name + " << END\n" + points + "END\n";
        plots +=
            (plots.empty() ? "plot " : ", \\\n  ") + name + " using 1:2 " + style + " title " + quotedForGnuplot(title);
    };
    const auto isBest = [](const StudyRow& row) { return row.best; };
    int color = 1;
    for (const std::string& method : methodsOf(run, scene)) {
        const auto ofMethod = [&](const StudyRow& row) { return row.method == method; };
        const std::string look = "lw 1.5 ps 0.7 pt " + std::to_string(4 + color % 9) + " lc " + std::to_string(color);
        addBlock("with linespoints " + look, legend(run, scene, method), ofMethod);
        for (const StudyRow& row : run.rows) {  // the parameter beside each point
            if (!isShown(row) || !ofMethod(row) || row.parameter.empty()) continue;
            labels += "set label " + quotedForGnuplot(row.parameter) + " at " + formatted("%.9g, ", shownX(row)) +
                      formatted("%.9g", row.msMedian) + " left offset 0.6,0.45 font ',8' noenhanced\n";
        }
        ++color;
    }
    if (plots.empty()) throw Error("plot", "must have a row with an error and a time", scene);
    addBlock("with points pt 6 ps 1.9 lw 1.5 lc rgb 'black'", "Pareto-best", isBest);
    std::string script = data + labels;
    script += "set title " + quotedForGnuplot(run.demo + (scene.empty() ? "" : ": " + scene)) + " noenhanced\n";
    script += "set xlabel " +
              quotedForGnuplot((run.axis == ErrorAxis::rms ? "root mean square error, " : "part that is wrong, ") +
                               run.quantity) +
              " noenhanced\n";
    script += "set xrange [" + formatted("%g", range.zero / 1.5) + ":" + formatted("%g", range.high) + "]\n";
    script += "set yrange [" + formatted("%g", range.fastest) + ":" + formatted("%g", range.slowest) + "]\n" +
              timeTics(range);
    script += "set xtics add ('0' " + formatted("%g", range.zero) + ")\n";
    script += "set arrow 1 from " + formatted("%g", range.zero * 2.4) + ", graph 0 to " +
              formatted("%g", range.zero * 2.4) + ", graph 1 nohead dt 3 lc rgb '#999999'\n";
    return script + plots + "\nunset xtics\nset xtics format '10^{%T}'\n";
}

}  // namespace

std::string errorText(double value) { return value == 0 ? "0" : formatted("%.3g", value); }

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
    const std::vector<std::string> scenes = scenesOf(run);
    const int height = 520 * static_cast<int>(scenes.size()) + 60;
    std::string script =
        "set terminal svg size 1150," + std::to_string(height) +
        " dynamic font 'DejaVu Sans,11' background rgb 'white'\n"
        "set logscale xy\nset grid lc rgb '#dddddd'\nset key at screen 0.65, graph 1 left top Left reverse noenhanced\n"
        "set format x '10^{%T}'\nset format y '%g'\n";
    script += run.width > 0 ? "set ylabel 'milliseconds a frame'\n" : "set ylabel 'milliseconds'\n";
    const double foot = 60.0 / height;
    script += "set multiplot layout " + std::to_string(scenes.size()) + ",1 margins 0.08,0.63," +
              formatted("%.4f", foot + 60.0 / height) + "," + formatted("%.4f", 1 - 40.0 / height) + " spacing " +
              formatted("%.4f", 100.0 / height) + "\n";
    script += "set label 1 " + quotedForGnuplot("Reference: " + referenceText(run)) + " at screen 0.01, screen " +
              formatted("%.4f", 34.0 / height) + " font ',9' noenhanced\n";
    script += "set label 2 " + quotedForGnuplot("Measured on: " + machineText(run)) + " at screen 0.01, screen " +
              formatted("%.4f", 14.0 / height) + " font ',9' noenhanced\n";
    for (const std::string& scene : scenes) {
        script += plotScript(run, scene) + "unset label\n";  // of the scene, and of the study: once is enough
    }
    return drawnByGnuplot(script + "unset multiplot\nset output\n");
}

}  // namespace mv
