#include "mv/run/render.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "mv/image/file.h"
#include "mv/image/png.h"
#include "mv/paper/report.h"
#include "mv/run/copyable.h"
#include "mv/show/compare.h"

namespace mv {
namespace {

std::unique_ptr<Context> openNoted(HostKind host) {
    std::vector<std::string> notes;
    auto context = openHeadless(host, {}, notes);
    for (const std::string& note : notes) std::cerr << "note: " << note << "\n";
    return context;
}

// Stops the picture after as many draws as the command says.
void stopAfterDraws(Stage& stage, int index, const Command& command) {
    if (!command.until) return;
    try {
        stage.stopAfter(index, *command.until);
    } catch (const Error& error) {
        if (!stage.steps()) throw;
        throw UsageError("--until", error.what());
    }
}

void printReport(const Command& command, Stage& stage, int index, double firstMs) {
    listenToDriver(false);  // which would be in the times
    const FrameTimes times = timeFrames(stage, index, 9, firstMs);
    stopAfterDraws(stage, index, command);
    const std::string text = command.report == ReportForm::json
                                 ? reportJson(stage, index, times)
                                 : reportText(stage, index, times) + (command.until ? stepsText(*stage.steps()) : "");
    std::cout << text << std::flush;
    if (!std::cout) throw Error("standard output", "could not be written");
}

std::string htmlEscaped(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '&') {
            escaped += "&amp;";
        } else if (c == '<') {
            escaped += "&lt;";
        } else {
            escaped += c;
        }
    }
    return escaped;
}

}  // namespace

HeadlessStage::HeadlessStage(HostKind host) : context(openNoted(host)), stage(*context) {}

void render(const Command& command) {
    HeadlessStage headless(command.host);
    Stage& stage = headless.stage;
    const DemoInfo& info = *command.demo;
    const auto start = std::chrono::steady_clock::now();
    const int width = command.width ? command.width : info.width;
    const int height = command.height ? command.height : info.height;
    if (!command.compareKnob.empty()) requireRoomToCompare(width, height);
    listenToDriver(command.report != ReportForm::none || command.until.has_value());
    stage.setSamples(command.samples.value_or(0));
    stage.open(info, width, height);
    stage.setDensity(command.density);
    stage.begin(command.knobs, command.changes);
    stage.timeline().progress = [](int reached, int wanted) {
        std::fprintf(stderr, "step %d of %d\n", reached, wanted);
    };
    stage.passesProgress = [](int done, int passes) { std::fprintf(stderr, "pass %d of %d\n", done, passes); };

    double firstMs = 0;
    auto shown = start;
    for (int index = command.firstFrame; index <= command.lastFrame; ++index) {
        const auto before = std::chrono::steady_clock::now();
        Picture sheet;
        const bool isSheet = !command.compareKnob.empty() || !command.strip.empty();
        if (!isSheet) {
            stage.draw(index, command.report != ReportForm::none);
        } else if (command.strip.empty()) {
            sheet = compareSettings(stage, index, command.compareKnob, command.compareValues);
        } else {
            sheet = stripOf(stage, index, command.strip);
        }
        if (command.report != ReportForm::none) glFinish();
        const auto now = std::chrono::steady_clock::now();
        if (index == command.firstFrame) {
            firstMs = std::chrono::duration<double, std::milli>(now - before).count();
            for (const std::string& message : stage.notes().messages) std::cerr << "note: " << message << "\n";
        }
        stopAfterDraws(stage, index, command);
        if (!command.shot.empty()) {
            writePng(command.shot == "-" ? "/dev/stdout" : frameFile(command.shot, index),
                     isSheet ? sheet : stage.picture(), lineOf(command, info.name, index));
        }
        if (now - shown > std::chrono::seconds(2) && index < command.lastFrame) {
            shown = now;
            std::fprintf(stderr, "frame %d of %d..%d\n", index, command.firstFrame, command.lastFrame);
        }
    }
    if (command.report != ReportForm::none) {
        printReport(command, stage, command.lastFrame, firstMs);
    } else if (command.until) {
        std::cout << stepsText(*stage.steps()) << std::flush;
        if (!std::cout) throw Error("standard output", "could not be written");
    }
    stage.close();
}

void writeGallery(const std::string& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) throw Error(folder, "could not be made", failure.message());
    HeadlessStage headless;
    std::string html =
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>mvgl gallery</title>\n"
        "<style>\nbody{font:16px/1.5 sans-serif;margin:2em auto;max-width:76em;padding:0 1em;color:#222}\n"
        "main{display:grid;grid-template-columns:repeat(auto-fill,minmax(20em,1fr));gap:1.5em}\n"
        "figure{margin:0;border:1px solid #ccc;border-radius:6px;overflow:hidden}\n"
        "img{width:100%;display:block}\nfigcaption{padding:.8em 1em}\ncode{background:#eee;padding:.1em "
        ".3em}\n</style>\n"
        "<h1>mvgl gallery</h1>\n<p>Each demo at frame 1. Click a picture for its full size.</p>\n<main>\n";
    for (const DemoInfo& info : catalogue()) {
        std::fprintf(stderr, "gallery: %s\n", info.name.c_str());
        headless.stage.open(info, info.width, info.height);
        headless.stage.draw(1);
        writePng(folder + "/" + info.name + ".png", headless.stage.picture());
        html += "<figure><a href=\"" + info.name + ".png\"><img src=\"" + info.name + ".png\" alt=\"" +
                htmlEscaped(info.sentence) + "\"></a><figcaption><b>" + info.name + "</b> &middot; " + info.chapter +
                "<br>" + htmlEscaped(info.sentence) + "<br><i>Look for:</i> " + htmlEscaped(info.lookFor) +
                "<br><code>" +
                copyableCommand(startOf("./run", info), info, headless.stage.demo(), 1, info.width, info.height) +
                "</code></figcaption></figure>\n";
    }
    html += "</main>\n</html>\n";
    writeFileAtomically(folder + "/index.html", std::string_view(html));
    headless.stage.close();
    std::cout << folder << "/index.html\n";
}

}  // namespace mv
