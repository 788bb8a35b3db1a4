// The times of mv/math's functions beside GLM's, and the pages that show them with the errors.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string_view>

#include "accuracy/page.h"
#include "bench/benches.h"
#include "mv/error.h"
#include "mv/image/file.h"

namespace mv::bench {
namespace {

namespace fs = std::filesystem;
using accuracy::Form;
using accuracy::Function;

// Runs of about a millisecond, as in math_bench.cpp; few enough arguments to stay in the cache.
constexpr int rounds = 31;
constexpr std::size_t sets = 64;

double nanosecondsPerCall(const Form& form, const std::vector<accuracy::Arguments>& arguments, int calls) {
    const auto start = std::chrono::steady_clock::now();
    form.run(arguments, calls);
    const std::chrono::duration<double, std::nano> passed = std::chrono::steady_clock::now() - start;
    return passed.count() / calls;
}

// The forms of a function in turn, round after round, the first dropped, the order turning about.
void timeFunction(const Function& function, accuracy::TimeTable& table) {
    test::Random random(1);
    std::vector<accuracy::Arguments> arguments;
    for (std::size_t i = 0; i < sets; ++i) {
        arguments.push_back(function.sample(random, accuracy::Domain::ordinary));
    }
    std::vector<int> calls;
    for (const Form& form : function.forms) {
        const double once = nanosecondsPerCall(form, arguments, 10000);
        calls.push_back(static_cast<int>(std::max(1000.0, 1e6 / std::max(once, 0.1))));
    }
    std::vector<std::vector<double>> times(function.forms.size());
    for (int round = 0; round <= rounds; ++round) {
        for (std::size_t k = 0; k < times.size(); ++k) {
            const std::size_t i = round % 2 == 0 ? k : times.size() - 1 - k;
            const double ns = nanosecondsPerCall(function.forms[i], arguments, calls[i]);
            if (round > 0) times[i].push_back(ns);
        }
    }
    for (std::size_t i = 0; i < times.size(); ++i) {
        table.times[{function.name, function.forms[i].name}] = {median(times[i]), medianDeviation(times[i])};
    }
}

std::string machineName() {
    std::ifstream information("/proc/cpuinfo");
    for (std::string line; std::getline(information, line);) {
        if (line.rfind("model name", 0) == 0) return "an " + line.substr(line.find(": ") + 2);
    }
    return "an unnamed processor";
}

}  // namespace

void accuracyBench(const std::string& folder) {
    using namespace accuracy;
    TimeTable times;
    times.machine = machineName();
    for (const Function& function : functions()) timeFunction(function, times);
    std::cerr << "timed; measuring errors, " << shortRun << " samples ...\n";
    ErrorTable errors = measureAll(shortRun);
    std::cerr << pageRun << " samples ...\n";
    errors.merge(measureAll(pageRun));

    // The page shows the numbers as the files keep them.
    const std::string errorsFile = errorsText(errors), timesFile = timesText(times);
    const ErrorTable keptErrors = errorsFrom(errorsFile);
    const TimeTable keptTimes = timesFrom(timesFile);
    std::ifstream worst(MVGL_SOURCE_DIR "/docs/library-worst.csv", std::ios::binary);
    const std::string worstFile{std::istreambuf_iterator<char>(worst), std::istreambuf_iterator<char>()};
    const std::string page = libraryPage(keptErrors, keptTimes, worstFrom(worstFile));
    if (folder.empty()) {
        std::cout << page;
        return;
    }
    writeFileAtomically(fs::path(folder) / "library.svg", std::string_view(libraryCurve(keptErrors, keptTimes)));
    writeFileAtomically(fs::path(folder) / "library-errors.csv", std::string_view(errorsFile));
    writeFileAtomically(fs::path(folder) / "library-times.csv", std::string_view(timesFile));
    writeFileAtomically(fs::path(folder) / "library.md", std::string_view(page));
}

}  // namespace mv::bench
