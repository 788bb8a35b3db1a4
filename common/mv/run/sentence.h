// An exception, told.
#pragma once
#include <exception>
#include <string>

namespace mv {

// What a user is told of an exception, "subject: rule, value": an Error's own words; of all others, whose words are a
// library's and mean nothing to him, ours. `subject` is what was being done, a demo's name say.
std::string sentenceOf(const std::exception& error, const std::string& subject);

}  // namespace mv
