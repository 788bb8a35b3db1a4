#include "mv/run/command_line.h"

#include "mv/image/png.h"
#include "mv/run/flag_table.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>
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

double readDensity(const std::string& text) {
    double density = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), density);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size() || !(density >= 1 && density <= 8)) {
        throw UsageError("--density", "must be a number 1 .. 8, as 2 for 192 dpi", "'" + text + "'");
    }
    return density;
}

int readSamples(const std::string& text) {
    if (text != "0" && text != "4") throw UsageError("--multisample", "must be 0 or 4", "'" + text + "'");
    return text == "4" ? 4 : 0;
}

HostKind readHost(const std::string& text) {
    if (text == "automatic") return HostKind::automatic;
    if (const std::optional<HostKind> kind = hostNamed(text)) return *kind;
    throw UsageError("--headless", "must be osmesa | egl | egl-device, or alone", "'" + text + "'");
}

// A knob and values that it takes; it then has the first.
KnobValues readValues(const std::string& flag, const std::string& text, const Demo& demo, const std::string& example,
                      std::size_t least, std::size_t most) {
    const auto [knob, values] = splitAt(text, "=");
    KnobValues result{knob, {}};
    for (std::size_t from = 0; from <= values.size();) {
        const std::size_t comma = std::min(values.find(',', from), values.size());
        result.values.push_back(values.substr(from, comma - from));
        from = comma + 1;
    }
    const bool isEmpty = knob.empty() || std::ranges::any_of(result.values, &std::string::empty);
    if (isEmpty || result.values.size() < least || result.values.size() > most) {
        const std::string number = most == 2 ? "two values" : "one value or more";
        throw UsageError(flag, "must be one knob and " + number + ", as " + example, "'" + text + "'");
    }
    for (std::size_t i = result.values.size(); i-- > 0;) demo.knob(knob).parse(result.values[i]);
    return result;
}

void readCompare(const std::string& text, const Demo& demo, Command& command) {
    KnobValues read = readValues("--compare", text, demo, "cull=back,front", 2, 2);
    command.compareKnob = std::move(read.knob);
    command.compareValues = std::move(read.values);
}

void readVersus(const std::string& text, const Demo& demo, Command& command) {
    KnobValues read = readValues("--versus", text, demo, "method=map,volume", 2, 2);
    command.versusKnob = std::move(read.knob);
    command.versusValues = std::move(read.values);
}

void readStrip(const std::vector<std::string>& texts, const Demo& demo, Command& command) {
    if (texts.size() > 2)
        throw UsageError("--strip", "must be given once or twice: a row of pictures, or rows of them");
    for (const std::string& text : texts)
        command.strip.push_back(readValues("--strip", text, demo, "bias=0,0.01,0.1", 1, 100));
    if (texts.size() == 2 && command.strip[0].knob == command.strip[1].knob)
        throw UsageError("--strip", "must be of two knobs where it is given twice", "'" + texts[1] + "'");
}

void readPlot(const std::string& text, Command& command) {
    const std::size_t equals = text.rfind('=');
    command.plot = equals == std::string::npos ? text : text.substr(equals + 1);
    if (equals != std::string::npos) command.plotScene = text.substr(0, equals);
    const bool known = command.plot.ends_with(".svg") || command.plot.ends_with(".png");
    if (!known || command.plot.size() <= std::string_view(".svg").size())
        throw UsageError("--plot", "must be [SCENE=]FILE.svg or FILE.png", "'" + text + "'");
}

void checkMovie(const Command& command) {
    const bool known = std::ranges::any_of(std::array{".mp4", ".webm", ".gif"}, [&](const char* end) {
        return command.movie.ends_with(end) && command.movie.size() > std::string_view(end).size();
    });
    if (!known)
        throw UsageError("--movie", "must be a file FILE.mp4, FILE.webm or FILE.gif", "'" + command.movie + "'");
    if (command.vary.empty() && command.lastFrame == command.firstFrame)
        throw UsageError("--movie", "needs --frames A..B, or --vary KNOB=A..B:N for one picture a value");
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
        for (const KnobValues& strip : command.strip) {
            if (change.knob == strip.knob)
                throw UsageError("--at", "must not set the knob that --strip does", change.knob);
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
bool isForSeveral(const std::string& flag) { return flag == "--at" || flag == "--strip"; }

// The flags of the command line; each has one line here, and its value is read below. Which go together: flag_table.cpp.
struct Flags {
    std::string preset, shot, frame, frames, headless, size, density, samples, compare, report, knobs, gallery, docs,
        study, vary;
    std::string until;
    std::string movie, versus, plot, from;
    std::vector<std::string> strip;
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
    app.add_option(
           "--density", flags.density,
           "of the screen that the picture is for, 1 is 96 dpi: words and lines in it are no smaller than can\nbe "
           "read there")
        ->type_name("D");
    app.add_option("--multisample", flags.samples,
                   "samples of each pixel, 0 or 4: with 4 edges are smooth; if not given 0, and in a "
                   "window 4 where a frame takes less than 8 ms so")
        ->type_name("N");
    app.add_flag("--headless{automatic}", flags.headless,
                 "open no window; =osmesa, =egl or =egl-device chooses the host");
    app.add_option("--compare", flags.compare, "two settings of a knob in one window, or side by side with --shot")
        ->type_name("KNOB=A,B");
    app.add_option(
           "--strip", flags.strip,
           "a row of pictures, each under its label; a second --strip has a row for each of its values\n(with --shot)")
        ->type_name("KNOB=A,B,C")
        ->allow_extra_args(false);
    app.add_option("--movie", flags.movie,
                   "the frames of --frames, or the values of --vary, as a film: .mp4, .webm or .gif, by ffmpeg")
        ->type_name("FILE");
    app.add_option("--versus", flags.versus, "print what one setting costs and how wrong it is, beside another")
        ->type_name("KNOB=A,B");
    app.add_option("--plot", flags.plot, "write one scene of the committed study as a plot")
        ->type_name("[SCENE=]FILE.svg");
    app.add_option("--from", flags.from,
                   "begin with the line that made this picture, which its file tells; other flags replace\nthose of it")
        ->type_name("FILE.png");
    app.add_option("--study", flags.study, "error against run time: study.csv, study.svg and a table")
        ->type_name("DIR");
    app.add_option("--vary", flags.vary, "a study by hand: N values of a knob, or KNOB=a,b,c (with --study or --movie)")
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
        if (option->count() > 1 && !isForSeveral(name)) throw UsageError(name, "must be given once");
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
    if (command.action == Action::movie) return;
    if (command.lastFrame > command.firstFrame && file == command.shot) {
        throw UsageError("--shot", "must have %d or %04d in its name for several frames", "'" + command.shot + "'");
    }
}

Command readFlags(const Flags& flags, Command command, Demo* demo) {
    if (!flags.frame.empty()) command.firstFrame = command.lastFrame = frameNumber("--frame", flags.frame);
    if (!flags.frames.empty()) readFrames(flags.frames, command);
    command.frameGiven = !flags.frame.empty() || !flags.frames.empty();
    if (!flags.size.empty()) readSize(flags.size, command);
    if (!flags.samples.empty()) command.samples = readSamples(flags.samples);
    if (!flags.density.empty()) command.density = readDensity(flags.density);
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
    command.movie = flags.movie;
    command.all = flags.all;
    const bool wantsDemo = command.action == Action::knobs || command.action == Action::copyable ||
                           command.action == Action::render || command.action == Action::study ||
                           (command.action == Action::audit && !command.all) || command.action == Action::movie ||
                           command.action == Action::versus || command.action == Action::plot ||
                           !flags.compare.empty() || !flags.preset.empty() || !flags.size.empty() ||
                           command.frameGiven || !flags.at.empty() || command.until;
    if (!demo && wantsDemo) {
        throw UsageError("demo", "must be named first, as in: mvgl cube-cull --shot a.png (--list shows them)");
    }
    if (flags.all && demo)
        throw UsageError("--all", "must not stand beside a demo's name", "'" + command.demo->name + "'");
    if (demo && !flags.compare.empty()) readCompare(flags.compare, *demo, command);
    if (demo && !flags.versus.empty()) readVersus(flags.versus, *demo, command);
    if (demo) readStrip(flags.strip, *demo, command);
    if (!flags.plot.empty()) readPlot(flags.plot, command);
    if (command.action == Action::movie) checkMovie(command);
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

// The words of a line for a shell, as quotedForShell() quotes them.
std::vector<std::string> wordsOf(const std::string& line) {
    std::vector<std::string> words;
    bool begun = false, quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == ' ' && !quoted) {
            begun = false;
            continue;
        }
        if (!begun) words.emplace_back();
        begun = true;
        if (c == '\'')
            quoted = !quoted;
        else
            words.back() += c == '\\' && !quoted && i + 1 < line.size() ? line[++i] : c;
    }
    return words;
}

std::string flagOf(const std::string& word) { return word.substr(0, word.find('=')); }

// A picture may be anybody's: its line says what is drawn, as copyableCommand() writes it, and nothing that is done.
void requireNoAction(const std::vector<std::string>& told) {
    static constexpr std::array drawn{"--at",          "--compare", "--density", "--frame",
                                      "--multisample", "--size",    "--strip",   "--until"};
    const auto demo = findDemo(told.front()).make();
    for (const std::string& word : told) {
        const std::string flag = flagOf(word);
        const auto knobs = demo->knobs();
        if (!flag.starts_with("--") || std::ranges::find(drawn, flag) != drawn.end() ||
            std::ranges::any_of(knobs, [&](const Knob* knob) { return "--" + knob->name() == flag; }))
            continue;
        throw Error("--from", "must be a picture whose line says what is drawn; its file has another flag", flag);
    }
}

// With --from FILE the line that the picture's file tells, before what else is given, which replaces its flags.
std::vector<std::string> withPicturesLine(const std::vector<std::string>& arguments) {
    std::vector<std::string> rest;
    std::string file;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (flagOf(arguments[i]) != "--from") {
            rest.push_back(arguments[i]);
            continue;
        }
        if (!file.empty()) throw UsageError("--from", "must be given once");
        const bool isOne = arguments[i] != "--from";
        file = isOne ? arguments[i].substr(7) : i + 1 < arguments.size() ? arguments[++i] : "";
        if (file.empty() || file.starts_with("--")) throw UsageError("--from", "must have a value (--help says which)");
    }
    if (file.empty()) return rest;
    const std::vector<std::string> told = wordsOf(commandInPng(file));
    if (told.empty())
        throw Error("--from", "must be a picture that --shot or a window of mvgl has written: it tells no command line",
                    file);
    const bool isNamed = !rest.empty() && !rest.front().starts_with('-');
    const std::string named = isNamed                   ? rest.front()
                              : catalogue().size() == 1 ? catalogue().front().name
                                                        : told.front();
    if (named != told.front()) throw UsageError("--from", "must be a picture of " + named, "one of " + told.front());
    requireNoAction(told);
    if (isNamed) rest.erase(rest.begin());
    std::vector<std::string> all{named};
    for (std::size_t i = 1; i < told.size();) {
        std::size_t next = i + 1;
        while (next < told.size() && !told[next].starts_with("--")) ++next;
        const bool isReplaced =
            std::ranges::any_of(rest, [&](const std::string& word) { return flagOf(word) == told[i]; });
        if (!isReplaced) all.insert(all.end(), told.begin() + long(i), told.begin() + long(next));
        i = next;
    }
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
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
    std::vector<std::string> rest = withPicturesLine(arguments);
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
        if (!isForSeveral(option->get_name())) option->take_last();
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
