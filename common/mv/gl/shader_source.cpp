#include "mv/gl/shader_source.h"

#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <utility>

#include "mv/error.h"
#include "mv/gl/functions.h"

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

// What GLSL calls the version, and what ES wants said once: the precision of numbers in fragment shaders.
std::string versionLines() {
    if (isEs()) return "#version 300 es\nprecision highp float;\nprecision highp int;\n";
    return "#version " + std::to_string(allowedVersion()) + "0 core\n";
}

std::string currentText(const ShaderFile& file, ShaderSource& source) {
    if (!file.path.empty()) {
        std::ifstream stream(file.path, std::ios::binary);
        if (stream) {
            source.readFrom.push_back(file.path);
            return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
        }
    }
    return file.text;
}

void append(ShaderSource& source, const std::string& shownName, std::string_view text, int depth) {
    if (depth > 8) throw Error(shownName, "must not include itself");
    const auto number = std::to_string(source.files.size());
    source.files.push_back(shownName);
    source.text += "#line 1 " + number + "\n";
    static const std::regex includeLine(R"(^\s*#include\s+\"([^\"]+)\"\s*$)");
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int lineNumber = 1; std::getline(lines, line); ++lineNumber) {
        std::smatch match;
        // The search for '#' first: std::regex on every line would cost more than compiling the shader.
        if (line.find("#include") == std::string::npos || !std::regex_match(line, match, includeLine)) {
            source.text += line + "\n";
            continue;
        }
        const std::string name = "include/" + match[1].str();
        const auto found = shaderFiles().find(name);
        if (found == shaderFiles().end()) {
            throw Error(shownName + ":" + std::to_string(lineNumber), "includes a file that is not in shaders/include",
                        "'" + match[1].str() + "'");
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

ShaderSource assembleShader(const std::string& name) {
    const auto found = shaderFiles().find(name);
    if (found == shaderFiles().end()) {
        throw Error("shaders/" + name, "is not built into this program; add the file and configure again");
    }
    ShaderSource source;
    source.text = versionLines();
    append(source, "shaders/" + name, currentText(found->second, source), 0);
    return source;
}

ShaderSource assembleShaderText(const std::string& shownName, std::string_view text) {
    ShaderSource source;
    source.text = versionLines();
    append(source, shownName, text, 0);
    return source;
}

std::string readableLog(std::string_view log, const ShaderSource& source) {
    // Mesa: "0:7(3): error: ..."   NVIDIA: "0(7) : error ..."   others: "ERROR: 0:7: ..."
    static const std::regex mesa(R"(^(\d+):(\d+)\(\d+\): (.*)$)");
    static const std::regex nvidia(R"(^(\d+)\((\d+)\) : (.*)$)");
    static const std::regex reference(R"(^ERROR: (\d+):(\d+): (.*)$)");
    std::string readable;
    std::istringstream lines{std::string(log)};
    std::string line;
    while (std::getline(lines, line)) {
        while (!line.empty() && (line.back() == '\0' || line.back() == '\r')) line.pop_back();
        if (line.empty()) continue;
        std::smatch match;
        for (const std::regex* form : {&mesa, &nvidia, &reference}) {
            if (!std::regex_match(line, match, *form)) continue;
            const auto file = std::stoul(match[1]);
            if (file < source.files.size()) line = source.files[file] + ":" + match[2].str() + ": " + match[3].str();
            break;
        }
        readable += (readable.empty() ? "" : "\n") + line;
    }
    return readable;
}

}  // namespace mv
