#include "mv/run/study_data.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "mv/error.h"

namespace mv {
namespace {

using Json = nlohmann::ordered_json;

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

// Slope of log y over log parameter, by least squares.
std::optional<double> slope(const StudyRun& run, const std::string& scene, const std::string& method,
                            const std::function<double(const StudyRow&)>& y) {
    std::vector<std::pair<double, double>> points;
    for (const StudyRow& row : run.rows) {
        if (row.scene != scene || row.method != method || !row.ok()) continue;
        const auto parameter = parameterOf(row);
        if (parameter && *parameter > 0 && y(row) > 0) points.emplace_back(*parameter, y(row));
    }
    return logarithmicSlope(points);
}

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

std::optional<double> parameterOf(const StudyRow& row) {
    const std::string& text = row.parameter;
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return {};
    return value;
}

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
    return slope(run, scene, method, [&](const StudyRow& row) { return run.shownError(row); });
}

std::optional<double> timeSlope(const StudyRun& run, const std::string& scene, const std::string& method) {
    return slope(run, scene, method, [](const StudyRow& row) { return row.msMedian; });
}

void markBest(StudyRun& run) {
    for (StudyRow& row : run.rows) {
        row.best =
            row.ok() && row.rounds > 0 && std::none_of(run.rows.begin(), run.rows.end(), [&](const StudyRow& other) {
                if (!other.ok() || other.scene != row.scene) return false;
                const double nearer = run.shownError(row) - run.shownError(other);
                const double faster = row.msMedian - other.msMedian;
                return nearer >= 0 && faster >= 0 && (nearer > 0 || faster > 0);
            });
    }
}

std::string studyJson(const StudyRun& run) {
    Json json;
    json["demo"] = run.demo;
    json["quantity"] = run.quantity;
    json["reference"] = run.reference;
    json["axis"] = run.axis == ErrorAxis::rms ? "rms" : "fraction";
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
        run.axis = in(json, "axis") == "rms" ? ErrorAxis::rms : ErrorAxis::fraction;
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

std::optional<StudyRun> committedStudy(const std::string& demo) {
    const auto found = committedTexts().find(demo);
    if (found == committedTexts().end()) return {};
    return readStudy(found->second);
}

}  // namespace mv
