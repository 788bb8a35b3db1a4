// Shader files in a page: they are in its memory, and edited there.
#include "shaders.h"

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "mv/error.h"
#include "mv/gl/shader_folder.h"
#include "mv/gl/shader_source.h"
#include "mv/image/file.h"
#include "pictures.h"

namespace mv {
namespace {

struct File {
    std::string text;
    std::filesystem::file_time_type written;
};

std::map<std::string, File>& files() {
    static std::map<std::string, File> all;
    return all;
}

}  // namespace

void writeShader(const std::string& name, std::string text) {
    const auto found = files().find(name);
    if (found == files().end()) throw Error("shaders/" + name, "is no shader of this page");
    found->second = {std::move(text), found->second.written + std::chrono::seconds(1)};
}

// What the library asks of files.

bool addBuiltShader(const char*, const char* name, const char* text) {
    files()[name] = {text, {}};
    return addShaderFile(name, text, name);
}

std::optional<std::filesystem::file_time_type> writtenAt(const std::filesystem::path& path) {
    const auto found = files().find(path.string());
    if (found == files().end()) return {};
    return found->second.written;
}

std::string readTextFile(const std::filesystem::path& path, std::size_t largest) {
    const auto shader = files().find(path.string());
    const std::string& text = shader == files().end() ? givenText(path) : shader->second.text;
    if (text.size() > largest) throw Error(path.string(), "must have " + std::to_string(largest) + " bytes at most");
    return text;
}

}  // namespace mv
