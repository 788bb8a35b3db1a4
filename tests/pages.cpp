// The pages' command lines: each one does what a reader who types it expects, or the page says that it does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "mv/run/command_line.h"
#include "mv/run/study.h"
#include "support/demo_run.h"
#include "support/process.h"

using namespace mv;
using namespace mv::test;

namespace {

namespace fs = std::filesystem;

// One "./run ..." of a page; `status` is 1 where a remark after # says "status 1".
struct PageLine {
    int number = 0;
    std::string text;
    int status = 0;
};

// In a block of code a line that begins so; in the text what stands in backquotes.
std::vector<PageLine> commandsOf(const fs::path& page) {
    std::ifstream stream(page);
    EXPECT_TRUE(stream) << page;
    std::vector<PageLine> commands;
    bool inBlock = false;
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        if (line.starts_with("```")) {
            inBlock = !inBlock;
        } else if (inBlock && line.starts_with("./run ")) {
            const auto remark = std::min(line.find(" #"), line.size());
            const int status = line.find("status 1", remark) != std::string::npos ? 1 : 0;
            commands.push_back({number, line.substr(0, remark), status});
        } else if (!inBlock) {
            for (std::size_t at = line.find("`./run "); at != std::string::npos; at = line.find("`./run ", at + 1)) {
                commands.push_back({number, line.substr(at + 1, line.find('`', at + 1) - at - 1)});
            }
        }
    }
    return commands;
}

std::vector<std::string> wordsOf(const std::string& text) {
    std::vector<std::string> words;
    std::istringstream stream(text);
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

bool isLong() { return std::getenv("MVGL_LONG") != nullptr; }

// What mvgl is given to try the command, in moments and without a window; nothing where parsing it was all.
std::optional<std::vector<std::string>> trial(const PageLine& line) {
    std::vector<std::string> words = wordsOf(line.text);
    words.erase(words.begin());
    if (!words.empty() && (words.front() == "DEMO" || words.front() == "<name>")) words.front() = "shadow-map";
    const Command command = parseCommandLine(words);
    const auto add = [&](const std::vector<std::string>& more) { words.insert(words.end(), more.begin(), more.end()); };
    if (command.action == Action::window && !command.demo) return {};  // the menu
    if (command.action == Action::window) {
        std::erase(words, "--window");
        add({"--shot", "window.png"});
    }
    if (isLong()) return words;
    if (command.action == Action::study && command.vary.empty()) {  // it takes minutes, and has a test that measures it
        (void)studyOf(*command.demo, command.knobs, command.vary);
        return {};
    }
    const bool draws =
        command.action == Action::window || command.action == Action::render || command.action == Action::study;
    if (draws && command.width == 0) add({"--size", "96x72"});
    return words;
}

std::vector<std::string> pages() {
    std::vector<std::string> names{"README.md", "CONTRIBUTING.md"};
    for (const DemoInfo& info : catalogue()) names.push_back("demos/" + info.name + ".md");
    return names;
}

std::string pageWord(const testing::TestParamInfo<std::string>& page) {
    std::string word = fs::path(page.param).stem().string();
    std::replace(word.begin(), word.end(), '-', '_');
    return word;
}

class Pages : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(Pages, every_command_does_what_it_says) {
    const fs::path page = fs::path(MVGL_SOURCE_DIR) / GetParam();
    const std::vector<PageLine> commands = commandsOf(page);
    const bool isLesson = GetParam().starts_with("demos/");
    EXPECT_GE(commands.size(), isLesson ? 3U : 1U) << "a lesson has three things to try";
    for (const PageLine& line : commands) {
        SCOPED_TRACE(GetParam() + ":" + std::to_string(line.number) + ": " + line.text);
        std::optional<std::vector<std::string>> words;
        try {
            words = trial(line);
        } catch (const std::exception& error) {
            ADD_FAILURE() << error.what();
        }
        if (!words) continue;
        const TemporaryFolder folder;
        words->insert(words->begin(), program("mvgl"));
        const ProcessResult run =
            runProcess(*words, {.folder = folder.path().string(), .environment = {"DISPLAY", "WAYLAND_DISPLAY"}});
        EXPECT_EQ(run.status, line.status) << run.err;
        EXPECT_TRUE(!run.out.empty() || folder.entries() > 0) << "it says or writes something";
    }
}

INSTANTIATE_TEST_SUITE_P(All, Pages, testing::ValuesIn(pages()), pageWord);
