#include "mv/study/data.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>

#include "mv/demo/read_number.h"
#include "mv/error.h"
#include "mv/paper/tables.h"

namespace mv {
namespace {

// Words in the order of ErrorAxis.
constexpr std::array<const char*, 3> axisNames{"rms", "fraction", "max"};

// Six digits say all that a measurement can.
double rounded(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6);
    double result = 0;
    std::from_chars(text, end.ptr, result);
    return result;
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

// ---- Fields of a CSV file

// A control character would end a line of the head; as a field in quotes it would do no harm, and is of no use.
std::string plain(const std::string& text) {
    std::string line = text;
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    }
    return line;
}

std::string csvField(const std::string& text) {
    if (text.find_first_of(",\"#") == std::string::npos) return plain(text);
    std::string quoted = "\"";
    for (const char c : plain(text)) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + "\"";
}

std::string csvLine(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields) line += (&field == fields.data() ? "" : ",") + csvField(field);
    return line + "\n";
}

// The fields of one line; a quoted field holds commas, and two quotes for one.
std::vector<std::string> fieldsOf(const std::string& line) {
    std::vector<std::string> fields{""};
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
            fields.back() += line[++i];
        } else if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    return fields;
}

// The columns that every file has, in this order, before those of the knobs and the counts.
const std::vector<std::string> fixedColumns{"scene",  "method",    "knob", "parameter", "status",   "rms",
                                            "max",    "fraction",  "n",    "rms away",  "max away", "fraction away",
                                            "n away", "unmatched", "ms",   "MAD",       "rounds",   "best"};

// Adds what is not yet there.
void addName(std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

[[noreturn]] void refuse(const std::string& problem) {
    throw Error("study", "must be the text of a study's CSV file of this version", problem);
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
    for (const StudyRow& row : run.rows) {
        if (row.scene == scene && row.method == method && !row.knob.empty()) return row.knob;
    }
    return "";
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
    // Rounded to the digits that a file has, so that a file that is read is judged alike: two splines may differ in the
    // tenth. From the most exact on, of equally exact ones the fastest first: whatever may beat a row is judged before
    // it.
    std::vector<StudyRow*> order;
    for (StudyRow& row : run.rows) {
        row.best = false;
        if (row.ok() && row.rounds > 0 && row.all.fraction <= mostWrong) order.push_back(&row);
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
    return "at most half of it is wrong, and no other best row" +
           (run.problem.empty() ? "" : " of the same " + run.problem) + " is as near without being measurably slower";
}

std::string studyCsv(const StudyRun& run) {
    std::string text;
    const auto fact = [&](const char* name, const std::string& value) {
        if (!value.empty()) text += "# " + std::string(name) + ": " + plain(value) + "\n";
    };
    fact("demo", run.demo);
    fact("compared", run.quantity);
    fact("reference", run.reference);
    fact("error", axisNames.at(static_cast<std::size_t>(run.axis)));
    fact("problem", run.problem);
    fact("wrong beyond", numberText(run.wrongBeyond));
    fact("size", std::to_string(run.width) + "x" + std::to_string(run.height));
    fact("frame", std::to_string(run.frame));
    fact("host", run.host);
    fact("renderer", run.renderer);
    fact("processor", run.processor);
    fact("threads", std::to_string(run.threads));
    fact("note", run.note);
    for (const auto& [scene, error] : run.referenceErrors) {
        fact("reference's own error", numberText(rounded(error)) + (scene.empty() ? "" : " in " + scene));
    }
    std::vector<std::string> knobs, counts;
    for (const StudyRow& row : run.rows) {
        for (const KnobSetting& setting : row.settings) addName(knobs, "--" + setting.name);
        for (const auto& [name, amount] : row.counts) addName(counts, plain(name));
    }
    std::vector<std::string> columns = fixedColumns;
    columns.insert(columns.end(), knobs.begin(), knobs.end());
    columns.insert(columns.end(), counts.begin(), counts.end());
    text += csvLine(columns);
    for (const StudyRow& row : run.rows) {
        std::vector<std::string> fields{row.scene, row.method, row.knob, row.parameter, row.status};
        for (const StudyError* error : {&row.all, &row.awayFromEdges}) {
            for (const double value : {error->rms, error->max, error->fraction}) {
                fields.push_back(row.ok() ? numberText(rounded(value)) : "");
            }
            fields.push_back(std::to_string(error->n));
        }
        fields.push_back(std::to_string(row.unmatched));
        for (const double value : {row.msMedian, row.msMad}) {
            fields.push_back(row.rounds > 0 ? numberText(rounded(value)) : "");
        }
        fields.push_back(std::to_string(row.rounds));
        fields.emplace_back(row.best ? "best" : "");
        const std::size_t first = fields.size();
        fields.resize(columns.size());
        const auto put = [&](const std::string& column, const std::string& value) {
            const auto at = std::find(columns.begin() + std::ptrdiff_t(first), columns.end(), column);
            fields[static_cast<std::size_t>(at - columns.begin())] = value;
        };
        for (const KnobSetting& setting : row.settings) put("--" + setting.name, setting.text);
        for (const auto& [name, amount] : row.counts) put(plain(name), numberText(amount));
        text += csvLine(fields);
    }
    return text;
}

namespace {

double numberOf(const std::string& text, const std::string& place) {
    const auto number = numberIn(text);
    if (!number) refuse(place + " is no number: '" + text + "'");
    if (*number < 0) throw Error("study", "must have no times and errors below 0; see " + place, text);
    return *number;
}

// A line of the head.
void readFact(StudyRun& run, const std::string& name, const std::string& value) {
    const auto number = [&] { return numberOf(value, "'" + name + "'"); };
    if (name == "demo") run.demo = value;
    if (name == "compared") run.quantity = value;
    if (name == "reference") run.reference = value;
    if (name == "problem") run.problem = value;
    if (name == "host") run.host = value;
    if (name == "renderer") run.renderer = value;
    if (name == "processor") run.processor = value;
    if (name == "note") run.note = value;
    if (name == "wrong beyond") run.wrongBeyond = number();
    if (name == "frame") run.frame = static_cast<int>(number());
    if (name == "threads") run.threads = static_cast<int>(number());
    if (name == "size") {
        const std::size_t x = value.find('x');
        if (x == std::string::npos) refuse("'size' is no size: '" + value + "'");
        run.width = static_cast<int>(numberOf(value.substr(0, x), "'size'"));
        run.height = static_cast<int>(numberOf(value.substr(x + 1), "'size'"));
    }
    if (name == "error") {
        const auto axis = std::find(axisNames.begin(), axisNames.end(), value);
        if (axis == axisNames.end()) throw Error("axis", "must be rms, fraction or max", value);
        run.axis = static_cast<ErrorAxis>(axis - axisNames.begin());
    }
    if (name == "reference's own error") {
        const std::size_t in = value.find(" in ");
        run.referenceErrors.emplace_back(in == std::string::npos ? "" : value.substr(in + 4),
                                         numberOf(value.substr(0, in), "'" + name + "'"));
    }
}

StudyRow rowFrom(const std::vector<std::string>& columns, const std::vector<std::string>& fields) {
    StudyRow row;
    std::size_t next = 0;
    const auto word = [&] { return fields[next++]; };
    const auto number = [&]() -> double {
        const std::size_t at = next++;
        return fields[at].empty() ? 0 : numberOf(fields[at], "'" + columns[at] + "'");
    };
    row.scene = word();
    row.method = word();
    row.knob = word();
    row.parameter = word();
    row.status = word();
    for (StudyError* error : {&row.all, &row.awayFromEdges}) {
        error->rms = number();
        error->max = number();
        error->fraction = number();
        error->n = static_cast<long>(number());
    }
    row.unmatched = static_cast<long>(number());
    row.msMedian = number();
    row.msMad = number();
    row.rounds = static_cast<int>(number());
    for (++next; next < columns.size(); ++next) {  // past what is best: that is judged anew
        if (fields[next].empty()) continue;
        if (columns[next].starts_with("--")) {
            row.settings.push_back({columns[next].substr(2), fields[next]});
        } else {
            row.counts.emplace_back(columns[next], numberOf(fields[next], "'" + columns[next] + "'"));
        }
    }
    return row;
}

}  // namespace

StudyRun readStudy(const std::string& text) {
    StudyRun run;
    run.axis = ErrorAxis::rms;
    std::vector<std::string> columns;
    int lineNumber = 0;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        std::string line = text.substr(from, end - from);
        from = end + 1;
        ++lineNumber;
        if (line.ends_with('\r')) line.pop_back();
        if (line.empty()) continue;
        if (columns.empty() && line.starts_with("# ")) {
            const std::size_t colon = line.find(": ");
            if (colon != std::string::npos) readFact(run, line.substr(2, colon - 2), line.substr(colon + 2));
            continue;
        }
        const std::vector<std::string> fields = fieldsOf(line);
        if (columns.empty()) {
            for (std::size_t i = 0; i < fixedColumns.size(); ++i) {
                if (i >= fields.size() || fields[i] != fixedColumns[i]) {
                    refuse("column '" + fixedColumns[i] + "' is not there");
                }
            }
            columns = fields;
            continue;
        }
        if (fields.size() != columns.size()) {
            refuse("line " + std::to_string(lineNumber) + " has " + std::to_string(fields.size()) + " fields of " +
                   std::to_string(columns.size()));
        }
        run.rows.push_back(rowFrom(columns, fields));
    }
    if (columns.empty()) refuse("it has no table");
    if (run.demo.empty()) refuse("'# demo:' is missing");
    if (run.renderer.empty()) refuse("'# renderer:' is missing");
    markBest(run);
    return run;
}

// ---- Machines

Drawer drawerOf(const std::string& renderer) {
    for (const char* software : {"llvmpipe", "softpipe", "lavapipe", "SwiftShader", "swrast", "Software Rasterizer"}) {
        if (renderer.find(software) != std::string::npos) return Drawer::processor;
    }
    return Drawer::gpu;
}

const char* nameOf(Drawer drawer) { return drawer == Drawer::gpu ? "gpu" : "processor"; }

std::string machineName(const StudyRun& run) {
    if (run.width == 0) {
        return run.processor + ", " + std::to_string(run.threads) + (run.threads == 1 ? " thread" : " threads");
    }
    const std::string name = run.renderer.substr(0, run.renderer.find_first_of("(/"));
    const std::string whose = drawerOf(run.renderer) == Drawer::gpu ? "this GPU (" : "a processor (";
    return whose + name.substr(0, name.find_last_not_of(' ') + 1) + ")";
}

namespace {
// The committed files, by demo. Never destroyed: the files of the demos fill it before main, in any order.
std::map<std::string, std::vector<std::string>>& committedTexts() {
    static auto& texts = *new std::map<std::string, std::vector<std::string>>;
    return texts;
}
}  // namespace

bool addStudyFile(const std::string& demo, std::string text) {
    committedTexts()[demo].push_back(std::move(text));
    return true;
}
bool addStudyFile(const char* demo, const char* text) { return addStudyFile(std::string(demo), std::string(text)); }

std::vector<StudyRun> committedStudies(const std::string& demo) {
    std::vector<StudyRun> runs;
    const auto found = committedTexts().find(demo);
    if (found == committedTexts().end()) return runs;
    for (const std::string& text : found->second) runs.push_back(readStudy(text));
    std::ranges::stable_sort(runs, {}, [](const StudyRun& run) { return drawerOf(run.renderer); });
    return runs;
}

std::optional<StudyRun> committedStudy(const std::string& demo, Drawer drawer) {
    std::optional<StudyRun> chosen;
    for (StudyRun& run : committedStudies(demo)) {
        if (!chosen || drawerOf(run.renderer) == drawer) chosen = std::move(run);
    }
    return chosen;
}

}  // namespace mv
