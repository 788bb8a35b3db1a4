#include "mv/run/copyable.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "mv/portable_number.h"

namespace mv {

std::string quotedForShell(const std::string& text) {
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("-_./=,:+@%").find(c) != std::string_view::npos;
    };
    if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string startOf(const std::string& program, const DemoInfo& info) {
    if (program.empty()) return info.name;
    // The program of one demo has its name, but where a script such as ./run started it under its own.
    const bool own =
        catalogue().size() == 1 && std::filesystem::path(program).filename() == std::string_view(info.name);
    return quotedForShell(program) + (own ? "" : " " + info.name);
}

std::string copyableCommand(const std::string& start, const DemoInfo& info, const Demo& demo, int frame, int width,
                            int height, const ComparedKnob& compared, const Timeline* timeline,
                            std::optional<int> until, double density, std::optional<int> samples) {
    std::string text = start;
    const auto set = [&](const std::string& knob, const std::string& value) {
        if (knob != compared.name) text += " --" + knob + " " + quotedForShell(value);
    };
    if (timeline && timeline->matters()) {
        for (const KnobSetting& knob : timeline->beginning()) set(knob.name, knob.text);
        for (const TimedChange& change : timeline->changesUntil(frame)) {
            if (change.knob == compared.name) continue;
            text += " --at " + std::to_string(change.frame) + " " + quotedForShell(change.knob + "=" + change.text);
        }
    } else {
        for (const Knob* knob : demo.knobs()) {
            if (!knob->isInitial()) set(knob->name(), knob->text());
        }
    }
    if (!compared.name.empty()) {
        text += " --compare " +
                quotedForShell(compared.name + "=" + demo.knob(compared.name).text() + "," + compared.other);
    }
    if (framesDiffer(info, timeline ? timeline->changesUntil(frame) : std::vector<TimedChange>()) && frame != 1) {
        text += " --frame " + std::to_string(frame);
    }
    if (width != info.width || height != info.height) {
        text += " --size " + std::to_string(width) + "x" + std::to_string(height);
    }
    if (figureUnit(width, height, info.width, info.height, density) !=
        figureUnit(width, height, info.width, info.height)) {
        text += " --density " + portable::shortestText(density);
    }
    if (samples) text += " --multisample " + std::to_string(*samples);
    if (until) text += " --until " + std::to_string(*until);
    return text;
}

std::string lineOf(const Command& command, const std::string& start, int frame) {
    const DemoInfo& info = *command.demo;
    const auto demo = info.make();
    applyKnobs(*demo, command.knobs);
    ComparedKnob compared;
    if (!command.compareKnob.empty()) {
        demo->knob(command.compareKnob).parse(command.compareValues[0]);
        compared = {command.compareKnob, command.compareValues[1]};
    }
    Timeline timeline(*demo);
    timeline.setChanges(command.changes);
    std::string text = copyableCommand(start, info, *demo, frame, command.width ? command.width : info.width,
                                       command.height ? command.height : info.height, compared, &timeline,
                                       command.until, command.density, command.samples);
    for (const KnobValues& strip : command.strip) {
        std::string values;
        for (const std::string& value : strip.values) values += (values.empty() ? "" : ",") + value;
        text += " --strip " + quotedForShell(strip.knob + "=" + values);
    }
    return text;
}

}  // namespace mv
