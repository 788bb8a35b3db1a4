// A program that runs beside the window and never outlives it.
#pragma once
#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace mv {

class Child {
  public:
    // Starts this very program with other arguments. Its standard output is thrown away.
    // Error: it cannot be started.
    explicit Child(const std::vector<std::string>& arguments);
    // Ends it, and what it has started itself, if it still runs: by TERM, which lets it remove its temporary files, and
    // after two seconds by KILL. Should this process die without a destructor, the system sends the child a TERM.
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    // The lines that it has written to standard error since the last call. Does not wait.
    std::vector<std::string> takeLines();
    // How it ended: its exit status, or 128 + n after signal n. Nothing while it runs.
    std::optional<int> status();

  private:
    pid_t process_ = -1;
    int errors_ = -1;    // the end of a pipe
    std::string begun_;  // a line whose end is not there yet
    std::optional<int> status_;
};

}  // namespace mv
