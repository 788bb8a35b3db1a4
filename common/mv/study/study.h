// Runs studies: error against run time.
#pragma once
#include <functional>
#include <string>

#include "mv/run/command_line.h"
#include "mv/study/data.h"

namespace mv {

struct StudyOptions {
    int rounds = 7;       // timed runs of each row, interleaved; an untimed one goes before each
    double seconds = 20;  // that all rounds together may take; where a round is long there are fewer, one at least
    bool timed = true;    // false: errors and counts only, without the reference's own error, as a test wants
    // Rows for which this says no are left out, with the status below; empty: all are measured.
    std::function<bool(const StudyRow& row)> wanted = {};
    // A line of progress for people, now and then.
    std::function<void(const std::string& line)> progress = {};
};

inline constexpr const char* notMeasured = "not measured";

// What --vary says: a knob and the values that it is to have. Error: no such knob, or a value that it refuses.
struct Varied {
    std::string knob;
    std::vector<std::string> values;
};
Varied variedBy(const DemoInfo& info, const std::vector<KnobSetting>& knobs, const std::string& vary);

// The study that the demo declares, or with --vary one made by hand: the knob's values in the demo's own scene.
// Error: the demo declares none; --vary of a demo without a reference; a range the knob does not have.
Study studyOf(const DemoInfo& info, const std::vector<KnobSetting>& knobs, const std::string& vary);

// Runs it on the stage, which must be open with the demo; its knobs end as they were. Each row is judged by a reference for
// its own settings; rows share one where all knobs that making it read have the same values. A setting that fails, or of
// which no reference can be made, is a row with its reason as status.
StudyRun runStudy(Stage& stage, const Study& study, const StudyOptions& options);

// The parts that table, plot and page have in common: scenes and methods in the order of the rows, an error with three
// digits ("0" where it is exactly that), what a row counted, how the reference was made, and where the study was
// measured.
std::vector<std::string> scenesOf(const StudyRun& run);
std::vector<std::string> methodsOf(const StudyRun& run, const std::string& scene);
// "map, 1 tap, resolution 1024"
std::string nameOf(const StudyRow& row);
std::string countsText(const StudyRow& row);
std::string referenceText(const StudyRun& run);
std::string machineText(const StudyRun& run);
// "map, 1 tap, resolution 1024: part that is wrong 0.00031, 9.1 ms"
std::string rowSentence(const StudyRun& run, const StudyRow& row);
// As the system names it.
std::string processorName();

// The table that --study prints: a row a setting, the Pareto-best marked with *.
std::string studyTable(const StudyRun& run);

// The words of an SVG's chart that a study's has otherwise.
struct PlotWords {
    std::string title, error, time;  // above, below and beside the axes; "" for the study's own
    bool joined = true;              // a method's points, by its line
};
// The plot as SVG: error to the right, time upwards, both logarithmic, one line a method. Each point is a group with the number
// of its row, <g data-row="7">, which a page's script finds. Error: no row has both numbers.
std::string studySvg(const StudyRun& run, const PlotWords& words = {});

// --study DIR: runs, prints the table, writes study.csv and study.svg into the folder.
void study(const Command& command);

// docs/errors-and-times/<demo>.md, from the committed runs, a machine each.
std::string studyPage(const std::vector<StudyRun>& runs, const DemoInfo& info);

}  // namespace mv
