// Which sections of the panel are folded, kept from one window to the next.
#pragma once
#include <filesystem>
#include <set>
#include <string>

namespace mv {

// A line for each folded section in $XDG_STATE_HOME/mvgl/folded, or ~/.local/state/mvgl/folded. Without either of the two, and where
// it cannot be written, which a line on standard error says, it is kept as long as the program runs.
class Folds {
  public:
    Folds();
    bool has(const std::string& title) const { return titles_.contains(title); }
    void set(const std::string& title, bool folded);

  private:
    std::filesystem::path file_;
    std::set<std::string> titles_;
};

}  // namespace mv
