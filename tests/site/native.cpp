// native FOLDER DEMO [--ends | --smaller | --opening]: what a page has to show, drawn by OpenGL ES 3.0 of EGL: the demo's presets at
// frame 1, of one that moves the first at frame 30, too. With --smaller all but what it opens with are a quarter as large; with --ends
// there is each end of each knob, too (a sixteenth as large where the picture is made in passes, which takes minutes in a page); with
// --opening nothing but what it opens with. JSON: [{"settings", "frame", "width", "height", "error", and where that is "" "knobs", "idle",
// "readouts", "matrices", "messages", "picture"}], the last a file of FOLDER with the picture's bytes: red, green, blue, alpha, the upper
// row first.
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/host/context.h"
#include "mv/paper/report.h"
#include "mv/show/caught.h"
#include "mv/show/session.h"

using namespace mv;

namespace {

struct Case {
    std::vector<KnobSetting> settings;
    int frame = 1;
    int smaller = 1;  // than the demo's own width and height
};

std::vector<Case> casesOf(const DemoInfo& info, const std::string& which) {
    if (which == "--opening") return {Case()};
    std::vector<Case> cases;
    for (const Preset& preset : info.presets) cases.push_back({{preset.settings.begin(), preset.settings.end()}});
    if (info.animated) cases.push_back({{}, 30});
    if (which == "--smaller") {
        for (std::size_t i = 1; i < cases.size(); ++i) cases[i].smaller = 2;
    }
    if (which != "--ends") return cases;
    const std::unique_ptr<Demo> demo = info.make();
    const int smaller = demo->passes(FrameInfo(1, info.width, info.height)) > 0 ? 4 : 1;
    for (const Knob* knob : demo->knobs()) {
        for (const std::string& text : knob->sweep()) {
            if (text != knob->initialText()) cases.push_back({{{knob->name(), text}}, 1, smaller});
        }
    }
    return cases;
}

nlohmann::ordered_json shown(Stage& stage, const DemoInfo& info, const Case& one, const std::string& file) {
    const int width = info.width / one.smaller, height = info.height / one.smaller;
    auto json = nlohmann::ordered_json{
        {"settings", nlohmann::ordered_json::object()}, {"frame", one.frame}, {"width", width}, {"height", height}};
    for (const KnobSetting& setting : one.settings) json["settings"][setting.name] = setting.text;
    Session session(stage, info,
                    {.width = width, .height = height, .knobs = one.settings, .frame = one.frame, .paused = true});
    session.finish(width, height, true);
    json["error"] = session.error();
    if (!session.error().empty()) return json;
    const auto report = nlohmann::ordered_json::parse(reportJson(stage, session.drawnFrame(), {}));
    for (const char* part : {"knobs", "idle", "readouts", "matrices", "messages"}) json[part] = report[part];
    const Picture picture = stage.picture();
    std::ofstream out(file, std::ios::binary);
    out.write(reinterpret_cast<const char*>(picture.rgba.data()), static_cast<std::streamsize>(picture.rgba.size()));
    if (!out.flush()) throw Error("native", "must be able to write", file);
    json["picture"] = file.substr(file.rfind('/') + 1);
    return json;
}

}  // namespace

int main(int count, char** arguments) {
    try {
        const std::vector<std::string> words(arguments + 1, arguments + count);
        const std::string which = words.size() == 3 ? words[2] : "";
        if (words.size() < 2 || words.size() > 3 ||
            (words.size() == 3 && which != "--ends" && which != "--smaller" && which != "--opening"))
            throw Error("native", "must have a folder and a demo, and --ends, --smaller, --opening or nothing");
        std::vector<std::string> notes;
        const std::unique_ptr<Context> context = openHeadless(HostKind::egl, {.version = 30, .es = true}, notes);
        Stage stage(*context);
        const DemoInfo& info = findDemo(words[1]);
        auto all = nlohmann::ordered_json::array();
        for (const Case& one : casesOf(info, which))
            all.push_back(shown(stage, info, one, words[0] + "/" + info.name + "-" + std::to_string(all.size())));
        std::cout << all.dump() << "\n";
        return 0;
    } catch (const std::exception&) {
        std::cerr << "error: " << caughtSentence("native") << "\n";
        return 1;
    }
}
