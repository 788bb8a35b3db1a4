#include <fstream>

#include "verdict.h"

int main(int, char** arguments) {
    std::ofstream(arguments[2], std::ios::app) << arguments[1] << "\n";
    const auto found = verdicts().find(arguments[1]);
    return found == verdicts().end() || found->second == "yes" ? 0 : 1;
}
