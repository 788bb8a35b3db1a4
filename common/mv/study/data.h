// The outcome of a study on one machine: rows of errors, times and counts, and their file.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mv/demo/study.h"

namespace mv {

// How far the values are from the reference. Dimensionless or in the unit of the quantity.
struct StudyError {
    double rms = 0;
    double max = 0;
    double fraction = 0;  // of the values that are wrong, 0..1
    long n = 0;           // values compared
};

struct StudyRow {
    std::string scene, method;
    std::string knob, parameter;        // the knob that moves along the line, and its value; "" for a single point
    std::vector<KnobSetting> settings;  // all knobs that the row sets
    StudyError all, awayFromEdges;      // of all values, and without the edge band
    long unmatched = 0;                 // pixels that count for only one of the two: for the demo, or for the reference
    double msMedian = 0, msMad = 0;     // milliseconds of one frame, or of one values()
    int rounds = 0;
    std::vector<std::pair<std::string, double>> counts;  // triangles, fragments, passes, taps ...
    std::string status = "ok";                           // or why there is no number
    bool best = false;                                   // Pareto-best; see markBest()
    bool ok() const { return status == "ok"; }
};

struct StudyRun {
    std::string demo, quantity, reference;
    ErrorAxis axis = ErrorAxis::rms;
    std::string problem;  // Study::problem
    double wrongBeyond = 0.5;
    int width = 0, height = 0, frame = 1;   // of the picture; 0x0 for a study of values
    std::string host, renderer, processor;  // who drew, and on what
    int threads = 0;                        // of the machine
    std::string note;                       // what else to know of how it was measured; "" for nothing
    std::vector<std::pair<std::string, double>> referenceErrors;  // by scene; Reference::ownError
    std::vector<StudyRow> rows;

    // The error that the plot shows.
    double shownError(const StudyRow& row) const {
        return axis == ErrorAxis::rms ? row.all.rms : axis == ErrorAxis::max ? row.all.max : row.all.fraction;
    }
};

// How a line's error falls (or its time grows) with its parameter p: the least-squares slope of the logarithms, so that
// the quantity goes as p^slope. Nothing where fewer than three of the line's rows have a positive number.
std::optional<double> errorSlope(const StudyRun& run, const std::string& scene, const std::string& method);
std::optional<double> timeSlope(const StudyRun& run, const std::string& scene, const std::string& method);

// p of the row as a number; nothing where it has none.
std::optional<double> parameterOf(const StudyRow& row);

// The least-squares slope of log y over log x, for positive x and y; nothing of fewer than three points, or of one x.
std::optional<double> logarithmicSlope(const std::vector<std::pair<double, double>>& points);

// The same of the line as it is drawn, time over error: the time goes as error^slope. The slope of the points that have
// a positive error and a time; nothing where these are fewer than three, or their errors within a factor of 2 of each
// other.
std::optional<double> drawnSlope(const StudyRun& run, const std::string& scene, const std::string& method);

// The rows whose points are on the line that is drawn: with a positive error and a time.
bool isOnLine(const StudyRun& run, const StudyRow& row);
// A row that has a place in the plot: measured, with a time.
bool isPlotted(const StudyRow& row);

// "0.00123", and "0" where it is exactly that.
std::string errorText(double value);
// The error that the plot shows, in words: "root mean square error", "part that is wrong" or "largest error".
std::string errorName(ErrorAxis axis);

// The knob that moves along a line, "resolution"; "" for a single point.
std::string knobOf(const StudyRun& run, const std::string& scene, const std::string& method);
// The value of Study::problem in a row as the row sets it, "1e4"; "" where it does not, or where no knob is the problem.
std::string problemOf(const StudyRun& run, const StudyRow& row);
// Whether two rows are of one scene and of equal problems, so that one may be better than the other.
bool compete(const StudyRun& run, const StudyRow& one, const StudyRow& other);

// A row of which a larger part of the values is wrong is best at nothing, however fast it is.
inline constexpr double mostWrong = 0.5;
// Marks the rows that are Pareto-best among those they compete with: none of these that is best, too, is as near to the
// reference or nearer and not measurably slower, which is by more than the deviations of both times.
void markBest(StudyRun& run);
// The same in words: "at most half of it is wrong, and no other best row of the same far is as near without ...".
std::string bestText(const StudyRun& run);

// A line "# name: text" for each fact about the whole, then a table with a line for each row. The columns "--knob" have
// the settings of a row, those after them its counts; a row has nothing where a field is empty.
std::string studyCsv(const StudyRun& run);
// Reads studyCsv's text, and marks the best rows anew. Error: not such a text, with what is missing.
StudyRun readStudy(const std::string& csv);

// ---- Machines

// Who draws, by the renderer's name: a "processor" (llvmpipe and its like) or a "gpu". A committed study's file is named so:
// docs/errors-and-times/DEMO.gpu.csv.
enum class Drawer { processor, gpu };
Drawer drawerOf(const std::string& renderer);
const char* nameOf(Drawer drawer);

// Whose times the run has, for people: "a processor (llvmpipe)", "this GPU (NVIDIA H100 80GB HBM3)"; of values, which no
// renderer computes, the processor's name and its threads.
std::string machineName(const StudyRun& run);

// For the code that builds the committed studies in; see cmake/EmbedShaders.cmake.
bool addStudyFile(const std::string& demo, std::string text);
bool addStudyFile(const char* demo, const char* text);

// The committed runs of a demo's study, a machine each, a processor's first; they are built in beside its shaders. Empty where
// there is none.
std::vector<StudyRun> committedStudies(const std::string& demo);
// The one of these of that kind of renderer or, where there is none, the first. Nothing where there is none.
std::optional<StudyRun> committedStudy(const std::string& demo, Drawer drawer = Drawer::processor);

}  // namespace mv
