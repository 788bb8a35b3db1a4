// native DEMO...: what a page has to show, drawn by OpenGL ES 3.0 of EGL: of each demo its presets and, with --ends before the
// names, each end of each knob, at frame 1. JSON: {"demo": [{"settings", "frame", "sum", "knobs", "readouts", "matrices", "messages",
// "error"}]}. The sum is FNV-1a of the picture's bytes, the upper row first.
#include <cstdint>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/host/context.h"
#include "mv/run/report.h"
#include "mv/run/sentence.h"
#include "mv/run/session.h"

using namespace mv;

namespace {

std::uint32_t sumOf(const Picture& picture) {
    std::uint32_t sum = 2166136261U;
    for (const unsigned char byte : picture.rgba) sum = (sum ^ byte) * 16777619U;
    return sum;
}

nlohmann::ordered_json shown(Stage& stage, const DemoInfo& info, const std::vector<KnobSetting>& settings) {
    auto json = nlohmann::ordered_json::object();
    json["settings"] = nlohmann::ordered_json::object();
    for (const KnobSetting& setting : settings) json["settings"][setting.name] = setting.text;
    json["frame"] = 1;
    const SessionStart start{.width = info.width, .height = info.height, .knobs = settings, .paused = true};
    Session session(stage, info, start);
    session.finish(info.width, info.height, true);
    json["error"] = session.error();
    if (!session.error().empty()) return json;
    const auto report = nlohmann::ordered_json::parse(session.report({}));
    for (const char* part : {"knobs", "idle", "readouts", "matrices", "messages"}) json[part] = report[part];
    json["sum"] = sumOf(stage.picture());
    return json;
}

}  // namespace

int main(int count, char** arguments) {
    try {
        std::vector<std::string> names(arguments + 1, arguments + count), notes;
        const bool ends = !names.empty() && names.front() == "--ends";
        if (ends) names.erase(names.begin());
        const std::unique_ptr<Context> context = openHeadless(HostKind::egl, {.version = 30, .es = true}, notes);
        Stage stage(*context);
        auto all = nlohmann::ordered_json::object();
        for (const std::string& name : names) {
            const DemoInfo& info = findDemo(name);
            std::vector<std::vector<KnobSetting>> tried;
            for (const Preset& preset : info.presets) tried.push_back(preset.settings);
            const std::unique_ptr<Demo> demo = info.make();
            for (const Knob* knob : demo->knobs()) {
                for (const std::string& text : knob->sweep()) {
                    if (ends && text != knob->initialText()) tried.push_back({{knob->name(), text}});
                }
            }
            all[name] = nlohmann::ordered_json::array();
            for (const auto& settings : tried) all[name].push_back(shown(stage, info, settings));
        }
        std::cout << all.dump() << "\n";
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "error: " << sentenceOf(error, "native") << "\n";
        return 1;
    }
}
