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

// What GLSL calls the version, and what ES wants said once: the precision of numbers, and of what is looked up. A sampler2D
// is of low precision there where nobody says otherwise, most others of none at all, which is a mistake.
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
    return text;
}

// Takes the first line off `rest`, without its end.
std::string takeLine(std::string_view& rest) {
    const std::size_t end = rest.find('\n');
    std::string line(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    return line;
}

// The file that a line `#include "x.glsl"` names.
std::optional<std::string> includedFile(const std::string& line) {
    const auto start = line.find_first_not_of(" \t");
    if (start == std::string::npos || line.compare(start, 8, "#include") != 0) return {};
    const auto open = line.find('"', start), close = line.rfind('"');
    if (open == std::string::npos || close == open) return {};
    return line.substr(open + 1, close - open - 1);
}

// A line of a driver's log: where in the source, and what.
struct LogLine {
    unsigned file, line;
    std::string message;
};

// In `form` # is a number, taken in the order file and line, * one that is passed over, a space any spaces or none, and all else
// itself. What comes after is the message.
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

void append(ShaderSource& source, const std::string& shownName, std::string_view text, int depth) {
    if (depth > 8) throw Error(shownName, "must not include itself");
    constexpr std::size_t largestWhole = std::size_t{1} << 22U;
    if (source.text.size() + text.size() > largestWhole) {
        throw Error(shownName,
                    "must hold, with all that it is included with, at most " + std::to_string(largestWhole) + " bytes");
    }
    const auto number = std::to_string(source.files.size());
    source.files.push_back(shownName);
    source.text += "#line 1 " + number + "\n";
    for (int lineNumber = 1; !text.empty(); ++lineNumber) {
        const std::string line = takeLine(text);
        const std::optional<std::string> included = includedFile(line);
        if (!included) {
            source.text += line + "\n";
            continue;
        }
        const std::string name = "include/" + *included;
        const auto found = shaderFiles().find(name);
        if (found == shaderFiles().end()) {
            throw Error(shownName + ":" + std::to_string(lineNumber), "includes a file that is not in shaders/include",
                        "'" + *included + "'");
        }
        append(source, "shaders/" + name, currentText(found->second, source), depth + 1);
        source.text += "#line " + std::to_string(lineNumber + 1) + " " + number + "\n";
    }
}

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
    ShaderSource source;
    source.text = versionLines(least);
    append(source, "shaders/" + name, currentText(found->second, source), 0);
    // Mesa links a fragment shader without one, and draws black: an empty file, say.
    if (source.text.find("main") == std::string::npos) throw Error("shaders/" + name, "must define main()");
    return source;
}

ShaderSource assembleShaderText(const std::string& shownName, std::string_view text, int least) {
    ShaderSource source;
    source.text = versionLines(least);
    append(source, shownName, text, 0);
    return source;
}

std::string readableLog(std::string_view log, const ShaderSource& source) {
    std::string readable;
    while (!log.empty()) {
        std::string line = takeLine(log);
        while (!line.empty() && (line.back() == '\0' || line.back() == '\r')) line.pop_back();
        if (line.empty()) continue;
        if (const auto found = parseLogLine(line); found && found->file < source.files.size()) {
            line = source.files[found->file] + ":" + std::to_string(found->line) + ": " + found->message;
        }
        readable += (readable.empty() ? "" : "\n") + line;
    }
    return readable;
}

}  // namespace mv
