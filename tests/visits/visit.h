// Every demo, visited in one state after another: its presets, each end of each knob, pairs of these, sizes and frames. What is to
// hold in every state is asked in one place, by visit(); what only some can tell stands with their walk.
#pragma once
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "support/demo_run.h"

namespace mv::test {

class Visits : public testing::TestWithParam<std::string> {};

enum class Times { once, twice };

// The present state of the open demo, drawn:
// - OpenGL and the driver report no error, and a draw reads nothing undefined (the stage throws, and tests watch);
// - it is the same picture again, and its readouts, which are measured the second time, change nothing of it (Times::twice);
// - each readout, each matrix shown and each count is finite;
// - one that is refused, is so by draw(), too, in a sentence with the flag of a knob and a rule.
// Returns the picture; nothing where the state is refused, or fails. (Once is with its readouts: so under the sanitizers.)
std::optional<Picture> visit(int frame = 1, Times times = sanitized ? Times::once : Times::twice);
// The same of a state that is to be refused; returns the sentence.
std::string visitRefused(DemoRun& run);
// And there is something to see in it.
std::optional<Picture> visitScene(const std::string& setting, Times times = sanitized ? Times::once : Times::twice);
// One drawing of it alone, with or without its readouts; nothing, and a test failure, where it throws.
std::optional<Picture> drawnOnce(int frame, bool readouts);

// There are many settings to draw: of the sides, the part that coarserOften() says.
void drawSmall();

// The value that is tried many times in the place of an end that costs seconds a picture: tests/visits/affordable.txt.
std::string affordable(const std::string& knob, const std::string& value);

}  // namespace mv::test
