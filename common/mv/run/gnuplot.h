// Plots, drawn by the program gnuplot.
#pragma once
#include <string>

namespace mv {

// The text as a string of gnuplot's, in quotes in which nothing is replaced: no backquoted command, no backslash. A control
// character, such as the end of a line, becomes a space. What shows it must be told `noenhanced`, or _ and ^ mean indices.
std::string quotedForGnuplot(const std::string& text);

// The SVG that the script draws; it sets the terminal and no output. The user's own settings of gnuplot are not read.
// Error: gnuplot is missing (package gnuplot-nox), or finds a mistake in the script, or no temporary folder can be written.
std::string drawnByGnuplot(const std::string& script);

}  // namespace mv
