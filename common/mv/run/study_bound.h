// A bound that a setting of a study must keep: --within and --error.
#pragma once
#include <string>

namespace mv {

// What is asked of a setting: a time that it must keep, in milliseconds, or an error, in the quantity of the study's axis.
struct StudyBound {
    enum class Of { time, error } of = Of::time;
    double value = 0;
    bool percent = false;  // the error was given as one: it is a part
};

// Reads "5ms", "0.5s" or "200us". Error: UsageError of the flag --within, which names the units.
StudyBound readWithin(const std::string& text);
// Reads "0.01" or "1%". Error: UsageError of the flag --error.
StudyBound readError(const std::string& text);
}  // namespace mv
