// Which flags go together: what each action of the command line reads.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "mv/run/command_line.h"

namespace mv {

// The parts of a command line: its flags, each once and without values; the knobs' flags are among `knobs`.
struct GivenFlags {
    std::vector<std::string> flags, knobs;
    bool demo = false;  // named first, in a program of several
    bool has(std::string_view flag) const;
};

// The request of the flags. With --shot, --report or --headless that is a picture without a window, without any such
// flag a window. Error: UsageError where a flag is given that does nothing beside the one that says what to do: it
// names both, and what the flag goes with.
Action actionOf(const GivenFlags& given);

}  // namespace mv
