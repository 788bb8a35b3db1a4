#include "mv/gl/shader_folder.h"

#include <dlfcn.h>

#include <fstream>
#include <map>

#include "mv/gl/shader_source.h"

namespace mv {
namespace {

std::filesystem::path programFolder() {
    std::error_code failed;
    return std::filesystem::read_symlink("/proc/self/exe", failed).parent_path();
}

std::filesystem::path findFolder(const std::string& group) {
    for (const auto& beside : {libraryFolder(), programFolder()}) {
        const auto folder = beside / "mvgl-shaders";
        std::error_code missing;
        // (For what is no file, a pipe say, one would wait.)
        if (!std::filesystem::is_regular_file(folder / group, missing)) continue;
        std::ifstream file(folder / group);
        std::string line;
        if (std::getline(file, line) && !line.empty()) return (folder / line).lexically_normal();
    }
    return {};
}

}  // namespace

std::filesystem::path libraryFolder() {
    Dl_info info{};
    if (!dladdr(reinterpret_cast<const void*>(&libraryFolder), &info) || !info.dli_fname) return {};
    return std::filesystem::path(info.dli_fname).parent_path();
}

std::filesystem::path shaderFolder(const std::string& group) {
    static std::map<std::string, std::filesystem::path> known;
    const auto found = known.find(group);
    return found != known.end() ? found->second : known[group] = findFolder(group);
}

std::optional<std::filesystem::file_time_type> writtenAt(const std::filesystem::path& path) {
    std::error_code missing;
    const auto written = std::filesystem::last_write_time(path, missing);
    if (missing) return {};
    return written;
}

bool addBuiltShader(const char* group, const char* name, const char* text) {
    const std::filesystem::path folder = shaderFolder(group);
    const std::string path = folder.empty() ? "" : (folder / name).string();
    return addShaderFile(name, text, path);
}

}  // namespace mv
