// Plots, drawn by the program gnuplot.
#pragma once
#include <string>

namespace mv {

// The SVG that the script draws; it sets the terminal and no output. Error: gnuplot is missing (package gnuplot-nox), or
// finds a mistake in the script, or no temporary folder can be written.
std::string drawnByGnuplot(const std::string& script);

}  // namespace mv
