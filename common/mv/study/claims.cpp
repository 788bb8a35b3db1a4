#include "mv/study/claims.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mv/error.h"
#include "mv/paper/tables.h"
#include "mv/study/study.h"

namespace mv {
namespace {

using Rows = std::vector<const StudyRow*>;

std::string nameOf(const StudyNumber& number) {
    switch (number.kind) {
        case StudyNumber::Kind::error:
            return "error";
        case StudyNumber::Kind::rms:
            return "rms";
        case StudyNumber::Kind::max:
            return "max";
        case StudyNumber::Kind::wrong:
            return "wrong %";
        case StudyNumber::Kind::wrongAwayFromEdges:
            return "wrong away from edges %";
        case StudyNumber::Kind::time:
            return "ms";
        case StudyNumber::Kind::count:
            return number.name;
    }
    return "";
}

std::string nameOf(const StudyRows& rows) {
    std::string text;
    for (const std::string& method : rows.methods) text += (text.empty() ? "" : "; ") + method;
    if (!rows.scene.empty()) text += " in " + rows.scene;
    if (rows.low == rows.high) return text + " at " + numberText(rows.low);
    if (rows.low > -HUGE_VAL) text += " from " + numberText(rows.low);
    if (rows.high < HUGE_VAL) text += " up to " + numberText(rows.high);
    return text;
}

std::string boundsText(double low, double high) {
    if (low == high) return errorText(low);
    if (low == -HUGE_VAL) return "at most " + errorText(high);
    if (high == HUGE_VAL) return "at least " + errorText(low);
    return errorText(low) + " .. " + errorText(high);
}

Rows matching(const StudyRun& run, const StudyRows& wanted) {
    Rows rows;
    for (const std::string& method : wanted.methods) {
        const std::size_t before = rows.size();
        for (const StudyRow& row : run.rows) {
            if (row.method != method || (!wanted.scene.empty() && row.scene != wanted.scene)) continue;
            const bool bounded = wanted.low > -HUGE_VAL || wanted.high < HUGE_VAL;
            const auto p = parameterOf(row);
            if (bounded && (!p || *p < wanted.low || *p > wanted.high)) continue;
            rows.push_back(&row);
        }
        if (rows.size() == before) {
            StudyRows one = wanted;
            one.methods = {method};
            throw Error("claim", "must be about rows that there are", nameOf(one));
        }
    }
    return rows;
}

// Nothing where the row failed.
std::optional<double> numberOf(const StudyRun& run, const StudyRow& row, const StudyNumber& number) {
    if (!row.ok()) return {};
    switch (number.kind) {
        case StudyNumber::Kind::error:
            return (run.axis == ErrorAxis::fraction ? 100 : 1) * run.shownError(row);
        case StudyNumber::Kind::rms:
            return row.all.rms;
        case StudyNumber::Kind::max:
            return row.all.max;
        case StudyNumber::Kind::wrong:
            return 100 * row.all.fraction;
        case StudyNumber::Kind::wrongAwayFromEdges:
            return 100 * row.awayFromEdges.fraction;
        case StudyNumber::Kind::time:
            if (row.rounds == 0) throw Error("claim", "must be about times that were measured", nameOf(row));
            return row.msMedian;
        case StudyNumber::Kind::count:
            for (const auto& [name, amount] : row.counts) {
                if (name == number.name) return amount;
            }
            throw Error("claim", "must be about what a frame counts", std::string(number.name) + " of " + nameOf(row));
    }
    return {};
}

// Collects the numbers found, each against the bounds.
class Finding {
  public:
    Finding(const Predicate& predicate, std::string what) : predicate_(predicate), what_(std::move(what)) {}

    void add(const std::string& where, const std::string& scene, double number) {
        least_ = std::min(least_, number);
        most_ = std::max(most_, number);
        found_ = true;
        if (std::find(scenes_.begin(), scenes_.end(), scene) == scenes_.end()) scenes_.push_back(scene);
        if (!(number >= predicate_.low && number <= predicate_.high))
            failures_.push_back(where + ": " + what_ + " is " + errorText(number));
    }
    void addFailed(const StudyRow& row) {
        failures_.push_back(nameOf(row) + ": " + what_ + " is not there: " + row.status);
    }

    Evaluation result(const std::string& rows) const {
        std::string text = what_ + (rows.empty() ? "" : ", " + rows) + ": ";
        text += !found_ ? "none" : least_ == most_ ? errorText(least_) : errorText(least_) + " .. " + errorText(most_);
        if (scenes_.size() > 1) text += " in " + std::to_string(scenes_.size()) + " scenes";
        return {failures_.empty(), text + "; claimed " + boundsText(predicate_.low, predicate_.high), failures_};
    }

  private:
    const Predicate& predicate_;
    std::string what_;
    double least_ = HUGE_VAL, most_ = -HUGE_VAL;
    bool found_ = false;
    std::vector<std::string> scenes_, failures_;
};

// The rows of one line, a scene's rows of one method, after the other.
std::vector<Rows> byLine(const Rows& rows) {
    std::vector<Rows> lines;
    for (const StudyRow* row : rows) {
        const auto same = std::find_if(lines.begin(), lines.end(), [&](const Rows& line) {
            return line.front()->scene == row->scene && line.front()->method == row->method;
        });
        if (same == lines.end()) {
            lines.push_back({row});
        } else {
            same->push_back(row);
        }
    }
    return lines;
}

std::string lineName(const StudyRow& row) { return row.scene.empty() ? row.method : row.scene + ", " + row.method; }

Evaluation slopes(const StudyRun& run, const Predicate& predicate) {
    Finding finding(predicate, "slope of " + nameOf(predicate.number) + " over p");
    for (const Rows& line : byLine(matching(run, predicate.which))) {
        std::vector<std::pair<double, double>> points;
        bool ok = true;
        for (const StudyRow* row : line) {
            const auto p = parameterOf(*row), number = numberOf(run, *row, predicate.number);
            if (!number) {
                finding.addFailed(*row);
                ok = false;
            } else if (p && *p > 0 && *number > 0) {
                points.emplace_back(*p, *number);
            }
        }
        if (!ok) continue;
        const auto found = logarithmicSlope(points);
        if (!found) throw Error("claim", "must have three rows for a slope", lineName(*line.front()));
        finding.add(lineName(*line.front()), line.front()->scene, *found);
    }
    return finding.result(nameOf(predicate.which));
}

Evaluation values(const StudyRun& run, const Predicate& predicate) {
    Finding finding(predicate, nameOf(predicate.number));
    for (const StudyRow* row : matching(run, predicate.which)) {
        if (const auto number = numberOf(run, *row, predicate.number)) {
            finding.add(nameOf(*row), row->scene, *number);
        } else {
            finding.addFailed(*row);
        }
    }
    return finding.result(nameOf(predicate.which));
}

const StudyRow& partnerOf(const StudyRow& row, const Rows& against, bool anyScene) {
    Rows partners;
    for (const StudyRow* other : against) {
        if (anyScene || other->scene == row.scene) partners.push_back(other);
    }
    if (partners.size() > 1)
        std::erase_if(partners, [&](const auto* other) { return other->parameter != row.parameter; });
    if (partners.size() != 1) throw Error("claim", "must compare each row with one other", nameOf(row));
    return *partners.front();
}

Evaluation ratios(const StudyRun& run, const Predicate& predicate) {
    Finding finding(predicate, nameOf(predicate.number) + " of " + nameOf(predicate.which) + " by that of " +
                                   nameOf(predicate.against));
    const Rows against = matching(run, predicate.against);
    for (const StudyRow* row : matching(run, predicate.which)) {
        const StudyRow& other = partnerOf(*row, against, !predicate.against.scene.empty());
        const auto upper = numberOf(run, *row, predicate.number), lower = numberOf(run, other, predicate.number);
        if (!upper) finding.addFailed(*row);
        if (!lower) finding.addFailed(other);
        if (!upper || !lower) continue;
        finding.add(nameOf(*row), row->scene, *upper == *lower ? 1 : *upper / *lower);
    }
    return finding.result("");
}

Evaluation settledLines(const StudyRun& run, const Predicate& predicate) {
    Finding finding(predicate, "largest " + nameOf(predicate.number) + " by the smallest");
    for (const Rows& line : byLine(matching(run, predicate.which))) {
        if (line.size() < 2) throw Error("claim", "must have two rows that can differ", lineName(*line.front()));
        double least = HUGE_VAL, most = 0;
        bool ok = true;
        for (const StudyRow* row : line) {
            const auto number = numberOf(run, *row, predicate.number);
            if (!number) finding.addFailed(*row);
            ok = ok && number;
            least = std::min(least, number.value_or(least));
            most = std::max(most, number.value_or(most));
        }
        if (ok) finding.add(lineName(*line.front()), line.front()->scene, most == least ? 1 : most / least);
    }
    return finding.result(nameOf(predicate.which));
}

// Judged by markBest, which says who competes with whom: among one row and all of its rivals.
Evaluation unbeatenRows(const StudyRun& run, const Predicate& predicate) {
    Evaluation result;
    const Rows rivals = matching(run, predicate.against);
    StudyRun alone = run;
    alone.rows.clear();
    std::size_t duels = 0;
    const Rows judged = matching(run, predicate.which);
    for (const StudyRow* row : judged) {
        if (!row->ok()) {
            result.failures.push_back(nameOf(*row) + " has no number: " + row->status);
            continue;
        }
        for (const StudyRow* rival : rivals) {
            if (rival->scene != row->scene || rival == row) continue;
            for (const StudyRow* timed : {row, rival}) {
                if (timed->ok()) (void)numberOf(run, *timed, claims::of::time);
            }
            ++duels;
            StudyRun two = alone;
            two.rows = {*row, *rival};
            markBest(two);
            if (!two.rows[0].best) result.failures.push_back(nameOf(*row) + " is beaten by " + nameOf(*rival));
        }
    }
    if (duels == 0) throw Error("claim", "must have rivals in the same scene", nameOf(predicate.which));
    result.holds = result.failures.empty();
    result.text = "rows of " + nameOf(predicate.which) + " that a row of " + nameOf(predicate.against) +
                  " beats in error and time: " + std::to_string(result.failures.size()) + " of " +
                  std::to_string(judged.size()) + "; claimed 0";
    return result;
}

Evaluation failedRows(const StudyRun& run, const Predicate& predicate) {
    Evaluation result;
    const Rows judged = matching(run, predicate.which);
    for (const StudyRow* row : judged) {
        if (row->ok() || row->status.find(predicate.reason) == std::string::npos)
            result.failures.push_back(nameOf(*row) + ": does not fail because '" + predicate.reason +
                                      "': " + row->status);
    }
    result.holds = result.failures.empty();
    result.text = "rows of " + nameOf(predicate.which) + " that fail, '" + predicate.reason +
                  "': " + std::to_string(judged.size() - result.failures.size()) + "; claimed " +
                  std::to_string(judged.size());
    return result;
}

}  // namespace

bool isAbout(const Saying& saying, const StudyRun& run) {
    if (run.width == 0) return true;  // values, which no renderer computes
    const auto says = [&](const char* words) { return saying.sentence.find(words) != std::string::npos; };
    const bool ofProcessor = says("on a processor") || says("On a processor");
    const bool ofGpu = says("on this GPU") || says("On this GPU");
    if (ofProcessor == ofGpu) return true;
    return ofGpu == (drawerOf(run.renderer) == Drawer::gpu);
}

Evaluation evaluate(const StudyRun& run, const Predicate& predicate) {
    switch (predicate.kind) {
        case Predicate::Kind::slope:
            return slopes(run, predicate);
        case Predicate::Kind::value:
            return values(run, predicate);
        case Predicate::Kind::ratio:
            return ratios(run, predicate);
        case Predicate::Kind::settled:
            return settledLines(run, predicate);
        case Predicate::Kind::unbeaten:
            return unbeatenRows(run, predicate);
        case Predicate::Kind::fails:
            return failedRows(run, predicate);
    }
    throw Error("claim", "must be of a known kind");
}

}  // namespace mv
