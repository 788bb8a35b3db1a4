// The words of an enumeration, as a row and a figure say them.
#pragma once
#include <cstddef>
#include <initializer_list>

#include "mv/demo/knob.h"

namespace mv {

// In the order of the enumeration's values, which count from 0.
//     enum class Cull { none, back };
//     inline constexpr WordList cullWords{{"none"}, {"back", "what faces away"}};
using WordList = std::initializer_list<Word>;

template <class Enum>
const char* wordOf(const WordList& words, Enum value) {
    return words.begin()[static_cast<std::size_t>(value)].word.c_str();
}

}  // namespace mv
