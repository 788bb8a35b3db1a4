// mvgl-bench: what the suite costs, as ratios of interleaved runs against the bare way of doing the same.
//     mvgl-bench [png] [math] [frame] [process] [rays] [shadows] [volumes] [--rounds N]
//     mvgl-bench accuracy [--write FOLDER]    the errors and times of mv/math: docs/library.*
//     mvgl-bench work-precision [--write FOLDER]    those of the integrators: docs/work-precision.*
//     mvgl-bench work-precision --references    what they are compared with: tests/work_precision/references.csv
// Exit status 0: every bound holds; 1: one is broken, or a run was too noisy to tell.
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "bench/benches.h"

int main(int count, char** arguments) {
    using namespace mv::bench;
    const std::vector<std::pair<std::string, std::function<std::vector<Row>(int)>>> benches{
        {"png", pngBench},   {"math", mathBench},       {"frame", frameBench},   {"process", processBench},
        {"rays", raysBench}, {"shadows", shadowsBench}, {"volumes", volumeBench}};
    const std::string first = count >= 2 ? arguments[1] : "";
    if (first == "accuracy" || first == "work-precision") {
        const std::string flag = count >= 3 ? arguments[2] : "";
        const bool isReferences = first == "work-precision" && count == 3 && flag == "--references";
        if (count != 2 && !isReferences && (count != 4 || flag != "--write")) {
            std::cerr << "error: " << first << ": takes --write FOLDER or nothing\n";
            return 2;
        }
        try {
            const std::string folder = count == 4 ? arguments[3] : "";
            if (isReferences) {
                workPrecisionReferences();
            } else if (first == "accuracy") {
                accuracyBench(folder);
            } else {
                workPrecisionBench(folder);
            }
            return 0;
        } catch (const std::exception& error) {
            std::cerr << "error: " << error.what() << "\n";
            return 1;
        }
    }
    std::vector<std::string> wanted;
    int rounds = 15;
    for (int i = 1; i < count; ++i) {
        const std::string word = arguments[i];
        if (word == "--rounds" && i + 1 < count) {
            rounds = std::atoi(arguments[++i]);
            continue;
        }
        bool known = false;
        for (const auto& bench : benches) known |= bench.first == word;
        if (!known) {
            std::cerr << "error: " << word
                      << ": must be accuracy, work-precision, png, math, frame, process, rays, shadows, volumes or "
                         "--rounds N\n";
            return 2;
        }
        wanted.push_back(word);
    }
    try {
        bool held = true;
        printHeading(std::cout);
        for (const auto& [name, bench] : benches) {
            if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) continue;
            std::cerr << "measuring " << name << " ...\n";
            for (const Row& row : bench(rounds)) {
                printRow(std::cout, row);
                held &= verdict(row) == Verdict::pass;
            }
        }
        return held ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << "\n";
        return 1;
    }
}
