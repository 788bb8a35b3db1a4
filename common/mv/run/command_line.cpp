#include "mv/run/command_line.h"

#include "mv/run/flag_table.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <optional>

namespace mv {
namespace {

std::optional<int> wholeNumber(std::string_view text) {
    int number = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return {};
    return number;
}

std::pair<std::string, std::string> splitAt(const std::string& text, const std::string& separator) {
    const auto at = text.find(separator);
    if (at == std::string::npos) return {text, ""};
    return {text.substr(0, at), text.substr(at + separator.size())};
}

int frameNumber(const std::string& flag, const std::string& text) {
    const auto number = wholeNumber(text);
    // Half a year at 60 a second; beyond it an index would come near the end of int.
    if (!number || *number < 0 || *number > 1'000'000'000) {
        throw UsageError(flag, "must be a whole number 0 .. 1000000000", "'" + text + "'");
    }
    return *number;
}

void readFrames(const std::string& text, Command& command) {
    const auto [first, last] = splitAt(text, "..");
    if (last.empty()) throw UsageError("--frames", "must be two frames, as 1..60", "'" + text + "'");
    command.firstFrame = frameNumber("--frames", first);
    command.lastFrame = frameNumber("--frames", last);
    if (command.lastFrame < command.firstFrame) throw UsageError("--frames", "must go upwards", "'" + text + "'");
}

void readSize(const std::string& text, Command& command) {
    const auto [width, height] = splitAt(text, "x");
    const auto w = wholeNumber(width), h = wholeNumber(height);
    if (!w || !h || *w < 1 || *h < 1 || *w > 16384 || *h > 16384) {
        throw UsageError("--size", "must be WIDTHxHEIGHT, each 1 .. 16384, as 640x480", "'" + text + "'");
    }
    command.width = *w;
    command.height = *h;
}

HostKind readHost(const std::string& text) {
    if (text == "automatic") return HostKind::automatic;
    if (const std::optional<HostKind> kind = hostNamed(text)) return *kind;
    throw UsageError("--headless", "must be osmesa | egl | egl-device, or alone", "'" + text + "'");
}

void readCompare(const std::string& text, const Demo& demo, Command& command) {
    const auto [knob, values] = splitAt(text, "=");
    const auto [a, b] = splitAt(values, ",");
    if (knob.empty() || a.empty() || b.empty() || b.find(',') != std::string::npos) {
        throw UsageError("--compare", "must be one knob and two values, as cull=back,front", "'" + text + "'");
    }
    for (const std::string& value : {b, a}) demo.knob(knob).parse(value);
    command.compareKnob = knob;
    command.compareValues = {a, b};
}

// A change that the demo takes, which then has it; the knobs before are `command`'s.
void readChange(const std::string& frame, const std::string& setting, Demo& demo, Command& command) {
    const int at = frameNumber("--at", frame);
    const auto [knob, value] = splitAt(setting, "=");
    if (at < 1) throw UsageError("--at", "must be at a frame from 1; what holds before is set by the knob's own flag");
    if (knob.empty() || value.empty()) {
        throw UsageError("--at", "must be a frame, a knob and its value, as --at 300 pull=0.2", "'" + setting + "'");
    }
    demo.knob(knob).parse(value);
    command.changes.push_back({at, knob, demo.knob(knob).text()});
}

// Changes that cannot be seen, since no frame is drawn that late, and those that set a knob twice.
void checkChanges(const Command& command) {
    for (const TimedChange& change : command.changes) {
        if (change.frame > command.lastFrame && (command.action != Action::window || command.frameGiven)) {
            throw UsageError(
                "--at",
                "must be at a frame that is drawn or before, up to " + std::to_string(command.lastFrame) + " (--frame)",
                std::to_string(change.frame));
        }
        if (change.knob == command.compareKnob) {
            throw UsageError("--at", "must not set the knob that --compare does", change.knob);
        }
    }
}

std::string knobHelp(const Knob& knob) {
    std::string text = knob.help() + "; " + knob.rangeInFull() + ", initially " + knob.initialText();
    for (const Option& option : knob.options()) {
        if (!option.meaning.empty()) text += "\n" + option.word + ": " + option.meaning;
    }
    return text;
}

constexpr const char* knobGroup = "Knobs";  // their heading in the help
constexpr std::string_view severalTimes = "--at";

// The flags of the command line; each has one line here, and its value is read below. Which go together: flag_table.cpp.
struct Flags {
    std::string preset, shot, frame, frames, headless, size, compare, report, knobs, gallery, docs, study, vary;
    std::string until;
    std::vector<std::pair<std::string, std::string>> at;
    bool list = false, version = false, copyable = false, audit = false, all = false, window = false;
};

void declareFlags(CLI::App& app, Flags& flags, bool launcher) {
    app.add_option("--preset", flags.preset, "begin with these settings; other flags of knobs then move from there")
        ->type_name("NAME");
    app.add_option("--shot", flags.shot, "write the picture to a PNG file, - for standard output; opens no window")
        ->type_name("FILE");
    app.add_option("--frame", flags.frame, "which frame, at 60 a second; 1 is the original's first picture")
        ->type_name("N");
    app.add_option("--frames", flags.frames, "several frames; the file is then named a.%04d.png")->type_name("A..B");
    app.add_option("--at", flags.at, "set a knob at a frame, after the step to it; as often as you like")
        ->type_name("N KNOB=VALUE")
        ->allow_extra_args(false);
    app.add_option("--until", flags.until,
                   "stop the frame after its draw K (0: before the first), and print what its draws are made of")
        ->type_name("K");
    app.add_option("--size", flags.size, "of the picture in pixels; the original's canvas if not given")
        ->type_name("WxH");
    app.add_flag("--headless{automatic}", flags.headless,
                 "open no window; =osmesa, =egl or =egl-device chooses the host");
    app.add_option("--compare", flags.compare, "two settings of a knob in one window, or side by side with --shot")
        ->type_name("KNOB=A,B");
    app.add_option("--study", flags.study, "error against run time: study.csv, study.svg and a table")
        ->type_name("DIR");
    app.add_option("--vary", flags.vary, "a study by hand: N values of a knob, or KNOB=a,b,c (with --study)")
        ->type_name("KNOB=A..B:N");
    app.add_flag("--report{text}", flags.report,
                 "print readouts, counters, matrices and times; =json as JSON; opens no window");
    app.add_flag(
        "--window", flags.window,
        "open a window, as without any flag; with --report, it prints one each time\nit has come to rest, once a "
        "second while something moves, and when it closes");
    app.add_flag("--audit", flags.audit, "print the work of a frame, and name what of it was needless");
    app.add_flag("--knobs{text}", flags.knobs, "list the knobs; =json as JSON");
    app.add_flag("--copyable", flags.copyable, "print the command line of these settings");
    app.add_flag("--list", flags.list, "list the demos of this program");
    app.add_flag("--version", flags.version, "print the version");
    if (launcher) {
        app.add_flag("--all", flags.all, "every demo (with --audit)");
        app.add_option("--gallery", flags.gallery, "write a picture of each demo and index.html to a folder")
            ->type_name("DIR");
        app.add_option("--docs", flags.docs, "write the generated pages into a source tree")->type_name("DIR");
    }
    app.set_help_flag("--help", "print this");
}

// CLI11 writes a flag's value for "alone" in braces; what can be typed says more.
std::string helpText(const CLI::App& app) {
    std::string text = app.help();
    for (const auto& [braces, words] : {std::pair<std::string, std::string>{"{automatic}", "[=HOST]"},
                                        {"--report{text} ", "--report[=json]"},
                                        {"--knobs{text} ", "--knobs[=json]"}}) {
        const auto at = text.find(braces);
        if (at == std::string::npos) continue;
        // The column of the descriptions stays where it is.
        const std::size_t width = std::max(words.size(), braces.size());
        text.replace(at, width, words + std::string(width - words.size(), ' '));
    }
    return text;
}

// "--shot=", and "--list=5" of a flag that takes no value: CLI11 would read these as "--shot" and "--list".
void refuseOddValue(const CLI::App& app, const std::string& word) {
    const auto equals = word.find('=');
    if (!word.starts_with("--") || equals == std::string::npos) return;
    const std::string name = word.substr(0, equals);
    if (equals + 1 == word.size()) throw UsageError(name, "must have a value after the =");
    const CLI::Option* option = app.get_option_no_throw(name);
    const bool isFlag = option && option->get_items_expected_max() == 0;
    if (isFlag && name != "--headless" && name != "--report" && name != "--knobs") {
        throw UsageError(name, "takes no value", "'" + word.substr(equals + 1) + "'");
    }
}

// The flags that are given, each with its value if it takes one. Error: one without its value, or twice.
GivenFlags givenFlags(const CLI::App& app, bool demo) {
    GivenFlags given;
    given.demo = demo;
    for (const CLI::Option* option : app.get_options()) {
        if (option->count() == 0) continue;
        const std::string name = option->get_name();
        if (option->count() > 1 && name != severalTimes) throw UsageError(name, "must be given once");
        const std::string& value = option->results().front();
        if (value.empty()) throw UsageError(name, "must have a value", "''");
        if (value.starts_with("--")) {
            throw UsageError(name, "must have a value before the next flag; a file of such a name is ./" + value);
        }
        (option->get_group() == knobGroup ? given.knobs : given.flags).push_back(name);
    }
    return given;
}

// A flag that is no flag, said with the nearest one.
UsageError unknown(const CLI::App& app, const std::string& word) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) names.push_back(option->get_name());
    if (!word.starts_with('-')) return {"'" + word + "'", "is no flag; flags begin with -- (--help lists them)"};
    const std::string flag = word.substr(0, word.find('='));
    return {flag, "is no flag here (--help lists them)" + suggestion(flag, names)};
}

// The preset's settings go before those that were given, in whatever order the flags stand.
void startFrom(const Preset& preset, Command& command) {
    command.preset = preset.name;
    command.presetKnobs = preset.settings.size();
    command.knobs.insert(command.knobs.begin(), preset.settings.begin(), preset.settings.end());
}

// The help's words beneath the flags.
std::string footerOf(const DemoInfo& info) {
    std::string text;
    if (!info.lookFor.empty()) text = "Look for: " + info.lookFor;
    if (info.presets.size() > 0) text += (text.empty() ? "" : "\n\n") + std::string("Presets:");
    for (const Preset& preset : info.presets) text += "\n  " + preset.name + ": " + preset.lookFor;
    return text;
}

// The format by the file's name: PNG, or nothing. "-" is standard output.
void checkShot(const Command& command) {
    const std::string file = frameFile(command.shot, 1);
    std::string kind = std::filesystem::path(file).extension().string();
    std::ranges::transform(kind, kind.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (kind.size() > 1 && std::isalpha(static_cast<unsigned char>(kind[1])) != 0 && kind != ".png") {
        throw UsageError("--shot", "must be a name that ends in .png, or says no other format",
                         "'" + command.shot + "'");
    }
    if (command.shot == "-" && (command.report != ReportForm::none || command.until)) {
        throw UsageError("--shot", "must be a file where a report is printed, which goes to standard output", "'-'");
    }
    if (command.lastFrame > command.firstFrame && file == command.shot) {
        throw UsageError("--shot", "must have %d or %04d in its name for several frames", "'" + command.shot + "'");
    }
}

Command readFlags(const Flags& flags, Command command, Demo* demo) {
    if (!flags.frame.empty()) command.firstFrame = command.lastFrame = frameNumber("--frame", flags.frame);
    if (!flags.frames.empty()) readFrames(flags.frames, command);
    command.frameGiven = !flags.frame.empty() || !flags.frames.empty();
    if (!flags.size.empty()) readSize(flags.size, command);
    if (!flags.until.empty()) {
        command.until =
            wholeNumber(flags.until);  // one that is out of range is refused when the frame's draws are known
        if (!command.until) {
            throw UsageError("--until", "must be a whole number from 0 to the frame's number of draws",
                             "'" + flags.until + "'");
        }
    }
    if (!flags.headless.empty()) command.host = readHost(flags.headless);
    if (!flags.report.empty()) {
        if (flags.report != "text" && flags.report != "json") {
            throw UsageError("--report", "must be json, or alone", "'" + flags.report + "'");
        }
        command.report = flags.report == "json" ? ReportForm::json : ReportForm::text;
    }
    if (!flags.knobs.empty()) {
        if (flags.knobs != "text" && flags.knobs != "json") {
            throw UsageError("--knobs", "must be json, or alone", "'" + flags.knobs + "'");
        }
        command.json = flags.knobs == "json";
    }
    command.shot = flags.shot;
    command.folder = flags.gallery + flags.docs + flags.study;  // of which one at most is given
    command.vary = flags.vary;
    command.all = flags.all;
    const bool wantsDemo = command.action == Action::knobs || command.action == Action::copyable ||
                           command.action == Action::render || command.action == Action::study ||
                           (command.action == Action::audit && !command.all) || !flags.compare.empty() ||
                           !flags.preset.empty() || !flags.size.empty() || command.frameGiven || !flags.at.empty() ||
                           command.until;
    if (!demo && wantsDemo) {
        throw UsageError("demo", "must be named first, as in: mvgl cube-cull --shot a.png (--list shows them)");
    }
    if (flags.all && demo)
        throw UsageError("--all", "must not stand beside a demo's name", "'" + command.demo->name + "'");
    if (demo && !flags.compare.empty()) readCompare(flags.compare, *demo, command);
    if (demo) {
        for (const auto& [frame, setting] : flags.at) readChange(frame, setting, *demo, command);
    }
    checkChanges(command);
    checkShot(command);
    // A report without a window needs no picture, but it is headless: that is asked for by name.
    if (command.action == Action::render && flags.shot.empty() && command.report == ReportForm::none) {
        command.report = ReportForm::text;
    }
    return command;
}

}  // namespace

std::string frameFile(const std::string& pattern, int frame) {
    for (std::size_t at = pattern.find('%'); at != std::string::npos; at = pattern.find('%', at + 1)) {
        std::size_t end = at + 1;
        while (end < pattern.size() && pattern[end] >= '0' && pattern[end] <= '9') ++end;
        if (end >= pattern.size() || pattern[end] != 'd' || end - at > 3) continue;
        std::string digits = std::to_string(frame);
        const auto width = static_cast<std::size_t>(wholeNumber(pattern.substr(at + 1, end - at - 1)).value_or(0));
        if (digits.size() < width) digits.insert(0, width - digits.size(), '0');
        return pattern.substr(0, at) + digits + pattern.substr(end + 1);
    }
    return pattern;
}

Command parseCommandLine(const std::vector<std::string>& arguments) {
    Command command;
    const bool launcher = catalogue().size() != 1;
    std::vector<std::string> rest = arguments;
    if (!launcher) {
        command.demo = &catalogue().front();
        // Its own name may stand first all the same, as in the line that --copyable prints.
        if (!rest.empty() && rest.front() == command.demo->name) rest.erase(rest.begin());
    } else if (!rest.empty() && !rest.front().starts_with('-')) {
        try {
            command.demo = &findDemo(rest.front());
        } catch (const Error& error) {
            throw UsageError("demo", error.what());
        }
        rest.erase(rest.begin());
    }
    const std::unique_ptr<Demo> demo = command.demo ? command.demo->make() : nullptr;

    CLI::App app(command.demo ? command.demo->sentence : "mvgl: small OpenGL programs for learning computer graphics.",
                 command.demo ? command.demo->name : "mvgl");
    if (launcher && !command.demo) app.footer("A demo is named first: mvgl cube-cull --help. --list shows them all.");
    if (command.demo) app.footer(footerOf(*command.demo));
    app.allow_extras();
    Flags flags;
    declareFlags(app, flags, launcher);
    if (demo) {
        for (const Knob* knob : demo->knobs()) {
            const std::string name = knob->name();
            if (app.get_option_no_throw("--" + name)) throw Error("knob " + name, "must not be named like a flag");
            app.add_option_function<std::string>(
                   "--" + name,
                   [&command, name](const std::string& text) {
                       command.knobs.push_back({name, text});
                   },
                   knobHelp(*knob))
                ->type_name("VALUE")
                ->group(knobGroup);
        }
    }
    for (CLI::Option* option : app.get_options()) {  // two are refused below, in our words
        if (option->get_name() != severalTimes) option->take_last();
    }
    for (const std::string& word : rest) refuseOddValue(app, word);
    try {
        std::reverse(rest.begin(), rest.end());  // CLI11 takes its words from the back
        app.parse(rest);
    } catch (const CLI::CallForHelp&) {
        command.action = Action::help;
        command.text = helpText(app);
        return command;
    } catch (const CLI::ArgumentMismatch& error) {
        const std::string text = error.what();  // "--shot: 1 required FILE missing"
        throw UsageError(text.substr(0, text.find(':')), "must have a value (--help says which)");
    } catch (const CLI::ParseError& error) {
        throw UsageError(command.demo ? command.demo->name : "mvgl", error.what());
    }
    if (const auto left = app.remaining(); !left.empty()) throw unknown(app, left.front());
    command.action = actionOf(givenFlags(app, launcher && demo));
    try {
        if (demo && !flags.preset.empty()) startFrom(findPreset(*command.demo, flags.preset), command);
        if (demo) applyKnobs(*demo, command.knobs);
        return readFlags(flags, command, demo.get());
    } catch (const UsageError&) {
        throw;
    } catch (const Error& error) {  // a knob's value, with its range
        throw UsageError(error);
    }
}

}  // namespace mv
