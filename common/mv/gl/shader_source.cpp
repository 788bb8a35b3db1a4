#include "mv/gl/shader_source.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "mv/error.h"
#include "mv/gl/functions.h"
#include "mv/image/file.h"

namespace mv {
namespace {

struct ShaderFile {
    std::string text;
    std::filesystem::path path;
};

// A function's static: embedded files add themselves before main.
std::map<std::string, ShaderFile>& shaderFiles() {
    static std::map<std::string, ShaderFile> files;
    return files;
}

// The version in GLSL's words, and what ES wants said once: the precision of numbers, and of what is looked up. A
// sampler2D is of low precision there where nobody says otherwise, most others of none at all, which is a mistake.
std::string versionLines(int least) {
    if (!isEs()) return "#version " + std::to_string(std::max(least, allowedVersion())) + "0 core\n";
    std::string lines = "#version 300 es\n";
    for (const char* type :
         {"float", "int", "sampler2D", "sampler3D", "samplerCube", "sampler2DArray", "sampler2DShadow",
          "samplerCubeShadow", "sampler2DArrayShadow", "isampler2D", "isampler3D", "isamplerCube", "isampler2DArray",
          "usampler2D", "usampler3D", "usamplerCube", "usampler2DArray"}) {
        lines += std::string("precision highp ") + type + ";\n";
    }
    return lines;
}

// The file as it is on disk where there is one, else as it was built in. One that is there and cannot be read is an Error:
// what was built in would be another program than the one that is being edited.
std::string currentText(const ShaderFile& file, ShaderSource& source) {
    if (file.path.empty()) return file.text;
    // Before the text: an edit in between is then found, and read again.
    const auto written = writtenAt(file.path);
    if (!written) {
        source.readFrom[file.path] = {};  // it may come back
        return file.text;
    }
    constexpr std::size_t largest = std::size_t{1} << 20U;
    std::string text = readTextFile(file.path, largest);
    source.readFrom[file.path] = written;
    source.edited = source.edited || text != file.text;
    return text;
}

// Takes the first line off `rest`, without its end: LF, CRLF, or CR alone, as GLSL has it.
std::string takeLine(std::string_view& rest) {
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    std::string line(rest.substr(0, end));
    rest.remove_prefix(std::min(rest.size(), end + (rest.substr(end, 2) == "\r\n" ? 2 : 1)));
    return line;
}

// The compiler's preprocessor after the lines so far, as far as it can be told without its macros.
class Reading {
  public:
    // The kind of a line, after the lines before it.
    struct Line {
        std::string directive;  // "#include", without what blanks there are after #; "" for a line of code
        std::string rest;       // what comes after it, without comments
    };

    Line take(std::string_view line) {
        const bool isContinued = std::exchange(continued_, line.ends_with('\\'));
        const std::string bare = withoutComments(line);
        if (isContinued) return {};  // part of what the line before began with
        Line told = directiveOf(bare);
        follow(told);
        return told;
    }

    // Whether the compiler certainly skips what comes now, or may do so.
    bool isSkipped() const {
        return std::any_of(branches_.begin(), branches_.end(), [](const Branch& b) { return b.now == Now::skipped; });
    }
    bool isConditional() const {
        return std::any_of(branches_.begin(), branches_.end(), [](const Branch& b) { return b.now != Now::taken; });
    }

  private:
    enum class Now { taken, skipped, unknown };  // unknown: its condition names macros
    struct Branch {
        Now now;
        bool wasTaken, mayHaveBeen;  // one of the same #if, so far
    };

    // A comment is a blank.
    std::string withoutComments(std::string_view line) {
        std::string bare;
        for (std::size_t i = 0; i < line.size() && !inLineComment_; ++i) {
            const std::string_view pair = line.substr(i, 2);
            if (inComment_) {
                if (pair != "*/") continue;
                inComment_ = false;
                ++i;
                bare += ' ';
            } else if (pair == "/*") {
                inComment_ = true;
                ++i;
            } else if (pair == "//") {
                inLineComment_ = true;
            } else {
                bare += line[i];
            }
        }
        inLineComment_ = inLineComment_ && continued_;
        return bare;
    }

    static Line directiveOf(std::string_view bare) {
        constexpr const char* blanks = " \t\f\v";
        const auto skip = [&] { bare.remove_prefix(std::min(bare.find_first_not_of(blanks), bare.size())); };
        skip();
        if (!bare.starts_with('#')) return {};
        bare.remove_prefix(1);
        skip();
        const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
        const auto end = std::find_if_not(bare.begin(), bare.end(), isLetter);
        Line told{"#" + std::string(bare.begin(), end), {}};
        bare.remove_prefix(static_cast<std::size_t>(end - bare.begin()));
        skip();
        bare.remove_suffix(bare.size() - std::min(bare.find_last_not_of(blanks) + 1, bare.size()));
        told.rest = bare;
        return told;
    }

    void follow(const Line& line) {
        const Now decided = line.rest == "0" ? Now::skipped : line.rest == "1" ? Now::taken : Now::unknown;
        if (line.directive == "#if" || line.directive == "#ifdef" || line.directive == "#ifndef") {
            const Now now = line.directive == "#if" ? decided : Now::unknown;
            branches_.push_back({now, now == Now::taken, now == Now::unknown});
        } else if (branches_.empty()) {
            return;
        } else if (line.directive == "#endif") {
            branches_.pop_back();
        } else if (line.directive == "#elif" || line.directive == "#else") {
            Branch& branch = branches_.back();
            branch.now = branch.wasTaken ? Now::skipped : line.directive == "#else" ? Now::taken : decided;
            if (branch.now == Now::taken && branch.mayHaveBeen) branch.now = Now::unknown;
            branch.wasTaken |= branch.now == Now::taken;
            branch.mayHaveBeen |= branch.now == Now::unknown;
        }
    }

    bool inComment_ = false, inLineComment_ = false, continued_ = false;
    std::vector<Branch> branches_;  // the innermost last
};

// The file that `"x.glsl"` names.
std::optional<std::string> quoted(const std::string& text) {
    const auto open = text.find('"'), close = text.rfind('"');
    if (open == std::string::npos || close == open) return {};
    return text.substr(open + 1, close - open - 1);
}

// A line of a driver's log: where in the source, and what.
struct LogLine {
    unsigned file, line;
    std::string message;
};

// In `form` # is a number, taken in the order file and line, * one that is passed over, a space any spaces or none, and all else
// itself. The rest of the line is the message.
std::optional<LogLine> logLineOf(std::string_view text, std::string_view form) {
    std::array<unsigned, 2> numbers{};
    std::size_t taken = 0;
    for (const char expected : form) {
        if (expected == ' ') {
            text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
        } else if (expected == '#' || expected == '*') {
            unsigned number = 0;
            const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
            if (read.ec != std::errc()) return {};
            text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
            if (expected == '#') numbers.at(taken++) = number;
        } else {
            if (!text.starts_with(expected)) return {};
            text.remove_prefix(1);
        }
    }
    return LogLine{numbers[0], numbers[1], std::string(text)};
}

std::optional<LogLine> parseLogLine(std::string_view text) {
    // Mesa: "0:7(3): error: ..."   NVIDIA: "0(7) : error ..."   others: "ERROR: 0:7: ..."
    for (const char* form : {"#:#(*): ", "#(#) : ", "ERROR: #:#: "}) {
        if (auto found = logLineOf(text, form)) return found;
    }
    return {};
}

// The origin of a line of the text; one past the end, at which a compiler misses what should come, is the last.
std::optional<ShaderSource::Place> placeOf(std::size_t line, const ShaderSource& source) {
    if (line < 1 || source.lines.empty()) return {};
    const ShaderSource::Place place = source.lines[std::min(line, source.lines.size()) - 1];
    if (place.line == 0) return {};
    return place;
}

// The lines of a file, and of what it includes, one by one.
class Assembly {
  public:
    explicit Assembly(int least) {
        const std::string version = versionLines(least);
        source_.text = version;
        source_.lines.assign(static_cast<std::size_t>(std::count(version.begin(), version.end(), '\n')), {0, 0});
    }

    ShaderSource take() { return std::move(source_); }

    void append(const std::string& shownName, const ShaderFile& file, int depth = 0) {
        append(shownName, currentText(file, source_), depth);
    }

    void append(const std::string& shownName, std::string_view text, int depth = 0) {
        const std::size_t number = source_.files.size();
        source_.files.push_back(shownName);
        if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // the byte order mark that some editors write
        for (unsigned lineNumber = 1; !text.empty(); ++lineNumber) {
            const std::string line = takeLine(text);
            const Reading::Line told = reading_.take(line);
            const ShaderSource::Place place{number, lineNumber};
            const auto included = told.directive == "#include" ? quoted(told.rest) : std::nullopt;
            if (included) {
                include(place, *included, depth);
            } else {
                addLine(told.directive == "#line" ? "" : line, place);
            }
        }
    }

  private:
    void addLine(const std::string& line, ShaderSource::Place place) {
        constexpr std::size_t most = std::size_t{4} << 20U;
        if (source_.text.size() + line.size() >= most)
            throw Error(source_.files.front(), "must have less than 4 MiB with all that it includes");
        source_.text += line + "\n";
        source_.lines.push_back(place);
    }

    void include(ShaderSource::Place place, const std::string& included, int depth) {
        addLine("", place);
        if (reading_.isSkipped()) return;
        const std::string name = "include/" + included;
        const auto found = shaderFiles().find(name);
        constexpr int deepest = 8;
        if (found != shaderFiles().end() && depth < deepest) {
            append("shaders/" + name, found->second, depth + 1);
            return;
        }
        // The compiler tells the mistake if it does not skip the line.
        const std::string rule =
            found != shaderFiles().end()
                ? "must not include itself"
                : "includes a file that is not in shaders/include, or came there after the program "
                  "was built (./run builds it anew)";
        const std::string& shownName = source_.files[place.file];
        if (reading_.isConditional()) {
            addLine("#error " + rule + ", '" + included + "'", place);
        } else {
            throw Error(shownName + ":" + std::to_string(place.line), rule, "'" + included + "'");
        }
    }

    ShaderSource source_;
    Reading reading_;
};

}  // namespace

bool addShaderFile(std::string name, std::string text, std::string path) {
    shaderFiles()[std::move(name)] = {std::move(text), std::move(path)};
    return true;
}

bool hasShaderFile(const std::string& name) { return shaderFiles().count(name) != 0; }

std::vector<std::string> shaderFileNames() {
    std::vector<std::string> names;
    for (const auto& [name, file] : shaderFiles()) names.push_back(name);
    return names;
}

std::string builtInShader(const std::string& name) {
    const auto found = shaderFiles().find(name);
    if (found == shaderFiles().end()) throw Error("shaders/" + name, "is not built into this program");
    return found->second.text;
}

ShaderSource assembleShader(const std::string& name, int least) {
    const auto found = shaderFiles().find(name);
    if (found == shaderFiles().end()) {
        throw Error("shaders/" + name, "is not built into this program; add the file and configure again");
    }
    Assembly assembly(least);
    assembly.append("shaders/" + name, found->second);
    ShaderSource source = assembly.take();
    // Mesa links a fragment shader without one, and draws black: an empty file, say.
    if (source.text.find("main") == std::string::npos) throw Error("shaders/" + name, "must define main()");
    return source;
}

ShaderSource assembleShaderText(const std::string& shownName, std::string_view text, int least) {
    Assembly assembly(least);
    assembly.append(shownName, text);
    return assembly.take();
}

std::string readableLog(std::string_view log, const ShaderSource& source) {
    std::string readable;
    while (!log.empty()) {
        std::string line = takeLine(log);
        while (!line.empty() && line.back() == '\0') line.pop_back();
        if (line.empty()) continue;
        if (const auto found = parseLogLine(line); found && found->file == 0) {
            if (const auto place = placeOf(found->line, source))
                line = source.files[place->file] + ":" + std::to_string(place->line) + ": " + found->message;
        }
        readable += (readable.empty() ? "" : "\n") + line;
    }
    return readable;
}

}  // namespace mv
