// The shaders of a page, which are edited in it.
#pragma once
#include <string>

namespace mv {

// Writes the shader file anew ("cube-cull.frag"); reloadChangedPrograms() then compiles what reads it. Error: there is no such file.
void writeShader(const std::string& name, std::string text);

}  // namespace mv
