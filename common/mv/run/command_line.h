// The command line, the same for every demo.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/host/context.h"
#include "mv/run/stage.h"
#include "mv/run/study_bound.h"

namespace mv {

// What was typed cannot be understood: exit status 2. Any other Error: exit status 1.
class UsageError : public Error {
  public:
    using Error::Error;
    explicit UsageError(const Error& error) : Error(error) {}
};

enum class Action { window, render, help, list, version, knobs, copyable, gallery, docs, study, audit };
enum class ReportForm { none, text, json };

struct Command {
    Action action = Action::window;
    const DemoInfo* demo = nullptr;  // none: the launcher's menu
    std::vector<KnobSetting> knobs;  // those of the preset, then those that were given
    std::string preset;              // "" for none
    std::size_t presetKnobs = 0;     // how many of `knobs` are the preset's
    int firstFrame = 1, lastFrame = 1;
    bool frameGiven = false;
    std::vector<TimedChange> changes;  // --at
    int width = 0, height = 0;         // 0: the original's canvas
    HostKind host = HostKind::automatic;
    std::string shot;         // the picture's file; "" for none. With several frames it contains %d or %04d
    std::string compareKnob;  // "" for no comparison
    std::vector<std::string> compareValues;
    ReportForm report = ReportForm::none;
    bool json = false;                // --knobs=json
    bool all = false;                 // --audit --all
    std::string folder;               // of --gallery, --docs and --study
    std::optional<StudyBound> bound;  // --within or --error: which setting of the study is drawn
    bool measureHere = false;         // by times measured here, not the committed ones
    std::string vary;                 // of --study: KNOB=A..B:N or KNOB=a,b,c; "" for the demo's own study
    std::optional<int> until;         // --until: the frame is stopped after so many draws
    std::string text;                 // what --help prints
    std::string program;  // how the program was started: what to type to start it once more; "" where nobody knows
};

// Reads the arguments after the program's name. With one demo linked in, that is the demo; with more, the first
// argument names it. Error: UsageError naming the flag, the rule and, for a slip of the hand, the nearest flag.
Command parseCommandLine(const std::vector<std::string>& arguments);

// A knob whose present value is compared with another; without a name, none is.
struct ComparedKnob {
    std::string name = {}, other = {};
};

// The command line that reproduces the picture: `start`, the knobs that are not at their initial value, what was changed and
// when, what is compared, frame, size and after how many draws it is stopped. A shell reads each word as it is meant. Without a timeline, the demo's knobs are
// those that it begins with.
std::string copyableCommand(const std::string& start, const DemoInfo& info, const Demo& demo, int frame, int width,
                            int height, const ComparedKnob& compared = {}, const Timeline* timeline = nullptr,
                            std::optional<int> until = {});

// What to type, where the program was started so, to start that demo: "./run shadow-map", and "build/bin/shadow-map" where the
// program is that demo's and has its name.
std::string startOf(const std::string& program, const DemoInfo& info);

// The text as one word of a shell's command line: in quotes where it is not made of letters, digits and -_./=,:+@%.
std::string quotedForShell(const std::string& text);

// `pattern` with the frame's number for its "%d" or "%04d".
std::string frameFile(const std::string& pattern, int frame);

}  // namespace mv
