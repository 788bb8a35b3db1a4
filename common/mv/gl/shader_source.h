// Shader files by name: embedded in the program at build time, read from the source tree in a developer build.
#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mv {

// Adds a file to the embedded ones. `path` is where the file itself is edited, so that an edit is seen without a build;
// empty where it is not (see shader_folder.h).
bool addShaderFile(std::string name, std::string text, std::string path);

// When the file was last written; nothing where there is no file.
std::optional<std::filesystem::file_time_type> writtenAt(const std::filesystem::path& path);

// A shader ready to compile: the version line put before it, its #include lines replaced by the files.
struct ShaderSource {
    // A line of a file, from 1; line 0 where we put it there.
    struct Place {
        std::size_t file;
        unsigned line;
    };
    std::string text;
    std::vector<std::string> files;  // shown names, the first that of the shader itself
    // The origin of each line of `text`. Drivers count these lines through: #line, which would tell them the file, too,
    // is forgotten by Mesa in what it says of more than one token.
    std::vector<Place> lines;
    // Files on disk that it was read from, and when each had been written: no time where there was none, and what is built
    // in stood for it.
    std::map<std::filesystem::path, std::optional<std::filesystem::file_time_type>> readFrom;
    bool edited = false;  // one of them is not as it was built in
};

// Whether there is a shader file of that name ("cube-cull.vert").
bool hasShaderFile(const std::string& name);
// The names of all of them, those of shaders/include as "include/light.glsl".
std::vector<std::string> shaderFileNames();
// The text of one as it was built in. Error: there is none of that name.
std::string builtInShader(const std::string& name);

// The shader file, for the current context's dialect: "#version 330 core" on OpenGL (or what the demo declares, and of both
// `least` where that is newer), "#version 300 es" on OpenGL ES, where all numbers and samplers are said to be of high
// precision.
// `#include "x.glsl"` stands for shaders/include/x.glsl, but in a comment, and between `#if 0` and its `#endif` or `#else`.
// A byte order mark is left out, and so is a #line, which would count otherwise than we do.
// Error: no such file, a file that includes itself (under another #if or #ifdef both are the compiler's to tell, where it
// comes there), one that is on disk and cannot be read, more than 4 MiB in all, or no main in it.
ShaderSource assembleShader(const std::string& name, int least = 33);
ShaderSource assembleShaderText(const std::string& shownName, std::string_view text, int least = 33);

// A driver's log with its line numbers turned into files and theirs: "shaders/cube-cull.frag:7: message", a line each.
std::string readableLog(std::string_view log, const ShaderSource& source);

}  // namespace mv
