// How small words in a figure may be.
#pragma once

namespace mv {

// The least height of a line that can be read, in a figure's units: no figure makes its words smaller to have room for them.
// (A unit has 0.8 pixels at least, see figureUnit().)
inline constexpr int leastWords = 12;

}  // namespace mv
