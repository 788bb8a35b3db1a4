// Shaders that are being edited: what an editor beside the picture asks.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace mv {

// The uniforms that were set since the last call and that edited programs do not use, "eye, lamp of shading" for each program: an edit that shows
// one colour is a good program, and what it does not use is not set. (A program as it was built refuses to be set so.)
std::vector<std::string> takeUnusedUniforms();

// The files that the programs which exist now were read from.
std::vector<std::filesystem::path> filesOfPrograms();

// The compiler's message about a shader file by itself, whether a program uses it or not; "" where it compiles, and of
// a stage that this context lacks. `file` is a name as "lights/lights.frag". Error: there is no such file.
std::string mistakesOf(const std::string& file);

}  // namespace mv
