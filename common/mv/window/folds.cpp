#include "mv/window/folds.h"

#include <cstdlib>
#include <iostream>
#include <sstream>

#include "mv/image/file.h"
#include "mv/show/caught.h"

namespace mv {
namespace {

constexpr std::size_t largestFile = 4096;  // bytes

// "" for none. By the XDG Base Directory Specification a path that is not absolute does not count.
std::filesystem::path stateFile() {
    const auto folder = [](const char* name) {
        const char* value = std::getenv(name);
        const std::filesystem::path path = value ? value : "";
        return path.is_absolute() ? path : std::filesystem::path();
    };
    if (const auto state = folder("XDG_STATE_HOME"); !state.empty()) return state / "mvgl" / "folded";
    const auto home = folder("HOME");
    return home.empty() ? home : home / ".local" / "state" / "mvgl" / "folded";
}

}  // namespace

Folds::Folds() : file_(stateFile()) {
    std::error_code missing;
    if (file_.empty() || !std::filesystem::exists(file_, missing)) return;
    try {
        std::istringstream lines(readTextFile(file_, largestFile));
        for (std::string line; std::getline(lines, line);) titles_.insert(line);
    } catch (const std::exception&) {
        std::cerr << "note: " << caughtSentence("window") << std::endl;
    }
}

void Folds::set(const std::string& title, bool folded) {
    if (folded)
        titles_.insert(title);
    else
        titles_.erase(title);
    if (file_.empty()) return;
    try {
        std::string text;
        for (const std::string& each : titles_) text += each + "\n";
        std::error_code failed;  // which the writing says
        std::filesystem::create_directories(file_.parent_path(), failed);
        writeFileAtomically(file_, text);
    } catch (const std::exception&) {
        std::cerr << "note: " << caughtSentence("window") << std::endl;
        file_.clear();  // and only once
    }
}

}  // namespace mv
