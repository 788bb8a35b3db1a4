#include "mv/study/choice.h"

#include <algorithm>
#include <tuple>

#include "mv/error.h"
#include "mv/paper/tables.h"

namespace mv {
namespace {

// As the study's rows have the problem, canonical.
std::string presentProblem(const StudyRun& run, const Demo& demo) {
    StudyRow here;
    here.settings = {{run.problem, demo.knob(run.problem).text()}};
    return problemOf(run, here);
}

}  // namespace

std::string boundText(const StudyBound& bound) {
    if (bound.of == StudyBound::Of::time) return formatted("%.3g ms", bound.value);
    return errorText(bound.value);
}

std::optional<std::size_t> rowWithin(const StudyRun& run, const std::vector<std::size_t>& rows,
                                     const StudyBound& bound) {
    std::optional<std::size_t> best;
    const bool ofTime = bound.of == StudyBound::Of::time;
    const auto rank = [&](std::size_t i) {
        const double error = run.shownError(run.rows[i]), time = run.rows[i].msMedian;
        return ofTime ? std::tuple(error, time, i) : std::tuple(time, error, i);
    };
    for (const std::size_t i : rows) {
        const StudyRow& row = run.rows[i];
        if (!isPlotted(row) || (ofTime ? row.msMedian : run.shownError(row)) > bound.value) continue;
        if (!best || rank(i) < rank(*best)) best = i;
    }
    return best;
}

std::optional<std::size_t> nearestTo(const StudyRun& run, const std::vector<std::size_t>& rows,
                                     const StudyBound& bound) {
    StudyBound loosest = bound;
    double least = -1;
    for (const std::size_t i : rows) {
        if (!isPlotted(run.rows[i])) continue;
        const double value = bound.of == StudyBound::Of::time ? run.rows[i].msMedian : run.shownError(run.rows[i]);
        if (least < 0 || value < least) least = value;
    }
    loosest.value = least;
    return rowWithin(run, rows, loosest);
}

std::vector<std::size_t> rowsOfProblem(const StudyRun& run, const std::string& scene, const Demo& demo,
                                       const std::string& subject) {
    std::vector<std::size_t> all, equal, unset;
    std::string known;
    const std::string here = run.problem.empty() ? "" : presentProblem(run, demo);
    for (std::size_t i = 0; i < run.rows.size(); ++i) {
        const StudyRow& row = run.rows[i];
        if (row.scene != scene) continue;
        const std::string problem = problemOf(run, row);
        all.push_back(i);
        if (problem == here) equal.push_back(i);
        if (problem.empty()) unset.push_back(i);
        if (!problem.empty() && ("," + known + ",").find(", " + problem + ",") == std::string::npos) {
            known += (known.empty() ? " " : ", ") + problem;
        }
    }
    if (run.problem.empty()) return all;
    if (!equal.empty()) return equal;
    // Rows that do not set the knob were measured with its initial value.
    if (!unset.empty() && demo.knob(run.problem).isInitial()) return unset;
    throw Error(subject, "needs a --" + run.problem + " that the study has in '" + scene + "':" + known, here);
}

std::string measuredOtherwise(const StudyRow& row, const Demo& demo) {
    std::string others;
    for (const Knob* knob : demo.knobs()) {
        const bool isSet =
            std::ranges::any_of(row.settings, [&](const KnobSetting& setting) { return setting.name == knob->name(); });
        if (!isSet && !knob->isInitial()) {
            others += (others.empty() ? "" : ", ") + knob->name();
        }
    }
    return others;
}

}  // namespace mv
