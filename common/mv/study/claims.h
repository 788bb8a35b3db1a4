// Whether the rows of a study bear out what it says.
#pragma once
#include <string>
#include <vector>

#include "mv/study/data.h"

namespace mv {

struct Evaluation {
    bool holds = false;
    // The predicates evaluated, with the numbers found and the bounds: "slope of error over p, 1 tap: -0.94 .. -0.92 in
    // 2 scenes; claimed -1.1 .. -0.9".
    std::string text;
    // The predicates that do not hold, a line each: "still life, 1 tap: slope of error over p is -0.79".
    std::vector<std::string> failures;
};

// Whether the saying is about the machine of this run: "on a processor" in its sentence means the processors' rows alone, "on this
// GPU" those of the GPU; a sentence with none of these words, or with both, is about both.
bool isAbout(const Saying& saying, const StudyRun& run);

// Error: the predicate asks for what the run does not have (rows, a count, partners, times), or for a slope of fewer
// than three rows. The predicate would hold of nothing.
Evaluation evaluate(const StudyRun& run, const Predicate& predicate);

}  // namespace mv
