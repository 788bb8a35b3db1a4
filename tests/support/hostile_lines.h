// Command lines that nobody meant.
#pragma once
#include <random>
#include <string>
#include <vector>

namespace mv::test {

// A stream of command lines for the demos of this test program, the same for the same seed: half of them from the grammar,
// with up to two slips of the hand, half of them words in any order.
class HostileLines {
  public:
    explicit HostileLines(unsigned seed);
    std::vector<std::string> next();

  private:
    std::size_t pick(std::size_t count) { return static_cast<std::size_t>(random_()) % count; }
    std::vector<std::string> meant();
    std::vector<std::string> anyWords();
    void slip(std::vector<std::string>& line);

    std::mt19937 random_;  // its numbers are the same on every machine
    std::vector<std::string> words_;
};

}  // namespace mv::test
