#include "mv/run/study_data.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "mv/demo/number.h"
#include "mv/error.h"
#include "mv/run/words.h"

namespace mv {
namespace {

using Json = nlohmann::ordered_json;

// By ErrorAxis.
constexpr std::array<const char*, 3> axisNames{"rms", "fraction", "max"};

// Six digits say all that a measurement can.
double rounded(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6);
    double result = 0;
    std::from_chars(text, end.ptr, result);
    return result;
}

Json errorJson(const StudyError& error) {
    return {{"rms", rounded(error.rms)},
            {"max", rounded(error.max)},
            {"fraction", rounded(error.fraction)},
            {"n", error.n}};
}

std::optional<double> numberIn(const std::string& text) {
    double value = 0;
    if (!readNumber(text, value)) return {};
    return value;
}

// The slope of a line's rows; nothing where fewer than three of them have both numbers positive.
using OfRow = std::function<double(const StudyRow&)>;
std::optional<double> slope(const StudyRun& run, const std::string& scene, const std::string& method, const OfRow& x,
                            const OfRow& y) {
    std::vector<std::pair<double, double>> points;
    for (const StudyRow& row : run.rows) {
        if (row.scene != scene || row.method != method || !row.ok()) continue;
        if (x(row) > 0 && y(row) > 0) points.emplace_back(x(row), y(row));
    }
    return logarithmicSlope(points);
}

double parameterOrZero(const StudyRow& row) { return parameterOf(row).value_or(0); }

std::string csvField(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + "\"";
}

}  // namespace

std::optional<double> parameterOf(const StudyRow& row) { return numberIn(row.parameter); }

std::optional<double> logarithmicSlope(const std::vector<std::pair<double, double>>& points) {
    if (points.size() < 3) return {};
    double meanX = 0, meanY = 0, xx = 0, xy = 0;
    for (const auto& [x, y] : points) {
        meanX += std::log(x) / double(points.size());
        meanY += std::log(y) / double(points.size());
    }
    for (const auto& [x, y] : points) {
        xx += (std::log(x) - meanX) * (std::log(x) - meanX);
        xy += (std::log(x) - meanX) * (std::log(y) - meanY);
    }
    if (xx == 0) return {};
    return xy / xx;
}

std::optional<double> errorSlope(const StudyRun& run, const std::string& scene, const std::string& method) {
    return slope(run, scene, method, parameterOrZero, [&](const StudyRow& row) { return run.shownError(row); });
}

std::optional<double> timeSlope(const StudyRun& run, const std::string& scene, const std::string& method) {
    return slope(run, scene, method, parameterOrZero, [](const StudyRow& row) { return row.msMedian; });
}

std::optional<double> drawnSlope(const StudyRun& run, const std::string& scene, const std::string& method) {
    double least = 0, most = 0;
    for (const StudyRow& row : run.rows) {
        if (row.scene != scene || row.method != method || !isOnLine(run, row)) continue;
        least = least == 0 ? run.shownError(row) : std::min(least, run.shownError(row));
        most = std::max(most, run.shownError(row));
    }
    if (most < 2 * least) return {};
    return slope(
        run, scene, method, [&](const StudyRow& row) { return isPlotted(row) ? run.shownError(row) : 0; },
        [](const StudyRow& row) { return row.msMedian; });
}

bool isPlotted(const StudyRow& row) { return row.ok() && row.rounds > 0 && row.msMedian > 0; }

bool isOnLine(const StudyRun& run, const StudyRow& row) { return isPlotted(row) && run.shownError(row) > 0; }

std::string errorText(double value) { return value == 0 ? "0" : formatted("%.3g", value); }

std::string errorName(ErrorAxis axis) {
    return axis == ErrorAxis::rms   ? "root mean square error"
           : axis == ErrorAxis::max ? "largest error"
                                    : "part that is wrong";
}

std::string knobOf(const StudyRun& run, const std::string& scene, const std::string& method) {
    // Of the settings that have each row's parameter for their value, the last one: rows set the line's knob last.
    std::vector<std::string> names;
    bool any = false;
    for (const StudyRow& row : run.rows) {
        if (row.scene != scene || row.method != method || row.parameter.empty()) continue;
        std::vector<std::string> here;
        for (const KnobSetting& setting : row.settings) {
            const bool before = !any || std::find(names.begin(), names.end(), setting.name) != names.end();
            if (before && setting.text == row.parameter) here.push_back(setting.name);
        }
        names = std::move(here);
        any = true;
    }
    if (!any) return "";
    return names.empty() ? "p" : names.back();
}

std::string problemOf(const StudyRun& run, const StudyRow& row) {
    std::string problem;
    for (const KnobSetting& setting : row.settings) {  // of several for one knob the last holds
        if (run.problem.empty() || setting.name != run.problem) continue;
        const auto value = numberIn(setting.text);  // "1e4" and "10000" are one problem
        problem = value ? numberText(*value) : setting.text;
    }
    return problem;
}

bool compete(const StudyRun& run, const StudyRow& one, const StudyRow& other) {
    return one.scene == other.scene && problemOf(run, one) == problemOf(run, other);
}

void markBest(StudyRun& run) {
    // By the digits that a file has, so that a file that is read is judged alike: two splines may differ in the tenth.
    // From the most exact on, of equally exact ones the fastest first: whatever may beat a row is judged before it.
    std::vector<StudyRow*> order;
    for (StudyRow& row : run.rows) {
        row.best = false;
        if (row.ok() && row.rounds > 0) order.push_back(&row);
    }
    std::stable_sort(order.begin(), order.end(), [&](const StudyRow* a, const StudyRow* b) {
        return std::pair(rounded(run.shownError(*a)), rounded(a->msMedian)) <
               std::pair(rounded(run.shownError(*b)), rounded(b->msMedian));
    });
    for (auto row = order.begin(); row != order.end(); ++row) {
        // Two standard errors of the difference of two medians of 7 are about the sum of both deviations.
        (*row)->best = std::none_of(order.begin(), row, [&](const StudyRow* nearer) {
            return nearer->best && compete(run, *nearer, **row) &&
                   rounded(nearer->msMedian) <=
                       rounded((*row)->msMedian) + rounded(nearer->msMad) + rounded((*row)->msMad);
        });
    }
}

std::string bestText(const StudyRun& run) {
    return "no other best row" + (run.problem.empty() ? "" : " of the same " + run.problem) +
           " is as near without being measurably slower";
}

std::string studyJson(const StudyRun& run) {
    Json json;
    json["demo"] = run.demo;
    json["quantity"] = run.quantity;
    json["reference"] = run.reference;
    json["axis"] = axisNames.at(static_cast<std::size_t>(run.axis));
    if (!run.problem.empty()) json["problem"] = run.problem;
    json["wrong_beyond"] = run.wrongBeyond;
    json["width"] = run.width;
    json["height"] = run.height;
    json["frame"] = run.frame;
    json["host"] = run.host;
    json["renderer"] = run.renderer;
    json["processor"] = run.processor;
    json["threads"] = run.threads;
    json["reference_errors"] = Json::object();
    for (const auto& [scene, error] : run.referenceErrors) json["reference_errors"][scene] = rounded(error);
    json["rows"] = Json::array();
    for (const StudyRow& row : run.rows) {
        Json entry;
        entry["scene"] = row.scene;
        entry["method"] = row.method;
        entry["parameter"] = row.parameter;
        entry["settings"] = Json::object();
        for (const auto& [name, text] : row.settings) entry["settings"][name] = text;
        entry["status"] = row.status;
        entry["all"] = errorJson(row.all);
        entry["away_from_edges"] = errorJson(row.awayFromEdges);
        entry["unmatched"] = row.unmatched;
        entry["ms_median"] = rounded(row.msMedian);
        entry["ms_mad"] = rounded(row.msMad);
        entry["rounds"] = row.rounds;
        entry["counts"] = Json::object();
        for (const auto& [name, amount] : row.counts) entry["counts"][name] = amount;
        entry["best"] = row.best;
        json["rows"].push_back(std::move(entry));
    }
    return json.dump(1) + "\n";
}

std::string studyCsv(const StudyRun& run) {
    std::string text =
        "scene,method,parameter,err_rms,err_max,err_frac,away_from_edges_rms,away_from_edges_max,away_from_edges_frac,"
        "ms_median,ms_mad,n,rounds,"
        "unmatched,ops,best,reference,status\n";
    for (const StudyRow& row : run.rows) {
        std::string ops;
        for (const auto& [name, amount] : row.counts) {
            ops += std::string(ops.empty() ? "" : " ").append(name).append("=").append(numberText(amount));
        }
        const auto add = [&](const std::string& field) { text += csvField(field) + ","; };
        const auto addNumber = [&](double value) { add(row.ok() ? numberText(rounded(value)) : ""); };
        add(row.scene);
        add(row.method);
        add(row.parameter);
        for (const StudyError* error : {&row.all, &row.awayFromEdges}) {
            addNumber(error->rms);
            addNumber(error->max);
            addNumber(error->fraction);
        }
        addNumber(row.msMedian);
        addNumber(row.msMad);
        add(std::to_string(row.all.n));
        add(std::to_string(row.rounds));
        add(std::to_string(row.unmatched));
        add(ops);
        add(row.best ? "best" : "");
        add(run.reference);
        text += csvField(row.status) + "\n";
    }
    return text;
}

StudyRun readStudy(const std::string& text) {
    std::string place = "the whole";  // that is being read
    const auto in = [&](const Json& json, const char* name) -> const Json& {
        place = std::string("'") + name + "'";
        return json.at(name);
    };
    const auto size = [&](const Json& json, const char* name) {
        const double value = in(json, name);
        if (value < 0) throw Error("study", "must have no times and errors below 0; see " + place, numberText(value));
        return value;
    };
    const auto errorIn = [&](const Json& json, const char* name) {
        const Json& error = in(json, name);
        return StudyError{size(error, "rms"), size(error, "max"), size(error, "fraction"), in(error, "n")};
    };
    constexpr const char* rule = "must be the text of a study.json of this version";
    try {
        const Json json = Json::parse(text);
        StudyRun run;
        run.demo = in(json, "demo");
        run.quantity = in(json, "quantity");
        run.reference = in(json, "reference");
        const std::string axisName = in(json, "axis");
        const auto axis = std::find(axisNames.begin(), axisNames.end(), axisName);
        if (axis == axisNames.end()) throw Error("axis", "must be rms, fraction or max", axisName);
        run.axis = static_cast<ErrorAxis>(axis - axisNames.begin());
        if (json.contains("problem")) run.problem = in(json, "problem");
        run.wrongBeyond = in(json, "wrong_beyond");
        run.width = in(json, "width");
        run.height = in(json, "height");
        run.frame = in(json, "frame");
        run.host = in(json, "host");
        run.renderer = in(json, "renderer");
        run.processor = in(json, "processor");
        run.threads = in(json, "threads");
        for (const auto& [scene, error] : in(json, "reference_errors").items()) {
            run.referenceErrors.emplace_back(scene, error.get<double>());
        }
        for (const Json& entry : in(json, "rows")) {
            StudyRow row;
            row.scene = in(entry, "scene");
            row.method = in(entry, "method");
            row.parameter = in(entry, "parameter");
            for (const auto& [name, value] : in(entry, "settings").items()) row.settings.push_back({name, value});
            row.status = in(entry, "status");
            row.all = errorIn(entry, "all");
            row.awayFromEdges = errorIn(entry, "away_from_edges");
            row.unmatched = in(entry, "unmatched");
            row.msMedian = size(entry, "ms_median");
            row.msMad = size(entry, "ms_mad");
            row.rounds = in(entry, "rounds");
            for (const auto& [name, amount] : in(entry, "counts").items()) {
                row.counts.emplace_back(name, amount.get<double>());
            }
            row.best = in(entry, "best");
            run.rows.push_back(std::move(row));
        }
        return run;
    } catch (const Json::parse_error& problem) {
        throw Error("study", rule, "it is no JSON from byte " + std::to_string(problem.byte) + " on");
    } catch (const Json::exception&) {
        throw Error("study", rule, place + " is missing or of another kind");
    }
}

namespace {
// Never destroyed: the files of the demos fill it before main, in any order.
std::map<std::string, std::string>& committedTexts() {
    static auto& texts = *new std::map<std::string, std::string>;
    return texts;
}
}  // namespace

bool addStudyFile(const std::string& demo, std::string text) {
    return committedTexts().emplace(demo, std::move(text)).second;
}
bool addStudyFile(const char* demo, const char* text) { return addStudyFile(std::string(demo), std::string(text)); }

std::optional<StudyRun> committedStudy(const std::string& demo) {
    const auto found = committedTexts().find(demo);
    if (found == committedTexts().end()) return {};
    return readStudy(found->second);
}

}  // namespace mv
