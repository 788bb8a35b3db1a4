// A frame of its own for a part of a picture: which values its sides stand for, and round numbers along them.
#pragma once
#include <string>
#include <vector>

#include "mv/geometry/strokes.h"

namespace mv {

// One axis of a plot: the values at its two ends, and what they are.
struct Axis {
    double low, high;
    std::string name = {};  // "" for none
    bool logarithmic = false;
};

// A part of a picture, in pixels, and the frame that is declared for it. The middle of the pixel (i, j) of a magnified
// picture is the value (i + 0.5, j + 0.5).
struct Plot {
    Box box;
    Axis x, y;
    // The place of a value, and the value of a place; each is the other's inverse. Values beyond an end are
    // drawn beyond the box. Refused: an axis whose ends are one, and a value or an end that is not above 0 on a
    // logarithmic one.
    vec2 pixel(const vec2& value) const;
    vec2 value(const vec2& pixel) const;
};

// Round numbers from low to high, both included: multiples of 1, 2 or 5 times a power of ten, as many as there can be
// up to `most`, ascending, each rounded once; of a range of few roundings only those that are numbers of their own. On a
// logarithmic axis powers of ten, of each second or third decade where there would be too many.
// Either may leave none. Refused: ends that are not finite or not in order, most below 1, and a logarithmic axis that
// does not begin above 0.
std::vector<double> ticks(const Axis& axis, int most);

// A tick's number as words: six digits at most, "1e+06" as "1e6".
std::string tickText(double value);

}  // namespace mv
