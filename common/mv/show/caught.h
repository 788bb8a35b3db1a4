// An exception, told.
#pragma once
#include <string>
#include <vector>

#include "mv/demo/demo.h"

namespace mv {

// In a catch clause for std::exception: what a user is told of the one that is caught, "subject: rule, value": an Error's own
// words; of all others, whose words are a library's and mean nothing to him, ours. `subject` is what was being done, a demo's
// name say.
std::string caughtSentence(const std::string& subject);

// The knobs that a refusal names, the refused one first: of "--near: must be less than --far 1.8, 2" near and far.
std::vector<std::string> knobsNamed(const std::string& refusal, const Demo& demo);
// The same for who moves knobs and types no flags: "near is 2, and must be less than far 1.8: move near or far". A
// sentence that is about no knob is returned as it is.
std::string inPlainWords(const std::string& refusal, const Demo& demo);

}  // namespace mv
