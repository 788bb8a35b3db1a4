// Whole programs under test.
#pragma once
#include <string>
#include <vector>

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

// An empty folder, removed with everything in it at the end.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::string& path() const { return path_; }
    std::string file(const std::string& name) const { return path_ + "/" + name; }
    std::vector<std::string> list() const;  // names of what is in it

  private:
    std::string path_;
};

}  // namespace mv::test
