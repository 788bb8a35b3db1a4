// An exception, told.
#pragma once
#include <string>

namespace mv {

// In a catch clause for std::exception: what a user is told of the one that is caught, "subject: rule, value": an Error's own
// words; of all others, whose words are a library's and mean nothing to him, ours. `subject` is what was being done, a demo's
// name say.
std::string caughtSentence(const std::string& subject);

}  // namespace mv
