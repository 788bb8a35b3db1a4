#include "mv/run/lecture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <span>

#include "mv/image/compare.h"
#include "mv/image/file.h"
#include "mv/paper/tables.h"
#include "mv/run/converter.h"
#include "mv/run/copyable.h"
#include "mv/run/film.h"
#include "mv/run/render.h"
#include "mv/show/frame_times.h"
#include "mv/show/median.h"
#include "mv/study/choice.h"
#include "mv/study/study.h"

namespace mv {

void writeMovie(const Command& command) {
    const DemoInfo& info = *command.demo;
    if (command.vary.empty() && !info.animated && command.changes.empty())
        throw Error("--movie", "needs something that moves: --vary KNOB=A..B:N, or --at N KNOB=VALUE", info.name);
    const int width = command.width ? command.width : info.width,
              height = command.height ? command.height : info.height;
    Film film(command.movie, width, height);
    HeadlessStage headless(command.host);
    Stage& stage = headless.stage;
    stage.setSamples(command.samples.value_or(0));
    stage.open(info, width, height);
    stage.setDensity(command.density);
    stage.begin(command.knobs, command.changes);
    if (command.vary.empty()) {
        for (int index = command.firstFrame; index <= command.lastFrame; ++index) {
            stage.draw(index);
            film.add(stage.picture());
        }
    } else {
        const Varied varied = variedBy(info, command.knobs, command.vary);
        for (const std::string& value : varied.values) {
            stage.demo().knob(varied.knob).parse(value);
            stage.draw(command.firstFrame);
            film.add(stage.picture());
        }
    }
    stage.close();
    film.finish();
}

namespace {

// ---- Two settings in one sentence

// The row of a committed study that has this value, and else what the demo has now.
const StudyRow* rowOf(const StudyRun& run, const Demo& demo, const std::string& knob, const std::string& value) {
    for (const StudyRow& row : run.rows) {
        const bool isHere = std::all_of(row.settings.begin(), row.settings.end(), [&](const KnobSetting& setting) {
            return setting.text == (setting.name == knob ? value : demo.word(setting.name));
        });
        const bool sets = std::any_of(row.settings.begin(), row.settings.end(),
                                      [&](const KnobSetting& setting) { return setting.name == knob; });
        if (isHere && sets && row.ok() && row.rounds > 0) return &row;
    }
    return nullptr;
}

std::string wrongness(const StudyRun& run, const StudyRow& row) {
    if (run.axis == ErrorAxis::fraction) return errorText(100 * row.all.fraction) + " %";
    return errorText(run.shownError(row));
}

// "map takes 0.4 of the time and is wrong in 0.14 % where volume is in 0"
std::string sentenceOf(const StudyRun& run, const StudyRow& a, const StudyRow& b, const std::string& nameOfA,
                       const std::string& nameOfB, const std::string& whence) {
    const bool inPart = run.axis == ErrorAxis::fraction;
    return nameOfA + " takes " + formatted("%.2g", a.msMedian / b.msMedian) + " of the time and is " +
           (inPart ? "wrong in " : "off by ") + wrongness(run, a) + " where " + nameOfB + " is " +
           (inPart ? "in " : "by ") + wrongness(run, b) + "\n" + nameOfA + ": " + formatted("%.3g", a.msMedian) +
           " ms, MAD " + formatted("%.2g", a.msMad) + "; " + nameOfB + ": " + formatted("%.3g", b.msMedian) +
           " ms, MAD " + formatted("%.2g", b.msMad) + "; medians of " + std::to_string(std::min(a.rounds, b.rounds)) +
           " rounds; " + errorName(run.axis) + " of " + run.quantity + "\n" + whence + ": " + machineText(run) + "\n";
}

// Of a demo without study: the times of both, in turn, and where their pictures differ.
std::string timesAndDifference(const Command& command, Stage& stage) {
    constexpr std::size_t rounds = 9;
    std::vector<double> times[2];
    Picture pictures[2];
    for (std::size_t round = 0; round <= rounds; ++round) {  // the first compiles and uploads
        for (std::size_t i = 0; i < 2; ++i) {
            stage.demo().knob(command.versusKnob).parse(command.versusValues[i]);
            stage.draw(command.firstFrame);  // which leaves the caches as a second frame finds them
            const FrameTimes time = timeFrames(stage, command.firstFrame, 1, 0);
            if (round > 0) times[i].push_back(time.medianMs);
            if (round == 0) pictures[i] = stage.picture();
        }
    }
    std::string text;
    double medians[2];
    for (std::size_t i = 0; i < 2; ++i) {
        medians[i] = median(times[i]);
        for (double& time : times[i]) time = std::abs(time - medians[i]);
        text += command.versusKnob + " " + command.versusValues[i] + ": " + formatted("%.3g", medians[i]) +
                " ms, MAD " + formatted("%.2g", median(times[i])) + "; ";
    }
    const Difference difference = compare(pictures[0], pictures[1]);
    return command.versusKnob + " " + command.versusValues[0] + " takes " + formatted("%.2g", medians[0] / medians[1]) +
           " of the time of " + command.versusValues[1] + ", and its picture is another in " +
           formatted("%.3g", 100 * difference.fraction) + " % of the pixels\n" + text + "medians of " +
           std::to_string(rounds) +
           " rounds\nmeasured here, and by no study of what is right: " + stage.driver().renderer + ", " +
           processorName() + "\n";
}

}  // namespace

void printVersus(const Command& command) {
    const DemoInfo& info = *command.demo;
    const std::string &knob = command.versusKnob, &a = command.versusValues[0], &b = command.versusValues[1];
    const auto print = [](const std::string& text) {
        std::cout << text << std::flush;
        if (!std::cout) throw Error("standard output", "could not be written");
    };
    const auto demo = info.make();
    applyKnobs(*demo, command.knobs);
    const bool asCommitted = !command.width && !command.frameGiven && command.host == HostKind::automatic;
    if (const std::optional<StudyRun> run = asCommitted ? committedStudy(info.name) : std::nullopt) {
        const StudyRow *first = rowOf(*run, *demo, knob, a), *second = rowOf(*run, *demo, knob, b);
        const bool asInitial = first && measuredOtherwise(*first, *demo).empty();
        if (first && second && asInitial)
            return print(sentenceOf(*run, *first, *second, a, b, "from the study that is committed"));
    }
    HeadlessStage headless(command.host);
    Stage& stage = headless.stage;
    stage.open(info, command.width ? command.width : info.width, command.height ? command.height : info.height);
    stage.begin(command.knobs);
    if (!info.study) {
        const std::string text = timesAndDifference(command, stage);
        stage.close();
        return print(text);
    }
    Study study = studyOf(info, command.knobs, knob + "=" + a + "," + b);
    if (command.width) study.width = command.width;
    if (command.height) study.height = command.height;
    if (command.frameGiven) study.frame = command.firstFrame;
    const StudyRun run = runStudy(
        stage, study, {.progress = [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); }});
    stage.close();
    for (const StudyRow& row : run.rows) {
        if (!row.ok()) throw Error(knob + " = " + row.parameter, "must be a setting that can be measured", row.status);
    }
    print(sentenceOf(run, run.rows.at(0), run.rows.at(1), a, b, "measured here"));
}

// ---- A plot of one scene

namespace {

// By rsvg-convert, in twice the SVG's size, so that a slide may enlarge it.
std::vector<std::byte> pngOf(const std::string& svg) {
    const ScratchFolder scratch("plot");
    const std::filesystem::path made = scratch.path() / "plot.png";
    Converter converter("--plot", {"rsvg-convert", "--zoom", "2", "--output", made.string()}, made,
                        std::chrono::seconds(30));
    if (!converter.give(std::as_bytes(std::span(svg))) || !converter.finish())
        throw Error("rsvg-convert", "must make a PNG of the plot; it says why above");
    constexpr std::size_t mostBytes = 64U << 20;
    return readFile(made.string(), mostBytes);
}

}  // namespace

void writePlot(const Command& command) {
    const std::string& name = command.demo->name;
    std::optional<StudyRun> run = committedStudy(name);
    if (!run) throw Error("--plot", "needs a demo with a study that is committed, see docs/errors-and-times", name);
    const std::vector<std::string> scenes = scenesOf(*run);
    std::string all;
    for (const std::string& scene : scenes) all += (all.empty() ? "" : ", ") + scene;
    if (command.plotScene.empty() && scenes.size() > 1)
        throw UsageError("--plot", "must name one scene, as '" + scenes.front() + "=FILE.svg'; there are: " + all);
    if (!command.plotScene.empty() && std::find(scenes.begin(), scenes.end(), command.plotScene) == scenes.end())
        throw UsageError("--plot", "must name a scene of the study: " + all, "'" + command.plotScene + "'");
    std::erase_if(run->rows, [&](const StudyRow& row) { return row.scene != command.plotScene && scenes.size() > 1; });
    const std::string svg = studySvg(*run);
    if (command.plot.ends_with(".svg")) return writeFileAtomically(command.plot, svg);
    if (!isInPath("rsvg-convert"))
        throw Error("--plot",
                    "needs rsvg-convert for a PNG, which is not installed (sudo apt install librsvg2-bin); "
                    "FILE.svg needs nothing");
    requireWritable(command.plot);
    writeFileAtomically(command.plot, pngOf(svg));
}

}  // namespace mv
