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
};
// The lines of tests/goldens/cases.txt.
const std::vector<GoldenCase>& goldenCases();
std::string goldenFile(const std::string& name);

// Draws the case on this test program's stage.
Picture drawCase(const GoldenCase& golden);

// Who drew the committed pictures, and who draws now: renderer, version and processor, one line.
std::string recordedDriver();
std::string presentDriver();

// Whether `drawn` matches the golden picture, and if not, why. Exact where the recorded driver draws. Elsewhere at most
// 3 levels on at most 0.1 % of the pixels: others have met 2 to 3 levels between processors on the same llvmpipe.
// What differs is left in build/failures: the picture, the golden one and the difference.
std::optional<std::string> mismatch(const std::string& name, const Picture& drawn, bool keepPictures = true);

}  // namespace mv::test
