// What the rows of a study have counted.
#pragma once
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "mv/demo/study.h"

namespace mv::test {

// The amount of that name; a test failure and NaN where the row does not count it.
inline double countOf(const StudyRow& row, const std::string& name) {
    for (const auto& [counted, amount] : row.counts) {
        if (counted == name) return amount;
    }
    ADD_FAILURE() << row.method << " does not count " << name;
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace mv::test
