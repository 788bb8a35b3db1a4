// What a program that is being edited no longer uses.
#pragma once
#include <string>
#include <vector>

namespace mv {

// The uniforms that were set since the last call and that edited programs do not use, "eye, lamp of shading" for each program: an edit that shows
// one colour is a good program, and what it does not use is not set. (A program as it was built refuses to be set so.)
std::vector<std::string> takeUnusedUniforms();

}  // namespace mv
