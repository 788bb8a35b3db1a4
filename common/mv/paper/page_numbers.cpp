#include "mv/paper/page_numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "mv/paper/tables.h"
#include "mv/run/command_line.h"
#include "mv/study/study.h"

namespace mv {
namespace {

constexpr std::string_view opening = "<!--=", closing = "<!--/-->", commentEnd = "-->";

std::string trimmed(const std::string& text) {
    const auto from = text.find_first_not_of(' ');
    if (from == std::string::npos) return "";
    return text.substr(from, text.find_last_not_of(' ') + 1 - from);
}

std::vector<std::string> parts(const std::string& text, const std::string& separator) {
    std::vector<std::string> result;
    std::size_t from = 0;
    for (std::size_t at = text.find(separator); at != std::string::npos; at = text.find(separator, from)) {
        result.push_back(trimmed(text.substr(from, at - from)));
        from = at + separator.size();
    }
    result.push_back(trimmed(text.substr(from)));
    return result;
}

// ---- A number as text

struct ToldNumber {
    double value = 0;
    double halfUnit = 0;  // half of what the last digit counts
    int digits = 0;       // significant ones
    bool isScientific = false, isGrouped = false;
};

bool isDigit(char c) { return c >= '0' && c <= '9'; }

// "0.014", "-0.92", "4e-7", "296 533". Nothing where the text is anything else.
std::optional<ToldNumber> toldNumberIn(const std::string& text) {
    ToldNumber told;
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool groups = text[i] == ' ' && i > 0 && isDigit(text[i - 1]) && i + 3 < text.size() &&
                            std::all_of(text.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                        text.begin() + static_cast<std::ptrdiff_t>(i) + 4, isDigit);
        if (groups) {
            told.isGrouped = true;
        } else {
            plain += text[i];
        }
    }
    const auto read = std::from_chars(plain.data(), plain.data() + plain.size(), told.value);
    if (read.ec != std::errc() || read.ptr != plain.data() + plain.size() || !std::isfinite(told.value)) return {};
    const auto e = plain.find('e');
    told.isScientific = e != std::string::npos;
    const std::string mantissa = plain.substr(0, e);
    const auto point = mantissa.find('.');
    const int decimals = point == std::string::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
    bool leading = true;
    for (const char c : mantissa) {
        if (!isDigit(c) || (leading && c == '0')) continue;
        leading = false;
        ++told.digits;
    }
    const int exponent = told.isScientific ? std::atoi(plain.c_str() + e + 1) : 0;
    // "0" alone says that it is exactly 0.
    told.halfUnit = told.value == 0 && decimals == 0 ? 0 : 0.5 * std::pow(10.0, exponent - decimals);
    return told;
}

// The number of digits before the point.
std::string inGroups(const std::string& digits) {
    const std::size_t whole = std::min(digits.find('.'), digits.size());
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && i < whole && (whole - i) % 3 == 0 && isDigit(digits[i - 1])) text += ' ';
        text += digits[i];
    }
    return text;
}

// ---- Where a marker may stand

// Markdown takes a comment that begins a paragraph, an item or a quotation for a block, and shows what follows as it is.
bool beginsBlock(const std::string& before) {
    return before.find_first_not_of(" \t>-*+.0123456789") == std::string::npos;
}

}  // namespace

std::vector<PageNumber> pageNumbers(const std::string& page, const std::string& file) {
    std::vector<PageNumber> numbers;
    bool inCode = false;
    int lineNumber = 0;
    for (std::size_t begin = 0; begin < page.size();) {
        const std::size_t end = std::min(page.find('\n', begin), page.size());
        const std::string line = page.substr(begin, end - begin);
        ++lineNumber;
        const auto refuse = [&](const std::string& rule, const std::string& value) {
            throw Error(file + ":" + std::to_string(lineNumber), rule, "'" + value + "'");
        };
        if (line.starts_with("```")) inCode = !inCode;
        std::size_t from = 0;
        while (true) {
            const std::size_t at = line.find(opening, from), stray = line.find(closing, from);
            if (stray < at) refuse("must open a marker with <!--= before it closes it", line.substr(stray));
            if (at == std::string::npos) break;
            const std::string rest = line.substr(at);
            if (inCode || line.starts_with("    ") ||
                std::count(line.begin(), line.begin() + std::ptrdiff_t(at), '`') % 2) {
                refuse("must not have a marker in code, where a reader would see it", rest);
            }
            if (beginsBlock(line.substr(0, at))) {
                refuse("must have a word before a marker: Markdown takes one that begins a line for a block", rest);
            }
            const std::size_t sourceAt = at + opening.size(), sourceEnd = line.find(commentEnd, sourceAt);
            if (sourceEnd == std::string::npos) refuse("must end a marker's comment with --> on its line", rest);
            const std::size_t textAt = sourceEnd + commentEnd.size(), textEnd = line.find(closing, textAt);
            if (textEnd == std::string::npos) refuse("must close a marker with <!--/--> on its line", rest);
            PageNumber number{lineNumber, trimmed(line.substr(sourceAt, sourceEnd - sourceAt)),
                              line.substr(textAt, textEnd - textAt), begin + textAt};
            if (number.source.find("--") != std::string::npos) {
                refuse("must name flags without their dashes: a comment must not hold two of them", number.source);
            }
            if (!toldNumberIn(number.text)) refuse("must have one number between a marker's comments", number.text);
            numbers.push_back(std::move(number));
            from = textEnd + closing.size();
        }
        begin = end + 1;
    }
    return numbers;
}

bool tells(const std::string& text, const MadeNumber& made) {
    const auto told = toldNumberIn(text);
    // Half a unit is itself rounded in binary: 0.0015 is not quite half of 0.003.
    return told && std::abs(told->value - made.value) <= told->halfUnit * (1 + 1e-9) + made.tolerance;
}

std::string toldLike(const std::string& text, const MadeNumber& made) {
    const ToldNumber old = toldNumberIn(text).value_or(ToldNumber{});
    if (made.isCount) {
        const std::string digits = formatted("%.0f", made.value);
        return old.isGrouped || digits.size() > 5 ? inGroups(digits) : digits;
    }
    if (made.value == 0) return "0";
    const int digits = std::max(old.digits, 2);
    char scientific[64];
    std::snprintf(scientific, sizeof scientific, "%.*e", digits - 1, made.value);
    const std::string mantissa(scientific, std::string_view(scientific).find('e'));
    const int exponent = std::atoi(scientific + mantissa.size() + 1);  // after rounding: 9.96 is 1.0e1
    if (old.isScientific || exponent < -6 || exponent > 6) return mantissa + "e" + std::to_string(exponent);
    char plain[64];
    std::snprintf(plain, sizeof plain, "%.*f", std::max(digits - 1 - exponent, 0), made.value);
    return old.isGrouped ? inGroups(plain) : plain;
}

// ---- Sources

namespace {

// A readout is computed in double, or summed over pixels, of which another driver rounds one in hundreds differently: 0.2 %
// of it may differ. On the same driver nothing does.
MadeNumber measured(double value) { return {value, 0.002 * std::abs(value), false}; }
// A number of a committed file, which is the same everywhere.
MadeNumber committedNumber(double value) { return {value, 0, false}; }
MadeNumber counted(double value) { return {value, 0, true}; }

std::string list(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) {
        if (text.find("'" + name + "'") != std::string::npos) continue;
        text.append(text.empty() ? "'" : ", '").append(name).append("'");
    }
    return text.empty() ? "none" : text;
}

[[noreturn]] void refuseName(const std::string& what, const std::vector<std::string>& known, const std::string& name) {
    throw Error(what, "must be one of " + list(known), "'" + name + "'");
}

// A line that is named without p is its first row that was measured: enough for a slope, which is of all of them.
const StudyRow& rowOf(const StudyRun& run, const std::string& scene, const std::string& method,
                      const std::string& parameter, bool isOfLine) {
    std::vector<std::string> scenes, methods, parameters;
    for (const StudyRow& row : run.rows) {
        scenes.push_back(row.scene);
        if (row.scene != scene) continue;
        methods.push_back(row.method);
        if (row.method != method) continue;
        parameters.push_back(row.parameter);
        if (isOfLine ? !row.ok() : row.parameter != parameter) continue;
        if (!row.ok()) throw Error("row", "must have been measured", row.status);
        return row;
    }
    if (methods.empty()) refuseName("scene", scenes, scene);
    if (parameters.empty()) refuseName("method", methods, method);
    refuseName("p", parameters, parameter);
}

bool isSlope(const std::string& column, const std::string& parameter) {
    return parameter.empty() && (column == "slope" || column == "time slope");
}

MadeNumber columnOf(const StudyRun& run, const StudyRow& row, const std::string& column) {
    if (column == "rms") return committedNumber(row.all.rms);
    if (column == "max") return committedNumber(row.all.max);
    if (column == "wrong %") return committedNumber(100 * row.all.fraction);
    if (column == "away from edges %") return committedNumber(100 * row.awayFromEdges.fraction);
    if (column == "wrong pixels") return counted(std::round(row.all.fraction * double(row.all.n)));
    if (column == "n") return counted(double(row.all.n));
    if (column == "unmatched") return counted(double(row.unmatched));
    if (column == "ms") return committedNumber(row.msMedian);
    if (column == "MAD") return committedNumber(row.msMad);
    for (const auto& [name, amount] : row.counts) {
        if (name == column) return counted(amount);
    }
    if (column == "slope" || column == "time slope") {
        const auto slope = (column == "slope" ? errorSlope : timeSlope)(run, row.scene, row.method);
        if (!slope) throw Error("slope", "needs three rows with a number each");
        return committedNumber(*slope);
    }
    std::vector<std::string> names{"rms", "max", "wrong %", "away from edges %", "wrong pixels", "n", "unmatched",
                                   "ms",  "MAD", "slope",   "time slope"};
    for (const auto& [name, amount] : row.counts) names.push_back(name);
    refuseName("column", names, column);
}

// "run viewpoints view=5 frame=100" as arguments.
std::vector<std::string> argumentsOf(const std::string& command) {
    std::vector<std::string> words = parts(command, " "), arguments;
    std::erase(words, "");
    for (std::size_t i = 1; i < words.size(); ++i) {
        if (i == 1) {
            arguments.push_back(words[i]);
            continue;
        }
        const auto equals = words[i].find('=');
        arguments.push_back("--" + words[i].substr(0, equals));
        if (equals != std::string::npos) arguments.push_back(words[i].substr(equals + 1));
    }
    arguments.emplace_back("--report");
    return arguments;
}

using Quantities = std::map<std::string, MadeNumber>;

// As a report has them: the readouts of the first draw, and the counts of the same frame once more, when what was made once
// is kept.
Quantities quantitiesOf(Stage& stage, int frame) {
    Quantities result;
    stage.draw(frame, true);
    for (const Readout* readout : stage.demo().readouts()) {
        if (readout->value()) result[readout->name()] = measured(*readout->value());
    }
    stage.draw(frame);
    const Counters& counters = stage.frameCounters();
    result["draws"] = counted(double(counters.draws));
    result["triangles"] = counted(double(counters.triangles));
    result["vertices"] = counted(double(counters.vertices));
    result["passes"] = counted(double(counters.passes));
    for (const auto& [name, amount] : stage.notes().counts) result[name] = counted(amount);
    return result;
}

}  // namespace

NumberSources::NumberSources(std::function<std::vector<StudyRun>(const std::string&)> studies,
                             std::function<Stage&()> stage)
    : readStudies_(std::move(studies)), stage_(std::move(stage)) {}

const StudyRun& NumberSources::committed(const std::string& demo, Drawer drawer) {
    auto found = studies_.find(demo);
    if (found == studies_.end()) found = studies_.emplace(demo, readStudies_(demo)).first;
    for (const StudyRun& run : found->second) {
        if (drawerOf(run.renderer) == drawer) return run;
    }
    throw Error("study", std::string("must be one of those committed in docs/errors-and-times, of a ") + nameOf(drawer),
                demo);
}

MadeNumber NumberSources::ofRun(const std::vector<std::string>& fields) {
    const std::string& text = fields.front();
    if (fields.size() != 2) throw Error("source", "must be run DEMO ...; READOUT");
    if (!drawn_.contains(text)) {
        const Command command = parseCommandLine(argumentsOf(text));
        if (!command.demo) throw Error("source", "must name a demo after 'run'");
        Stage& stage = stage_();
        stage.open(*command.demo, command.width ? command.width : command.demo->width,
                   command.height ? command.height : command.demo->height);
        stage.begin(command.knobs, command.changes);
        drawn_[text] = quantitiesOf(stage, command.firstFrame);
        stage.close();
    }
    const Quantities& quantities = drawn_.at(text);
    const auto found = quantities.find(fields[1]);
    if (found != quantities.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [name, made] : quantities) names.push_back(name);
    refuseName("readout", names, fields[1]);
}

MadeNumber NumberSources::make(const std::string& source) {
    const std::vector<std::string> fields = parts(source, ";");
    if (fields.front().starts_with("run ")) return ofRun(fields);
    if (!fields.front().starts_with("study ")) {
        throw Error("source", "must begin with 'study' or 'run'", "'" + fields.front() + "'");
    }
    if (fields.size() != 5) throw Error("source", "must be study DEMO; SCENE; METHOD; P; COLUMN");
    const std::vector<std::string> whose = parts(fields.front(), " ");
    if (whose.size() > 3 || (whose.size() == 3 && whose[2] != "gpu")) {
        throw Error("source", "must be study DEMO, or study DEMO gpu", "'" + fields.front() + "'");
    }
    const StudyRun& run = committed(whose[1], whose.size() == 3 ? Drawer::gpu : Drawer::processor);
    return columnOf(run, rowOf(run, fields[1], fields[2], fields[3], isSlope(fields[4], fields[3])), fields[4]);
}

std::string withNumbers(const std::string& page, const std::string& file, NumberSources& sources) {
    std::string text;
    std::size_t done = 0;
    for (const PageNumber& number : pageNumbers(page, file)) {
        MadeNumber made;
        try {
            made = sources.make(number.source);
        } catch (const Error& error) {
            throw Error(file + ":" + std::to_string(number.line) + ", '" + number.source + "'", error.what());
        }
        if (tells(number.text, made)) continue;
        text += page.substr(done, number.from - done) + toldLike(number.text, made);
        done = number.from + number.text.size();
    }
    return text + page.substr(done);
}

}  // namespace mv
