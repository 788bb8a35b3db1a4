// The curve is used: which setting of a study keeps a bound.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/run/study_bound.h"
#include "mv/run/study_data.h"

namespace mv {

// "5 ms"; "0.01".
std::string boundText(const StudyBound& bound);

// Of these rows the cheapest whose error keeps the bound, or the most exact that keeps the time; of equals the other number
// decides, then the order. Rows without a place in the plot keep nothing. Nothing where none keeps it.
std::optional<std::size_t> rowWithin(const StudyRun& run, const std::vector<std::size_t>& rows,
                                     const StudyBound& bound);

// The row that comes nearest to the bound: the most exact one, or the fastest. Nothing where no row is plotted.
std::optional<std::size_t> nearestTo(const StudyRun& run, const std::vector<std::size_t>& rows,
                                     const StudyBound& bound);

// "map, 1 tap, resolution 1024: part that is wrong 0.00031, 9.1 ms"
std::string rowSentence(const StudyRun& run, const StudyRow& row);

// The rows of a scene that compete for the demo's present problem (Study::problem). Error, with `subject`: the study has no
// row of this problem; it names the values that it has.
std::vector<std::size_t> rowsOfProblem(const StudyRun& run, const std::string& scene, const Demo& demo,
                                       const std::string& subject);

// What a choice is made of.
struct StudyCandidates {
    std::string scene;
    std::vector<KnobSetting> settings;  // the scene's own, which go before those of the row that is chosen
    std::vector<std::size_t> rows;
};
// The rows of the scene of the present settings which set none of the knobs in `given` to another value. Where the present
// settings are no scene's own, the one scene that contradicts no given knob is meant. `demo` has the present settings.
// Error: UsageError with `subject` or the knob: several scenes may be meant, or none; no row agrees with the given knobs.
StudyCandidates candidates(const StudyRun& run, const DemoInfo& info, const Demo& demo,
                           const std::vector<KnobSetting>& given, const std::string& subject);

// Which of the demo's knobs the row does not set are not at their initial value, with which it was measured: "spin-x, fov";
// "" for none.
std::string measuredOtherwise(const StudyRow& row, const Demo& demo);

}  // namespace mv
