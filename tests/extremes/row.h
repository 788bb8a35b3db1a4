// A row of the table of extreme cases (docs/stability.md): one input on which the usual form fails and ours holds.
#pragma once
#include <string>
#include <vector>

namespace mv::test {

// One error, measured alike on both forms: a number that is best at 0, and NaN or infinity where nothing usable came out.
struct Row {
    std::string id;        // "X05 1e6": the case's, and what sets this row apart from others of the same
    std::string input;     // in words
    std::string measured;  // what the numbers below are, with the unit
    std::string naive;     // the usual form: "glm::lookAt in float"
    double naiveError;     // must NOT be within the tolerance, or the row proves nothing
    std::string ours;      // what mvgl does: "lookAtAnyRoll"
    double ourError;       // must be within the tolerance
    double tolerance;      // 0 where only exactly right will do
    std::string reason;    // why this tolerance
};

// A row that declares itself, as demos do:
//     const bool x01 = addRow([] { return Row{...}; });
// It is computed when somebody asks for rows().
using MakeRow = Row (*)();
bool addRow(MakeRow make);

// All rows, ordered by id, each computed once. Error: an id that occurs twice.
const std::vector<Row>& rows();

// Within the tolerance; false for NaN.
inline bool holds(double error, double tolerance) { return error <= tolerance; }

// The page made of these rows: the same bytes for the same rows.
std::string stabilityPage(const std::vector<Row>& rows);

// The difference between a committed page and a fresh one, line by line, "" where nothing does. Words must agree exactly;
// the columns of measured numbers within a factor of 4, where what is below 1.1e-16, the rounding of a double, counts as
// that: another processor's sine may round another way.
std::string pageDifference(const std::string& committed, const std::string& fresh);

}  // namespace mv::test
