// The folder in which a built program finds the shader files that are being edited; an installed one has those that
// were built in.
#pragma once
#include <filesystem>
#include <string>

namespace mv {

// The folder of the library that this function is in, as the program found it; empty where nobody knows.
std::filesystem::path libraryFolder();

// The folder in which the shaders of a group (a target of mvgl_add_demo, demo-NAME) are edited: the one line of the file
// mvgl-shaders/GROUP beside this library, or beside the program, relative to the folder that file is in. Empty where there
// is none: the build writes it, and nothing installs it, so that no program has a path of the machine that built it.
std::filesystem::path shaderFolder(const std::string& group);

// addShaderFile for a file of that group. Returns true. The source that the build makes of the shader files calls this,
// and declares it by itself (cmake/EmbedShaders.cmake).
bool addBuiltShader(const char* group, const char* name, const char* text);

}  // namespace mv
