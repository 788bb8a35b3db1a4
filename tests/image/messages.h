// The words of an Error, for tests that check them.
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "mv/error.h"

namespace mv {

// The text of the Error that `work` throws; a failed test, and an empty text, if it throws none.
template <typename Work>
std::string messageOf(Work&& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.what();
    }
    ADD_FAILURE() << "no Error was thrown";
    return {};
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace mv
