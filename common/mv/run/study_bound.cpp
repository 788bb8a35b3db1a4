#include "mv/run/study_bound.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "mv/run/command_line.h"

namespace mv {
namespace {

// The number that the text begins with, and what follows it.
std::optional<std::pair<double, std::string>> numberAndUnit(const std::string& text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc() || !std::isfinite(value)) return {};
    return std::pair{value, std::string(read.ptr, end)};
}

}  // namespace

StudyBound readWithin(const std::string& text) {
    const auto read = numberAndUnit(text);
    const double factor = !read                  ? 0
                          : read->second == "ms" ? 1
                          : read->second == "s"  ? 1000
                          : read->second == "us" ? 1e-3
                                                 : 0;
    if (factor == 0 || read->first <= 0) {
        throw UsageError("--within", "must be a time above 0 with its unit, us, ms or s, as 5ms", "'" + text + "'");
    }
    return {StudyBound::Of::time, read->first * factor};
}

StudyBound readError(const std::string& text) {
    const auto read = numberAndUnit(text);
    const bool percent = read && read->second == "%";
    if (!read || (!percent && !read->second.empty()) || read->first < 0) {
        throw UsageError("--error", "must be a number from 0 on, as 0.01, or a part in percent, as 1%",
                         "'" + text + "'");
    }
    return {StudyBound::Of::error, percent ? read->first / 100 : read->first, percent};
}

}  // namespace mv
