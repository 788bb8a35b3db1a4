#include "mv/run/run.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "mv/demo/chapters.h"
#include "mv/host/trial.h"
#include "mv/image/file.h"
#include "mv/paper/audit.h"
#include "mv/paper/docs.h"
#include "mv/paper/report.h"
#include "mv/paper/tables.h"
#include "mv/run/command_line.h"
#include "mv/run/copyable.h"
#include "mv/run/lecture.h"
#include "mv/run/render.h"
#include "mv/run/window_module.h"
#include "mv/show/caught.h"
#include "mv/study/study.h"

namespace mv {
namespace {

void print(const std::string& text) {
    std::cout << text << std::flush;
    if (!std::cout) throw Error("standard output", "could not be written");
}

// The demos, each chapter's below its name.
std::string list() {
    std::vector<std::vector<std::string>> rows;
    for (const DemoInfo& info : catalogue()) rows.push_back({"  " + info.name, info.sentence});
    std::istringstream lines(aligned(rows, 2));
    std::string text;
    for (const Chapter& chapter : catalogueByChapter()) {
        text += chapter.name + "\n";
        for (std::size_t i = 0; i < chapter.demos.size(); ++i) {
            std::string line;
            std::getline(lines, line);
            text += line + "\n";
        }
    }
    return text;
}

std::unique_ptr<Demo> demoWithKnobs(const Command& command) {
    if (!command.demo) throw UsageError("demo", "must be named first");  // as the command line's reading has seen to
    auto demo = command.demo->make();
    applyKnobs(*demo, command.knobs);
    return demo;
}

// A knob that was given and changes nothing in the settings that are drawn is named, with its reason.
void noteIdleKnobs(const Command& command) {
    const bool draws = command.action == Action::render || command.action == Action::window ||
                       command.action == Action::audit || command.action == Action::movie;
    if (!draws || !command.demo) return;
    const auto demo = demoWithKnobs(command);
    for (std::size_t i = command.presetKnobs; i < command.knobs.size(); ++i) {
        const Knob& knob = demo->knob(command.knobs[i].name);
        if (knob.name() == command.compareKnob || !command.strip.empty() || !command.vary.empty()) continue;
        std::string reason;
        // Beside each other two settings are drawn: it is idle in both, or it does something.
        for (const std::string& value :
             command.compareKnob.empty() ? std::vector<std::string>{""} : command.compareValues) {
            if (!value.empty()) demo->knob(command.compareKnob).parse(value);
            reason = knob.idleReason();
            if (reason.empty()) break;
        }
        if (!reason.empty()) {
            std::cerr << "note: --" << knob.name() << " does nothing in these settings: " << reason << "\n";
        }
    }
}

void act(const Command& command) {
    noteIdleKnobs(command);
    switch (command.action) {
        case Action::help:
            return print(command.text);
        case Action::version:
            return print("mvgl " MVGL_VERSION "\n");
        case Action::list:
            return print(list());
        case Action::knobs: {
            const auto demo = demoWithKnobs(command);
            const DemoInfo& info = *command.demo;
            return print(command.json ? knobsJson(info, *demo) : knobsText(*demo) + presetsText(info));
        }
        case Action::copyable: {
            if (!command.demo)
                throw UsageError("demo", "must be named first");  // as the command line's reading has seen to
            return print(lineOf(command, startOf(command.program, *command.demo), command.firstFrame) + "\n");
        }
        case Action::gallery:
            return writeGallery(command.folder);
        case Action::docs:
            return writeDocs(command.folder);
        case Action::audit:
            return audit(command);
        case Action::study:
            return study(command);
        case Action::render:
            return render(command);
        case Action::movie:
            return writeMovie(command);
        case Action::versus:
            return printVersus(command);
        case Action::plot:
            return writePlot(command);
        case Action::window:
            return openWindow(command);
    }
}

// Standard streams that are closed would be taken by the next files that are opened, a driver's say. In their place stands a pipe
// that nobody reads: what is written there fails, as it would. And what may not be written is told in words, not by a
// signal's end.
void steadyStreams() {
    for (const int signal : {SIGXFSZ, SIGPIPE}) std::signal(signal, SIG_IGN);
    std::vector<int> closed;
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
        // The lowest free number is this one, since those below are open.
        if (::open("/dev/null", O_RDONLY) == stream && stream != STDIN_FILENO) closed.push_back(stream);  // NOLINT
    }
    std::array<int, 2> ends{-1, -1};
    if (closed.empty() || ::pipe2(ends.data(), O_CLOEXEC) != 0) return;
    for (const int stream : closed) ::dup2(ends[1], stream);
    for (const int end : ends) ::close(end);
}

// The sentence as it is printed: names may hold newlines and what a terminal obeys, which are shown as in C. Only a shader's log
// keeps its lines, each below the sentence.
std::string oneLine(const std::string& sentence) {
    // A log is what stands after the comma, on lines of its own (mv/gl/program.cpp).
    constexpr std::string_view log = ", \n";
    const auto at = sentence.find(log);
    if (at == std::string::npos) return printable(sentence);
    std::string text = printable(sentence.substr(0, at)) + ", ";
    std::istringstream lines(sentence.substr(at + log.size()));
    for (std::string line; std::getline(lines, line);) text += "\n" + printable(line);
    return text;
}

}  // namespace

void beforeAll() { requireRoom(); }

int runMain(int count, char** arguments) {
    steadyStreams();
    tellOfFaults();
    std::string subject = "mvgl";
    try {
        Command command = parseCommandLine({arguments + 1, arguments + count});
        if (count > 0) command.program = arguments[0];
        if (command.demo) subject = command.demo->name;
        act(command);
        return 0;
    } catch (const UsageError& error) {
        std::cerr << "error: " << oneLine(error.what()) << "\n";
        return 2;
    } catch (const std::exception&) {
        std::cerr << "error: " << oneLine(caughtSentence(subject)) << "\n";
        return 1;
    }
}

}  // namespace mv
