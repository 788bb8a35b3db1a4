// Two ways of doing the same, timed side by side. On a shared machine milliseconds say little; the ratio of two runs
// that follow each other closely says a lot.
#pragma once
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace mv::bench {

inline constexpr int fewestRounds = 7;

// The outcome of interleaved(). Deviations are median absolute deviations: half of the ratios lie within `mad` of
// `median`.
struct Ratio {
    double median = 0;   // of the ratios time(a) / time(b), one a pair
    double mad = 0;      // of those ratios
    double medianA = 0;  // milliseconds
    double medianB = 0;
};

// Milliseconds by a clock that never goes back; only differences of two say something.
[[nodiscard]] double steadyMilliseconds();

// Runs a and b in pairs, `rounds` + 1 of them, and drops the first (caches, first allocations). The order turns about
// from pair to pair, a b b a a b b a, so that a machine growing slower or faster favours neither.
// Each call should take at least about a millisecond: repeat within the function what is shorter.
// `clock` tells milliseconds. Error if rounds is below fewestRounds or b takes no measurable time.
[[nodiscard]] Ratio interleaved(const std::function<void()>& a, const std::function<void()>& b, int rounds,
                                const std::function<double()>& clock = steadyMilliseconds);

// The value in the middle, or the mean of the two there; and the median distance from it. Error if there are no values.
[[nodiscard]] double median(std::vector<double> values);
[[nodiscard]] double medianDeviation(const std::vector<double>& values);

// One line of a benchmark's table. `ratio` is what is measured, a time or a size; `bound` what it must not exceed.
// A size has neither deviation nor times (zero).
struct Row {
    std::string name;
    Ratio ratio;
    double bound = 0;
};

// Beyond the bound by more than three deviations is a failure. Beyond it by less is no success either: the run was too
// noisy to tell, however far beyond the ratio lies, and has to be repeated.
enum class Verdict { pass, fail, unclear };
[[nodiscard]] Verdict verdict(const Row& row);

// "name ratio bound ms_a ms_b mad verdict" as a heading, and the rows beneath it.
void printHeading(std::ostream& out);
void printRow(std::ostream& out, const Row& row);

}  // namespace mv::bench
