// A program of the system that makes a file of what it is given.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace mv {

class Converter {
  public:
    // Starts the program of these words, the first of which is its name. It reads from its standard input, and writes the file `made`.
    // It is given up if it neither reads nor writes anything for as long as `patience`. Error, of `flag`: it cannot be started.
    Converter(const std::string& flag, std::vector<std::string> words, std::filesystem::path made,
              std::chrono::milliseconds patience);
    // Ends it where it still runs. Should this process end without a destructor, the system does.
    ~Converter();
    Converter(const Converter&) = delete;
    Converter& operator=(const Converter&) = delete;

    // Both: false where it has failed; it has said why on standard error. Error: it was given up.
    [[nodiscard]] bool give(std::span<const std::byte> bytes);
    // That was all: waits for its end.
    [[nodiscard]] bool finish();

  private:
    void requireProgress();

    std::string name_;
    std::filesystem::path made_;
    std::chrono::milliseconds patience_;
    std::chrono::steady_clock::time_point lastMove_;
    std::uintmax_t lastSize_ = 0;
    int pipe_ = -1;
    pid_t process_ = -1;
};

}  // namespace mv
