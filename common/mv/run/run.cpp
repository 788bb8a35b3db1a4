#include "mv/run/run.h"

#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "mv/run/audit.h"
#include "mv/run/command_line.h"
#include "mv/run/docs.h"
#include "mv/run/render.h"
#include "mv/run/report.h"
#include "mv/run/study.h"
#include "mv/run/window_module.h"

namespace mv {
namespace {

void print(const std::string& text) {
    std::cout << text << std::flush;
    if (!std::cout) throw Error("standard output", "could not be written");
}

std::string list() {
    std::string text;
    for (const DemoInfo& info : catalogue()) {
        text += info.name + std::string(info.name.size() < 14 ? 14 - info.name.size() : 1, ' ') + info.sentence + "\n";
    }
    return text;
}

std::unique_ptr<Demo> demoWithKnobs(const Command& command) {
    auto demo = command.demo->make();
    applyKnobs(*demo, command.knobs);
    return demo;
}

void act(const Command& command) {
    switch (command.action) {
        case Action::help:
            return print(command.text);
        case Action::version:
            return print("mvgl " MVGL_VERSION "\n");
        case Action::list:
            return print(list());
        case Action::knobs: {
            const auto demo = demoWithKnobs(command);
            return print(command.json ? knobsJson(*demo) : knobsText(*demo));
        }
        case Action::copyable: {
            const auto demo = demoWithKnobs(command);
            const DemoInfo& info = *command.demo;
            ComparedKnob compared;
            if (!command.compareKnob.empty()) {
                demo->knob(command.compareKnob).parse(command.compareValues[0]);
                compared = {command.compareKnob, command.compareValues[1]};
            }
            return print(copyableCommand(startOf(command.program, info), info, *demo, command.firstFrame,
                                         command.width ? command.width : info.width,
                                         command.height ? command.height : info.height, compared) +
                         "\n");
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
        case Action::window:
            return openWindow(command);
    }
}

}  // namespace

int runMain(int count, char** arguments) {
    try {
        Command command = parseCommandLine({arguments + 1, arguments + count});
        if (count > 0) command.program = arguments[0];
        act(command);
        return 0;
    } catch (const UsageError& error) {
        std::cerr << "error: " << error.what() << "\n";
        return 2;
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << "\n";
        return 1;
    }
}

}  // namespace mv
