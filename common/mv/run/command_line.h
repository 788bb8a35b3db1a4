// The command line, the same for every demo.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/host/context.h"
#include "mv/show/compare.h"
#include "mv/show/stage.h"

namespace mv {

// A command line that cannot be understood: exit status 2. Any other Error: exit status 1.
class UsageError : public Error {
  public:
    using Error::Error;
    explicit UsageError(const Error& error) : Error(error) {}
};

enum class Action {
    window,
    render,
    movie,
    versus,
    plot,
    help,
    list,
    version,
    knobs,
    copyable,
    gallery,
    docs,
    study,
    audit
};
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
    double density = 1;                // --density
    // --multisample; a picture without has none, and a window chooses by how long a frame takes
    std::optional<int> samples;
    HostKind host = HostKind::automatic;
    std::string
        shot;  // the picture's file; "" for none, "-" standard output. With several frames it contains %d or %04d
    std::string compareKnob;  // "" for no comparison
    std::vector<std::string> compareValues;
    std::vector<KnobValues> strip;  // --strip, of one knob or two
    std::string movie;              // --movie: the film's file
    std::string versusKnob;         // --versus
    std::vector<std::string> versusValues;
    std::string plot, plotScene;  // --plot: the file, and the scene of the study or ""
    ReportForm report = ReportForm::none;
    bool json = false;         // --knobs=json
    bool all = false;          // --audit --all
    std::string folder;        // of --gallery, --docs and --study
    std::string vary;          // of --study and --movie: KNOB=A..B:N or KNOB=a,b,c; "" for the demo's own study
    std::optional<int> until;  // --until: the frame is stopped after so many draws
    std::string text;          // what --help prints
    std::string program;       // how the program was started: what to type to start it once more; "" where nobody knows
};

// Reads the arguments after the program's name. With one demo linked in, that is the demo; with more, the first
// argument names it. Error: UsageError naming the flag, the rule and, for a slip of the hand, the nearest flag.
Command parseCommandLine(const std::vector<std::string>& arguments);

// `pattern` with the frame's number for its "%d" or "%04d".
std::string frameFile(const std::string& pattern, int frame);

}  // namespace mv
