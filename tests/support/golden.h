// Golden pictures: what they are, and when a picture matches one.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mv/image/compare.h"
#include "mv/run/command_line.h"

namespace mv::test {

struct GoldenCase {
    std::string name;
    Command command;  // demo, knobs, frame, size
    // Of the pixels, how many may differ by more than 3 levels where another renderer than the recorded one draws, in percent; and
    // why, where it is more than what it is for the others.
    double elsewhere = 0.1;
    std::string reason;
};
// The lines of tests/goldens/cases.txt. Error: a line that says nothing of why more may differ.
const std::vector<GoldenCase>& goldenCases();
std::string goldenFile(const std::string& name);

// Draws the case on this test program's stage.
Picture drawCase(const GoldenCase& golden);

// Who drew the committed pictures, and who draws now: renderer, version and processor, one line.
std::string recordedDriver();
std::string presentDriver();

// Whether `drawn` matches the golden picture, and if not, why. Exact where the recorded driver draws. Elsewhere as much may differ as
// the case says: of 216 presets on a GPU 199 were within 0.1 %, and one level off, as a background of 0.9 of 255 is, is no difference.
// A difference is left in build/failures: the picture, the golden one and the difference.
std::optional<std::string> mismatch(const GoldenCase& golden, const Picture& drawn, bool keepPictures = true);

}  // namespace mv::test
