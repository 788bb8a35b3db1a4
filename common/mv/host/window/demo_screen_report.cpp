// What a demo's window reports: the settings, the picture, the panel.
#include <nlohmann/json.hpp>

#include "mv/host/window/demo_screen.h"
#include "mv/host/window/window_report.h"
#include "mv/run/report.h"
#include "mv/run/run.h"

namespace mv {

// At the end the frame is drawn some times more for it; while the window lives the last time it took has to do.
FrameTimes DemoScreen::timesForReport(bool closing) {
    if (closing && error_.empty() && hasPicture_) {
        try {
            return timeFrames(stage_, drawnFrame_, 9, firstMs_);
        } catch (const std::exception& error) {
            error_ = sentenceOf(error, info_.name);
        }
    }
    return {firstMs_, lastMs_, 0, hasPicture_ ? 1 : 0};
}

void DemoScreen::report(const WindowState& state) {
    if (report_ == ReportForm::none) return;
    const FrameTimes times = timesForReport(state.closing);
    std::string problem;
    for (const Message& message : messages()) {
        if (message.error) problem += (problem.empty() ? "" : "\n") + message.text;
    }
    if (report_ == ReportForm::text) {
        std::string text = reportText(stage_, drawnFrame_, times) + "command   " + commandLine() + "\n";
        if (!problem.empty()) text += "error     " + problem + "\n";
        return printReport(text + windowText(state) + "demo      " + std::to_string(demoFrames_) + " frames drawn" +
                           (playback_.playing() ? ", playing\n" : "\n"));
    }
    auto json = nlohmann::ordered_json::parse(reportJson(stage_, drawnFrame_, times));
    json["command"] = commandLine();
    if (!problem.empty()) json["error"] = problem;
    auto& window = json["window"] = windowJson(state);
    window["demo_frames"] = demoFrames_;
    window["playing"] = playback_.playing();
    window["hovered"] = hand_.hovered();
    if (study_.any()) {
        window["study"] = study_.origin();
        window["here"] = study_.here(stage_.demo());
        window["measuring"] = study_.measuring();
    }
    if (comparison_.drawn()) {
        window["compare"] = comparison_.compared().name;
        window["compare_with"] = comparison_.other();
        window["divider"] = comparison_.divider();
        window["difference"] = comparison_.difference();
    }
    json["places"] = placesJson(places_);
    printReport(json.dump(2) + "\n");
}

}  // namespace mv
