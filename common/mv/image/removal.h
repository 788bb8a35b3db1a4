// Temporary files and folders that are gone even when a signal, or a library's exit(), ends the program.
#pragma once
#include <csignal>
#include <filesystem>

namespace mv {

// As long as this lives, a signal that ends the process removes the file or folder at `path`, with all that is in it, before it
// ends the process as it would have done: TERM, INT, HUP, QUIT, ALRM, USR1, XCPU and the like, not a crash's; and so does
// exit(), whoever calls it. A signal that the program handles or ignores
// is left as it is. Nobody removes the files that KILL and crashes leave, nor those that another thread makes in that
// very moment. Two dozen paths at once; a further one, or one of 4096 bytes, is not noted. In the ordinary case who has
// made the file removes it.
class RemovedOnSignal {
  public:
    explicit RemovedOnSignal(const std::filesystem::path& path);
    ~RemovedOnSignal();
    RemovedOnSignal(const RemovedOnSignal&) = delete;
    RemovedOnSignal& operator=(const RemovedOnSignal&) = delete;

  private:
    int slot_ = -1;
};

// As long as this lives, this thread is not interrupted by a signal: they come afterwards, but for KILL. For the moment between
// making a file and noting that it is to be removed, or renaming it.
class SignalsHeld {
  public:
    SignalsHeld();
    ~SignalsHeld();
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;

  private:
    sigset_t before_{};
};

}  // namespace mv
