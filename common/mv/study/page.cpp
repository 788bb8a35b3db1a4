// docs/errors-and-times/<demo>.md: the page of a study and of what was committed of it, a machine each.
#include <algorithm>
#include <cstdio>

#include "mv/error.h"
#include "mv/paper/tables.h"
#include "mv/study/claims.h"
#include "mv/study/study.h"

namespace mv {
namespace {

std::string errorTable(const StudyRun& run) {
    std::string text =
        "| scene | method | p | rms | max | wrong % | away from edges % | ms | MAD | best |\n"
        "|---|---|---:|---:|---:|---:|---:|---:|---:|---|\n";
    for (const StudyRow& row : run.rows) {
        text += "| " + tableCell(row.scene) + " | " + tableCell(row.method) + " | " + tableCell(row.parameter) + " | ";
        if (!row.ok()) {
            text += "failed: " + tableCell(row.status) + " | | | | | | |\n";
            continue;
        }
        text += errorText(row.all.rms) + " | " + errorText(row.all.max) + " | " + errorText(100 * row.all.fraction) +
                " | " + errorText(100 * row.awayFromEdges.fraction) + " | " + formatted("%.3g", row.msMedian) + " | " +
                formatted("%.2g", row.msMad) + " | " + (row.best ? "best" : "") + " |\n";
    }
    return text;
}

std::string countTable(const StudyRun& run) {
    std::vector<std::string> names;
    for (const StudyRow& row : run.rows) {
        for (const auto& [name, amount] : row.counts) {
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
        }
    }
    if (names.empty()) return "";
    std::string head = "| scene | method | p |", line = "|---|---|---:|", text;
    for (const std::string& name : names) {
        head += " " + name + " |";
        line += "---:|";
    }
    for (const StudyRow& row : run.rows) {
        if (!row.ok()) continue;
        text += "| " + tableCell(row.scene) + " | " + tableCell(row.method) + " | " + tableCell(row.parameter) + " |";
        for (const std::string& name : names) {
            const auto found = std::find_if(row.counts.begin(), row.counts.end(),
                                            [&](const auto& count) { return count.first == name; });
            text += " " + (found == row.counts.end() ? "" : formatted("%.10g", found->second)) + " |";
        }
        text += "\n";
    }
    return std::string(run.width > 0 ? "\n### Work of a frame on " : "\n### Counts on ") + machineName(run) + "\n\n" +
           head + "\n" + line + "\n" + text;
}

std::string slopeList(const StudyRun& run) {
    std::string text;
    std::vector<std::pair<std::string, std::string>> seen;
    for (const StudyRow& row : run.rows) {
        const std::pair<std::string, std::string> line{row.scene, row.method};
        if (std::find(seen.begin(), seen.end(), line) != seen.end()) continue;
        seen.push_back(line);
        const auto error = errorSlope(run, row.scene, row.method), time = timeSlope(run, row.scene, row.method);
        if (!error && !time) continue;
        text += "- " + (row.scene.empty() ? "" : row.scene + ", ") + row.method + ":";
        if (error) text += " error ~ p^" + formatted("%.2f", *error);
        if (time) text += std::string(error ? "," : "") + " time ~ p^" + formatted("%.2f", *time);
        text += "\n";
    }
    return text.empty()
               ? ""
               : "\n### Slopes on " + machineName(run) + "\n\nBy least squares over the logarithms:\n\n" + text;
}

std::string setUp(const StudyRun& run) {
    std::string text = "- Compared: " + run.quantity + ".";
    if (run.width > 0) {
        text += " Picture " + std::to_string(run.width) + "x" + std::to_string(run.height) + ", frame " +
                std::to_string(run.frame) + ".";
    }
    text += " Wrong is what is farther than " + numberText(run.wrongBeyond) +
            " from the reference.\n- Reference: " + run.reference + ".";
    for (const auto& [scene, error] : run.referenceErrors) {
        text += std::string(" Its own error")
                    .append(scene.empty() ? "" : " in \"" + scene + "\"")
                    .append(", by doubling its samples in each direction: ")
                    .append(errorText(error))
                    .append(".");
    }
    int rounds = 0;
    for (const StudyRow& row : run.rows) rounds = std::max(rounds, row.rounds);
    text += "\n- Times: median and median absolute deviation of " + std::to_string(rounds) +
            " interleaved runs, the first dropped, each finished by `glFinish`; " + run.host + ", " + run.renderer +
            ", " + run.processor + ", " + std::to_string(run.threads) + " threads.\n";
    if (!run.note.empty()) text += "- " + run.note + ".\n";
    return text;
}

// The machine of each evaluation, when the sentence is about more than one.
std::string whatItSays(const std::vector<StudyRun>& runs, const Study& study) {
    std::string text =
        "Under each claim stands what was evaluated of the rows below, and what a test requires of it.\n\n";
    for (const Saying& saying : study.says) {
        if (!saying.isClaim()) {
            text += "- " + saying.sentence + "\n";
            continue;
        }
        text += "- **" + saying.id + "** " + saying.sentence + "\n";
        for (const Predicate& predicate : saying.predicates) {
            for (const StudyRun& run : runs) {
                if (!isAbout(saying, run)) continue;
                text += "  - " + (runs.size() > 1 ? "on " + machineName(run) + ": " : "") +
                        evaluate(run, predicate).text + "\n";
            }
        }
    }
    return text;
}

std::string machinePart(const StudyRun& run) {
    const std::string file = run.demo + "." + nameOf(drawerOf(run.renderer));
    return "\n## On " + machineName(run) + "\n\n![Error against run time on " + machineName(run) + "](" + file +
           ".svg)\n\n" + setUp(run) + "- The rows as a file: [" + file + ".csv](" + file + ".csv).\n\n" +
           errorTable(run) + slopeList(run) + countTable(run);
}

}  // namespace

std::string studyPage(const std::vector<StudyRun>& runs, const DemoInfo& info) {
    if (!info.study) throw Error(info.name, "must declare the study that its page shows");
    if (runs.empty()) throw Error(info.name, "must have a committed study, for a page");
    std::string text =
        "# Error and time: " + info.name +
        "\n\nMade by `./run --docs .` from the rows in CSV files; do not "
        "edit. The demo: [" +
        info.name + "](../../" + info.page + ").\n\n" + whatItSays(runs, *info.study) +
        "\nErrors and counts are the same on every machine with the same OpenGL driver, and a test measures "
        "them\nagain; milliseconds, their deviation and so what is best belong to the machine that a part is "
        "headed with. Measure yours:\n\n```\n./run " +
        info.name +
        " --study out\n```\n\np is the value of the knob that moves along the line; *best*: " + bestText(runs.front()) +
        ".\n";
    for (const StudyRun& run : runs) text += machinePart(run);
    return text;
}

}  // namespace mv
