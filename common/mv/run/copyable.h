// The command line of what is shown, to be typed or pasted.
#pragma once
#include <optional>
#include <string>

#include "mv/demo/demo.h"
#include "mv/run/command_line.h"
#include "mv/show/timeline.h"

namespace mv {

// A knob whose present value is compared with another; without a name, none is.
struct ComparedKnob {
    std::string name = {}, other = {};
};

// The command line that reproduces the picture: `start`, the knobs that are not at their initial value, what was changed and
// when, what is compared, frame, size, density, samples and after how many draws it is stopped. A shell reads each word as it is meant. Without a timeline, the demo's knobs are
// those that it begins with.
std::string copyableCommand(const std::string& start, const DemoInfo& info, const Demo& demo, int frame, int width,
                            int height, const ComparedKnob& compared = {}, const Timeline* timeline = nullptr,
                            std::optional<int> until = {}, double density = 1, std::optional<int> samples = {});

// The same of what was typed, for that frame. A picture's file tells it with the demo's name for `start` (--from).
std::string lineOf(const Command& command, const std::string& start, int frame);

// The words to type, where the program was started so, to start that demo: "./run shadow-map", and
// "build/bin/shadow-map" where the program is that demo's and has its name.
std::string startOf(const std::string& program, const DemoInfo& info);

// The text as one word of a shell's command line: in quotes where it is not made of letters, digits and -_./=,:+@%.
std::string quotedForShell(const std::string& text);

}  // namespace mv
