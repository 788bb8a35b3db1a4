// docs/library.md and the two files it is made of: what was measured, kept so that the page can be made again without
// measuring, and compared with what is measured now.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "accuracy/function.h"

namespace mv::accuracy {

// Samples of a run: what every test run measures again; what the page shows; and what MVGL_LONG=1 asks for.
inline constexpr long shortRun = 10'000, pageRun = 100'000, longRun = 1'000'000;

// The measurement of a form: its name, where, and with how many samples.
struct Measurement {
    std::string function, form;
    Domain domain;
    long samples;

    // The warning of clang-tidy 14 here is about the compiler's own code.
    auto operator<=>(const Measurement&) const = default;  // NOLINT(modernize-use-nullptr)
};
using ErrorTable = std::map<Measurement, Errors>;

// All measurements of a function with this many samples: ours over the whole domain; in a short run also GLM's, and both
// over the ordinary one where GLM has the function.
std::vector<Measurement> measurementsOf(const Function& function, long samples);
// Measures those of all functions, on all processors.
ErrorTable measureAll(long samples);

struct Time {
    double nanoseconds, deviation;  // median of the runs, and median absolute deviation
};
struct TimeTable {
    std::string machine;
    std::map<std::pair<std::string, std::string>, Time> times;  // by function and form
};

// The worst that a search has found of a form (tests/adversary), and the input that gives it.
struct WorstFound {
    double ulp = 0, bound = 0;
    std::uint64_t seed = 0;
    long evaluations = 0;
    Arguments input{};
};
using WorstTable = std::map<std::pair<std::string, std::string>, WorstFound>;  // by function and form

// docs/library-worst.csv: errors to three digits, arguments to the last bit.
std::string worstText(const WorstTable& worst);
WorstTable worstFrom(const std::string& text);

// docs/library-errors.csv and docs/library-times.csv, numbers to two digits. Error: a line that is none of ours.
std::string errorsText(const ErrorTable& errors);
ErrorTable errorsFrom(const std::string& text);
std::string timesText(const TimeTable& times);
TimeTable timesFrom(const std::string& text);

// The page: a function of the three tables and of the words in functions(). Error: a function without its numbers.
std::string libraryPage(const ErrorTable& errors, const TimeTable& times, const WorstTable& worst);
// The curve docs/library.svg, a function of the same tables.
std::string libraryCurve(const ErrorTable& errors, const TimeTable& times);

}  // namespace mv::accuracy
