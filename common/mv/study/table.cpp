// A study in words: its names, its table.
#include <algorithm>

#include "mv/paper/tables.h"
#include "mv/study/study.h"

namespace mv {

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
    return (run.renderer.empty() ? "" : run.renderer + ", ") + run.processor + ", " + std::to_string(run.threads) +
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

std::string rowSentence(const StudyRun& run, const StudyRow& row) {
    std::string text = row.method;
    if (!row.parameter.empty()) text += ", " + (row.knob.empty() ? "" : row.knob + " ") + row.parameter;
    return text + ": " + errorName(run.axis) + " " + errorText(run.shownError(row)) +
           formatted(", %.3g ms", row.msMedian);
}

}  // namespace mv
