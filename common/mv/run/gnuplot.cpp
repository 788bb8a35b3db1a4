#include "mv/run/gnuplot.h"

#include <cstdlib>
#include <string_view>

#include "mv/error.h"
#include "mv/image/file.h"

namespace mv {
namespace {

constexpr std::size_t largest = std::size_t{1} << 24U;

// One word of a shell, whatever is in it.
std::string shellQuoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

}  // namespace

std::string drawnByGnuplot(const std::string& script) {
    const ScratchFolder scratch("plot");
    writeFileAtomically(scratch.path() / "plot.gp", std::string_view("set output 'plot.svg'\n" + script));
    const std::string command = "cd " + shellQuoted(scratch.path().string()) + " && gnuplot plot.gp 2>errors >&2";
    const bool done = std::system(command.c_str()) == 0;
    std::string svg = done ? readTextFile(scratch.path() / "plot.svg", largest) : "";
    if (svg.find("</svg>") == std::string::npos) {
        throw Error("gnuplot", "must be there and draw the plot (package gnuplot-nox)",
                    readTextFile(scratch.path() / "errors", largest));
    }
    return svg;
}

}  // namespace mv
