// The report of a demo's window: the settings, the picture, the panel.
#include <nlohmann/json.hpp>

#include "mv/paper/report.h"
#include "mv/window/demo_screen.h"
#include "mv/window/window_report.h"

namespace mv {

void DemoScreen::report(const WindowState& state) {
    if (report_ == ReportForm::none) return;
    // At the end the frame is drawn some times more for it; while the window lives the last time it took has to do.
    const FrameTimes times = session_.times(state.closing ? 9 : 0);
    std::string problem;
    for (const Message& message : messages()) {
        if (message.error) problem += (problem.empty() ? "" : "\n") + message.text;
    }
    if (report_ == ReportForm::text) {
        std::string text = reportText(stage_, session_.drawnFrame(), times) + "command   " +
                           commandLine(startOf(program_, info_)) + "\n";
        if (!problem.empty()) text += "error     " + problem + "\n";
        return printReport(text + windowText(state) + "demo      " + std::to_string(session_.picturesDrawn()) +
                           " frames drawn" + (session_.playback().playing() ? ", playing\n" : "\n"));
    }
    auto json = nlohmann::ordered_json::parse(reportJson(stage_, session_.drawnFrame(), times));
    json["command"] = commandLine(startOf(program_, info_));
    if (!problem.empty()) json["error"] = problem;
    auto& window = json["window"] = windowJson(state);
    window["demo_frames"] = session_.picturesDrawn();
    if (session_.passes() > 0) {
        window["passes"] = session_.passes();
        window["passes_done"] = session_.passesDone();
    }
    window["playing"] = session_.playback().playing();
    window["hovered"] = handled_;
    if (steps_.outlined()) window["outlined"] = *steps_.outlined();
    window["focused"] = gui_.focused();
    window["tip"] = gui_.tip();
    if (study_.any()) {
        window["study"] = study_.origin();
        window["here"] = study_.here(session_.demo());
        window["asked"] = study_.asked(session_.demo());
        window["measuring"] = study_.measuring();
    }
    if (comparison_.drawn()) {
        window["compare"] = comparison_.compared().name;
        window["compare_with"] = comparison_.other();
        window["divider"] = comparison_.divider();
        window["difference"] = comparison_.difference();
    }
    json["places"] = placesJson(gui_.places());
    printReport(json.dump(2) + "\n");
}

}  // namespace mv
