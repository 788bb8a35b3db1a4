// The curve is used: which setting of a study keeps a bound.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/study/data.h"

namespace mv {

// The demand on a setting: a time that it must keep, in milliseconds, or an error, in the quantity of the study's axis.
struct StudyBound {
    enum class Of { time, error } of = Of::time;
    double value = 0;
};

// "5 ms"; "0.01".
std::string boundText(const StudyBound& bound);

// The cheapest of these rows whose error keeps the bound, or the most exact that keeps the time; of equals the other
// number decides, then the order. Rows without a place in the plot keep nothing. Nothing where none keeps it.
std::optional<std::size_t> rowWithin(const StudyRun& run, const std::vector<std::size_t>& rows,
                                     const StudyBound& bound);

// The row that comes nearest to the bound: the most exact one, or the fastest. Nothing where no row is plotted.
std::optional<std::size_t> nearestTo(const StudyRun& run, const std::vector<std::size_t>& rows,
                                     const StudyBound& bound);

// The rows of a scene that compete for the demo's present problem (Study::problem). Error, with `subject`: the study has no
// row of this problem; it names the values that it has.
std::vector<std::size_t> rowsOfProblem(const StudyRun& run, const std::string& scene, const Demo& demo,
                                       const std::string& subject);

// Which of the demo's knobs the row does not set are not at their initial value, with which it was measured: "spin-x, fov";
// "" for none.
std::string measuredOtherwise(const StudyRow& row, const Demo& demo);

}  // namespace mv
