// docs/work-precision.md and the rows that it is made of, docs/work-precision.csv: what was measured, kept so that the
// page can be made again without measuring, and compared with what is measured now.
#pragma once
#include <string>
#include <vector>

#include "mv/demo/claim.h"
#include "mv/study/data.h"
#include "work_precision/solver.h"

namespace mv::work_precision {

// As the rows of a study: the problem is the scene, the error that is shown the largest.
StudyRun emptyRun();
// Without a time. A run that errs by more than the whole size of a component, and says nothing, has that for its status.
StudyRow rowOf(const Problem& problem, const Solver& solver, double parameter, const Outcome& outcome);
// The same for what is not tried.
StudyRow rowLeftOut(const Problem& problem, const Solver& solver, double parameter, const std::string& why);

std::string rowsText(const StudyRun& run, const std::string& cvode);
// Error: a line that is none of ours.
StudyRun rowsFrom(const std::string& text);

// What each takes for a given error, along its curve: in each problem a row of "the best of ours", "CVODE" and "Odeint",
// and of each of ours that chooses steps, for errors of 1e-3, 1e-6 and 1e-9, which are the parameter. The time is
// interpolated between the logarithms of the last row that errs more and the next one; where no row errs more it is the
// first one's; where the last row errs more there is none. `method` in the settings is who was the best.
StudyRun atEqualErrors(const StudyRun& run);

// The words of the page. The claims of the first list are about the rows, those of the second about atEqualErrors.
std::vector<Saying> sayings();
std::vector<Saying> sayingsAtEqualErrors();

std::string page(const StudyRun& run);
// A line that says which rows a curve shows, by the text of their file.

}  // namespace mv::work_precision
