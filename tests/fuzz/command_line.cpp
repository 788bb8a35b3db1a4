// libFuzzer: any words into the command line, one a line of the input. Lines are understood or refused as not
// understood, nothing else; and what is understood prints a command line that means the same.
#include <algorithm>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "mv/run/command_line.h"
#include "mv/run/copyable.h"
#include "support/demo_of.h"

namespace {

using namespace mv;

enum class Choice { first, second };

// Every kind of knob.
struct Settings {
    double real = 0.5;
    int whole = 3;
    bool toggle = true;
    Choice choice = Choice::first;
    double angle = 0;
};
struct Small final : test::DemoOf<Settings> {
    Small()
        : DemoOf(together(mv::number("real", &Settings::real, {-1, 1e8}, "a number"),
                          mv::whole("whole", &Settings::whole, {0, 300}, "a whole number"),
                          mv::toggle("toggle", &Settings::toggle, "on or off"),
                          mv::word("choice", &Settings::choice, {{"first"}, {"second"}}, "a word"),
                          mv::angle("angle", &Settings::angle, "an angle"))) {}
};
constexpr Declaration smallDeclaration{.name = "small", .sentence = "moves", .animated = true};
const bool smallAdded = addDemo(smallDeclaration, {}, "", [] { return std::make_unique<Small>(); });
constexpr Declaration otherDeclaration{.name = "other", .sentence = "rests"};
const bool otherAdded = addDemo(otherDeclaration, {}, "", [] { return std::make_unique<Small>(); });

void require(bool condition, const std::string& what) {
    if (!condition) throw std::logic_error(what);  // which libFuzzer reports as a crash
}

std::string copyable(const Command& command) {
    const auto demo = command.demo->make();
    applyKnobs(*demo, command.knobs);
    ComparedKnob compared;
    if (!command.compareKnob.empty()) {
        demo->knob(command.compareKnob).parse(command.compareValues.at(0));
        compared = {command.compareKnob, command.compareValues.at(1)};
    }
    const DemoInfo& info = *command.demo;
    return copyableCommand(info.name, info, *demo, command.firstFrame, command.width ? command.width : info.width,
                           command.height ? command.height : info.height, compared);
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> words;
    std::istringstream stream(text);
    for (std::string word; std::getline(stream, word, separator);) words.push_back(word);
    return words;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    Command command;
    std::string words(reinterpret_cast<const char*>(data), size);
    std::replace(words.begin(), words.end(), '\0', '\n');  // no argument can have one
    try {
        command = parseCommandLine(split(words, '\n'));
    } catch (const UsageError& error) {
        require(std::string(error.what()).find(": ") != std::string::npos, error.what());
        return 0;
    } catch (const Error& error) {  // what --from reads is a file, or none
        require(words.find("--from") != std::string::npos, error.what());
        return 0;
    }
    if (command.action == Action::help || !command.demo) return 0;
    const std::string line = copyable(command);
    require(copyable(parseCommandLine(split(line, ' '))) == line, line);
    return 0;
}
