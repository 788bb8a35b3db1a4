// Whole programs: one 512x512 picture of cube-cull, from the start of the process to the written file, against
// bare-cube, which does the same without mvgl. The shader cache is warm after the first pair, which is dropped.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/benches.h"
#include "mv/error.h"

namespace mv::bench {
namespace {

// Runs a program to its end; returns its peak resident memory in KiB.
long runProgram(const std::vector<std::string>& command) {
    const pid_t child = fork();
    if (child < 0) throw Error(command.front(), "must be started");
    if (child == 0) {
        std::vector<char*> arguments;
        for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        execv(arguments[0], arguments.data());
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw Error(command.front(), "must draw its picture");
    return usage.ru_maxrss;
}

}  // namespace

std::vector<Row> processBench(int rounds) {
    const auto folder = std::filesystem::temp_directory_path() / ("mvgl-bench-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    const std::vector<std::string> ours{
        MVGL_BINARY_DIR "/bin/cube-cull", "--shot", folder / "ours.png", "--headless=osmesa", "--size", "512x512"};
    const std::vector<std::string> bare{MVGL_BINARY_DIR "/bin/bare-cube",
                                        MVGL_SOURCE_DIR "/shaders/cube-cull/cube-cull.vert",
                                        MVGL_SOURCE_DIR "/shaders/cube-cull/cube-cull.frag", folder / "bare.png"};
    std::vector<double> oursMemory, bareMemory;
    Row time{"process: cube-cull 512x512 / bare program", {}, 1.3};
    time.ratio =
        interleaved([&] { oursMemory.push_back(static_cast<double>(runProgram(ours))); },
                    [&] { bareMemory.push_back(static_cast<double>(runProgram(bare))); }, std::max(rounds, 21));
    Row memory{"process: peak memory", {}, 1.15};
    memory.ratio.median = median(oursMemory) / median(bareMemory);
    std::filesystem::remove_all(folder);
    return {time, memory};
}

}  // namespace mv::bench
