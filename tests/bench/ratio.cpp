#include "bench/ratio.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <ostream>

#include "mv/error.h"

namespace mv::bench {

double steadyMilliseconds() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> values) {
    if (values.empty()) throw Error("median", "there must be at least one value");
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

double medianDeviation(const std::vector<double>& values) {
    const double centre = median(values);
    std::vector<double> distances;
    distances.reserve(values.size());
    for (const double value : values) distances.push_back(std::abs(value - centre));
    return median(std::move(distances));
}

Ratio interleaved(const std::function<void()>& a, const std::function<void()>& b, int rounds,
                  const std::function<double()>& clock) {
    if (rounds < fewestRounds) {
        throw Error("interleaved", "rounds must be at least " + std::to_string(fewestRounds), std::to_string(rounds));
    }
    const auto timeOf = [&](const std::function<void()>& work) {
        const double start = clock();
        work();
        return clock() - start;
    };
    std::vector<double> timesA;
    std::vector<double> timesB;
    std::vector<double> ratios;
    for (int round = 0; round <= rounds; ++round) {
        double timeA = 0;
        double timeB = 0;
        if (round % 2 == 0) {
            timeA = timeOf(a);
            timeB = timeOf(b);
        } else {
            timeB = timeOf(b);
            timeA = timeOf(a);
        }
        if (round == 0) continue;
        if (timeB <= 0) throw Error("interleaved", "b must take measurable time; repeat it within the function");
        timesA.push_back(timeA);
        timesB.push_back(timeB);
        ratios.push_back(timeA / timeB);
    }
    return {median(ratios), medianDeviation(ratios), median(timesA), median(timesB)};
}

Verdict verdict(const Row& row) {
    const double beyond = row.ratio.median - row.bound;
    if (beyond <= 0) return Verdict::pass;
    return beyond > 3 * row.ratio.mad ? Verdict::fail : Verdict::unclear;
}

void printHeading(std::ostream& out) {
    out << std::left << std::setw(44) << "name" << std::right << std::setw(9) << "ratio" << std::setw(8) << "bound"
        << std::setw(11) << "ms_a" << std::setw(11) << "ms_b" << std::setw(9) << "mad"
        << "  verdict\n";
}

void printRow(std::ostream& out, const Row& row) {
    constexpr std::array<const char*, 3> words = {"pass", "fail", "unclear"};
    const auto flags = out.flags();
    const auto precision = out.precision();
    out << std::fixed << std::setprecision(3) << std::left << std::setw(44) << row.name << std::right << std::setw(9)
        << row.ratio.median << std::setw(8) << row.bound << std::setw(11) << row.ratio.medianA << std::setw(11)
        << row.ratio.medianB << std::setw(9) << row.ratio.mad << "  " << words[static_cast<std::size_t>(verdict(row))]
        << '\n';
    out.flags(flags);
    out.precision(precision);
}

}  // namespace mv::bench
