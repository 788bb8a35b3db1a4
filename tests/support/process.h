// Whole programs under test.
#pragma once
#include <string>
#include <vector>

#include "support/temporary_folder.h"

namespace mv::test {

struct ProcessResult {
    int status = -1;  // exit status; 128 + n after signal n
    std::string out, err;
};

struct ProcessOptions {
    std::string folder = {};                    // to start in; "" for the present one
    std::vector<std::string> environment = {};  // "NAME=value" sets, "NAME" alone unsets
};

// Runs a program to its end. Error: it cannot be started.
ProcessResult runProcess(const std::vector<std::string>& command, const ProcessOptions& options = {});

// A program of this build tree ("cube-cull").
std::string program(const std::string& name);

}  // namespace mv::test
